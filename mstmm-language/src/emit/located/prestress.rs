//! Emits how the members of a built system take axial forces.

use super::super::Names;
use super::{field, of_members};
use crate::skeleton::Skeleton;
use proc_macro2::TokenStream;
use quote::quote_spanned;

/// `impl Prestressed`. The description of the members is a part of `build()`, too.
pub(super) fn prestressed(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let changed = quote_spanned!(names.here=> &mut);
    let forces = of_members(skeleton, names, &changed, |kind, span| {
        let element = names.trait_at("Element", span);
        quote_spanned!(span=> <#kind as #element>::add_axial_force(built, force))
    });
    let descriptions = skeleton.members.iter().enumerate().map(|(index, member)| {
        let (span, kind) = (member.span(names), member.kind(names));
        let field = field(index, span);
        quote_spanned!(span=> self.skeleton.describe::<#kind>(#index, &self.#field, &mut self.estimates);)
    });
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::Prestressed for #system<#parameter> {
            fn add_axial_force(
                &mut self,
                member: ::core::primitive::usize,
                force: [::core::primitive::f64; 2],
            ) -> ::core::option::Option<::core::result::Result<::core::primitive::bool, #private::InvalidParameter>> {
                #forces
            }

            fn describe(&mut self) {
                self.estimates = ::core::default::Default::default();
                self.skeleton.estimate(&mut self.estimates);
                #(#descriptions)*
                self.estimates.finish();
                self.skeleton.arrange(&ORDER.order());
            }

            fn name_of_member(&self, member: ::core::primitive::usize) -> &'static ::core::primitive::str {
                SKETCH.members[member].name
            }
        }
    }
}
