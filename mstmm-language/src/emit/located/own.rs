//! Emits what only types know of elements of the user's own between points with places: the number of unknowns at once, and checks at their tokens.

use super::super::Names;
use crate::network::{Network, Suspicion};
use crate::skeleton::Skeleton;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};

/// The largest number of unknowns at once: a number where the macro knows it, else the constant of [`own`].
pub(super) fn width(width: Option<usize>, names: &Names) -> TokenStream {
    width.map_or_else(|| quote_spanned!(names.here=> WIDTH), |width| quote_spanned!(names.here=> #width))
}

/// Whether some element is of the user's own.
pub(super) fn has_own(network: &Network<'_>) -> bool {
    network.paths.iter().flat_map(|path| &path.elements).any(|element| element.element.known().is_none())
}

/// `WIDTH`, and one constant per check; nothing for a model of elements of the language alone.
pub(super) fn own(network: &Network<'_>, skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let elements = network.paths.iter().flat_map(|path| &path.elements).map(|element| element.element);
    let own = elements.filter(|element| element.known().is_none()).map(|element| {
        let span = names.at_element(element);
        let [one_motion, has_chart] = ["one_motion", "has_chart"].map(|name| names.function_at(name, span));
        let kind = names.element_over(element, &format_ident!("f64"));
        quote_spanned! {span=>
            const _: () = #one_motion::<#kind>();
            const _: () = #has_chart::<#kind>();
        }
    });
    let suspicions = network.suspicions.iter().map(|suspicion| check(suspicion, names));
    let width = skeleton
        .has_own_motions()
        .then(|| quote_spanned!(names.here=> const WIDTH: ::core::primitive::usize = SKETCH.width(ORDER);));
    quote_spanned!(names.here=> #width #(#own)* #(#suspicions)*)
}

/// A constant that fails at the user's tokens if all elements of a suspicion have the states that are wrong.
fn check(suspicion: &Suspicion<'_>, names: &Names) -> TokenStream {
    let Suspicion { place, message, of } = suspicion;
    let (first, last) = (names.at(place.first), names.at(place.last));
    let states = of.iter().map(|(element, space)| {
        let span = names.at_element(element);
        let [space_of, spaces] = ["space_of", "Space"].map(|name| names.function_at(name, span));
        let kind = names.element_over(element, &format_ident!("f64"));
        let space = Ident::new(if space.is(mstmm_plan::Space::Rotation) { "Rotation" } else { "Translation" }, span);
        quote_spanned!(span=> #space_of::<#kind>().is(#spaces::#space))
    });
    let refuse_if = names.function_at("refuse_if", first);
    let arguments = quote_spanned!(last=> (#(#states)&&*, #message));
    quote_spanned!(last=> const _: () = #refuse_if #arguments;)
}
