//! An element of one's own whose stiffness may be negative.

use mstmm::element::{
    Element, FrequencyEstimates, FrequencyPowers, InvalidParameter, Line, PlaneStep, Requirement, RootCounter,
    Subspace, Translation,
};
use mstmm::number::{Frequency, Parameter, Size, Truth};

/// A spring of either sign, `Q = K (Y_I - Y_O)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link<T> {
    /// Stiffness K [N/m], not zero.
    pub(crate) stiffness: T,
}

impl<T: Parameter> Element for Link<T> {
    type State = Translation;
    type Built = Self;
    const MAY_BUCKLE: bool = true;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Finite.check("stiffness", self.stiffness)?;
        Ok(self)
    }

    fn estimate(link: &Self, estimates: &mut FrequencyEstimates) {
        estimates.translational_stiffness(link.stiffness.to_f64().abs());
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Link<T> {
    type Coefficients = S;

    fn coefficients(link: &Self, _at: &FrequencyPowers<S>) -> S {
        S::from_parameter(link.stiffness)
    }

    /// The step multiplies the line by K: the point behind a line has the stiffness `-q/y + K`, the sign of which is that of
    /// `(K y - q)/y`, whatever K is.
    fn step<C: RootCounter<S>>(stiffness: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        let before = input.line();
        let after = Line::new(*stiffness * before.y - before.q, *stiffness * before.q, before.exponent);
        if C::COUNTS {
            counter.line(&before, &after, S::Size::of(0.0), S::Truth::of(false));
        }
        Subspace::Line(after, input.space())
    }
}
