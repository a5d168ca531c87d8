//! Emits the code of a plan. Nothing is decided here.

mod evaluate;
mod layout;
mod system;

use crate::ast::{Element, Kind, Model};
use crate::keywords::{ELEMENTS, look_up};
use crate::plan::Plan;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

/// All items of a model.
pub(crate) fn model(model: &Model, plan: &Plan<'_>) -> TokenStream {
    let names = Names::of(model);
    let parameters = &model.parameters;
    let system = system::system(model, plan, &names);
    let layout = layout::layout(plan, &names);
    let evaluate = evaluate::evaluate(plan, &names);
    let characteristic = evaluate::characteristic(plan, &names);
    quote! {
        #parameters
        #system
        const _: () = {
            #layout
            #evaluate
            #characteristic
        };
    }
}

/// Paths and names that several emitted items share.
struct Names {
    /// Path to everything that emitted code uses.
    private: TokenStream,
    /// Type of the built system.
    system: Ident,
}

impl Names {
    fn of(model: &Model) -> Self {
        let facade = &model.facade;
        Names { private: quote!(#facade::__private), system: format_ident!("{}System", model.parameters.ident) }
    }

    /// Path of an element's type, at the user's token.
    fn element_type(&self, element: &Element) -> TokenStream {
        match &element.kind {
            Kind::Type(path) => quote!(#path),
            Kind::Keyword(keyword) => {
                let private = &self.private;
                // `check` has refused unknown keywords
                let name = Ident::new(look_up(ELEMENTS, &keyword.to_string()).unwrap_or("Beam"), keyword.span());
                quote_spanned!(keyword.span()=> #private::elements::#name)
            }
        }
    }
}

/// Field of the built system that holds an element; labels are unique, so these are.
fn field(element: &Element) -> Ident {
    Ident::new(&format!("element_{}", element.label), Span::call_site())
}
