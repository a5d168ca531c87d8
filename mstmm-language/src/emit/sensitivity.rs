//! Emits the derivatives with respect to the fields of the model: the chain rule from the parameters of elements.

use super::{Names, element_field, first_of_each_type, implement};
use crate::ast::{Element, Field, Model};
use crate::check::Derivatives;
use crate::plan::Plan;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};
use syn::Index;

/// `impl Fields` and `impl Chain<S>`.
pub(super) fn sensitivity(model: &Model, plan: &Plan<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    let fields = fields(model, names);
    let chain = chain(model, plan, derivatives, names);
    quote_spanned!(names.here=> #fields #chain)
}

/// Whether a parameter depends on a field: then the built system keeps the values of the fields.
pub(super) fn keeps_fields(plan: &Plan<'_>, derivatives: &Derivatives) -> bool {
    plan.elements.iter().any(|element| !derivatives.of(element).is_empty())
}

/// Member of the built system that holds the value of a field.
pub(super) fn member(field: &Field<'_>, names: &Names) -> Ident {
    format_ident!("field_{}", field.name, span = names.here)
}

/// `impl Fields`: the names of the fields that have derivatives.
pub(super) fn fields(model: &Model, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let with_derivative = || model.fields().filter(|field| field.has_derivative);
    let texts = with_derivative().map(|Field { name, conditions, .. }| {
        let text = syn::ext::IdentExt::unraw(name).to_string();
        quote_spanned!(names.here=> #(#conditions)* #text)
    });
    let units = with_derivative().map(|field| {
        let conditions = field.conditions;
        quote_spanned!(names.here=> #(#conditions)* ())
    });
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::NamedFields for #system<#parameter> {
            const NAMES: &'static [&'static ::core::primitive::str] = &[#(#texts),*];
        }

        #[automatically_derived]
        impl<#parameter: #private::Real> #private::Fields for #system<#parameter> {
            type PerField<V: ::core::marker::Copy + ::core::fmt::Debug> = [V; <[()]>::len(&[#(#units),*])];

            fn per_field<V: ::core::marker::Copy + ::core::fmt::Debug>(value: V) -> Self::PerField<V> {
                [value; _]
            }
        }
    }
}

/// `impl Chain<S>`: fields become variables, and the formulas of the model parameters with derivatives.
fn chain(model: &Model, plan: &Plan<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let mut body = TokenStream::new();
    if keeps_fields(plan, derivatives) {
        let variables = variables(model, names);
        let lets = &derivatives.lets;
        let elements = (0..plan.elements.len()).map(|index| summand(index, plan, derivatives, names));
        body = quote_spanned!(names.here=> #(#variables)* #(#lets)* #(#elements)*);
    }
    let body = quote_spanned! {names.here=>
        fn chain(
            &self,
            ends: impl ::core::ops::Fn(::core::primitive::usize) -> #private::Ends<#frequency>,
        ) -> Self::PerField<#frequency> {
            let zeros = <Self as #private::Fields>::per_field(#private::Scalar::from_f64(0.0));
            let mut chain = #private::ChainRule::new(zeros);
            #body
            chain.finish()
        }
    };
    let elements = first_of_each_type(plan, names).into_iter().map(|element| bound(element, names)).collect();
    implement("Chain", "Real", elements, &body, names)
}

/// Makes variables of the fields, in their order: `let length = chain.variable(self.field_length);`.
pub(super) fn variables<'m>(model: &'m Model, names: &'m Names) -> impl Iterator<Item = TokenStream> + 'm {
    model.fields().map(|field| {
        let (member, name, conditions) = (member(&field, names), field.name, &field.conditions);
        let value = quote_spanned!(names.here=> self.#member);
        let value = if field.has_derivative { quote_spanned!(names.here=> chain.variable(#value)) } else { value };
        quote_spanned!(names.here=> #(#conditions)* let #name = #value;)
    })
}

/// `Type<T>: Energies<S, Gradient = Type<S>>`
fn bound(element: &Element, names: &Names) -> TokenStream {
    let span = names.at_element(element);
    let (kind, gradient) = (names.element(element), names.element_over(element, &names.frequency));
    let motion = names.trait_with("Energies", span, &quote_spanned!(span=> Gradient = #gradient));
    quote_spanned!(span=> #kind: #motion)
}

/// What an element adds, as often as it stands in the sketch.
fn summand(index: usize, plan: &Plan<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    let element = plan.elements[index];
    let parameters = derivatives.of(element);
    if parameters.is_empty() {
        return TokenStream::new();
    }
    let steps = plan.steps_of(index);
    let (field, motion) = (element_field(element, names), names.element_as(element, "Energies"));
    let (parameters, values): (Vec<_>, Vec<_>) =
        parameters.iter().map(|(name, value)| (names.field_of(element, name), *value)).unzip();
    let order = (0..values.len()).map(Index::from);
    quote_spanned! {names.here=>
        let values = (#(#values,)*);
        for step in [#(#steps),*] {
            let gradient = #motion::gradient(&self.#field, &ends(step));
            #(chain.add(gradient.#parameters, values.#order);)*
        }
    }
}
