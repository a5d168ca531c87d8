//! `let` lines, blocks, and patterns that bind names.

use super::{Dependence, Formulas};
use syn::visit::{self, Visit};
use syn::{Block, Local, Pat, PatIdent, PatTuple, PatType, Stmt, Token, Type, TypeInfer};

impl Formulas<'_> {
    /// `let pattern: type = value;`
    pub(super) fn local(&mut self, local: &mut Local) {
        let mut dependence = Dependence::None;
        if let Some(init) = &mut local.init {
            dependence = self.expression(&mut init.expr);
            if let Some((_, diverging)) = &mut init.diverge {
                self.expression(diverging);
            }
        }
        if let Pat::Type(PatType { ty, .. }) = &mut local.pat {
            leave_open(ty, &dependence);
        }
        self.bind(&local.pat, &dependence);
    }

    /// The value of a block.
    pub(super) fn block(&mut self, block: &mut Block) -> Dependence {
        let depth = self.scope.depth();
        let mut value = Dependence::None;
        for statement in &mut block.stmts {
            value = Dependence::None;
            match statement {
                Stmt::Local(local) => self.local(local),
                Stmt::Expr(expression, None) => value = self.expression(expression),
                Stmt::Expr(expression, Some(_)) => {
                    self.expression(expression);
                }
                Stmt::Macro(statement) => {
                    self.macro_call(&statement.mac);
                }
                Stmt::Item(_) => {}
            }
        }
        self.scope.leave(depth);
        value
    }

    /// Binds the names of a pattern to the parts of a value.
    pub(super) fn bind(&mut self, pattern: &Pat, dependence: &Dependence) {
        match (pattern, dependence) {
            (Pat::Type(PatType { pat, .. }), _) => self.bind(pat, dependence),
            (Pat::Paren(pattern), _) => self.bind(&pattern.pat, dependence),
            (Pat::Guard(pattern), _) => self.bind(&pattern.pat, dependence),
            (Pat::Wild(_), _) => {}
            (Pat::Ident(PatIdent { by_ref: None, subpat: None, ident, .. }), _) => {
                self.scope.bind(ident, dependence.clone())
            }
            (Pat::Tuple(pattern), Dependence::Tuple(parts)) => self.bind_tuple(pattern, parts),
            _ => {
                self.refuse(dependence, pattern, "this pattern", "bind names and compare in an `if`");
                let mut names = Names(Vec::new());
                names.visit_pat(pattern);
                names.0.into_iter().for_each(|name| self.scope.bind(name, Dependence::None));
            }
        }
    }

    /// `(first, .., last)`
    fn bind_tuple(&mut self, pattern: &PatTuple, parts: &[Dependence]) {
        let is_rest = |pattern: &&Pat| matches!(pattern, Pat::Rest(_));
        let front = pattern.elems.iter().take_while(|pattern| !is_rest(pattern)).count();
        for (pattern, part) in pattern.elems.iter().zip(parts).take(front) {
            self.bind(pattern, part);
        }
        let back = pattern.elems.iter().rev().take_while(|pattern| !is_rest(pattern));
        if front < pattern.elems.len() {
            for (pattern, part) in back.zip(parts.iter().rev()) {
                self.bind(pattern, part);
            }
        }
    }
}

/// Leaves the type of a value to the compiler where the value depends on fields: it is no `f64` there.
fn leave_open(of_type: &mut Type, dependence: &Dependence) {
    match (&mut *of_type, dependence) {
        (_, Dependence::None) => {}
        (Type::Tuple(types), Dependence::Tuple(parts)) => {
            types.elems.iter_mut().zip(parts).for_each(|(of_type, part)| leave_open(of_type, part));
        }
        _ => *of_type = Type::Infer(TypeInfer { attrs: Vec::new(), underscore_token: <Token![_]>::default() }),
    }
}

/// The names that a pattern binds.
struct Names<'a>(Vec<&'a syn::Ident>);

impl<'a> Visit<'a> for Names<'a> {
    fn visit_pat_ident(&mut self, pattern: &'a PatIdent) {
        self.0.push(&pattern.ident);
        visit::visit_pat_ident(self, pattern);
    }
}
