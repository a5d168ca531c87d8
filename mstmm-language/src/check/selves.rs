//! `self` in a formula: fields are written by their names alone.

use crate::ast::{Element, Model, Parameter};
use crate::diagnostics::{Errors, Place};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprField, ExprPath, Member};

/// Refuses `self` in `let` lines, parameters and places.
pub(super) fn selves(model: &Model, errors: &mut Errors) {
    let mut finder = Finder { errors };
    model.lets.iter().for_each(|line| finder.visit_local(line));
    for value in model.elements().flat_map(Element::parameters).filter_map(|Parameter { value, .. }| value.as_ref()) {
        finder.visit_expr(value);
    }
    for part in model.coordinates().flat_map(|coordinates| &coordinates.parts) {
        finder.visit_expr(part);
    }
}

struct Finder<'e> {
    errors: &'e mut Errors,
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_expr_field(&mut self, field: &'ast ExprField) {
        match (&*field.base, &field.member) {
            (Expr::Path(base), Member::Named(name)) if base.path.is_ident("self") => {
                let place = Place { first: base.span(), last: name.span() };
                self.errors.push(place, format!("a field is written by its name alone, `{name}`, without `self`"));
            }
            _ => visit::visit_expr_field(self, field),
        }
    }

    fn visit_expr_path(&mut self, path: &'ast ExprPath) {
        if path.path.is_ident("self") {
            self.errors.push(path.span(), "there is no `self` here: fields are written by their names, `length`");
        }
    }
}
