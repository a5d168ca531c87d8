//! Emits the evaluation of the overall matrix and its determinant.

use super::{Names, field};
use crate::ast::Element;
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// `impl Evaluate<S>`: a line per step.
pub(super) fn evaluate(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system } = names;
    let bounds = bounds(plan, names);
    let matrices = plan.elements.iter().map(|element| {
        let (matrix, field) = (matrix(element), field(element));
        quote!(let #matrix = #private::TransferMatrix::transfer_matrix(&self.#field, x);)
    });
    let steps = plan.steps.iter().enumerate().filter_map(|(index, step)| match step {
        Step::Element { element, .. } => {
            let element = plan.elements[*element];
            let (matrix, kind) = (matrix(element), names.element_type(element));
            Some(quote!(equation.element::<#kind<T>>(#index, &#matrix);))
        }
        Step::Connection { .. } => Some(quote!(equation.connection(#index);)),
        Step::Tip(_) | Step::Root { .. } => None,
    });
    let denominators = plan.steps.iter().filter_map(|step| {
        let Step::Element { element, .. } = step else { return None };
        let field = field(plan.elements[*element]);
        Some(quote!(let determinant = #private::without_pole(determinant, &self.#field, x);))
    });
    quote! {
        #[automatically_derived]
        impl<T, S> #private::Evaluate<S> for #system<T>
        where
            T: #private::Real,
            S: #private::Frequency<T>,
            #bounds
        {
            type Matrix = #private::SMatrix<S, N, N>;

            fn overall_matrix(&self, x: S) -> Self::Matrix {
                #(#matrices)*
                let mut equation = #private::Assembly::new(&LAYOUT);
                #(#steps)*
                equation.finish()
            }

            fn overall_determinant(&self, x: S) -> #private::Scaled<S> {
                let determinant = #private::determinant(#private::Evaluate::overall_matrix(self, x));
                #(#denominators)*
                determinant
            }
        }
    }
}

/// Each type of element can be evaluated: where one cannot, rustc says so at its keyword.
fn bounds(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let kinds: BTreeMap<String, TokenStream> =
        plan.elements.iter().map(|element| names.element_type(element)).map(|kind| (kind.to_string(), kind)).collect();
    let bounds = kinds.values().map(|kind| quote!(#kind<T>: #private::TransferMatrix<S>));
    quote!(#(#bounds),*)
}

fn matrix(element: &Element) -> Ident {
    format_ident!("u_{}", element.label.to_string(), span = Span::call_site())
}
