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
use crate::ast::{Element, Model, Parameter};
use crate::diagnostics::Errors;
use dependence::Dependence;
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use scope::Scope;
use std::collections::BTreeMap;
use syn::{Expr, Ident, Local};

/// The formulas of a model over numbers with derivatives.
#[derive(Default)]
pub(crate) struct Derivatives {
    /// The `let` lines.
    pub(crate) lets: Vec<Local>,
    /// By the labels of the elements: the parameters that depend on fields.
    parameters: BTreeMap<String, Vec<(Ident, Expr)>>,
}

impl Derivatives {
    /// The parameters of an element that depend on fields.
    pub(crate) fn of(&self, element: &Element) -> &[(Ident, Expr)] {
        self.parameters.get(&element.label.to_string()).map_or(&[], Vec::as_slice)
    }
}

/// Finds the formulas, and reports code without a derivative.
pub(crate) fn derivatives(model: &Model, errors: &mut Errors) -> Derivatives {
    let mut formulas = Formulas { scope: Scope::of(model), facade: &model.facade, errors };
    let mut lets = model.lets.clone();
    lets.iter_mut().for_each(|line| formulas.local(line));
    let mut parameters: BTreeMap<String, Vec<_>> = BTreeMap::new();
    for element in model.elements() {
        let dependent = element.parameters().filter_map(|parameter| formulas.parameter(parameter));
        parameters.entry(element.label.to_string()).or_default().extend(dependent);
    }
    for part in model.coordinates().flat_map(|coordinates| &coordinates.parts) {
        formulas.expression(&mut part.clone());
    }
    if parameters.values().any(|parameters| !parameters.is_empty()) {
        exits::exits(model, errors);
    }
    Derivatives { lets, parameters }
}

/// Goes through the formulas in the order of the source and rewrites them.
struct Formulas<'a> {
    scope: Scope,
    facade: &'a TokenStream,
    errors: &'a mut Errors,
}

impl Formulas<'_> {
    /// The name and the value of a parameter that depends on fields.
    fn parameter(&mut self, parameter: &Parameter) -> Option<(Ident, Expr)> {
        let mut value = parameter.expression();
        let dependence = self.expression(&mut value);
        matches!(dependence, Dependence::Number(_)).then(|| (parameter.name.clone(), value))
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
