//! The syntax tree of a model, as the user wrote it.

mod coordinates;
mod row;

pub(crate) use coordinates::{Coordinates, place_of, tuple_parts};

use crate::diagnostics::Place;
use crate::keywords::{Dimension, Keyword};
use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use std::collections::BTreeSet;
use std::fmt;
use syn::ext::IdentExt;
use syn::{Attribute, Expr, ExprPath, Ident, ItemStruct, Lit, Local, Path, Type};

/// A whole model.
pub(crate) struct Model {
    /// Path to the facade crate, from the wrapper macro.
    pub(crate) facade: TokenStream,
    /// The struct of parameters.
    pub(crate) parameters: ItemStruct,
    /// Derived quantities, as statements.
    pub(crate) lets: Vec<Local>,
    /// Parameters that elements share.
    pub(crate) sections: Vec<Section>,
    /// The sketch.
    pub(crate) paths: Vec<TransferPath>,
    /// Whether every line could be read.
    pub(crate) is_whole: bool,
    /// Every name that occurs in the model, for emitted names that must differ from them.
    pub(crate) names: BTreeSet<String>,
}

/// The attribute of fields that formulas take as plain numbers.
pub(crate) const NO_SENSITIVITY: &str = "no_sensitivity";

/// A field of the struct of parameters.
pub(crate) struct Field<'a> {
    pub(crate) name: &'a Ident,
    /// Its type, which should be `f64`.
    pub(crate) kind: &'a Type,
    /// Its `#[cfg(..)]` attributes.
    pub(crate) conditions: Vec<&'a Attribute>,
    /// Whether it has a derivative: it is not marked by `#[no_sensitivity]`.
    pub(crate) has_derivative: bool,
}

impl Model {
    /// The fields of the struct of parameters.
    pub(crate) fn fields(&self) -> impl Iterator<Item = Field<'_>> {
        self.parameters.fields.iter().filter_map(|field| {
            let named =
                |name: &'static str| field.attrs.iter().filter(move |attribute| attribute.path().is_ident(name));
            let has_derivative = named(NO_SENSITIVITY).next().is_none();
            Some(Field {
                name: field.ident.as_ref()?,
                kind: &field.ty,
                conditions: named("cfg").collect(),
                has_derivative,
            })
        })
    }

    /// All nodes in the order of the source.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.paths.iter().flat_map(|path| std::iter::once(&path.first).chain(path.rest.iter().map(|(_, node)| node)))
    }

    /// All elements in the order of the source.
    pub(crate) fn elements(&self) -> impl Iterator<Item = &Element> {
        self.nodes().filter_map(|node| match node {
            Node::Element(element) => Some(&**element),
            Node::Support(_) | Node::Connection(_) => None,
        })
    }

    /// All elements, to be changed.
    pub(crate) fn elements_mut(&mut self) -> impl Iterator<Item = &mut Element> {
        let nodes = self
            .paths
            .iter_mut()
            .flat_map(|path| std::iter::once(&mut path.first).chain(path.rest.iter_mut().map(|(_, node)| node)));
        nodes.filter_map(|node| match node {
            Node::Element(element) => Some(&mut **element),
            Node::Support(_) | Node::Connection(_) => None,
        })
    }

    /// All arrows in the order of the source.
    pub(crate) fn arrows(&self) -> impl Iterator<Item = &Arrow> {
        self.paths.iter().flat_map(|path| path.rest.iter().map(|(arrow, _)| arrow))
    }

    /// Whether a point has a location: the model then is a network of points, and else a tree of paths.
    pub(crate) fn is_located(&self) -> bool {
        self.nodes().any(|node| node.location().is_some())
    }

    /// All places, then all directions.
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = &Coordinates> {
        let of_supports = self.nodes().filter_map(|node| match node {
            Node::Support(support) => support.direction.as_ref(),
            Node::Connection(_) | Node::Element(_) => None,
        });
        let of_paths = self.arrows().filter_map(|arrow| arrow.along.as_ref());
        self.nodes().filter_map(Node::location).chain(of_supports).chain(of_paths)
    }
}

/// `section steel { axial_stiffness: ea, .. }`
pub(crate) struct Section {
    pub(crate) name: Ident,
    pub(crate) parameters: Vec<Parameter>,
}

/// `node (arrow node)* ;`
pub(crate) struct TransferPath {
    pub(crate) first: Node,
    pub(crate) rest: Vec<(Arrow, Node)>,
}

/// A transfer direction.
pub(crate) struct Arrow {
    pub(crate) forward: bool,
    pub(crate) place: Place,
    /// The direction in the middle of the arrow, `-> along (dx, dy) ->` or `-> about (x, y, z) ->`, in which a path acts on a connection.
    pub(crate) along: Option<Coordinates>,
}

/// A node of the sketch, between arrows.
pub(crate) enum Node {
    Support(Support),
    Connection(Connection),
    Element(Box<Element>),
}

/// A mention of a support, `pinned` or `roller at (x, y) along (dx, dy)`, `roller at (x, y, z) normal (nx, ny, nz)`.
pub(crate) struct Support {
    pub(crate) keyword: Ident,
    /// The freedoms in the parentheses of `held(x, rz)`.
    pub(crate) held: Option<Vec<Ident>>,
    pub(crate) location: Option<Coordinates>,
    pub(crate) direction: Option<Coordinates>,
}

/// A mention of a connection, `conn 2` or `conn 2 at (x, y)`.
pub(crate) struct Connection {
    pub(crate) keyword: Ident,
    pub(crate) label: Label,
    pub(crate) location: Option<Coordinates>,
}

/// An element with its label and parameters.
pub(crate) struct Element {
    pub(crate) kind: Kind,
    pub(crate) label: Label,
    /// `None` where there are no braces: a mistake that `check` explains.
    pub(crate) parameters: Option<Vec<Parameter>>,
    /// The sections that stand among the parameters, `..steel`: of those that there are, the parameters take the place.
    pub(crate) spread: Vec<Ident>,
    /// The dimension of the model, as soon as it is known: what a keyword is depends on it.
    pub(crate) dimension: Dimension,
    /// A mistake that `check` explains: points have locations, elements have none.
    pub(crate) location: Option<Coordinates>,
    /// The row of what it is as a part of another element.
    pub(crate) part_row: Option<&'static Keyword>,
    /// Its parts in space, by their planes: that of x and y, that of x and z, and the rotation about x.
    pub(crate) parts: [Option<Box<Element>>; 3],
}

/// The kind of an element: a keyword of the language or a type of the user.
#[derive(Clone)]
pub(crate) enum Kind {
    Keyword(Ident),
    Type(Path),
}

/// `name: value`, or the shorthand `name`.
#[derive(Clone)]
pub(crate) struct Parameter {
    pub(crate) name: Ident,
    pub(crate) value: Option<Expr>,
    /// The section that gives it.
    pub(crate) section: Option<Ident>,
    /// Whether what is wrong with its name was told of another element.
    pub(crate) is_told: bool,
    /// What the model calls it, where it is that of a part and has another name there.
    pub(crate) called: Option<&'static str>,
}

/// The name of an element or a connection.
#[derive(Clone)]
pub(crate) enum Label {
    Name(Ident),
    /// A number; `check` refuses other literals.
    Literal(Lit),
}

impl Node {
    pub(crate) fn location(&self) -> Option<&Coordinates> {
        match self {
            Node::Support(support) => support.location.as_ref(),
            Node::Connection(connection) => connection.location.as_ref(),
            Node::Element(element) => element.location.as_ref(),
        }
    }
}

impl Connection {
    /// `conn 2`
    pub(crate) fn place(&self) -> Place {
        Place { first: self.keyword.span(), last: self.label.span() }
    }
}

impl Element {
    /// `beam 1`
    pub(crate) fn place(&self) -> Place {
        Place { first: self.kind.place().first, last: self.label.span() }
    }

    pub(crate) fn parameters(&self) -> impl Iterator<Item = &Parameter> {
        self.parameters.iter().flatten()
    }

    /// The parts of a parameter; one of another expression than a tuple, none where it is not given.
    pub(crate) fn tuple(&self, name: &str) -> Vec<Expr> {
        let mut named = self.parameters().filter(|parameter| parameter.name.unraw() == name);
        let value = named.next().map(|parameter| parameter.expression());
        value.map_or_else(Vec::new, |value| match tuple_parts(&value) {
            Some(parts) => parts.into_iter().cloned().collect(),
            None => vec![value],
        })
    }

    /// Whether a parameter of that name is given.
    pub(crate) fn gives(&self, name: &str) -> bool {
        self.parameters().any(|parameter| parameter.name.unraw() == name)
    }
}

impl Kind {
    /// The name of the type.
    pub(crate) fn name(&self) -> &Ident {
        match self {
            Kind::Keyword(keyword) => keyword,
            // a parsed path has a segment
            Kind::Type(path) => &path.segments[path.segments.len() - 1].ident,
        }
    }

    pub(crate) fn place(&self) -> Place {
        let last = self.name().span();
        match self {
            Kind::Keyword(_) => last.into(),
            Kind::Type(path) => {
                let first = path.leading_colon.map_or_else(|| path.segments[0].ident.span(), |colon| colon.spans[0]);
                Place { first, last }
            }
        }
    }
}

impl Parameter {
    /// The value, which for the shorthand is the variable of that name.
    pub(crate) fn expression(&self) -> Expr {
        let variable = || ExprPath { attrs: Vec::new(), qself: None, path: self.name.clone().into() };
        self.value.clone().unwrap_or_else(|| Expr::Path(variable()))
    }
}

impl Label {
    /// Whether it is a name, or a decimal number without leading zero or suffix.
    pub(crate) fn is_well_formed(&self) -> bool {
        let Label::Literal(literal) = self else { return true };
        let text = self.to_string();
        let is_plain = text.bytes().all(|b| b.is_ascii_digit()) && (text == "0" || !text.starts_with('0'));
        is_plain && matches!(literal, Lit::Int(_))
    }

    pub(crate) fn span(&self) -> Span {
        match self {
            Label::Name(name) => name.span(),
            Label::Literal(literal) => literal.span(),
        }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Label::Name(name) => write!(f, "{}", syn::ext::IdentExt::unraw(name)),
            Label::Literal(literal) => write!(f, "{}", literal.to_token_stream()),
        }
    }
}

impl fmt::Display for Connection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.keyword, self.label)
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind.name(), self.label)
    }
}
