//! Parses what stands behind a node: its place, its direction, the freedoms that a support holds.

use super::error_at;
use crate::ast::Coordinates;
use crate::depth;
use crate::groups::in_braces;
use crate::keywords::{ABOUT, ALONG, AT, NORMAL, nearest};
use proc_macro2::{TokenStream, TokenTree};
use std::fmt::Display;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Error, Expr, Ident, Token, braced, parenthesized, token};

/// The words that stand behind a node: in front of its place and of its direction.
pub(super) const BEHIND_NODES: &[&str] = &[AT, ALONG, NORMAL];

/// The words of directions.
pub(super) const DIRECTIONS: &[&str] = &[ALONG, NORMAL, ABOUT];

/// `at (x, y) along (dx, dy)`, each if it is there.
pub(super) struct Suffixes {
    pub(super) location: Option<Coordinates>,
    pub(super) direction: Option<Coordinates>,
}

impl Suffixes {
    /// Parses what stands behind a node.
    pub(super) fn parse(input: ParseStream<'_>, owner: &str) -> Result<Self> {
        let location = if is_word(input, AT) { Some(parse_coordinates(input.parse()?, input)?) } else { None };
        let has_direction = is_one_of(input, DIRECTIONS);
        let direction = if has_direction { Some(parse_coordinates(input.parse()?, input)?) } else { None };
        if is_word(input, AT) {
            let message = match (&location, &direction) {
                (None, Some(Coordinates { keyword, .. })) => {
                    format!("the place of `{owner}` stands before its direction: `{owner} at .. {keyword} ..`")
                }
                _ => format!("`{owner}` has its place already: remove this `at`"),
            };
            return Err(error_at(input, message));
        }
        if is_one_of(input, DIRECTIONS) {
            let word: Ident = input.fork().parse()?;
            return Err(error_at(input, format!("`{owner}` has its direction already: remove this `{word}`")));
        }
        match unknown_word(input) {
            Some(word) => Err(Error::new(word.span(), format!("`{word}` {}", advice(&word, owner)))),
            None => Ok(Suffixes { location, direction }),
        }
    }

    /// The place of what takes no direction; that of a path stands between arrows, behind some connection.
    pub(super) fn location_alone(self, connection: &str) -> Result<Option<Coordinates>> {
        match self.direction {
            None => Ok(self.location),
            Some(Coordinates { keyword, .. }) if keyword == NORMAL => {
                let message = "`normal` says in which direction a support holds: it stands behind `roller` or `guided`";
                Err(Error::new(keyword.span(), message))
            }
            Some(Coordinates { keyword, .. }) => Err(Error::new(
                keyword.span(),
                format!(
                    "`{keyword}` directs the path that acts on a connection: write it between arrows, `{connection} <- \
                     {keyword} {} <- ..`",
                    parts_behind(&keyword)
                ),
            )),
        }
    }
}

fn advice(word: &Ident, owner: &str) -> String {
    match nearest(BEHIND_NODES.iter().copied(), &word.to_string()) {
        Some(meant) => format!("says nothing of `{owner}`: did you mean `{meant}`?"),
        None => format!("says nothing of `{owner}`: its place is written `{owner} at (x, y)`"),
    }
}

/// A word that stands where `at` or `along` may: it is like one of them, or parentheses follow it.
fn unknown_word(input: ParseStream<'_>) -> Option<Ident> {
    let ahead = input.fork();
    let word: Ident = ahead.parse().ok()?;
    let is_like_one = nearest(BEHIND_NODES.iter().copied(), &word.to_string()).is_some();
    (ahead.peek(token::Paren) || is_like_one).then_some(word)
}

/// The parts of a direction, as advice shows them before the dimension is known.
fn parts_behind(keyword: &Ident) -> &'static str {
    if keyword == ABOUT { "(x, y, z)" } else { "(dx, dy)" }
}

/// Where the word of a direction stands, if a node cannot begin with it.
pub(super) fn stands_elsewhere(word: &Ident) -> Option<String> {
    if word == NORMAL {
        return Some(
            "`normal` stands behind a support, `roller at (x, y) normal (nx, ny)`: remove the arrow between".to_owned(),
        );
    }
    let is_of_path = word == ALONG || word == ABOUT;
    is_of_path.then(|| stands_between(word))
}

/// Where the direction of a path stands.
pub(super) fn stands_between(word: &Ident) -> String {
    let parts = parts_behind(word);
    format!("`{word}` stands between a connection and the path that acts on it, `conn a <- {word} {parts} <- ..`")
}

/// Whether a place or a direction follows, and no label of that name.
pub(super) fn is_suffix(input: ParseStream<'_>) -> bool {
    (is_word(input, AT) || is_one_of(input, DIRECTIONS)) && !input.peek2(token::Brace)
}

pub(super) fn is_one_of(input: ParseStream<'_>, words: &[&str]) -> bool {
    words.iter().any(|word| is_word(input, word))
}

pub(super) fn is_word(input: ParseStream<'_>, expected: &str) -> bool {
    input.fork().parse::<Ident>().is_ok_and(|word| word == expected)
}

/// Parses the coordinates behind `at` or the word of a direction, which end outside of brackets at an arrow, a `;` or another one of the words.
///
/// The tokens are cut there and parsed by themselves: `0.3 * l <- beam 1` would be a comparison.
pub(super) fn parse_coordinates(keyword: Ident, input: ParseStream<'_>) -> Result<Coordinates> {
    let mut tokens = TokenStream::new();
    while !(input.is_empty() || input.peek(Token![;]) || is_arrow(input)) {
        if !tokens.is_empty() && (is_word(input, AT) || is_one_of(input, DIRECTIONS)) {
            break;
        }
        tokens.extend([input.parse::<TokenTree>()?]);
    }
    if tokens.is_empty() {
        let message = if keyword == AT {
            "`at` says where a point is: write its coordinates behind, `at (x, y)`".to_owned()
        } else {
            let parts = parts_behind(&keyword);
            format!("`{keyword}` says in which direction: write its parts behind, `{keyword} {parts}`")
        };
        return Err(Error::new(keyword.span(), message));
    }
    depth::check_expression(tokens.clone())?;
    let value = whole.parse2(in_braces(tokens))?;
    Ok(Coordinates::new(keyword, value))
}

pub(super) fn is_arrow(input: ParseStream<'_>) -> bool {
    input.peek(Token![->]) || input.peek(Token![<-])
}

/// Parses an expression in braces, which stand at the end of it.
fn whole(input: ParseStream<'_>) -> Result<Expr> {
    let content;
    braced!(content in input);
    let value = content.parse()?;
    if content.is_empty() {
        return Ok(value);
    }
    let unread =
        error_at(&content, "expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`");
    // else it would be an error that tokens are left
    let _ = content.parse::<TokenStream>();
    Err(unread)
}

/// `(x, rz)`, behind `held`.
pub(super) fn held(keyword: &Ident, input: ParseStream<'_>) -> Result<Vec<Ident>> {
    if !input.peek(token::Paren) {
        return Err(Error::new(keyword.span(), "`held` names in parentheses what it holds, such as `held(x, rz)`"));
    }
    let content;
    parenthesized!(content in input);
    let mut freedoms = Vec::new();
    while !content.is_empty() {
        freedoms.push(expect(&content, "expected a freedom, such as `x`, `y` or `rz`")?);
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(error_at(&content, "expected `,` between freedoms"));
        }
    }
    Ok(freedoms)
}

fn expect(input: ParseStream<'_>, message: impl Display) -> Result<Ident> {
    input.fork().parse::<Ident>().map_err(|_| error_at(input, message))?;
    input.parse()
}
