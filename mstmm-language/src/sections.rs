//! Sections: parameters that elements share. Each expression becomes a `let` line, which elements name.

use crate::ast::{Element, Model, Parameter, Section, tuple_parts};
use crate::check::listed;
use crate::diagnostics::Errors;
use crate::keywords::nearest;
use crate::spans::emitted_at;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeSet;
use syn::ext::IdentExt;
use syn::parse::Parser;
use syn::token::Paren;
use syn::{Block, Expr, ExprPath, ExprTuple, Local, Stmt};

/// Gives each element the parameters of its sections that it does not name itself. Returns the sections that no element has.
pub(crate) fn spread(model: &mut Model, errors: &mut Errors) -> Vec<Ident> {
    check_sections(&model.sections, errors);
    let sections = std::mem::take(&mut model.sections);
    let lines: Vec<Local> = sections
        .iter()
        .flat_map(|section| section.parameters.iter().flat_map(|parameter| lines(section, parameter, &model.facade)))
        .collect();
    model.lets.extend(lines);
    let facade = model.facade.clone();
    let (mut used, mut told) = (BTreeSet::new(), BTreeSet::new());
    for element in model.elements_mut() {
        spread_into(element, &sections, &facade, &mut used, errors);
        tell_once(element, &mut told);
    }
    model.sections = sections;
    let names = model.sections.iter().map(|section| section.name.clone());
    names.filter(|name| !used.contains(&name.unraw().to_string())).collect()
}

/// Names of sections are different, and so are the names in each.
fn check_sections(sections: &[Section], errors: &mut Errors) {
    let mut known = BTreeSet::new();
    for Section { name, parameters } in sections {
        if !known.insert(name.unraw().to_string()) {
            errors.push(name.span(), format!("there is a section `{name}` already: give this one another name"));
        }
        let mut given = BTreeSet::new();
        for parameter in parameters {
            if !given.insert(parameter.name.unraw().to_string()) {
                let message =
                    format!("section `{name}` gives `{}` a second time: remove one of the two", parameter.name);
                errors.push(parameter.name.span(), message);
            }
        }
    }
}

/// The expressions of a parameter of a section, of a tuple those of its parts, each with its variable: no name of the user's, since it has the meaning
/// of emitted code.
fn variables(section: &Section, parameter: &Parameter, facade: &TokenStream) -> Vec<(Ident, Expr)> {
    let span = emitted_at(facade, parameter.name.span());
    let value = parameter.expression();
    let name = format!("_section_{}_{}", section.name.unraw(), parameter.name.unraw());
    let of_part = |(part, value): (usize, &Expr)| (format_ident!("{name}_{part}", span = span), value.clone());
    match tuple_parts(&value) {
        Some(parts) => parts.into_iter().enumerate().map(of_part).collect(),
        None => vec![(format_ident!("{name}", span = span), value)],
    }
}

/// What an element has of a parameter of a section: its variable, or a tuple of its variables.
fn spread_value(section: &Section, parameter: &Parameter, facade: &TokenStream) -> Expr {
    let path =
        |(variable, _): (Ident, Expr)| Expr::Path(ExprPath { attrs: Vec::new(), qself: None, path: variable.into() });
    let mut parts: Vec<Expr> = variables(section, parameter, facade).into_iter().map(path).collect();
    match parts.pop() {
        Some(only) if parts.is_empty() => only,
        last => {
            let elems = parts.into_iter().chain(last).collect();
            Expr::Tuple(ExprTuple { attrs: Vec::new(), paren_token: Paren(parameter.name.span()), elems })
        }
    }
}

/// `let variable: f64 = expression;` for each variable.
fn lines(section: &Section, parameter: &Parameter, facade: &TokenStream) -> Vec<Local> {
    let variables = variables(section, parameter, facade).into_iter();
    variables.filter_map(|(variable, value)| line(parameter, &variable, &value)).collect()
}

fn line(parameter: &Parameter, variable: &Ident, value: &Expr) -> Option<Local> {
    // a type that is not `f64` is shown at the expression, and what is expected at the name
    let float = quote_spanned!(parameter.name.span()=> ::core::primitive::f64);
    let_line(quote_spanned!(variable.span()=> let #variable: #float = #value;))
}

/// A `let` line of its tokens.
pub(crate) fn let_line(tokens: TokenStream) -> Option<Local> {
    match Block::parse_within.parse2(tokens).ok()?.pop()? {
        Stmt::Local(local) => Some(local),
        _ => None,
    }
}

/// Gives one element the parameters of its sections.
fn spread_into(
    element: &mut Element,
    sections: &[Section],
    facade: &TokenStream,
    used: &mut BTreeSet<String>,
    errors: &mut Errors,
) {
    let own: BTreeSet<String> = element.parameters().map(|parameter| parameter.name.unraw().to_string()).collect();
    let mut given: Vec<Parameter> = Vec::new();
    for name in &element.spread {
        let Some(section) = sections.iter().find(|section| section.name.unraw() == name.unraw()) else {
            errors.push(name.span(), no_section(name, sections));
            continue;
        };
        used.insert(name.unraw().to_string());
        for parameter in &section.parameters {
            let same = |other: &Parameter| other.name.unraw() == parameter.name.unraw();
            if own.contains(&parameter.name.unraw().to_string()) {
                continue;
            }
            if let Some(first) = given.iter().find(|other| same(other)).and_then(|other| other.section.as_ref()) {
                let message = format!(
                    "sections `{first}` and `{name}` both give `{}`: name it in `{element}` itself, which then wins",
                    parameter.name
                );
                errors.push(name.span(), message);
                continue;
            }
            let value = Some(spread_value(section, parameter, facade));
            given.push(Parameter {
                name: parameter.name.clone(),
                value,
                section: Some(section.name.clone()),
                is_told: false,
                called: None,
            });
        }
    }
    element.spread.retain(|name| !sections.iter().any(|section| section.name.unraw() == name.unraw()));
    element.parameters.iter_mut().for_each(|parameters| parameters.append(&mut given));
}

/// A name that a keyword lacks is told with the first of its elements.
fn tell_once(element: &mut Element, told: &mut BTreeSet<[String; 3]>) {
    let kind = element.kind.name().to_string();
    for parameter in element.parameters.iter_mut().flatten() {
        let Some(section) = &parameter.section else { continue };
        parameter.is_told =
            !told.insert([kind.clone(), section.unraw().to_string(), parameter.name.unraw().to_string()]);
    }
}

fn no_section(name: &Ident, sections: &[Section]) -> String {
    let names: Vec<String> = sections.iter().map(|section| section.name.unraw().to_string()).collect();
    if names.is_empty() {
        return format!("there is no section `{name}`: write `section {name} {{ .. }}` behind the `let` lines");
    }
    let hint = match nearest(names.iter().map(String::as_str), &name.unraw().to_string()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("there are {}", listed(names.iter().map(String::as_str))),
    };
    format!("there is no section `{name}`: {hint}")
}
