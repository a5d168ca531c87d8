//! Parses a model. This file knows the grammar and no element.

use crate::ast::{Arrow, Element, Kind, Label, Model, Node, Parameter, TransferPath};
use crate::keywords::CONNECTION;
use proc_macro2::{Group, Span};
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Result};
use syn::{Ident, ItemStruct, LitFloat, LitInt, Path, Stmt, Token, braced, token};

impl Parse for Model {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let facade: Group = input.parse()?;
        let parameters: ItemStruct = input.parse()?;
        let mut lets = Vec::new();
        while input.peek(Token![let]) {
            lets.push(parse_let(input)?);
        }
        let mut paths = Vec::new();
        while !input.is_empty() {
            paths.push(input.parse()?);
            if !input.is_empty() {
                input.parse::<Token![;]>()?;
            }
        }
        Ok(Model { facade: facade.stream(), parameters, lets, paths })
    }
}

/// `let name = expression;`
fn parse_let(input: ParseStream<'_>) -> Result<syn::Local> {
    match input.parse()? {
        Stmt::Local(line) => Ok(line),
        other => Err(syn::Error::new_spanned(other, "expected `let name = expression;`")),
    }
}

impl Parse for TransferPath {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
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
        if input.peek(Token![->]) {
            let arrow: Token![->] = input.parse()?;
            return Ok(Arrow { forward: true, span: arrow.spans[0] });
        }
        if input.peek(Token![<-]) {
            let arrow: Token![<-] = input.parse()?;
            return Ok(Arrow { forward: false, span: arrow.spans[0] });
        }
        Err(input.error("expected an arrow, `->` or `<-`, or `;` at the end of the path"))
    }
}

impl Parse for Node {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let is_type = input.peek(Token![::]) || (input.peek(Ident::peek_any) && input.peek2(Token![::]));
        if is_type {
            let path = Path::parse_mod_style(input)?;
            return parse_element(Kind::Type(path), input);
        }
        let Ok(keyword) = input.parse::<Ident>() else {
            return Err(input.error("expected a support, a connection `conn ..` or an element"));
        };
        if keyword == CONNECTION {
            return Ok(Node::Connection(parse_label(input, &keyword)?));
        }
        if input.is_empty() || input.peek(Token![->]) || input.peek(Token![<-]) || input.peek(Token![;]) {
            return Ok(Node::Support(keyword));
        }
        parse_element(Kind::Keyword(keyword), input)
    }
}

/// `label { parameters }`, behind the kind of an element.
fn parse_element(kind: Kind, input: ParseStream<'_>) -> Result<Node> {
    let label = parse_label(input, &kind)?;
    if !input.peek(token::Brace) {
        return Err(
            input.error(format!("expected the parameters of `{kind} {label}` in braces, `{{ name: value, .. }}`"))
        );
    }
    let content;
    braced!(content in input);
    let parameters = content.parse_terminated(Parameter::parse, Token![,])?.into_iter().collect();
    Ok(Node::Element(Box::new(Element { kind, label, parameters })))
}

/// A name, or a decimal number without leading zero or suffix.
fn parse_label(input: ParseStream<'_>, owner: &dyn std::fmt::Display) -> Result<Label> {
    if input.peek(Ident) {
        return Ok(Label::Name(input.parse()?));
    }
    let malformed = |span: Span, text: &str| {
        let advice = "a label is a name or a decimal number without leading zero or suffix, such as `arm` or `12`";
        Err(syn::Error::new(span, format!("`{text}` is not a label: {advice}")))
    };
    if input.peek(LitInt) {
        let number: LitInt = input.parse()?;
        let text = number.to_string();
        let plain = text.bytes().all(|b| b.is_ascii_digit()) && (text == "0" || !text.starts_with('0'));
        return if plain { Ok(Label::Number(number)) } else { malformed(number.span(), &text) };
    }
    if input.peek(LitFloat) {
        let number: LitFloat = input.parse()?;
        return malformed(number.span(), &number.to_string());
    }
    Err(input.error(format!("expected a label after `{owner}`: a name or a number, such as `{owner} 1`")))
}

impl Parse for Parameter {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name: Ident = input.parse()?;
        let value = if input.peek(Token![:]) {
            input.parse::<Token![:]>()?;
            Some(input.parse()?)
        } else {
            None
        };
        Ok(Parameter { name, value })
    }
}
