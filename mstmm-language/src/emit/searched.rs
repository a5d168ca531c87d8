//! Emits that a built system can be searched, as far as the macro knows.

use super::{Names, element_field};
use crate::plan::Plan;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Undamped` and `impl Spectrum`. What elements lack for them, such as a real frequency where something is damped, rustc says. They need
/// bounds and a function for elements of the user's own.
pub(super) fn searched((bounds, own_part): (TokenStream, TokenStream), names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter> #private::search::Undamped for #system<#parameter>
        where
            #parameter: #private::Real + #private::InLanes,
            Self: #private::search::RealPasses,
            #bounds
        {
            #own_part
        }

        #[automatically_derived]
        impl<#parameter: #private::Real> #private::search::Spectrum for #system<#parameter>
        where
            Self: #private::search::ComplexPasses,
        {
        }
    }
}

/// What elements of the user's own between places are asked for, and the visit of one of them.
pub(super) fn own_member(names: &Names) -> (TokenStream, TokenStream) {
    let Names { private, .. } = names;
    let bounds = quote_spanned!(names.here=> Self: #private::OwnMembers,);
    let body = quote_spanned! {names.here=>
        fn own_part(
            &self,
            member: ::core::primitive::usize,
            omega: [::core::primitive::f64; 2],
        ) -> ::core::option::Option<#private::OwnPart> {
            #private::OwnMembers::own_member(self, member, omega)
        }
    };
    (bounds, body)
}

/// What elements of the user's own in a tree are asked for, and the visit of one of them: for counts without a proof where they tell no numbers.
pub(super) fn own_part(plan: &Plan<'_>, names: &Names) -> (TokenStream, TokenStream) {
    if !plan.has_own_types() {
        return Default::default();
    }
    let Names { private, parameter, .. } = names;
    let own = plan.elements.iter().enumerate().filter(|(_, element)| element.known().is_none());
    let own: Vec<_> = own.collect();
    let extended = quote_spanned!(names.here=> <#parameter as #private::Real>::Extended);
    let bounds = own.iter().map(|(_, element)| {
        let span = names.at_element(element);
        let kind = names.element(element);
        quote_spanned!(span=> #kind: #private::PlaneStep<#extended>,)
    });
    let parts = own.iter().map(|(index, element)| {
        let (steps, field, kind) = (plan.steps_of(*index), element_field(element, names), names.element(element));
        quote_spanned! {names.at_element(element)=>
            #(#steps)|* => #private::own_part::<#kind, #extended>(&self.#field, omega),
        }
    });
    let (index, word) =
        (quote_spanned!(names.here=> ::core::primitive::usize), quote_spanned!(names.here=> ::core::primitive::f64));
    let body = quote_spanned! {names.here=>
        fn own_part(&self, step: #index, omega: [#word; 2]) -> ::core::option::Option<#private::OwnPart> {
            match step {
                #(#parts)*
                _ => ::core::option::Option::None,
            }
        }
    };
    (quote_spanned!(names.here=> #(#bounds)*), body)
}
