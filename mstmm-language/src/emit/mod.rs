//! Emits the code of a plan. Nothing is decided here.

mod evaluate;
mod labels;
mod layout;
mod names;
mod pass;
mod system;
mod tree;

use crate::ast::{Element, Model};
use crate::plan::Plan;
use names::Names;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeMap;

/// All items of a model.
pub(crate) fn model(model: &Model, plan: &Plan<'_>) -> TokenStream {
    let names = Names::of(model);
    let parameters = &model.parameters;
    let system = system::system(model, plan, &names);
    let labels = labels::labels(model, &names);
    let layout = layout::layout(plan, &names);
    let evaluate = evaluate::evaluate(plan, &names);
    let characteristic = pass::characteristic(plan, &names);
    let constants = tree::labels(model, plan, &names);
    let planned = tree::planned(model, plan, &names);
    let tree = tree::tree(plan, &names);
    quote_spanned! {names.here=>
        #parameters
        #system
        #constants
        const _: () = {
            #labels
            #layout
            #evaluate
            #characteristic
            #planned
            #tree
        };
    }
}

/// Field of the built system that holds an element; labels are unique, so these are.
fn element_field(element: &Element, names: &Names) -> Ident {
    format_ident!("element_{}", element.label.to_string(), span = names.at_element(element))
}

/// A local variable for an element.
fn local(prefix: &str, element: &Element, names: &Names) -> Ident {
    format_ident!("{prefix}_{}", element.label.to_string(), span = names.at_element(element))
}

/// An element of each type that occurs, the first in the source, in a fixed order.
fn first_of_each_type<'a>(plan: &Plan<'a>, names: &Names) -> Vec<&'a Element> {
    let elements = plan.elements.iter().rev();
    let first: BTreeMap<_, _> = elements.map(|element| (names.element_type(element).to_string(), *element)).collect();
    first.into_values().collect()
}

/// Implements a trait for the built system, where each type of element has a trait of its own.
///
/// If one has not, rustc says so at its keyword, and "required for the system" at the name of the model.
fn implement(of: &str, of_elements: &str, body: &TokenStream, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system, parameter, frequency, .. } = names;
    let header = names.trait_at(of, names.here);
    let bounds = first_of_each_type(plan, names).into_iter().map(|element| {
        let span = names.at_element(element);
        let (kind, bound) = (names.element(element), names.trait_at(of_elements, span));
        quote_spanned!(span=> #kind: #bound)
    });
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter, #frequency> #header for #system<#parameter>
        where
            #parameter: #private::Real,
            #frequency: #private::Frequency<#parameter>,
            #(#bounds),*
        {
            #body
        }
    }
}
