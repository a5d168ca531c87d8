//! Emits the labels of a model with locations as values: points, and members.

use super::super::Names;
use super::super::tree::constant;
use crate::ast::{Connection, Model};
use crate::skeleton::{Body, Member, Skeleton};
use proc_macro2::TokenStream;
use quote::{format_ident, quote_spanned};
use std::collections::BTreeSet;

/// `Model::conn_b`, `Model::planar_beam_1`: a value per label.
pub(super) fn points(model: &Model, skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let name = &model.parameters.ident;
    let mut named = BTreeSet::new();
    let connections = skeleton
        .points
        .iter()
        .enumerate()
        .flat_map(|(index, point)| point.connections.iter().map(move |connection| (index, *connection)));
    // each once, however often it is written
    let points = connections
        .filter(|(_, connection)| named.insert(connection.label.to_string()))
        .map(|(index, connection)| of_point(model, index, connection, names));
    let members =
        skeleton.members.iter().enumerate().filter_map(|(index, member)| of_member(model, index, member, names));
    let masses = skeleton.bodies.iter().filter_map(|body| of_mass(model, skeleton, body, names));
    quote_spanned! {names.here=>
        /// The labels of the sketch: points and members, as results about motions take them.
        #[allow(dead_code, non_upper_case_globals)]
        impl #name {
            #(#points)*
            #(#members)*
            #(#masses)*
        }
    }
}

fn of_point(model: &Model, point: usize, connection: &Connection, names: &Names) -> TokenStream {
    let private = &names.private;
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let (constant, doc) = (constant("conn", &connection.label, names), format!(" `{connection}`"));
    quote_spanned! {names.here=>
        #[doc = #doc]
        #visibility const #constant: #private::PlanePoint<#name> = SKETCH.label(#point);
    }
}

/// A member that is an element of the sketch.
fn of_member(model: &Model, index: usize, member: &Member<'_>, names: &Names) -> Option<TokenStream> {
    let private = &names.private;
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let element = member.what.element()?;
    let constant = constant(&element.kind.name().to_string(), &element.label, names);
    let (kind, doc) = (names.element_over(element, &format_ident!("f64")), format!(" `{element}`"));
    Some(quote_spanned! {names.here=>
        #[doc = #doc]
        #visibility const #constant: #private::MemberLabel<#name, #kind> = #private::MemberLabel::member(#index);
    })
}

/// A mass on a path, whose motion along the path is its x.
fn of_mass(model: &Model, skeleton: &Skeleton<'_>, body: &Body<'_>, names: &Names) -> Option<TokenStream> {
    let private = &names.private;
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let Body { element, node, .. } = body;
    if skeleton.nodes[*node].place.is_some() {
        return None;
    }
    let constant = constant(&element.kind.name().to_string(), &element.label, names);
    let doc = format!(" `{element}`");
    Some(quote_spanned! {names.here=>
        #[doc = #doc]
        #visibility const #constant: #private::PlanePoint<#name> = #private::PlanePoint::node(#node);
    })
}
