//! The model without what damps, a second model of the same fields: `#[undamped(Name)]` above the struct asks for it.

use crate::ast::{Element, Kind, Model, Parameter};
use crate::diagnostics::Errors;
use crate::keywords::DAMPING;
use crate::sections::let_line;
use crate::spans::emitted_at;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;
use syn::ext::IdentExt;
use syn::{Expr, Local, parse_quote_spanned};

/// The attribute that names the model without what damps.
const UNDAMPED: &str = "undamped";

/// Elements that damp and do nothing else, and what stands in their place with a stiffness of zero.
const DASHPOTS: [(&str, &str); 2] = [("damper", "spring"), ("torsion_damper", "torsion_spring")];

/// Takes the attribute from the struct; the name in it, if there is one.
pub(crate) fn take_name(model: &mut Model, errors: &mut Errors) -> Option<Ident> {
    let mut name = None;
    model.parameters.attrs.retain(|attribute| {
        if !attribute.path().is_ident(UNDAMPED) {
            return true;
        }
        match attribute.parse_args::<Ident>() {
            Ok(given) if name.is_none() => name = Some(given),
            Ok(_) => errors.add(syn::Error::new_spanned(attribute, "a model has one undamped model: remove this line")),
            Err(_) => {
                let message = "write the name of the model without damping, `#[undamped(QuietModel)]`";
                errors.add(syn::Error::new_spanned(attribute, message));
            }
        }
        false
    });
    name
}

/// Renames the model and takes away what damps. Says so where nothing does.
pub(crate) fn rewrite(model: &mut Model, name: &Ident, errors: &mut Errors) {
    let own = &model.parameters.ident;
    if *name == *own || *name == format!("{own}System") {
        errors.push(name.span(), format!("`{name}` is a type of this model: give the undamped model another name"));
    }
    let is_located = model.is_located();
    let (mut removed, mut damped) = (Vec::new(), false);
    for element in model.elements_mut() {
        let (freed, values) = quieten(element);
        if !is_located && !freed.is_empty() && element.parameters().count() > 1 {
            let [damping, stiffness] = ["damping", "stiffness"].map(|what| format!("{what}_{}", freed[0]));
            let message = format!(
                "`{element}` would have no stiffness without its `{damping}`: name a `{stiffness}`, which a hinge of two freedoms needs"
            );
            errors.push(element.place(), message);
        }
        damped |= !values.is_empty();
        removed.extend(values);
    }
    // a field that no parameter uses was told of the damped model
    let always = model.fields().filter(|field| field.conditions.is_empty());
    removed.extend(always.map(|field| field_expression(field.name)).collect::<Vec<_>>());
    model.parameters.ident = name.clone();
    if !damped {
        let message = "nothing in this model damps: it has natural frequencies itself, so remove `#[undamped(..)]`";
        errors.push(name.span(), message);
    }
    // a field that stands in damping alone is used all the same
    model.lets.extend(removed.iter().filter_map(|value| use_of(value, name.span())));
}

/// Takes away what damps in an element. The freedoms that it held by damping alone, and the values that are used no more.
fn quieten(element: &mut Element) -> (Vec<String>, Vec<Expr>) {
    let Kind::Keyword(keyword) = &mut element.kind else { return Default::default() };
    let word = keyword.unraw().to_string();
    let Some(parameters) = &mut element.parameters else { return Default::default() };
    let mut freed = Vec::new();
    let (damping, mut kept): (Vec<_>, Vec<_>) = parameters.drain(..).partition(|parameter| damps(&parameter.name));
    if let Some((_, spring)) = DASHPOTS.iter().find(|(dashpot, _)| *dashpot == word) {
        *keyword = Ident::new(spring, keyword.span());
        kept.push(without_stiffness("stiffness", keyword.span()));
    }
    for parameter in &damping {
        // what a hinge names is flexible: where damping alone holds a freedom, nothing is left
        let own = parameter.name.unraw().to_string();
        let Some(freedom) = own.strip_prefix("damping_") else { continue };
        let stiffness = format!("stiffness_{freedom}");
        if kept.iter().all(|other| other.name.unraw() != stiffness.as_str()) {
            kept.push(without_stiffness(&stiffness, parameter.name.span()));
            freed.push(freedom.to_owned());
        }
    }
    *parameters = kept;
    (freed, damping.into_iter().map(|parameter| parameter.expression()).collect())
}

/// Whether a parameter is one of damping.
fn damps(parameter: &Ident) -> bool {
    let name = parameter.unraw().to_string();
    DAMPING.contains(&name.as_str()) || name == "damping" || name.starts_with("damping_") || name == "cross_damping"
}

/// `stiffness: 0.0`
fn without_stiffness(name: &str, span: Span) -> Parameter {
    let value = parse_quote_spanned!(span=> 0.0);
    Parameter { name: Ident::new(name, span), value: Some(value), section: None, is_told: false, called: None }
}

/// A field as an expression.
fn field_expression(name: &Ident) -> Expr {
    parse_quote_spanned!(name.span()=> #name)
}

/// `let _: f64 = value;`
fn use_of(value: &Expr, span: Span) -> Option<Local> {
    let_line(quote_spanned!(span=> let _: ::core::primitive::f64 = #value;))
}

/// The method that leads from one model to the other.
pub(crate) fn method(model: &Model, name: &Ident) -> TokenStream {
    let here = emitted_at(&model.facade, name.span());
    let (visibility, damped) = (&model.parameters.vis, &model.parameters.ident);
    let fields = model.fields().map(|field| {
        let (conditions, name) = (&field.conditions, field.name);
        quote_spanned!(here=> #(#conditions)* #name: self.#name)
    });
    let doc = format!(
        " This model without what damps: its dampers have no stiffness, and no material loses energy. Its labels are those of [`{name}`]."
    );
    quote_spanned! {here=>
        #[allow(dead_code)]
        impl #damped {
            #[doc = #doc]
            #visibility fn undamped(&self) -> #name {
                #name { #(#fields,)* }
            }
        }
    }
}
