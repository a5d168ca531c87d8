//! Refuses tokens that are nested so deeply that parsing them could overflow the stack.
//!
//! The parser of Rust expressions and types calls itself: for each bracket, for each operator in front of an operand, for
//! each generic argument. One level takes up to 60 kB of stack where a macro is compiled without optimisation, as macros are,
//! and rustc has 8 MB.

use proc_macro2::token_stream::IntoIter;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Ident;

/// Weight of a token that may begin a level; other tokens weigh one.
const LEVEL: usize = 32;

/// Greatest weight around a token: 64 levels, or a sum of a thousand terms.
const LIMIT: usize = 64 * LEVEL;

const MESSAGE: &str = "this is too long or nested too deeply: write a part of it in a `let` line of its own";

/// Checks a model without calling itself.
///
/// # Errors
/// The first token that lies too deep.
pub(crate) fn check(model: TokenStream) -> syn::Result<()> {
    walk(model, Nesting::default())
}

/// Checks an expression of the sketch, in which braces behind a name end no element.
///
/// # Errors
/// The first token that lies too deep.
pub(crate) fn check_expression(expression: TokenStream) -> syn::Result<()> {
    walk(expression, Nesting { in_expression: true, ..Nesting::default() })
}

fn walk(tokens: TokenStream, nesting: Nesting) -> syn::Result<()> {
    let mut open: Vec<Row> = Vec::new();
    let mut row = Row { tokens: tokens.into_iter(), is_invisible: false, nesting };
    loop {
        match row.tokens.next() {
            Some(token) => {
                row.nesting.pass(&token, open.is_empty());
                if row.nesting.weight() > LIMIT {
                    let span = if let TokenTree::Group(group) = &token { group.span_open() } else { token.span() };
                    return Err(syn::Error::new(span, MESSAGE));
                }
                if let TokenTree::Group(group) = token {
                    let inner = row.enter(&group);
                    open.push(std::mem::replace(&mut row, inner));
                }
            }
            None => {
                let Some(mut outer) = open.pop() else { return Ok(()) };
                if row.is_invisible {
                    outer.nesting = row.nesting;
                }
                row = outer;
            }
        }
    }
}

/// The tokens of a group that are still to come.
struct Row {
    tokens: IntoIter,
    is_invisible: bool,
    nesting: Nesting,
}

impl Row {
    /// The row in a group. That of an invisible group is a part of the row around it.
    fn enter(&self, group: &Group) -> Row {
        let is_invisible = group.delimiter() == Delimiter::None;
        let inside = Nesting { outside: self.nesting.weight() + LEVEL, ..Nesting::default() };
        let nesting = if is_invisible { self.nesting } else { inside };
        Row { tokens: group.stream().into_iter(), is_invisible, nesting }
    }
}

/// A bound of how deeply the next token of a row is nested.
#[derive(Clone, Copy, Default)]
struct Nesting {
    /// Weight of the tokens around the group of the row.
    outside: usize,
    /// Weight since the last `,`.
    passing: usize,
    /// Weight of lists to which a `,` may belong: generic arguments, the arguments of a closure.
    lasting: usize,
    /// Whether the last token may end an operand, so that no operator in front of one follows.
    after_operand: bool,
    /// Whether this is a `let` line or another expression between those of elements.
    in_expression: bool,
}

impl Nesting {
    fn weight(&self) -> usize {
        self.outside + self.passing + self.lasting
    }

    /// Adds a token.
    fn pass(&mut self, token: &TokenTree, in_sketch: bool) {
        let is_operand = match token {
            TokenTree::Ident(word) => !is_keyword(word),
            TokenTree::Literal(_) | TokenTree::Group(_) => true,
            TokenTree::Punct(_) => false,
        };
        match token {
            TokenTree::Punct(punct) => match punct.as_char() {
                ';' => *self = Nesting { outside: self.outside, ..Nesting::default() },
                ',' => self.passing = 0,
                '<' | '|' => self.lasting += LEVEL,
                ':' | '#' => self.passing += 1,
                '=' => self.passing += LEVEL,
                _ => self.passing += if self.after_operand { 1 } else { LEVEL },
            },
            // an element of the sketch ends: expressions alone have braces behind a name that go on
            TokenTree::Group(group) if in_sketch && self.ends_element(group) => {
                (self.passing, self.lasting) = (0, 0);
            }
            _ => self.passing += if is_operand { 1 } else { LEVEL },
        }
        self.in_expression |= in_sketch && matches!(token, TokenTree::Ident(word) if word == "let");
        self.after_operand = is_operand;
    }

    fn ends_element(&self, group: &Group) -> bool {
        group.delimiter() == Delimiter::Brace && self.after_operand && !self.in_expression
    }
}

/// Whether a word is one of Rust's own, which names nothing.
pub(crate) fn is_keyword(word: &Ident) -> bool {
    syn::parse2::<Ident>(word.to_token_stream()).is_err()
}
