//! Emits that a built system can be searched, as far as the macro knows.

use super::Names;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Undamped` and `impl Spectrum`. What elements lack for them, such as a real frequency where something is damped, rustc says.
pub(super) fn searched(names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter> #private::search::Undamped for #system<#parameter>
        where
            #parameter: #private::Real + #private::InLanes,
            Self: #private::search::RealPasses,
        {
        }

        #[automatically_derived]
        impl<#parameter: #private::Real> #private::search::Spectrum for #system<#parameter>
        where
            Self: #private::search::ComplexPasses,
        {
        }
    }
}
