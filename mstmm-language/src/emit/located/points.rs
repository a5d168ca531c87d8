//! Emits the labels of a model with locations as values: points, and members.

use super::super::Names;
use super::super::tree::constant;
use super::sketch::freedoms;
use crate::ast::Model;
use crate::skeleton::{Member, Point, Skeleton};
use proc_macro2::TokenStream;
use quote::{format_ident, quote_spanned};

/// `Model::conn_b`, `Model::planar_beam_1`: a value per label.
pub(super) fn points(model: &Model, skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let name = &model.parameters.ident;
    let points = skeleton.points.iter().map(|point| of_point(model, point, names));
    let members =
        skeleton.members.iter().enumerate().filter_map(|(index, member)| of_member(model, index, member, names));
    quote_spanned! {names.here=>
        /// The labels of the sketch: points and members, as results about motions take them.
        #[allow(dead_code, non_upper_case_globals)]
        impl #name {
            #(#points)*
            #(#members)*
        }
    }
}

fn of_point(model: &Model, point: &Point<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let Point { connection, node, place, .. } = point;
    let (constant, doc) = (constant("conn", &connection.label, names), format!(" `{connection}`"));
    let freedoms = freedoms(point.freedoms, names);
    quote_spanned! {names.here=>
        #[doc = #doc]
        #visibility const #constant: #private::PlanePoint<#name> = #private::PlanePoint::tied(#node, #place, #freedoms);
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
