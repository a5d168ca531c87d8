//! Collects errors, so that all of a stage are reported together.

use proc_macro2::Span;
use std::fmt::Display;

/// The errors of one stage.
#[derive(Default)]
pub(crate) struct Errors(Option<syn::Error>);

impl Errors {
    /// Adds an error at the user's token.
    pub(crate) fn push(&mut self, span: Span, message: impl Display) {
        let error = syn::Error::new(span, message);
        match &mut self.0 {
            None => self.0 = Some(error),
            Some(errors) => errors.combine(error),
        }
    }

    /// Ends the stage: all errors at once, or none.
    pub(crate) fn propagate(self) -> syn::Result<()> {
        match self.0 {
            None => Ok(()),
            Some(errors) => Err(errors),
        }
    }
}
