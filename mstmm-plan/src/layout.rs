//! Where everything stands in `U_all`: the plan of a tree of transfer paths, resolved into spaces, columns and rows.
//!
//! The macro emits the tree as a constant list of [`Step`]s; [`Layout::new`] resolves it in that constant. What a state space
//! is worth only the element types know, so it is settled there and not in the macro.

use crate::resolve::resolve;
use crate::scheme::{Place, Scheme};
use crate::step::Step;

/// A plan of `STEPS` steps with its places: what a constant holds.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a, const STEPS: usize> {
    steps: [Step<'a>; STEPS],
    places: [Place; STEPS],
    inputs: [usize; STEPS],
}

impl<'a, const STEPS: usize> Layout<'a, STEPS> {
    /// Resolves a plan, as [`Scheme::resolve`] does.
    pub const fn new(steps: [Step<'a>; STEPS]) -> Self {
        let mut layout = Layout { steps, places: [Place::NOWHERE; STEPS], inputs: [0; STEPS] };
        resolve(&layout.steps, &mut layout.places, &mut layout.inputs);
        layout
    }

    /// The resolved plan.
    #[inline]
    pub const fn scheme(&'a self) -> Scheme<'a> {
        Scheme { steps: &self.steps, places: &self.places, inputs: &self.inputs }
    }
}

#[cfg(test)]
mod tests;
