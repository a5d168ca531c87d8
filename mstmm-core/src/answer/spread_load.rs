//! Loads along elements of a tree: what they work on a motion, from which the response follows by reciprocity.
//!
//! A jump of the dual entry at the point that is asked for causes a motion; the work of the load on that motion is the response, to its sign.
//! So no load enters a pass, and clamped frequencies of the loaded element are nothing special.

use crate::answer::states::SystemStates;
use crate::element::{CoefficientsOf, Moving, Visit, space_of};
use crate::model::{Ends, MotionError, Spread, State};
use crate::number::{Oscillation, Scaled, Single};
use crate::pass::both_ways::Passes;
use crate::pass::route::Place;
use crate::pass::tree::Tree;
use mstmm_plan::{Coordinate, Freedoms, Space};

/// What a load works on a motion, and a size compared with which its rounding is small.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Work<S> {
    pub(crate) value: S,
    pub(crate) size: f64,
}

/// The response of an entry to a load along elements, and a size compared with which its rounding is small: the load on the largest
/// displacement at ends of loaded elements.
pub(crate) fn response<Y, S>(system: &Y, load: Spread, entry: Place, x: S) -> Result<Work<S>, MotionError>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    let passes = Passes::whole(system, x);
    let meeting = passes.meeting(entry.step);
    let delta = meeting.delta();
    if delta.mantissa().is_zero() {
        return Err(MotionError::Resonance { frequency: x.modulus() });
    }
    let jump = meeting.jump(entry.coordinate.dual());
    let recovered = passes.recover(entry.step, jump.upstream, jump.downstream);
    let largest = recovered.states.as_ref().iter().filter_map(|state| state.magnitude()).max().unwrap_or(0);
    let Work { value, size } = SystemStates::of(system, x, &recovered, -largest).work_of(load)?;
    // a jump of Q is a force and one of -M a moment; a jump of -Y works with Q, one of Θ with M
    let value = if matches!(entry.coordinate, Coordinate::Theta | Coordinate::Q) { -value } else { value };
    let over_delta = |work: S| Scaled::new(work, i64::from(largest)).over(delta).value();
    let (value, size) = (over_delta(value), over_delta(S::from_f64(size)).size());
    if value.size().is_finite() {
        Ok(Work { value, size: size.max(value.size()) })
    } else {
        Err(MotionError::NotFinite { frequency: x.modulus() })
    }
}

impl<Y, S> SystemStates<'_, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Single,
{
    /// The work of a load along elements on this motion, and that on the largest displacements.
    pub(crate) fn work_of(&self, load: Spread) -> Result<Work<S>, MotionError> {
        let work = |step: usize, is_weight: bool| {
            let of = self.system.visit(None, step, WorkOf { ends: self.ends(step), is_weight });
            of.map(|work| work.ok_or(MotionError::NoUniformLoad))
        };
        match load {
            Spread::Along(step) => work(step, false).unwrap_or(Err(MotionError::NoUniformLoad)),
            Spread::Weight => {
                let all = (0..self.system.scheme().len()).filter_map(|step| work(step, true));
                let none = Work { value: S::zero(), size: 0.0 };
                all.into_iter().try_fold(none, |sum, part| {
                    let part = part?;
                    Ok(Work { value: sum.value + part.value, size: sum.size + part.size })
                })
            }
            Spread::Inertia(axis) => {
                let freedom = Freedoms::EACH[axis];
                if !freedom.is(Freedoms::Y) {
                    return Err(MotionError::NoSuchFreedom { freedom });
                }
                let weight = self.work_of(Spread::Weight)?;
                Ok(Work { value: -weight.value, size: weight.size })
            }
        }
    }
}

/// The work of a load of 1 per length, or of the weight, on the motion of an element.
struct WorkOf<S> {
    ends: Ends<S>,
    is_weight: bool,
}

impl<S: Single> Visit<S> for WorkOf<S> {
    type Output = Option<Work<S>>;

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> Option<Work<S>> {
        let WorkOf { ends, is_weight } = self;
        let Some(inside) = E::inside(built, ends.x) else {
            if !is_weight {
                return None;
            }
            let lifted = State { y: S::one(), ..State::default() };
            let value = E::mass_form(built, &ends, &Ends { x: ends.x, input: lifted, output: lifted });
            return Some(Work { value, size: value.size() });
        };
        let density = if is_weight { E::mass_per_length(built) } else { S::one() };
        let value = E::load_work(built, &ends)? * density;
        let is_turning = space_of::<E>().is(Space::Rotation);
        let [input, output] = [ends.input, ends.output].map(|end| if is_turning { end.theta } else { end.y }.size());
        Some(Work { value, size: inside.length * density.size() * input.max(output) })
    }
}
