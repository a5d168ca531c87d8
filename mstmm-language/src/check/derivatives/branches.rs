//! `if` and `match`: where any branch gives a number with derivatives, all do.

use super::expressions::make_float;
use super::{Dependence, Formulas};
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, ExprIf, ExprMatch, Pat, Stmt, Token};

impl Formulas<'_> {
    /// `if condition { .. } else { .. }`
    pub(super) fn branches(&mut self, expression: &mut ExprIf) -> Dependence {
        let depth = self.scope.depth();
        // names that `if let` binds are those of its block
        self.expression(&mut expression.cond);
        let then = self.block(&mut expression.then_branch);
        self.scope.leave(depth);
        let Some((_, other_branch)) = &mut expression.else_branch else { return Dependence::None };
        let other = self.expression(other_branch);
        let joined = then.clone().joined(&other);
        if needs_lift(&then, &joined) {
            let lifted = self.lifted(&expression.then_branch, &then, &joined);
            expression.then_branch.stmts = vec![Stmt::Expr(Expr::Verbatim(lifted), None)];
        }
        self.lift(other_branch, &other, &joined);
        joined
    }

    /// `match value { .. }`
    pub(super) fn arms(&mut self, expression: &mut ExprMatch) -> Dependence {
        let value = self.expression(&mut expression.expr);
        let mut values = Vec::new();
        for arm in &mut expression.arms {
            let depth = self.scope.depth();
            self.bind(&arm.pat, &value);
            if let Pat::Guard(pattern) = &mut arm.pat {
                self.expression(&mut pattern.guard);
            }
            values.push(self.expression(&mut arm.body));
            self.scope.leave(depth);
        }
        let joined = values.iter().fold(Dependence::None, Dependence::joined);
        for (arm, value) in expression.arms.iter_mut().zip(&values) {
            self.lift(&mut arm.body, value, &joined);
            arm.comma.get_or_insert_with(<Token![,]>::default);
        }
        joined
    }

    /// Makes a value that depends on no field a constant, where one that does may stand too.
    pub(super) fn lift(&self, expression: &mut Expr, from: &Dependence, to: &Dependence) {
        if needs_lift(from, to) {
            make_float(expression);
            *expression = Expr::Verbatim(self.lifted(expression, from, to));
        }
    }

    fn lifted(&self, value: &impl ToTokens, from: &Dependence, to: &Dependence) -> TokenStream {
        let span = self.at(value.span());
        match to {
            _ if !needs_lift(from, to) => value.to_token_stream(),
            Dependence::Tuple(to) => {
                let parts = (0..to.len()).map(|part| format_ident!("part_{part}", span = span));
                let from = |part| match from {
                    Dependence::Tuple(parts) => &parts[part],
                    Dependence::None | Dependence::Number(_) => &Dependence::None,
                };
                let lifted = to
                    .iter()
                    .enumerate()
                    .zip(parts.clone())
                    .map(|((part, to), name)| self.lifted(&name, from(part), to));
                quote_spanned!(span=> { let (#(#parts,)*) = #value; (#(#lifted,)*) })
            }
            Dependence::None | Dependence::Number(_) => quote_spanned!(span=> chain.constant(#value)),
        }
    }
}

/// Whether one value is plain where the other is a number with derivatives.
fn needs_lift(from: &Dependence, to: &Dependence) -> bool {
    match (from, to) {
        (Dependence::None, _) => !to.is_none(),
        (Dependence::Tuple(from), Dependence::Tuple(to)) => from.iter().zip(to).any(|(from, to)| needs_lift(from, to)),
        _ => false,
    }
}
