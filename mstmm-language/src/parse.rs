//! Parses a model. This file knows the grammar and no element.

mod node;
mod suffix;

use crate::ast::{Arrow, Model, Section, TransferPath};
use crate::diagnostics::{Errors, Place};
use crate::keywords::{ABOUT, ALONG, SECTION};
use crate::spans::collect_names;
use proc_macro2::{Group, Punct, Spacing, Span, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::fmt::Display;
use suffix::{is_arrow, is_one_of, is_word, parse_coordinates, stands_between};
use syn::parse::{Parse, ParseStream, Parser, Result};
use syn::{
    Attribute, Error, Ident, ItemStruct, LitInt, Local, LocalInit, LocalModifiers, Pat, PatType, Token, Visibility,
    braced, token,
};

/// Parses `{ (path to mstmm) model }`, where the braces stand for the end of the input. Lines that cannot be read are left
/// out, each with an error; without its struct a model is none.
pub(crate) fn model(input: TokenStream, errors: &mut Errors) -> Result<Model> {
    let mut model = None;
    let outcome = (|input: ParseStream<'_>| -> Result<()> {
        model = Some(read(input, errors)?);
        Ok(())
    })
    .parse2(input);
    match model {
        // tokens that a wrong line leaves unread inside of brackets are no further error
        Some(model) if !model.is_whole => Ok(model),
        Some(model) => outcome.map(|()| model),
        None => Err(outcome.err().unwrap_or_else(|| Error::new(Span::call_site(), "this model cannot be read"))),
    }
}

fn read(input: ParseStream<'_>, errors: &mut Errors) -> Result<Model> {
    let content;
    braced!(content in input);
    let facade: Group = content.parse()?;
    let mut names = BTreeSet::new();
    collect_names(content.cursor().token_stream(), &mut names);
    let parameters = parse_struct(&content)?;
    let mut lets = Vec::new();
    while content.peek(Token![let]) {
        lets.extend(recover(&content, parse_let, errors));
    }
    let mut sections = Vec::new();
    while is_section(&content) {
        // a section that cannot be read ends with its braces
        sections.extend(content.parse::<Section>().map_err(|error| errors.add(error)));
        content.parse::<Option<Token![;]>>()?;
    }
    let mut paths = Vec::new();
    while !content.is_empty() {
        paths.extend(recover(&content, TransferPath::parse, errors));
    }
    Ok(Model { facade: facade.stream(), parameters, lets, sections, paths, is_whole: errors.is_empty(), names })
}

/// Parses a line and its `;`. A wrong line is skipped up to the next `;`, so that the other lines are read.
fn recover<T>(input: ParseStream<'_>, parse: fn(ParseStream<'_>) -> Result<T>, errors: &mut Errors) -> Option<T> {
    let line = parse(input).map_err(|error| errors.add(error)).ok();
    while !input.is_empty() && !input.peek(Token![;]) && line.is_none() {
        // any token tree will do
        let _ = input.parse::<TokenTree>();
    }
    let _ = input.parse::<Option<Token![;]>>();
    line
}

/// The struct that a model begins with.
fn parse_struct(input: ParseStream<'_>) -> Result<ItemStruct> {
    let ahead = input.fork();
    let header = ahead.call(Attribute::parse_outer).and_then(|_| ahead.parse::<Visibility>());
    if header.is_ok() && !ahead.peek(Token![struct]) {
        let message = "a model begins with its struct of parameters, `struct Model { length: f64, .. }`";
        return Err(error_at(&ahead, message));
    }
    input.parse()
}

/// `let pattern = expression`, with or without a type, as a statement.
fn parse_let(input: ParseStream<'_>) -> Result<Local> {
    let let_token: Token![let] = input.parse()?;
    if input.peek(Token![=]) {
        return Err(error_at(input, "expected a name: a `let` line gives a value a name, `let name = expression;`"));
    }
    let mut pat = Pat::parse_single(input)?;
    if let Some(colon_token) = input.parse::<Option<Token![:]>>()? {
        pat = Pat::Type(PatType { attrs: Vec::new(), pat: Box::new(pat), colon_token, ty: input.parse()? });
    }
    if !input.peek(Token![=]) {
        return Err(error_at(input, "expected `=`: a `let` line gives a value a name, `let name = expression;`"));
    }
    let init = Some(LocalInit { eq_token: input.parse()?, expr: input.parse()?, diverge: None });
    if input.peek(Token![else]) {
        return Err(error_at(input, "a `let` line takes no `else`: its pattern must always match"));
    }
    if !input.peek(Token![;]) {
        return Err(error_at(input, "expected `;` at the end of the `let` line"));
    }
    // the user's own token, at which rustc shows what it would put before
    let semi_token = input.fork().parse()?;
    Ok(Local { attrs: Vec::new(), let_token, modifiers: LocalModifiers::default(), pat, init, semi_token })
}

/// Whether a section begins here.
fn is_section(input: ParseStream<'_>) -> bool {
    is_word(input, SECTION) && !input.peek2(LitInt) && !input.peek2(Token![->]) && !input.peek2(Token![<-])
}

impl Parse for Section {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let keyword: Ident = input.parse()?;
        let advice = "a section has a name and parameters, `section steel { bending_stiffness: ei, .. }`";
        let name = input.parse::<Ident>();
        if !input.peek(token::Brace) {
            return Err(Error::new(name.map_or(keyword.span(), |name| name.span()), advice));
        }
        let Ok(name) = name else {
            input.parse::<TokenTree>()?;
            return Err(Error::new(keyword.span(), advice));
        };
        let (parameters, spread) = node::parse_parameters(input)?;
        if let Some(section) = spread.first() {
            let message = format!("a section takes no other one: write `..{section}` in the elements that have both");
            return Err(Error::new(section.span(), message));
        }
        Ok(Section { name, parameters })
    }
}

impl Parse for TransferPath {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        if input.peek(Token![let]) {
            return Err(error_at(input, "`let` lines stand between the struct and the first path: move this one up"));
        }
        if is_section(input) {
            return Err(error_at(input, "sections stand between the `let` lines and the first path: move this one up"));
        }
        if input.peek(Token![#]) {
            return Err(error_at(
                input,
                "attributes stand in front of the struct and of its fields alone: remove this one",
            ));
        }
        if input.peek(Token![;]) {
            return Err(error_at(input, "there is no path before this `;`: remove it"));
        }
        let first = input.parse()?;
        let mut rest = Vec::new();
        while !input.is_empty() && !input.peek(Token![;]) {
            rest.push((input.parse()?, input.parse()?));
        }
        Ok(TransferPath { first, rest })
    }
}

impl Parse for Arrow {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let (forward, place) = parse_arrow(input)?;
        if !is_one_of(input, &[ALONG, ABOUT]) {
            return Ok(Arrow { forward, place, along: None });
        }
        let along = parse_coordinates(input.parse()?, input)?;
        let word = &along.keyword;
        if !is_arrow(input) {
            return Err(Error::new(word.span(), stands_between(word)));
        }
        let ahead = input.fork();
        if parse_arrow(input)?.0 != forward {
            let message = format!(
                "the arrows on both sides of `{word}` are one: turn one of them round, so that both point one way"
            );
            return Err(error_at(&ahead, message));
        }
        if is_one_of(input, &[ALONG, ABOUT]) {
            let second: Ident = input.fork().parse()?;
            return Err(error_at(input, format!("the path has its direction already: remove this `{second}`")));
        }
        Ok(Arrow { forward, place, along: Some(along) })
    }
}

/// `->` or `<-`: whether it points forward, and its tokens.
fn parse_arrow(input: ParseStream<'_>) -> Result<(bool, Place)> {
    let forward = input.peek(Token![->]);
    if input.peek(token::Paren) {
        return Err(error_at(input, "parameters stand in braces, `{ name: value, .. }`, and nodes between arrows"));
    }
    if !forward && !input.peek(Token![<-]) {
        return Err(error_at(
            input,
            "expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`",
        ));
    }
    let [first, last] = if forward { input.parse::<Token![->]>()?.spans } else { input.parse::<Token![<-]>()?.spans };
    Ok((forward, Place { first, last }))
}

/// An error at the next token: at all characters of an arrow, at the opening brace of a block.
fn error_at(input: ParseStream<'_>, message: impl Display) -> Error {
    let ahead = input.fork();
    match ahead.parse() {
        Ok(TokenTree::Punct(first)) if first.spacing() == Spacing::Joint => {
            let last = ahead.parse::<Punct>().map_or_else(|_| first.span(), |punct| punct.span());
            Error::new_spanned(Place { first: first.span(), last }, message)
        }
        Ok(TokenTree::Group(group)) => Error::new(group.span_open(), message),
        _ => Error::new(input.span(), message),
    }
}
