//! The coordinates of a place or of a direction.

use crate::diagnostics::Place;
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use syn::{Expr, Ident};

/// `at (x, y)` or `along (dx, dy)`: a literal tuple has several coordinates, anything else is one.
pub(crate) struct Coordinates {
    /// `at` or `along`.
    pub(crate) keyword: Ident,
    pub(crate) parts: Vec<Expr>,
    pub(crate) is_tuple: bool,
    /// The tokens behind the keyword.
    pub(crate) value: Place,
}

impl Coordinates {
    pub(crate) fn new(keyword: Ident, value: Expr) -> Self {
        let place = place_of(&value);
        let (parts, is_tuple) = match tuple_parts(&value) {
            Some(parts) => (parts.into_iter().cloned().collect(), true),
            None => (vec![value], false),
        };
        Coordinates { keyword, parts, is_tuple, value: place }
    }
}

/// The parts of a literal tuple; `None` for any other expression.
pub(crate) fn tuple_parts(value: &Expr) -> Option<Vec<&Expr>> {
    match value {
        Expr::Tuple(tuple) => Some(tuple.elems.iter().collect()),
        Expr::Paren(inner) => tuple_parts(&inner.expr),
        Expr::Group(inner) => tuple_parts(&inner.expr),
        _ => None,
    }
}

/// The tokens of an expression.
pub(crate) fn place_of(value: &Expr) -> Place {
    let spans = |tokens: TokenStream| tokens.into_iter().map(|token| token.span());
    let first = spans(value.to_token_stream()).next().unwrap_or_else(Span::call_site);
    Place { first, last: spans(value.to_token_stream()).last().unwrap_or(first) }
}
