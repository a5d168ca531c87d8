//! Motions between the ends of elements: nodes and largest deflections.

use crate::answer::states::SystemStates;
use crate::element::Inside;
use crate::model::{Label, State};
use crate::number::{Oscillation, Parameter, Real, Scalar};
use crate::pass::tree::Tree;

/// Samples per half wave; a deflection between two of them is monotonic or has one extremum.
const SAMPLES: f64 = 16.0;
/// Number of halvings that narrow the distance of two samples to rounding.
pub(crate) const HALVINGS: u32 = 60;

impl Inside {
    /// Number of samples between the ends.
    pub(crate) fn samples(&self) -> u32 {
        (SAMPLES * (1.0 + self.wave_number * self.length / core::f64::consts::PI)) as u32
    }
}

impl<Y, S> SystemStates<'_, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// The deflection of largest size at points and inside of elements.
    pub(crate) fn largest_deflection(&self) -> S {
        let mut largest = S::zero();
        let mut keep = |y: S| {
            if square(y) > square(largest) {
                largest = y;
            }
        };
        for step in 0..self.system.scheme().len() {
            keep(self.states.as_ref()[step].y);
            let Some(inside) = self.inside(step) else { continue };
            let width = inside.length / f64::from(inside.samples());
            for sample in 0..inside.samples() {
                keep(self.extremum(step, f64::from(sample) * width, f64::from(sample + 1) * width));
            }
        }
        largest
    }

    /// The deflection of largest size between two places of an element.
    fn extremum(&self, step: usize, mut from: f64, mut to: f64) -> S {
        let growth = |state: &State<S>| S::to_complex(state.theta * state.y.conjugate()).re;
        let [start, end] = [from, to].map(|place| self.state_at(step, place));
        if !(growth(&start).to_f64() > 0.0 && growth(&end).to_f64() < 0.0) {
            return end.y;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if growth(&self.state_at(step, middle)).to_f64() > 0.0 { from = middle } else { to = middle }
        }
        self.state_at(step, from).y
    }
}

/// Square of the modulus.
fn square<T: Real, S: Oscillation<T>>(y: S) -> f64 {
    S::to_complex(y * y.conjugate()).re.to_f64()
}

impl<Y, T> SystemStates<'_, Y, T>
where
    T: Real,
    Y: Tree<T, Parameter = T> + ?Sized,
{
    /// Number of nodes inside of an element: places between its ends where the deflection changes its sign. A single beam between
    /// supports has n - 1 of them in mode n (Sturm).
    ///
    /// A node at the point where two elements meet is inside of neither. Shapes of damped systems are complex and have no nodes.
    pub fn nodes<E>(&self, label: Label<Y::Model, E>) -> usize {
        let Some(inside) = self.inside(label.step) else { return 0 };
        let samples = inside.samples();
        let deflection =
            |sample: u32| self.state_at(label.step, inside.length * f64::from(sample) / f64::from(samples)).y;
        sign_changes(samples, deflection)
    }
}

/// How often a deflection changes its sign inside of an element, given at samples from its input end to its output end.
pub(crate) fn sign_changes<T: Real>(samples: u32, deflection: impl Fn(u32) -> T) -> usize {
    let largest = (0..=samples).map(|sample| deflection(sample).size()).fold(0.0, f64::max);
    // a deflection that a support holds is zero to rounding, and no node
    let shown = |y: &T| y.size() > largest * Scalar::sqrt(f64::from(samples) * T::EPSILON);
    let ends = [0, samples].map(&deflection);
    let first = Some(ends[0]).filter(shown);
    let last = Some(ends[1]).filter(shown);
    let inner = (1..samples).map(&deflection);
    let mut signs = first.into_iter().chain(inner).chain(last).filter(|y| !y.is_zero()).map(|y| y > T::zero());
    let Some(mut before) = signs.next() else { return 0 };
    signs.filter(|&sign| core::mem::replace(&mut before, sign) != sign).count()
}
