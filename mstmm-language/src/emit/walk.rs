//! Emits the walk through the steps of a system.

use super::{Names, bounds, element_field, first_of_each_type, implement};
use crate::ast::Element;
use crate::plan::{Plan, Step};
use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

/// `impl Walk<S>`: a call per step, in the order of the plan.
pub(super) fn walk(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, counter: walker, .. } = names;
    let mut open = Vec::new();
    let steps = plan.steps.iter().enumerate().map(|(index, step)| {
        let call = match step {
            Step::Tip(keyword) => {
                let support = names.support(keyword);
                quote_spanned!(names.here=> walker.tip(#support, const { LAYOUT.space(#index) });)
            }
            Step::Element { evaluated, input, .. } => {
                open.retain(|path| path != input);
                let element = plan.elements[*evaluated];
                let (field, kind) = (element_field(element, names), names.element(element));
                quote_spanned!(names.here=> walker.element::<#kind>(&self.#field);)
            }
            Step::Connection { inputs, .. } => {
                let places = inputs.iter().filter_map(|input| open.iter().rev().position(|path| path == input));
                let places: Vec<Literal> = places.map(Literal::usize_unsuffixed).collect();
                open.retain(|path| !inputs.contains(path));
                quote_spanned!(names.here=> walker.connection(&[#(#places),*], const { LAYOUT.output(#index) });)
            }
            Step::Root { support, .. } => {
                let support = names.support(support);
                quote_spanned!(names.here=> walker.root(#support);)
            }
        };
        open.push(index);
        call
    });
    let steps: TokenStream = steps.collect();
    let body = quote_spanned! {names.here=>
        fn walk<#walker: #private::Walker<#frequency>>(&self, walker: &mut #walker) {
            #steps
        }
    };
    implement("Walk", [bounds("PlaneStep", plan, names), straight_bounds(plan, names)].concat(), &body, names)
}

/// What blocks of frequencies ask of the elements besides: steps over numbers of straight-line code.
pub(super) fn straight_bounds(plan: &Plan<'_>, names: &Names) -> Vec<TokenStream> {
    let bounds = |series: bool| {
        let bound = move |element: &Element| {
            let span = names.at_element(element);
            let (kind, private, frequency) = (names.element(element), &names.private, &names.frequency);
            quote_spanned!(span=> #kind: #private::PlaneStep<#private::BranchFree<#frequency, #series>>)
        };
        first_of_each_type(plan, names).into_iter().map(bound)
    };
    bounds(false).chain(bounds(true)).collect()
}
