//! What checks of a network find: errors, and what is wrong if elements of the user's own are what rustc alone knows.

use crate::ast::Element;
use crate::diagnostics::{Errors, Place};
use crate::network::Suspicion;
use mstmm_plan::Space;

/// Errors and suspicions found so far.
pub(super) struct Findings<'a> {
    pub(super) errors: Errors,
    pub(super) suspicions: Vec<Suspicion<'a>>,
}

impl<'a> Findings<'a> {
    /// Adds an error.
    pub(super) fn error(&mut self, place: impl Into<Place>, message: String) {
        self.errors.push(place, message);
    }

    /// Adds errors.
    pub(super) fn errors_of(&mut self, all: Vec<(Place, String)>) {
        all.into_iter().for_each(|(place, message)| self.error(place, message));
    }

    /// Adds what is wrong if all of some elements of the user's own have these states; an error, if there are none.
    pub(super) fn suspect(
        &mut self,
        place: impl Into<Place>,
        message: String,
        of: impl IntoIterator<Item = (&'a Element, Space)>,
    ) {
        let of: Vec<_> = of.into_iter().collect();
        if of.is_empty() {
            return self.error(place, message);
        }
        self.suspicions.push(Suspicion { place: place.into(), message, of });
    }

    /// Adds all that is wrong if an element of the user's own has these states.
    pub(super) fn suspect_all(&mut self, all: Vec<(Place, String)>, of: (&'a Element, Space)) {
        all.into_iter().for_each(|(place, message)| self.suspect(place, message, [of]));
    }
}
