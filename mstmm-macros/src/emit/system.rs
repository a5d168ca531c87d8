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
        quote!(#field: #kind<T>)
    });
    let bindings = model.parameters.fields.iter().filter_map(|field| field.ident.as_ref());
    let lets = &model.lets;
    let values = plan.elements.iter().map(|element| value(element, names));
    let validations = plan.elements.iter().map(|element| {
        let (field, name) = (field(element), element.to_string());
        quote!(#private::validate(&system.#field, #name)?;)
    });
    let system_doc =
        format!("The system of a [`{parameters}`], built: evaluate it at a frequency, or search its frequencies.");
    quote! {
        #[doc = #system_doc]
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #system<T = f64> {
            #(#fields,)*
        }

        impl #parameters {
            /// Validates all parameters and builds the system.
            ///
            /// # Errors
            /// The error names the first element with a parameter out of its range, the parameter and its value.
            #visibility fn build(&self) -> ::core::result::Result<#system, #private::ParameterError> {
                let Self { #(#bindings),* } = *self;
                #(#lets)*
                let system = #system { #(#values,)* };
                #(#validations)*
                ::core::result::Result::Ok(system)
            }
        }
    }
}

/// `field: Type { parameter: expression, .. }`.
fn value(element: &Element, names: &Names) -> TokenStream {
    let (field, kind) = (field(element), names.element_type(element));
    let parameters = element.parameters.iter().map(|parameter| {
        let name = &parameter.name;
        match &parameter.value {
            None => quote!(#name),
            Some(value) => quote_spanned!(name.span()=> #name: #value),
        }
    });
    quote!(#field: #kind { #(#parameters),* })
}
