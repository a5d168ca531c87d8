//! What is measured besides the paper's examples: chains of any length, and one beam for its many roots.

use core::f64::consts::PI;
use core::ops::RangeInclusive;
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;

pub mod frames;

/// A chain whose steps live as long as the program.
pub type BeamChain = StepList<'static, AnyUndamped<f64>>;

system! {
    /// Pinned beam with EI = m = l = 1: mode n is at (nπ)².
    #[derive(Clone, Copy, Debug)]
    pub struct PinnedBeam {}
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned
}

/// What cannot fail with parameters that are valid.
pub fn valid<Y, E>(result: Result<Y, E>) -> Y {
    let Ok(value) = result else { unreachable!("what is measured is valid") };
    value
}

/// The same where it is, so that a measurement does not begin with a copy.
pub fn kept<Y, E>(result: Result<Y, E>) -> &'static Y {
    Box::leak(Box::new(valid(result)))
}

/// A clamped chain of so many beams with EI = m = l = 1, each evaluated for itself: a list knows no equal elements.
pub fn chain(elements: usize) -> BeamChain {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let beam = ListStep::Element(valid(AnyUndamped::try_from(beam)));
    let mut steps = vec![ListStep::Tip(Support::Fixed)];
    steps.extend(std::iter::repeat_n(beam, elements));
    steps.push(ListStep::Root(Support::Free));
    valid(StepList::new(steps.leak()))
}

/// A range that holds one mode of the pinned beam, wide as the distance to the next one.
pub fn around(mode: usize) -> RangeInclusive<f64> {
    let [start, end] = [-0.5, 0.5].map(|share| ((mode as f64 + share) * PI).powi(2));
    start..=end
}
