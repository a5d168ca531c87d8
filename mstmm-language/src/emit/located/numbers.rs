//! Emits the numbers of a model with locations: coordinates, directions, masses, parameters.

use super::super::Names;
use super::super::system::{number, number_of};
use crate::ast::{Element, Parameter, place_of, tuple_parts};
use crate::keywords::Dimension;
use crate::skeleton::{Body, Skeleton, What};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote_spanned};
use syn::Expr;
use syn::ext::IdentExt;

/// The numbers in the order of the core's sketch, then the parameters of members.
pub(super) fn numbers(skeleton: &Skeleton<'_>, names: &Names) -> Vec<TokenStream> {
    let of_sketch = geometry(skeleton).map(|entry| match entry {
        Some(Number::Part(part)) => coordinate(part, names),
        Some(Number::Parameter(parameter)) => number(parameter, names),
        None => zero(names),
    });
    let of_members = skeleton.members.iter().flat_map(|member| member_parameters(member.what));
    of_sketch.chain(of_members.map(|parameter| number(parameter, names))).collect()
}

/// The parameters of what stands between two points.
pub(super) fn member_parameters<'a>(what: What<'a>) -> impl Iterator<Item = &'a Parameter> {
    what.element().into_iter().flat_map(Element::parameters)
}

/// A number of a sketch: a part of a place or a direction, or a parameter of a mass.
pub(super) enum Number<'s> {
    Part(&'s Expr),
    Parameter(&'s Parameter),
}

/// The numbers of places, directions and masses in the order of the core's sketch; none for what the model does not say, which is zero.
pub(super) fn geometry<'s>(skeleton: &'s Skeleton<'_>) -> impl Iterator<Item = Option<Number<'s>>> {
    let is_in_space = skeleton.dimension == Dimension::Space;
    let vector = move |parts: &'s [Expr]| (0..if is_in_space { 3 } else { 2 }).map(|k| parts.get(k).map(Number::Part));
    let (places, directions) = (skeleton.places.iter(), skeleton.directions.iter());
    let vectors = places.map(|place| &place.parts).chain(directions.map(|direction| &direction.parts));
    let bodies = skeleton.bodies.iter().flat_map(move |body| {
        let mass = named(body.element, "mass").map(Number::Parameter);
        let inertia =
            if is_in_space { entries(body) } else { vec![named(body.element, "inertia").map(Number::Parameter)] };
        [mass].into_iter().chain(inertia).chain(vector(&body.centre))
    });
    vectors.flat_map(move |parts| vector(parts)).chain(bodies)
}

/// How many numbers stand in front of the parameters of members.
pub(super) fn count(skeleton: &Skeleton<'_>) -> usize {
    geometry(skeleton).count()
}

/// The entries xx, yy, zz, xy, yz and zx of the inertia of a body in space; of one on a path that about z, about which its motion turns.
fn entries<'s>(body: &'s Body<'_>) -> Vec<Option<Number<'s>>> {
    let inertia = named(body.element, "inertia");
    let parts = inertia.and_then(|inertia| inertia.value.as_ref()).and_then(tuple_parts);
    match parts {
        Some(parts) => (0..ENTRIES).map(|entry| parts.get(entry).copied().map(Number::Part)).collect(),
        None => (0..ENTRIES).map(|entry| inertia.filter(|_| entry == ABOUT_Z).map(Number::Parameter)).collect(),
    }
}

/// The number of entries of a tensor, and the place of the one about z.
const ENTRIES: usize = 6;
const ABOUT_Z: usize = 2;

/// A coordinate as a number.
fn coordinate(value: &Expr, names: &Names) -> TokenStream {
    let span = place_of(value).first;
    number_of(&value.to_token_stream(), span, names.at(span))
}

/// A parameter of an element by its name.
fn named<'s>(element: &'s Element, name: &str) -> Option<&'s Parameter> {
    element.parameters().find(|parameter| parameter.name.unraw() == name)
}

fn zero(names: &Names) -> TokenStream {
    quote_spanned!(names.here=> 0.0)
}
