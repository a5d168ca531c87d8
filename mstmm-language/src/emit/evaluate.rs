//! Emits the evaluation of the overall matrix and its determinant.

use super::layout::size;
use super::{Names, bounds, element_field, implement, local};
use crate::plan::{Plan, Step};
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Evaluate<S>`: the overall matrix and its determinant, a line per step.
pub(super) fn evaluate(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let matrices = plan.elements.iter().map(|element| {
        let (matrix, field, kind) =
            (local("u", element, names), element_field(element, names), names.element_as(element, "TransferMatrix"));
        quote_spanned!(names.here=> let #matrix = #kind::transfer_matrix(&self.#field, x);)
    });
    let steps = plan.steps.iter().enumerate().filter_map(|(index, step)| match step {
        Step::Element { evaluated, .. } => {
            let element = plan.elements[*evaluated];
            let (matrix, kind) = (local("u", element, names), names.element(element));
            Some(quote_spanned!(names.here=> equation.element::<#kind>(#index, &#matrix);))
        }
        Step::Connection { .. } => Some(quote_spanned!(names.here=> equation.connection(#index);)),
        Step::Tip(_) => Some(quote_spanned!(names.here=> equation.tip(#index);)),
        Step::Root { .. } => None,
    });
    let denominators = plan.steps.iter().filter_map(|step| {
        let Step::Element { evaluated, .. } = step else { return None };
        let element = plan.elements[*evaluated];
        let (field, kind) = (element_field(element, names), names.element(element));
        Some(quote_spanned! {names.here=>
            let determinant = #private::without_pole::<#kind, #frequency>(determinant, &self.#field, x);
        })
    });
    let size = match size(plan) {
        Some(size) => quote_spanned!(names.here=> #size),
        // braces, since a type may be called `N` too
        None => quote_spanned!(names.here=> { N }),
    };
    let body = quote_spanned! {names.here=>
        type Matrix = #private::SMatrix<#frequency, #size, #size>;

        fn overall_matrix(&self, x: #frequency) -> Self::Matrix {
            #(#matrices)*
            let mut equation = #private::Assembly::new(&LAYOUT);
            #(#steps)*
            equation.finish()
        }

        fn overall_determinant(&self, x: #frequency) -> #private::Scaled<#frequency> {
            let determinant = #private::determinant(#private::Evaluate::overall_matrix(self, x));
            #(#denominators)*
            determinant
        }
    };
    let mut bounds = bounds("TransferMatrix", plan, names);
    // pivots are chosen for one number at a time
    bounds.push(quote_spanned!(names.here=> #frequency: #private::Single));
    implement("Evaluate", "Real", bounds, &body, names)
}
