//! Exits from a formula other than by its value.

use crate::ast::Model;
use crate::diagnostics::Errors;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{ExprAsync, ExprClosure, ExprReturn, ExprTry, Item};

/// Refuses `return` and `?`: formulas stand in `build` and in sensitivities, which return different things.
pub(super) fn exits(model: &Model, errors: &mut Errors) {
    let mut exits = Exits(errors);
    model.lets.iter().for_each(|line| exits.visit_local(line));
    let values =
        model.elements().flat_map(|element| element.parameters()).filter_map(|parameter| parameter.value.as_ref());
    let values = values.chain(model.coordinates().flat_map(|coordinates| &coordinates.parts));
    values.for_each(|value| exits.visit_expr(value));
}

struct Exits<'a>(&'a mut Errors);

impl Exits<'_> {
    fn refuse(&mut self, place: impl ToTokens) {
        let message = "a formula has a value and no other way out: make what may fail a field, computed before";
        self.0.add(syn::Error::new_spanned(place, message));
    }
}

impl<'e> Visit<'e> for Exits<'_> {
    fn visit_expr_try(&mut self, expression: &'e ExprTry) {
        self.refuse(expression.question_token);
        visit::visit_expr_try(self, expression);
    }

    fn visit_expr_return(&mut self, expression: &'e ExprReturn) {
        self.refuse(expression.return_token);
    }

    // a `return` inside of these leaves them alone
    fn visit_expr_closure(&mut self, _closure: &'e ExprClosure) {}
    fn visit_expr_async(&mut self, _block: &'e ExprAsync) {}
    fn visit_item(&mut self, _item: &'e Item) {}
}
