//! Emits the built system and `build()`.

use super::{Names, field};
use crate::ast::{Element, Model};
use crate::plan::Plan;
use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};

/// The struct of elements and the function that makes it from the parameters.
pub(super) fn system(model: &Model, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system } = names;
    let (visibility, parameters) = (&model.parameters.vis, &model.parameters.ident);
    let fields = plan.elements.iter().map(|element| {
        let (field, kind) = (field(element), names.element_type(element));
        quote!(#field: <#kind<T> as #private::Element>::Built)
    });
    let bindings = model.parameters.fields.iter().filter_map(|field| field.ident.as_ref());
    let lets = &model.lets;
    let values = plan.elements.iter().map(|element| value(element, names));
    let bounds = plan.elements.iter().map(|element| {
        let (field, kind) = (field(element), names.element_type(element));
        quote!(<#kind<T> as #private::Element>::bound(&self.#field, &mut bounds);)
    });
    let system_doc =
        format!("The system of a [`{parameters}`], built: evaluate it at a frequency, or search its frequencies.");
    quote! {
        #[doc = #system_doc]
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #system<T: #private::Real = f64> {
            #(#fields,)*
        }

        impl #parameters {
            /// Validates all parameters and builds the system.
            ///
            /// # Errors
            /// The error names the first element with a parameter out of its range, the parameter and its value.
            #visibility fn build(&self) -> ::core::result::Result<#system, #private::ParameterError> {
                self.build_as()
            }

            /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
            ///
            /// # Errors
            /// As `build`.
            #visibility fn build_as<T: #private::Real>(
                &self,
            ) -> ::core::result::Result<#system<T>, #private::ParameterError> {
                let Self { #(#bindings),* } = *self;
                #(#lets)*
                ::core::result::Result::Ok(#system { #(#values,)* })
            }
        }

        #[automatically_derived]
        impl<T: #private::Real> #private::System for #system<T> {
            type Parameter = T;

            fn bounds(&self) -> #private::FrequencyBounds {
                let mut bounds = ::core::default::Default::default();
                #(#bounds)*
                bounds
            }
        }
    }
}

/// The built element, `field: build(Type { parameter: expression, .. }, name)?`.
fn value(element: &Element, names: &Names) -> TokenStream {
    let private = &names.private;
    let (field, kind, name) = (field(element), names.element_type(element), element.to_string());
    let parameters = element.parameters.iter().map(|parameter| {
        let name = &parameter.name;
        let value = match &parameter.value {
            None => quote!(#name),
            Some(value) => quote!(#value),
        };
        quote_spanned!(name.span()=> #name: #private::Scalar::from_f64(#value))
    });
    quote!(#field: #private::build(#kind::<T> { #(#parameters),* }, #name)?)
}
