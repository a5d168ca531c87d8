//! Emits the skeleton as a constant, and the order of its nodes.

use super::super::Names;
use crate::keywords::Dimension;
use crate::network::FreedomSet;
use crate::skeleton::{Axis, Direction, End, Member, Node, Plane, Point, Seat, Skeleton, Skew, Support, Up};
use mstmm_plan::Freedoms;
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote_spanned};

/// `SKETCH` and `ORDER`.
pub(super) fn sketch(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let places = skeleton.places.iter().map(|place| &place.name);
    let directions = skeleton.directions.iter().map(|Direction { name, word, .. }| {
        quote_spanned!(names.here=> #private::SketchedDirection { name: #name, word: #word })
    });
    let is_in_space = skeleton.dimension == Dimension::Space;
    let bodies = skeleton.bodies.iter().map(|body| {
        let (name, node) = (body.element.to_string(), body.node);
        quote_spanned!(names.here=> #private::SketchedBody { name: #name, node: #node })
    });
    let points = skeleton.points.iter().map(|point| sketched_point(point, names));
    let supports = skeleton.supports.iter().map(|support| sketched_support(support, skeleton, names));
    let nodes = skeleton.nodes.iter().map(|node| sketched_node(node, names));
    let members = skeleton.members.iter().map(|member| sketched_member(member, names));
    let (node_count, member_count) = (skeleton.nodes.len(), skeleton.members.len());
    quote_spanned! {names.here=>
        const SKETCH: #private::NetworkSketch<#node_count, #member_count> = #private::NetworkSketch {
            is_in_space: #is_in_space,
            places: &[#(#places),*],
            directions: &[#(#directions),*],
            bodies: &[#(#bodies),*],
            points: &[#(#points),*],
            supports: &[#(#supports),*],
            nodes: [#(#nodes),*],
            members: [#(#members),*],
        };
        #[allow(long_running_const_eval)]
        const ORDER: &#private::OrderRoom<#node_count, #member_count> = &#private::OrderRoom::of(SKETCH.pairs());
    }
}

fn sketched_point(point: &Point<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let Point { name, node, place, .. } = point;
    let freedoms = freedom_set(&point.freedoms, names);
    quote_spanned! {names.here=>
        #private::SketchedPoint { name: #name, node: #node, place: #place, freedoms: #freedoms }
    }
}

fn sketched_support(support: &Support, skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let Support { name, point, node, .. } = support;
    let (mut held, skew) = (freedoms(support.held, names), skew(support.skew, names));
    let of_point = &skeleton.points[*point].freedoms;
    if of_point.as_known().is_none() {
        let of_point = freedom_set(of_point, names);
        held = quote_spanned!(names.here=> #held.intersection(#of_point));
    }
    quote_spanned! {names.here=>
        #private::SketchedSupport { name: #name, point: #point, node: #node, held: #held, skew: #skew }
    }
}

fn sketched_node(node: &Node<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let (place, skew) = (option(node.place, names), skew(node.skew, names));
    let own = freedom_set(&node.freedoms, names);
    let held = match node.known() {
        Some([_, held]) => freedoms(held, names),
        None => {
            let [held, all, turns] = [node.held, node.all, Freedoms::ROTATIONS].map(|set| freedoms(set, names));
            let turns = node.skew.map(|_| quote_spanned!(names.here=> .intersection(#turns)));
            quote_spanned!(names.here=> #held.union(#all.without(#own))#turns)
        }
    };
    quote_spanned! {names.here=>
        #private::SketchedNode { place: #place, freedoms: #own, held: #held, skew: #skew }
    }
}

fn sketched_member(member: &Member<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let (name, kind) = (&member.name, option(member.kind.as_ref(), names));
    let freedoms = freedom_set(&member.freedoms, names);
    let released = self::freedoms(member.released(), names);
    let ends = member.ends.iter().map(|end| sketched_end(end, names));
    let (plane, is_further) = (sketched_plane(member.plane, names), member.is_further);
    quote_spanned! {names.here=>
        #private::SketchedMember {
            name: #name, kind: #kind, freedoms: #freedoms, released: #released,
            plane: #private::SketchedPlane::#plane, is_further: #is_further, ends: [#(#ends),*]
        }
    }
}

fn sketched_plane(plane: Plane, names: &Names) -> TokenStream {
    let private = &names.private;
    let up = |up: Up| match up {
        Up::Named(direction) => quote_spanned!(names.here=> #private::SketchedUp::Named(#direction)),
        Up::Z => quote_spanned!(names.here=> #private::SketchedUp::Z),
        Up::Any => quote_spanned!(names.here=> #private::SketchedUp::Any),
    };
    match plane {
        Plane::Structure => quote_spanned!(names.here=> Structure),
        Plane::First(own) => {
            let up = up(own);
            quote_spanned!(names.here=> First(#up))
        }
        Plane::Second(own) => {
            let up = up(own);
            quote_spanned!(names.here=> Second(#up))
        }
        Plane::Twist => quote_spanned!(names.here=> Twist),
        Plane::OneMotion => quote_spanned!(names.here=> OneMotion),
    }
}

fn skew(skew: Option<Skew>, names: &Names) -> TokenStream {
    let private = &names.private;
    let skew = skew.map(|Skew { direction, is_normal }| {
        let way = proc_macro2::Ident::new(if is_normal { "Normal" } else { "Along" }, names.here);
        quote_spanned!(names.here=> #private::SketchedSkew::#way(#direction))
    });
    option(skew, names)
}

fn sketched_end(end: &End, names: &Names) -> TokenStream {
    let private = &names.private;
    let seat = match end.seat {
        Seat::Point(point) => quote_spanned!(names.here=> Point(#point)),
        Seat::Node(node) => quote_spanned!(names.here=> Node(#node)),
    };
    let axis = match end.axis {
        Axis::Member => quote_spanned!(names.here=> Member),
        Axis::X => quote_spanned!(names.here=> X),
        Axis::Y => quote_spanned!(names.here=> Y),
        Axis::Along(direction) => quote_spanned!(names.here=> Along(#direction)),
        Axis::FromTo([from, to]) => quote_spanned!(names.here=> FromTo(#from, #to)),
    };
    quote_spanned!(names.here=> #private::SketchedEnd { seat: #private::Seat::#seat, axis: #private::Axis::#axis })
}

fn option(value: Option<impl ToTokens>, names: &Names) -> TokenStream {
    match value {
        Some(value) => quote_spanned!(names.here=> ::core::option::Option::Some(#value)),
        None => quote_spanned!(names.here=> ::core::option::Option::None),
    }
}

/// A set of freedoms; those of elements of the user's own are a constant of their types.
pub(super) fn freedom_set(set: &FreedomSet<'_>, names: &Names) -> TokenStream {
    let mut sum = freedoms(set.known, names);
    let own = if set.as_known().is_some() { &[][..] } else { &set.own };
    let within = freedoms(set.within, names);
    for element in own {
        let span = names.at_element(element);
        let (brought, kind) = (names.function_at("brought", span), names.element_over(element, &format_ident!("f64")));
        sum.extend(quote_spanned!(span=> .union(#brought::<#kind>().intersection(#within))));
    }
    sum
}

/// A set of known freedoms.
fn freedoms(set: Freedoms, names: &Names) -> TokenStream {
    let private = &names.private;
    for (all, name) in [(Freedoms::PLANE, "PLANE"), (Freedoms::SPACE, "SPACE")] {
        if set == all {
            let name = proc_macro2::Ident::new(name, names.here);
            return quote_spanned!(names.here=> #private::Freedoms::#name);
        }
    }
    let mut sum = quote_spanned!(names.here=> #private::Freedoms::NONE);
    for (freedom, name) in Freedoms::EACH.into_iter().zip(["X", "Y", "RZ", "Z", "RX", "RY"]) {
        if set.contains(freedom) {
            let name = proc_macro2::Ident::new(name, names.here);
            sum.extend(quote_spanned!(names.here=> .union(#private::Freedoms::#name)));
        }
    }
    sum
}
