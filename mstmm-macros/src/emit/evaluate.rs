//! Emits the evaluation of the overall matrix and its determinant.

use super::{Names, field};
use crate::ast::Element;
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// `impl Evaluate<S>`: the overall matrix and its determinant, a line per step.
pub(super) fn evaluate(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system } = names;
    let bounds = bounds(plan, names, &quote!(TransferMatrix));
    let matrices = plan.elements.iter().map(|element| {
        let (matrix, field, kind) = (local("u", element), field(element), names.element_type(element));
        quote!(let #matrix = <#kind<T> as #private::TransferMatrix<S>>::transfer_matrix(&self.#field, x);)
    });
    let steps = plan.steps.iter().enumerate().filter_map(|(index, step)| match step {
        Step::Element { element, .. } => {
            let element = plan.elements[*element];
            let (matrix, kind) = (local("u", element), names.element_type(element));
            Some(quote!(equation.element::<#kind<T>>(#index, &#matrix);))
        }
        Step::Connection { .. } => Some(quote!(equation.connection(#index);)),
        Step::Tip(_) | Step::Root { .. } => None,
    });
    let denominators = plan.steps.iter().filter_map(|step| {
        let Step::Element { element, .. } = step else { return None };
        let (field, kind) = (field(plan.elements[*element]), names.element_type(plan.elements[*element]));
        Some(quote!(let determinant = #private::without_pole::<#kind<T>, S>(determinant, &self.#field, x);))
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

/// `impl Characteristic<S>`: one pass of the plane method, a line per step.
pub(super) fn characteristic(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system } = names;
    let bounds = bounds(plan, names, &quote!(PlaneStep));
    let kinds = kinds(plan, names);
    let waves = kinds.values().map(|kind| quote!(<#kind<T> as #private::PlaneStep<S>>::WAVES));
    let coefficients = plan.elements.iter().map(|element| {
        let (coefficients, field, kind) = (local("k", element), field(element), names.element_type(element));
        quote!(let #coefficients = <#kind<T> as #private::PlaneStep<S>>::coefficients(&self.#field, &at);)
    });
    let steps = plan.steps.iter().enumerate().map(|(index, step)| pass_step(index, step, plan, names));
    quote! {
        #[automatically_derived]
        impl<T, S> #private::Characteristic<S> for #system<T>
        where
            T: #private::Real,
            S: #private::Frequency<T>,
            #bounds
        {
            fn pass<C: #private::Tally<S>>(&self, x: S, tally: &mut C) -> #private::Scaled<S> {
                let at = #private::At::new(x, false #(|| #waves)*);
                #(#coefficients)*
                #(#steps)*
            }
        }
    }
}

/// One step of the pass: `let s3 = ..`, or at the end Δ.
fn pass_step(index: usize, step: &Step<'_>, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let subspace = |index: &usize| format_ident!("s{}", index, span = Span::mixed_site());
    let own = subspace(&index);
    match step {
        Step::Tip(_) if plan.holds_connection(index) => TokenStream::new(),
        Step::Tip(keyword) => {
            let support = super::layout::support(keyword, names);
            quote!(let #own = #private::Subspace::Tip(#support, const { LAYOUT.space(#index) });)
        }
        // the last element ends in the root
        Step::Element { .. } if index + 2 == plan.steps.len() => TokenStream::new(),
        Step::Element { element, input, .. } => {
            let element = plan.elements[*element];
            let (coefficients, kind, input) = (local("k", element), names.element_type(element), subspace(input));
            if plan.is_short() {
                quote!(let #own = <#kind<T> as #private::PlaneStep<S>>::step(&#coefficients, #input, tally);)
            } else {
                quote!(let #own = #private::called_step::<#kind<T>, S, C>(&#coefficients, #input, tally);)
            }
        }
        Step::Connection { inputs, .. } => {
            let is_tip = |input: &&usize| matches!(plan.steps[**input], Step::Tip(_));
            let paths = inputs.iter().filter(|input| !is_tip(input)).map(subspace);
            let joined =
                paths.enumerate().map(|(rank, path)| (rank, quote!(#path))).reduce(|(_, sum), (rank, path)| {
                    let sum = if rank > 1 { quote!(#private::moderated(#sum)) } else { sum };
                    (rank, quote!(#private::joined(#sum, #path)))
                });
            let joined = joined.map(|(_, joined)| joined);
            let held = inputs.iter().filter_map(|&input| match plan.steps[input] {
                Step::Tip(keyword) => Some(super::layout::support(keyword, names)),
                _ => None,
            });
            quote! {
                let #own = #private::widened(#joined, const { LAYOUT.output(#index) });
                #(let #own = #private::held(#own, #held);)*
                let #own = #private::narrowed(#own, const { LAYOUT.output(#index) }, tally);
            }
        }
        Step::Root { support: keyword, input } => {
            let support = super::layout::support(keyword, names);
            match &plan.steps[*input] {
                Step::Element { element, input, .. } => {
                    let element = plan.elements[*element];
                    let (coefficients, kind, input) =
                        (local("k", element), names.element_type(element), subspace(input));
                    quote!(<#kind<T> as #private::PlaneStep<S>>::root(&#coefficients, #input, #support, tally))
                }
                _ => {
                    let input = subspace(input);
                    quote!(#input.at_root(#support, tally))
                }
            }
        }
    }
}

/// The types of elements that occur, in a fixed order.
fn kinds(plan: &Plan<'_>, names: &Names) -> BTreeMap<String, TokenStream> {
    let kinds = plan.elements.iter().map(|element| names.element_type(element));
    kinds.map(|kind| (kind.to_string(), kind)).collect()
}

/// Each type of element must have a trait: where one has not, rustc says so at its keyword.
fn bounds(plan: &Plan<'_>, names: &Names, bound: &TokenStream) -> TokenStream {
    let private = &names.private;
    let kinds = kinds(plan, names);
    let bounds = kinds.values().map(|kind| quote!(#kind<T>: #private::#bound<S>));
    quote!(#(#bounds),*)
}

/// A local variable for an element.
fn local(prefix: &str, element: &Element) -> Ident {
    format_ident!("{}_{}", prefix, element.label.to_string(), span = Span::mixed_site())
}
