//! Emits the formulas of a model over a box of its fields.

use super::Names;
use crate::ast::{Element, Model, Parameter};
use crate::check::Derivatives;
use crate::plan::Plan;
use proc_macro2::TokenStream;
use quote::quote_spanned;
use syn::Expr;

/// `impl Formulas` of a model without places. A rotor has none: its whirls are systems like others.
pub(super) fn of_plan(model: &Model, plan: &Plan<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    if plan.spins() || derivatives.are_none() {
        return TokenStream::new();
    }
    formulas(model, plan.elements.iter().flat_map(|element| of_element(element, derivatives)), derivatives, names)
}

/// A number of a model over a box.
#[derive(Clone, Copy)]
pub(super) struct Formula<'d> {
    value: &'d Expr,
    /// Whether it is a parameter of an element of the user's own.
    is_own: bool,
}

impl<'d> Formula<'d> {
    /// A number of the sketch.
    pub(super) fn of_sketch(value: &'d Expr) -> Self {
        Formula { value, is_own: false }
    }
}

/// The formula of each parameter of an element; none for a parameter that depends on no field.
pub(super) fn of_element<'d>(element: &Element, derivatives: &'d Derivatives) -> Vec<Option<Formula<'d>>> {
    let dependent = derivatives.of(element);
    let formula = |parameter: &Parameter| {
        let own = dependent.iter().find(|(name, _)| *name == parameter.name);
        own.map(|(_, value)| Formula { value, is_own: element.known().is_none() })
    };
    element.parameters().map(formula).collect()
}

/// `impl Formulas`, given the formula of each number in order; none for a number that depends on no field.
pub(super) fn formulas<'d>(
    model: &Model,
    numbers: impl Iterator<Item = Option<Formula<'d>>>,
    derivatives: &Derivatives,
    names: &Names,
) -> TokenStream {
    let Names { private, system, .. } = names;
    let (name, lets, compares) = (&model.parameters.ident, &derivatives.lets, derivatives.compares);
    let variables = model.fields().map(|field| {
        let (name, conditions) = (field.name, field.conditions);
        let plain = quote_spanned!(names.here=> self.#name);
        let value = if field.has_derivative { quote_spanned!(names.here=> chain.variable()) } else { plain };
        quote_spanned!(names.here=> #(#conditions)* let #name = #value;)
    });
    let values = model.fields().filter(|field| field.has_derivative).map(|field| {
        let (name, conditions) = (field.name, field.conditions);
        quote_spanned!(names.here=> #(#conditions)* self.#name)
    });
    let numbers: Vec<_> = numbers.enumerate().filter_map(|(place, formula)| Some((place, formula?))).collect();
    let takes = numbers.iter().map(|(place, Formula { value, .. })| {
        quote_spanned!(names.here=> let number = #value; take(#place, number.value, &number.partials);)
    });
    let is_own = of_own_elements(&numbers, names);
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl #private::Formulas for #name {
            type Built = #system;
            const COMPARES: ::core::primitive::bool = #compares;
            #is_own

            #[inline]
            fn values(&self) -> <#system as #private::Fields>::PerField<::core::primitive::f64> {
                [#(#values),*]
            }

            #[inline]
            fn built(
                &self,
                numbers: &Self::Numbers,
            ) -> ::core::result::Result<#system, #private::ParameterError> {
                #private::Build::build_of(self, numbers)
            }

            #[inline]
            #[allow(unused_braces)]
            fn enclose(
                &self,
                fields: &<#system as #private::Fields>::PerField<#private::Interval>,
                take: &mut dyn ::core::ops::FnMut(
                    ::core::primitive::usize,
                    #private::Interval,
                    &[#private::Interval],
                ),
            ) {
                let mut chain = #private::Enclosing::new(fields);
                #(#variables)*
                #(#lets)*
                #(#takes)*
            }
        }
    }
}

/// What tells the numbers that are parameters of elements of the user's own; nothing, where there are none.
fn of_own_elements(numbers: &[(usize, Formula<'_>)], names: &Names) -> Option<TokenStream> {
    let own: Vec<_> = numbers.iter().filter(|(_, formula)| formula.is_own).map(|(place, _)| *place).collect();
    (!own.is_empty()).then(|| {
        quote_spanned! {names.here=>
            fn is_of_own_element(place: ::core::primitive::usize) -> ::core::primitive::bool {
                ::core::matches!(place, #(#own)|*)
            }
        }
    })
}
