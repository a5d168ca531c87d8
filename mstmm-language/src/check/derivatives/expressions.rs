//! Expressions, by their kind.

use super::{Dependence, Formulas};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::BTreeSet;
use syn::visit::{self, Visit};
use syn::{
    BinOp, Expr, ExprBinary, ExprBlock, ExprField, ExprLit, ExprPath, ExprUnary, Lit, LitFloat, Macro, Member, UnOp,
};

const ADVICE: &str = "write the formula without it";

impl Formulas<'_> {
    /// Rewrites an expression; returns the dependence of its value on the fields.
    pub(super) fn expression(&mut self, expression: &mut Expr) -> Dependence {
        match expression {
            Expr::Path(path) => self.scope.of_path(path),
            Expr::Paren(inner) => self.expression(&mut inner.expr),
            Expr::Group(inner) => self.expression(&mut inner.expr),
            Expr::Block(ExprBlock { label: None, block, .. }) => self.block(block),
            Expr::Tuple(tuple) => {
                Dependence::of_tuple(tuple.elems.iter_mut().map(|element| self.expression(element)).collect())
            }
            Expr::Field(field) => self.part(field),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::If(branches) => self.branches(branches),
            Expr::Let(condition) => {
                let dependence = self.expression(&mut condition.expr);
                self.bind(&condition.pat, &dependence);
                Dependence::None
            }
            Expr::Match(arms) => self.arms(arms),
            Expr::MethodCall(call) => self.method(call),
            Expr::Call(_) => self.call(expression),
            Expr::Cast(cast) => {
                let dependence = self.expression(&mut cast.expr);
                self.refuse(&dependence, cast.as_token, "a cast", ADVICE)
            }
            Expr::Reference(reference) => {
                let dependence = self.expression(&mut reference.expr);
                self.refuse(&dependence, reference.and_token, "a reference", ADVICE)
            }
            Expr::Index(index) => {
                let (list, position) = (self.expression(&mut index.expr), self.expression(&mut index.index));
                self.refuse(&Dependence::all([&list, &position]), &index, "an index", ADVICE)
            }
            Expr::Macro(call) => self.macro_call(&call.mac),
            Expr::Closure(closure) => {
                let mentions = self.mentions(|mentions| mentions.visit_expr_closure(closure));
                self.refuse(&mentions, &closure, "a closure", "write the formula here")
            }
            other => {
                let mentions = self.mentions(|mentions| mentions.visit_expr(other));
                self.refuse(&mentions, &other, "this expression", "write the formula here")
            }
        }
    }

    /// `macro!(..)`
    pub(super) fn macro_call(&mut self, call: &Macro) -> Dependence {
        let mentions = self.mentions(|mentions| mentions.visit_macro(call));
        let name = format!("`{}!`", call.path.to_token_stream().to_string().replace(' ', ""));
        self.refuse(&mentions, &call.path, &name, "write the formula here")
    }

    /// `tuple.0`
    fn part(&mut self, field: &mut ExprField) -> Dependence {
        match (self.expression(&mut field.base), &field.member) {
            (Dependence::Tuple(parts), Member::Unnamed(index)) => {
                parts.into_iter().nth(index.index as usize).unwrap_or(Dependence::None)
            }
            _ => Dependence::None,
        }
    }

    fn unary(&mut self, unary: &mut ExprUnary) -> Dependence {
        let dependence = self.expression(&mut unary.expr);
        match unary.op {
            UnOp::Neg(_) if !dependence.is_tuple() => dependence,
            op => self.refuse(&dependence, op, &format!("`{}`", op.to_token_stream()), ADVICE),
        }
    }

    fn binary(&mut self, binary: &mut ExprBinary) -> Dependence {
        let (left, right) = (self.expression(&mut binary.left), self.expression(&mut binary.right));
        let all = Dependence::all([&left, &right]);
        let is_of_numbers = !left.is_tuple() && !right.is_tuple();
        if !all.is_none() {
            make_float(&mut binary.left);
            make_float(&mut binary.right);
        }
        match binary.op {
            BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) if is_of_numbers => all,
            BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) | BinOp::Eq(_) | BinOp::Ne(_)
                if is_of_numbers =>
            {
                self.compares |= !all.is_none();
                Dependence::None
            }
            op => self.refuse(&all, op, &format!("`{}`", op.to_token_stream()), ADVICE),
        }
    }

    /// The fields on which what is mentioned depends.
    fn mentions(&self, visit: impl FnOnce(&mut Mentions<'_, '_>)) -> Dependence {
        let mut mentions = Mentions { formulas: self, fields: BTreeSet::new() };
        visit(&mut mentions);
        if mentions.fields.is_empty() { Dependence::None } else { Dependence::Number(mentions.fields) }
    }
}

/// Makes an integer a number of a formula: rustc refuses it in `build`, which is enough.
pub(super) fn make_float(expression: &mut Expr) {
    let Expr::Lit(ExprLit { lit, .. }) = expression else { return };
    if let Lit::Int(integer) = lit {
        *lit = Lit::Float(LitFloat::new(&format!("{}.0", integer.base10_digits()), integer.span()));
    }
}

/// Looks for variables that depend on fields.
struct Mentions<'f, 'a> {
    formulas: &'f Formulas<'a>,
    fields: BTreeSet<usize>,
}

impl Mentions<'_, '_> {
    /// Names among tokens that are no expression yet.
    fn tokens(&mut self, tokens: TokenStream) {
        for tree in tokens {
            match tree {
                TokenTree::Ident(name) => self.fields.extend(self.formulas.scope.of_name(&name).fields()),
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
        }
    }
}

impl<'e> Visit<'e> for Mentions<'_, '_> {
    fn visit_expr_path(&mut self, path: &'e ExprPath) {
        self.fields.extend(self.formulas.scope.of_path(path).fields());
        visit::visit_expr_path(self, path);
    }

    fn visit_macro(&mut self, call: &'e Macro) {
        self.tokens(call.tokens.clone());
    }
}
