//! The misfit of the states of a motion: the residual of compatibility and equilibrium at connections.
//!
//! Where several paths are near a frequency at which they vibrate with their ends held, displacements of their joint are small
//! and rounded. Forces follow from them, divided by the distance to that frequency, and do not add up.

use crate::answer::dominant_entry::{UnitsOf, comparable};
use crate::answer::mode_shape::ModeShape;
use crate::answer::states::SystemStates;
use crate::model::{MotionError, State};
use crate::number::{FrequencyPowers, MISFIT, Oscillation, REFUSED_MISFIT, Scalar, Single};
use crate::pass::tree::Tree;
use mstmm_plan::{Coordinate, Step};

impl<Y, S> SystemStates<'_, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// The misfit of states at connections, relative to the largest states in the system. Entries are compared as square roots of
    /// energies.
    fn misfit(&self) -> f64 {
        let (mut whole, mut worst) = (0.0_f64, 0.0_f64);
        let at = comparable(self.system, self.x);
        for step in 0..self.system.scheme().len() {
            match self.system.scheme().steps[step] {
                Step::Element(..) => {
                    let units = self.units(step, &at);
                    let ends = self.ends(step);
                    whole = whole.max(energy(&ends.input, units)).max(energy(&ends.output, units));
                }
                Step::Connection(inputs) => worst = worst.max(self.misfit_at(step, inputs, &at)),
                Step::Tip(_) | Step::Root(..) => {}
            }
        }
        Scalar::sqrt(worst / whole)
    }

    /// The misfit at a connection, as an energy.
    fn misfit_at(&self, connection: usize, inputs: &[usize], at: &FrequencyPowers<S>) -> f64 {
        let behind = self.states.as_ref()[connection];
        let mut units = [0.0_f64; 2];
        let mut left = behind;
        for &input in inputs {
            let State { m, q, .. } = self.at(input, true);
            left = State { m: left.m - m, q: left.q - q, ..left };
            if let Step::Element(..) = self.system.scheme().steps[input] {
                let own = self.units(input, at);
                units = [units[0].max(own[0]), units[1].max(own[1])];
            }
        }
        let mut gap = State { y: S::zero(), theta: S::zero(), ..left };
        for coordinate in [Coordinate::Y, Coordinate::Theta] {
            let has = |step: &usize| self.system.scheme().behind(*step).contains(coordinate.freedom());
            let mut values =
                inputs.iter().filter(|input| has(input)).map(|&input| self.at(input, true).entry(coordinate));
            let Some(first) = values.next() else { continue };
            let on = has(&connection).then(|| behind.entry(coordinate));
            let farthest = values
                .chain(on)
                .map(|value| value - first)
                .fold(S::zero(), |farthest, gap| if gap.size() > farthest.size() { gap } else { farthest });
            gap = if coordinate == Coordinate::Y {
                State { y: farthest, ..gap }
            } else {
                State { theta: farthest, ..gap }
            };
        }
        energy(&gap, units)
    }

    fn units(&self, step: usize, at: &FrequencyPowers<S>) -> [f64; 2] {
        self.system.visit(None, step, UnitsOf(at)).unwrap_or_default()
    }
}

impl<'a, Y, S> ModeShape<'a, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// Whether the misfit of its states is larger than usual.
    pub(crate) fn is_doubtful(&self) -> bool {
        let misfit = self.misfit();
        misfit.is_nan() || misfit > MISFIT * S::EPSILON
    }

    /// The shape, or an error if its states do not fit together.
    pub(crate) fn accepted(self) -> Result<Self, MotionError> {
        self.check().map(|()| self)
    }

    /// Refuses a shape whose states do not fit together. One that is not doubtful is not refused.
    ///
    /// A motion between the ends of an element follows from the states there. Where it is trapped inside, these are rounding, and its modal mass is not 1.
    pub(crate) fn check(&self) -> Result<(), MotionError> {
        let misfit = worse(self.misfit(), (self.modal_mass() - S::one()).size());
        if misfit <= REFUSED_MISFIT * S::EPSILON {
            return Ok(());
        }
        Err(MotionError::Unresolved { root: self.x.modulus(), misfit })
    }

    /// A shape that was found in extended precision.
    pub(crate) fn of_extended(judged: &ModeShape<'a, Y, S::Extended>) -> Self
    where
        Y: Tree<S::Extended>,
    {
        let mut states = Y::per_step(State::default());
        for (state, judged) in states.as_mut().iter_mut().zip(judged.states.as_ref()) {
            *state = judged.map(S::from_extended);
        }
        let (x, beyond) = (S::from_extended(judged.x), judged.beyond.map(S::from_extended));
        ModeShape::of(SystemStates { system: judged.system, x, states, source: judged.source, beyond })
    }
}

/// The larger of two misfits; one that is no number is worse than any.
pub(crate) fn worse(one: f64, other: f64) -> f64 {
    if one > other || one.is_nan() { one } else { other }
}

/// The largest of the squares of the entries, as energies.
fn energy<S: Single>(state: &State<S>, [by_y, by_theta]: [f64; 2]) -> f64 {
    let squares = [
        (state.y.size(), by_y),
        (state.theta.size(), by_theta),
        (state.m.size(), 1.0 / by_theta),
        (state.q.size(), 1.0 / by_y),
    ];
    squares.iter().map(|(entry, unit)| entry * entry * unit).filter(|energy| energy.is_finite()).fold(0.0, f64::max)
}
