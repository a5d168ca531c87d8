//! Emits the code of a plan. Nothing is decided here.

mod evaluate;
mod fields;
mod formulas;
mod labels;
mod layout;
mod located;
mod names;
mod pass;
mod rotor;
mod searched;
mod sensitivity;
mod system;
mod tree;

use crate::ast::{Element, Model, NO_SENSITIVITY};
use crate::check::Derivatives;
use crate::plan::Plan;
pub(crate) use located::located;
use names::Names;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeMap;
use syn::ItemStruct;

/// All items of a model, with the sections that no element has.
pub(crate) fn model(model: &Model, unused: &[Ident], plan: &Plan<'_>, derivatives: &Derivatives) -> TokenStream {
    let names = Names::of(model);
    let parameters = parameters(model);
    let keeps_fields = sensitivity::keeps_fields(plan, derivatives);
    let system = system::system(model, plan, keeps_fields, &names);
    let implementation = system::implementation(plan, &names);
    let sensitivity = sensitivity::sensitivity(model, plan, derivatives, &names);
    let labels = labels::labels(model, &names);
    let layout = layout::layout(plan, &names);
    let evaluate = evaluate::evaluate(plan, &names);
    let characteristic = pass::characteristic(plan, &names);
    let constants = tree::labels(model, plan, &names);
    let planned = tree::planned(model, plan, &names);
    let tree = tree::tree(plan, &names);
    let drawn = tree::drawn(plan, &names);
    let formulas = formulas::of_plan(model, plan, derivatives, &names);
    let rotor = rotor::spinning(plan, &names);
    let unused = fields::unused(model, unused, &names);
    // one message for a planar path that is searched, rather than one for each number that searches use
    let searched = if plan.is_planar() {
        TokenStream::new()
    } else {
        searched::searched(searched::own_part(plan, &names), &names)
    };
    quote_spanned! {names.here=>
        #parameters
        #system
        #constants
        #sensitivity
        #formulas
        const _: () = {
            #labels
            #layout
            #implementation
            #evaluate
            #characteristic
            #planned
            #tree
            #drawn
            #unused
            #rotor
            #searched
        };
    }
}

/// The struct of parameters, without the marks that are the macro's own.
fn parameters(model: &Model) -> ItemStruct {
    let mut parameters = model.parameters.clone();
    for field in &mut parameters.fields {
        field.attrs.retain(|attribute| !attribute.path().is_ident(NO_SENSITIVITY));
    }
    parameters
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

/// What a trait for the built system asks of its elements: a trait for each type of element.
///
/// If one has not, rustc says so at its keyword, and "required for the system" at the name of the model.
fn bounds(of_elements: &str, plan: &Plan<'_>, names: &Names) -> Vec<TokenStream> {
    let bound = |element: &Element| {
        let span = names.at_element(element);
        let (kind, bound) = (names.element(element), names.trait_at(of_elements, span));
        quote_spanned!(span=> #kind: #bound)
    };
    first_of_each_type(plan, names).into_iter().map(bound).collect()
}

/// Implements a trait for the built system over a kind of parameters, with bounds of its elements.
fn implement(of: &str, over: &str, bounds: Vec<TokenStream>, body: &TokenStream, names: &Names) -> TokenStream {
    let Names { private, system, parameter, frequency, .. } = names;
    let (header, over) = (names.trait_at(of, names.here), Ident::new(over, names.here));
    quote_spanned! {names.here=>
        #[automatically_derived]
        #[allow(unused_braces)]
        impl<#parameter, #frequency> #header for #system<#parameter>
        where
            #parameter: #private::#over,
            #frequency: #private::Frequency<#parameter>,
            #(#bounds),*
        {
            #body
        }
    }
}
