//! The states at both ends of an element.

use crate::model::state::State;

/// The states at both ends of an element, at the frequency at which they belong together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ends<S> {
    /// The frequency: ω for a real scalar, λ for a complex one.
    pub x: S,
    /// State at the input end.
    pub input: State<S>,
    /// State at the output end.
    pub output: State<S>,
}
