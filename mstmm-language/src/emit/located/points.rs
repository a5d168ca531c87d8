//! Emits the labels of a model with locations as values: points, and members.

use super::super::Names;
use super::super::tree::constant;
use crate::ast::{Connection, Model};
use crate::keywords::Dimension;
use crate::skeleton::{Body, Member, Skeleton};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeSet;
use std::fmt::Display;

/// `Model::conn_b`, `Model::beam_1`: a value per label.
pub(super) fn points(model: &Model, skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let (private, name) = (&names.private, &model.parameters.ident);
    let mut named = BTreeSet::new();
    let connections = skeleton
        .points
        .iter()
        .enumerate()
        .flat_map(|(index, point)| point.connections.iter().map(move |connection| (index, *connection)));
    // each once, however often it is written
    let points = connections
        .filter(|(_, connection)| named.insert(connection.label.to_string()))
        .map(|(index, connection)| of_point(model, skeleton, (index, connection), names));
    let members =
        skeleton.members.iter().enumerate().filter_map(|(index, member)| of_member(model, index, member, names));
    let masses = skeleton.bodies.iter().filter_map(|body| of_mass(model, skeleton, body, names));
    let in_space = (skeleton.dimension == Dimension::Space)
        .then(|| quote_spanned!(names.here=> #[automatically_derived] impl #private::InSpace for #name {}));
    quote_spanned! {names.here=>
        #in_space

        /// The labels of the sketch: points and members, as results about motions take them.
        #[allow(dead_code, non_upper_case_globals)]
        impl #name {
            #(#points)*
            #(#members)*
            #(#masses)*
        }
    }
}

fn of_point(
    model: &Model,
    skeleton: &Skeleton<'_>,
    (point, connection): (usize, &Connection),
    names: &Names,
) -> TokenStream {
    let is_in_space = skeleton.dimension == Dimension::Space;
    let of_sketch = Ident::new(if is_in_space { "label_in_space" } else { "label" }, names.here);
    let constant = constant("conn", &connection.label, names);
    label(
        model,
        &constant,
        connection,
        [point_type(model, is_in_space, names), quote_spanned!(names.here=> SKETCH.#of_sketch(#point))],
        names,
    )
}

/// A member that is an element of the sketch.
fn of_member(model: &Model, index: usize, member: &Member<'_>, names: &Names) -> Option<TokenStream> {
    let (private, name) = (&names.private, &model.parameters.ident);
    let element = member.what.element().filter(|_| !member.is_further)?;
    let constant = constant(&element.kind.name().to_string(), &element.label, names);
    let kind = names.element_over(element, &format_ident!("f64"));
    let kind = quote_spanned!(names.here=> #private::MemberLabel<#name, #kind>);
    let value = quote_spanned!(names.here=> #private::MemberLabel::member(#index));
    Some(label(model, &constant, element, [kind, value], names))
}

/// A mass on a path, whose motion along the path is its x, or an inertia, whose rotation is that about its z.
fn of_mass(model: &Model, skeleton: &Skeleton<'_>, body: &Body<'_>, names: &Names) -> Option<TokenStream> {
    let Body { element, node, .. } = body;
    if skeleton.nodes[*node].place.is_some() {
        return None;
    }
    let constant = constant(&element.kind.name().to_string(), &element.label, names);
    let is_in_space = skeleton.dimension == Dimension::Space;
    let kind = point_type(model, is_in_space, names);
    let value = quote_spanned!(names.here=> <#kind>::tied(SKETCH.of_path(#node)));
    Some(label(model, &constant, element, [kind, value], names))
}

fn point_type(model: &Model, is_in_space: bool, names: &Names) -> TokenStream {
    let (private, name) = (&names.private, &model.parameters.ident);
    let kind = Ident::new(if is_in_space { "SpacePoint" } else { "PlanePoint" }, names.here);
    quote_spanned!(names.here=> #private::#kind<#name>)
}

/// The constant of a label, with its type and its value; the documentation is what the user calls it.
fn label(
    model: &Model,
    constant: &Ident,
    of: &impl Display,
    [kind, value]: [TokenStream; 2],
    names: &Names,
) -> TokenStream {
    let (visibility, doc) = (&model.parameters.vis, format!(" `{of}`"));
    quote_spanned! {names.here=>
        #[doc = #doc]
        #visibility const #constant: #kind = #value;
    }
}
