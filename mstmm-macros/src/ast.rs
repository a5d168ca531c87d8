//! The syntax tree of a model: what the user wrote, nothing concluded from it.

use proc_macro2::{Span, TokenStream};
use std::fmt;
use syn::{Expr, Ident, ItemStruct, LitInt, Path};

/// A whole model.
pub(crate) struct Model {
    /// Path to the facade crate, from the wrapper macro.
    pub(crate) facade: TokenStream,
    /// The struct of parameters.
    pub(crate) parameters: ItemStruct,
    /// Derived quantities, as statements.
    pub(crate) lets: Vec<syn::Local>,
    /// The sketch.
    pub(crate) paths: Vec<TransferPath>,
}

/// `node (arrow node)* ;`
pub(crate) struct TransferPath {
    pub(crate) first: Node,
    pub(crate) rest: Vec<(Arrow, Node)>,
}

/// A transfer direction.
pub(crate) struct Arrow {
    pub(crate) forward: bool,
    pub(crate) span: Span,
}

/// What stands between arrows.
pub(crate) enum Node {
    Support(Ident),
    Connection(Label),
    Element(Box<Element>),
}

/// An element with its label and parameters.
pub(crate) struct Element {
    pub(crate) kind: Kind,
    pub(crate) label: Label,
    pub(crate) parameters: Vec<Parameter>,
}

/// Which element it is: a keyword of the language or a type of the user's own.
pub(crate) enum Kind {
    Keyword(Ident),
    Type(Path),
}

/// `name: value`, or the shorthand `name`.
pub(crate) struct Parameter {
    pub(crate) name: Ident,
    pub(crate) value: Option<Expr>,
}

/// The name of an element or a connection.
pub(crate) enum Label {
    Name(Ident),
    Number(LitInt),
}

impl Label {
    pub(crate) fn span(&self) -> Span {
        match self {
            Label::Name(name) => name.span(),
            Label::Number(number) => number.span(),
        }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Label::Name(name) => write!(f, "{}", syn::ext::IdentExt::unraw(name)),
            Label::Number(number) => write!(f, "{}", number.base10_digits()),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Kind::Keyword(keyword) => write!(f, "{keyword}"),
            Kind::Type(path) => match path.segments.last() {
                Some(segment) => write!(f, "{}", segment.ident),
                None => Ok(()),
            },
        }
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind, self.label)
    }
}
