//! Parses the nodes between arrows: supports, connections, elements.

use super::error_at;
use super::suffix::{BEHIND_NODES, Suffixes, held, is_one_of, is_suffix, stands_elsewhere};
use crate::ast::{Connection, Element, Kind, Label, Node, Parameter, Support};
use crate::depth::is_keyword;
use crate::diagnostics::Place;
use crate::keywords::{AT, CONNECTION, Dimension, HELD, apart, support_of};
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream, Result};
use syn::{Error, Ident, Lit, LitInt, Path, Token, braced, token};

impl Parse for Node {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let is_type = input.peek(Token![::]) || (input.peek(Ident::peek_any) && input.peek2(Token![::]));
        if is_type {
            let kind = Kind::Type(Path::parse_mod_style(input)?);
            if is_keyword(kind.name()) {
                let message =
                    format!("`{}` is no type: the path of an element ends in the name of its type", kind.name());
                return Err(Error::new(kind.name().span(), message));
            }
            return parse_element(kind, input);
        }
        if input.peek(Token![for]) || input.peek(Token![while]) || input.peek(Token![loop]) {
            let message = "a sketch has no loops: write each cell, or describe the structure at run time by a `Frame` or a list of steps";
            return Err(error_at(input, message));
        }
        let Ok(keyword) = input.parse::<Ident>() else {
            let expected = "expected a support, a connection `conn ..` or an element";
            let hint =
                input.fork().parse::<LitInt>().map_or(String::new(), |label| format!(", such as `conn {label}`"));
            return Err(error_at(input, format!("{expected}{hint}")));
        };
        if keyword == CONNECTION {
            let label = parse_label(input, &keyword, keyword.span().into(), "")?;
            if input.peek(token::Brace) {
                return Err(error_at(input, format!("`{keyword} {label}` joins paths: it takes no parameters")));
            }
            let owner = format!("{keyword} {label}");
            let location = Suffixes::parse(input, &owner)?.location_alone(&owner)?;
            return Ok(Node::Connection(Connection { keyword, label, location }));
        }
        if let Some(message) = stands_elsewhere(&keyword) {
            return Err(Error::new(keyword.span(), message));
        }
        if keyword == AT {
            let message = "`at` stands behind a connection or a support, whose place it says: remove the arrow between";
            return Err(Error::new(keyword.span(), message));
        }
        if keyword == HELD || ends_here(&keyword, input) {
            let held = if keyword == HELD { Some(held(&keyword, input)?) } else { None };
            let Suffixes { location, direction } = Suffixes::parse(input, &keyword.to_string())?;
            return Ok(Node::Support(Support { keyword, held, location, direction }));
        }
        parse_element(Kind::Keyword(keyword), input)
    }
}

/// Whether a word stands alone, as supports do.
///
/// The name of a support does so unless a label with parameters follows: then something is wrong with the support, and
/// else an arrow or a `;` is missing behind it.
fn ends_here(keyword: &Ident, input: ParseStream<'_>) -> bool {
    if support_of(&keyword.to_string()).is_some() {
        let takes_label = input.peek(LitInt) || (input.peek(Ident) && input.peek2(token::Brace));
        return !takes_label || is_one_of(input, BEHIND_NODES);
    }
    is_suffix(input) || input.is_empty() || input.peek(Token![->]) || input.peek(Token![<-]) || input.peek(Token![;])
}

/// `label { parameters }`, behind the kind of an element.
fn parse_element(kind: Kind, input: ParseStream<'_>) -> Result<Node> {
    if input.peek(Token![<]) {
        return Err(error_at(input, "the type of an element is written without generic arguments"));
    }
    let label = parse_label(input, kind.name(), kind.place(), " { .. }")?;
    let (parameters, spread) = match input.peek(token::Brace).then(|| parse_parameters(input)).transpose()? {
        Some((parameters, spread)) => (Some(parameters), spread),
        None => (None, Vec::new()),
    };
    let owner = format!("{} {label}", kind.name());
    let location = if is_suffix(input) { Suffixes::parse(input, &owner)?.location_alone("conn a")? } else { None };
    let dimension = Dimension::Line;
    let (part_row, parts) = (None, [None, None, None]);
    Ok(Node::Element(Box::new(Element { kind, label, parameters, spread, dimension, location, part_row, parts })))
}

/// `{ name: value, name, ..section }`: parameters and sections.
pub(super) fn parse_parameters(input: ParseStream<'_>) -> Result<(Vec<Parameter>, Vec<Ident>)> {
    let content;
    braced!(content in input);
    let (mut parameters, mut sections) = (Vec::new(), Vec::new());
    while !content.is_empty() {
        if content.peek(Token![..]) {
            let dots: Token![..] = content.parse()?;
            let message = "`..` stands before the name of a section, whose parameters the element takes: `..steel`";
            let name = content.parse::<Ident>().map_err(|_| Error::new_spanned(dots, message))?;
            sections.push(name);
        } else {
            parameters.push(content.parse()?);
        }
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(error_at(&content, "expected `,` between parameters"));
        }
    }
    Ok((parameters, sections))
}

/// A name or a number, behind `owner`.
fn parse_label(input: ParseStream<'_>, owner: &Ident, place: Place, rest: &str) -> Result<Label> {
    if input.peek(Ident) {
        return Ok(Label::Name(input.parse()?));
    }
    if input.peek(Lit) {
        return Ok(Label::Literal(input.parse()?));
    }
    if input.peek(Ident::peek_any) {
        let word = input.call(Ident::parse_any)?;
        return Err(Error::new(word.span(), format!("`{word}` is a word of Rust: give `{owner}` another label")));
    }
    let text = owner.to_string();
    let advice = match apart(&text) {
        Some(apart) => format!("put a space before the label, `{apart}{rest}`"),
        None => format!("`{text}` needs a label, a name or a number: `{text} 1{rest}`"),
    };
    Err(Error::new_spanned(place, advice))
}

impl Parse for Parameter {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let Ok(name) = input.parse::<Ident>() else {
            let message = "expected a parameter, `name: value`, or `name` alone for the value of that name";
            return Err(error_at(input, message));
        };
        if input.is_empty() || input.peek(Token![,]) {
            return Ok(Parameter { name, value: None, section: None, is_told: false, called: None });
        }
        if input.peek(Token![;]) || input.peek2(Token![:]) || input.peek2(Token![,]) {
            return Err(error_at(input, "expected `,` between parameters"));
        }
        if !input.peek(Token![:]) {
            return Err(error_at(input, format!("expected `:`: a parameter is written `{name}: value`")));
        }
        input.parse::<Token![:]>()?;
        Ok(Parameter { name, value: Some(input.parse()?), section: None, is_told: false, called: None })
    }
}
