//! Emits the plan as a constant, its size, and the checks that only types can make.

use super::Names;
use crate::diagnostics::Place;
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote_spanned};

/// `LAYOUT`, `N`, and one constant per check at the user's token.
pub(super) fn layout(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system, .. } = names;
    let steps = plan.steps.iter().map(|step| emit_step(step, plan, names));
    // where the macro knows all states, `check` has compared them
    let unknown = if plan.has_own_types() { &*plan.steps } else { &[] };
    let checks = unknown.iter().enumerate().map(|(index, step)| check(index, step.place(), names));
    // where the macro does not know the width the layout does
    let (from_layout, size) = match size(plan) {
        Some(size) => (TokenStream::new(), quote_spanned!(names.here=> #size)),
        None => (quote_spanned!(names.here=> const N: usize = LAYOUT.size();), quote_spanned!(names.here=> N)),
    };
    quote_spanned! {names.here=>
        const LAYOUT: #private::Scheme<'static> = const { &#private::Layout::new([#(#steps),*]) }.scheme();
        #from_layout
        #(#checks)*

        impl #system {
            /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
            pub const N: usize = #size;
        }
    }
}

/// The width of the overall matrix where the macro knows it: a number, which is what documentation shows then.
pub(super) fn size(plan: &Plan<'_>) -> Option<Literal> {
    plan.size().map(Literal::usize_unsuffixed)
}

fn emit_step(step: &Step<'_>, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    match step {
        Step::Tip(keyword) => {
            let support = names.support(keyword);
            quote_spanned!(names.here=> #private::Step::Tip(#support))
        }
        Step::Element { evaluated, input, .. } => {
            let element = plan.elements[*evaluated];
            let span = names.at_element(element);
            let (space_of, kind) =
                (names.function_at("space_of", span), names.element_over(element, &format_ident!("f64")));
            let space = quote_spanned!(span=> #space_of::<#kind>());
            quote_spanned!(names.here=> #private::Step::Element(#input, #space))
        }
        Step::Connection { inputs, .. } => quote_spanned!(names.here=> #private::Step::Connection(&[#(#inputs),*])),
        Step::Root { support: keyword, input } => {
            let support = names.support(keyword);
            quote_spanned!(names.here=> #private::Step::Root(#input, #support))
        }
    }
}

/// A constant that fails at the user's tokens.
fn check(step: usize, place: Place, names: &Names) -> TokenStream {
    let (first, last) = (names.at(place.first), names.at(place.last));
    let (layout, rule) = (Ident::new("LAYOUT", first), Ident::new("check", last));
    quote_spanned!(last=> const _: () = #layout.#rule(#step);)
}
