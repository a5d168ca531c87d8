//! Emits what a rotor has beside other systems: two whirls.

use super::{Names, element_field};
use crate::plan::Plan;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Spinning`: the system as the other whirl sees it. Nothing, where nothing spins.
pub(super) fn spinning(plan: &Plan<'_>, names: &Names) -> Option<TokenStream> {
    let Names { private, system, parameter, .. } = names;
    let turned = plan.spinning().map(|element| {
        let (span, field, kind) = (names.at_element(element), element_field(element, names), names.element(element));
        let spins = names.function_at("Spins", span);
        quote_spanned!(span=> #field: <#kind as #spins>::turned_round(self.#field))
    });
    let turned: Vec<TokenStream> = turned.collect();
    (!turned.is_empty()).then(|| {
        quote_spanned! {names.here=>
            #[automatically_derived]
            impl<#parameter: #private::Real> #private::Spinning for #system<#parameter> {
                type BuildError = #private::ParameterError;

                fn turned_round(self) -> Self {
                    #system { #(#turned,)* ..self }
                }
            }
        }
    })
}
