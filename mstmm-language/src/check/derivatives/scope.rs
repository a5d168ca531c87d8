//! The names that a formula can refer to.

use super::super::fields::is_number;
use super::Dependence;
use crate::ast::Model;
use crate::spans::origin;
use std::collections::BTreeSet;
use syn::ext::IdentExt;
use syn::{ExprPath, Ident};

/// The names of fields and variables, later ones hiding earlier ones.
pub(super) struct Scope {
    fields: Vec<String>,
    variables: Vec<(Ident, Dependence)>,
}

impl Scope {
    /// The fields of a model.
    pub(super) fn of(model: &Model) -> Self {
        let mut scope = Scope { fields: Vec::new(), variables: Vec::new() };
        for field in model.fields() {
            let index = scope.fields.len();
            scope.fields.push(field.name.to_string());
            let number = Dependence::Number(BTreeSet::from([index]));
            // what is no number was refused as a field
            let depends = field.has_derivative && is_number(field.kind);
            scope.bind(field.name, if depends { number } else { Dependence::None });
        }
        scope
    }

    /// The name of a field.
    pub(super) fn field(&self, index: usize) -> &str {
        &self.fields[index]
    }

    /// Adds a variable.
    pub(super) fn bind(&mut self, name: &Ident, dependence: Dependence) {
        self.variables.push((name.clone(), dependence));
    }

    /// The number of variables, to which [`leave`](Self::leave) goes back.
    pub(super) fn depth(&self) -> usize {
        self.variables.len()
    }

    /// Forgets the variables of a block.
    pub(super) fn leave(&mut self, depth: usize) {
        self.variables.truncate(depth);
    }

    /// How the value of a path depends on the fields: not at all, if it is no variable.
    pub(super) fn of_path(&self, path: &ExprPath) -> Dependence {
        path.path.get_ident().map_or(Dependence::None, |name| self.of_name(name))
    }

    /// How a variable depends on the fields. Where origins cannot be told, names alone decide.
    pub(super) fn of_name(&self, name: &Ident) -> Dependence {
        let from = origin(name.span());
        let candidates = || self.variables.iter().rev().filter(|(variable, _)| variable.unraw() == name.unraw());
        let same = candidates().find(|(variable, _)| origin(variable.span()) == from);
        same.or_else(|| candidates().next()).map_or(Dependence::None, |(_, dependence)| dependence.clone())
    }
}
