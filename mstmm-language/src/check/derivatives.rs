//! The values that depend on the fields of the struct, and their formulas over numbers with derivatives.
//!
//! An expression stays as the user wrote it unless its value depends on a field. Then it may use the operators and functions
//! of numbers with derivatives alone; any other code that the value passes through is an error. Where either kind of number
//! may come, at the ends of branches and as arguments, plain numbers are made constants.

mod bindings;
mod branches;
mod dependence;
mod exits;
mod expressions;
mod functions;
mod scope;

use super::listed;
use crate::ast::{Element, Model, Parameter, tuple_parts};
use crate::diagnostics::Errors;
use crate::spans::meaning;
use dependence::Dependence;
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use scope::Scope;
use std::collections::BTreeMap;
use syn::ext::IdentExt;
use syn::{Expr, Ident, Local};

/// The formulas of a model over numbers with derivatives.
#[derive(Default)]
pub(crate) struct Derivatives {
    /// The `let` lines.
    pub(crate) lets: Vec<Local>,
    /// By the labels of the elements: the parameters that depend on fields.
    parameters: BTreeMap<String, Vec<(Ident, Expr)>>,
    /// By what they mean: the numbers of a model with locations that depend on fields.
    numbers: BTreeMap<String, Expr>,
    /// Whether a formula compares values that depend on fields.
    pub(crate) compares: bool,
}

impl Derivatives {
    /// The parameters of an element that depend on fields; of a part of an element those that it has.
    pub(crate) fn of(&self, element: &Element) -> Vec<(Ident, &Expr)> {
        let all = self.parameters.get(&element.label.to_string()).map_or(&[][..], Vec::as_slice);
        let own = element.parameters().filter_map(|parameter| {
            let is_it = |name: &Ident| match parameter.called {
                Some(called) => name.unraw() == called,
                None => *name == parameter.name,
            };
            let (_, value) = all.iter().find(|(name, _)| is_it(name))?;
            Some((parameter.name.clone(), value))
        });
        own.collect()
    }

    /// The formula of a number of a model with locations that depends on fields.
    pub(crate) fn of_number(&self, number: &Expr) -> Option<&Expr> {
        self.numbers.get(&meaning(number.to_token_stream()))
    }

    /// Whether nothing depends on a field.
    pub(crate) fn are_none(&self) -> bool {
        self.numbers.is_empty() && self.parameters.values().all(Vec::is_empty)
    }
}

/// Finds the formulas, and reports code without a derivative.
pub(crate) fn derivatives(model: &Model, errors: &mut Errors) -> Derivatives {
    let mut formulas = Formulas { scope: Scope::of(model), facade: &model.facade, compares: false, errors };
    let mut lets = model.lets.clone();
    lets.iter_mut().for_each(|line| formulas.local(line));
    let mut parameters: BTreeMap<String, Vec<_>> = BTreeMap::new();
    for element in model.elements() {
        let dependent = element.parameters().filter_map(|parameter| formulas.parameter(parameter));
        parameters.entry(element.label.to_string()).or_default().extend(dependent);
    }
    let mut numbers = BTreeMap::new();
    for part in model.coordinates().flat_map(|coordinates| &coordinates.parts) {
        numbers.extend(formulas.number(part));
    }
    // what is wrong with a parameter was said with its element
    let silent = &mut Errors::default();
    let mut formulas = Formulas { errors: silent, ..formulas };
    for value in model.elements().flat_map(Element::parameters).map(Parameter::expression) {
        for part in tuple_parts(&value).unwrap_or_else(|| vec![&value]) {
            numbers.extend(formulas.number(part));
        }
    }
    let derivatives = Derivatives { lets, parameters, numbers, compares: formulas.compares };
    if !derivatives.are_none() {
        exits::exits(model, errors);
    }
    derivatives
}

/// Goes through the formulas in the order of the source and rewrites them.
struct Formulas<'a> {
    scope: Scope,
    facade: &'a TokenStream,
    compares: bool,
    errors: &'a mut Errors,
}

impl Formulas<'_> {
    /// The name and the value of a parameter that depends on fields.
    fn parameter(&mut self, parameter: &Parameter) -> Option<(Ident, Expr)> {
        let mut value = parameter.expression();
        let dependence = self.expression(&mut value);
        matches!(dependence, Dependence::Number(_)).then(|| (parameter.name.clone(), value))
    }

    /// The meaning and the formula of a number that depends on fields.
    fn number(&mut self, part: &Expr) -> Option<(String, Expr)> {
        let mut value = part.clone();
        let dependence = self.expression(&mut value);
        matches!(dependence, Dependence::Number(_)).then(|| (meaning(part.to_token_stream()), value))
    }

    /// Refuses code through which a value passes, if the value depends on fields.
    fn refuse(&mut self, dependence: &Dependence, place: impl ToTokens, what: &str, advice: &str) -> Dependence {
        let fields = dependence.fields();
        if !fields.is_empty() {
            let fields = listed(fields.iter().map(|&field| self.scope.field(field)));
            let message = format!(
                "{what} has no derivative that mstmm knows: {advice}, or mark {fields} with `#[no_sensitivity]`"
            );
            self.errors.add(syn::Error::new_spanned(place, message));
        }
        Dependence::None
    }

    /// The span of code that takes the place of a token.
    fn at(&self, token: Span) -> Span {
        crate::spans::emitted_at(self.facade, token)
    }
}
