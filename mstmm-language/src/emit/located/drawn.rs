//! Emits what the sketch of a built system shows.

use super::super::Names;
use crate::ast::Model;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Drawn`: the iterators of the core's sketch, with the numbers of the built system.
pub(super) fn drawn(model: &Model, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let model = &model.parameters.ident;
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::Drawn for #system<#parameter> {
            const IS_IN_SPACE: ::core::primitive::bool = SKETCH.is_in_space;

            fn points(&self) -> impl ::core::iter::Iterator<Item = #private::DrawnPoint<#model, #parameter>> {
                SKETCH.drawn_points(&self.geometry)
            }

            fn members(&self) -> impl ::core::iter::Iterator<Item = #private::DrawnMember<#model, #parameter>> {
                SKETCH.drawn_members(self)
            }

            fn bodies(&self) -> impl ::core::iter::Iterator<Item = #private::DrawnBody<#parameter>> {
                SKETCH.drawn_bodies(&self.geometry)
            }

            fn supports(&self) -> impl ::core::iter::Iterator<Item = #private::DrawnSupport<#parameter>> {
                SKETCH.drawn_supports(&self.geometry)
            }
        }
    }
}
