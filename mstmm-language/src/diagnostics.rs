//! Collects errors, so that all of a stage are reported together.

use proc_macro2::{Ident, Span, TokenStream};
use quote::ToTokens;
use std::fmt::Display;

/// The tokens that an error is about: from the first to the last.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub(crate) first: Span,
    pub(crate) last: Span,
}

impl From<Span> for Place {
    fn from(span: Span) -> Self {
        Place { first: span, last: span }
    }
}

/// An error takes its place from the spans of these tokens; the tokens themselves do not matter.
impl ToTokens for Place {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens
            .extend([Ident::new("first", self.first), Ident::new("last", self.last)].map(ToTokens::into_token_stream));
    }
}

/// The errors found so far.
#[derive(Default)]
pub(crate) struct Errors(Option<syn::Error>);

impl Errors {
    /// Adds an error at the user's tokens.
    pub(crate) fn push(&mut self, place: impl Into<Place>, message: impl Display) {
        self.add(syn::Error::new_spanned(place.into(), message));
    }

    /// Adds an error that knows its place.
    pub(crate) fn add(&mut self, error: syn::Error) {
        match &mut self.0 {
            None => self.0 = Some(error),
            Some(errors) => errors.combine(error),
        }
    }

    /// Whether there is none so far.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// All errors at once, or none.
    pub(crate) fn propagate(self) -> syn::Result<()> {
        match self.0 {
            None => Ok(()),
            Some(errors) => Err(errors),
        }
    }
}
