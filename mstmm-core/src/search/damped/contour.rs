//! The argument principle: how many eigenvalues a contour encloses.

use crate::model::SearchError;
use crate::number::{Dual, Real, Store, argument, larger, modulus, smaller};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::found::Eigenvalue;
use crate::search::damped::growth::Growth;
use crate::search::damped::point::Point;
use crate::search::damped::rectangle::Rectangle;
use crate::search::damped::session::EigenvalueSearch;
use num_complex::Complex;

/// Steps after which a traversal is given up: rounding noise can make it creep.
const STEPS: u32 = 20_000;

/// Largest ratio of a step to the one before. Between two roots, where Δ' vanishes, the rate alone would let a step leap over
/// the next one, or the next two.
const STEP_GROWTH: f64 = 2.0;

/// Bound of `|step Δ'/Δ|` at both ends of a step.
const STEP_BOUND: f64 = 1.5;

/// Bound of the relative difference between Δ at the end of a step and its prediction from the start by the rates at both ends.
const STEP_MISMATCH: f64 = 0.4;

/// Steps between a search for a root that failed, or did not help, and the next.
const PATIENCE: u32 = 8;

/// Least distance from the real axis, in lengths of `Δ/Δ'`, of a point from which a root is sought.
const LOW: f64 = 0.1;

/// The second step as a part of the distance of the nearest root that the first one shows.
const SECOND_STEP: f64 = 0.7;

/// Least `|Δ'/Δ|` times the wanted step at which a root is sought that seems to lie inside.
const HELD_UP: f64 = 0.9 * STEP_BOUND;

/// Least `|Δ'/Δ|` times the wanted step at which a root is sought wherever it lies.
const CLOSE: f64 = 8.0;

/// The result of the traversal of a contour.
pub(super) enum Traversal {
    /// Growth of the argument of Δ.
    Argument(f64),
    /// The contour meets a root, or nearly.
    MeetsRoot,
}

/// A polygon to be traversed.
pub(super) struct Polygon<'w, T: Real> {
    pub(super) corners: &'w [Complex<T>],
    /// Lengths as parts of the polygon's size: the shortest step, below which the polygon meets a root, and the longest first and
    /// second steps.
    pub(super) steps: [f64; 3],
    /// The rectangle whose contour it is, if roots that keep steps short are to be found and divided out. None far from the
    /// imaginary axis, where the growth of Δ stands for all roots near it.
    pub(super) rectangle: Option<&'w Rectangle<T>>,
    /// The growth by which Δ is divided.
    pub(super) growth: Growth<T>,
}

impl<T: Real> Polygon<'_, T> {
    /// Whether the contour of a rectangle passes by one of some roots within a distance.
    fn meets(&self, mut roots: impl Iterator<Item = Eigenvalue<T>>, distance: T) -> bool {
        let Some(rectangle) = self.rectangle else { return false };
        roots.any(|Eigenvalue { lambda, .. }| {
            rectangle.contains(lambda, distance) && !rectangle.contains(lambda, -distance)
        })
    }
}

/// A traversal in progress.
struct Traverse<'w, T: Real> {
    polygon: &'w Polygon<'w, T>,
    /// The corner ahead.
    next: usize,
    start: Point<T>,
    /// The current point, with roots divided out.
    here: Point<T>,
    shortest: T,
    longest: T,
    angle: f64,
    /// Steps to be made before the next search for a root.
    patience: u32,
    /// Whether the polygon meets a root.
    is_stuck: bool,
}

impl<T: Real> Traverse<'_, T> {
    /// The rest of the polygon.
    fn rest(&self) -> impl Iterator<Item = Complex<T>> + Clone {
        let ahead = self.polygon.corners.iter().skip(self.next).copied();
        core::iter::once(self.here.lambda).chain(ahead)
    }

    /// Makes a step that was accepted.
    fn go(&mut self, there: Point<T>, corner: Complex<T>, change: f64) {
        if there.lambda != corner {
            self.longest = modulus(there.lambda - self.here.lambda) * T::from_f64(STEP_GROWTH);
        }
        (self.here, self.angle) = (there, self.angle + change);
        self.patience = self.patience.saturating_sub(1);
    }
}

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// Growth of the argument of Δ along a polygon. Every point of the traversal is shown to `visit`.
    pub(super) fn traverse(
        &mut self,
        polygon: &Polygon<'_, T>,
        mut visit: impl FnMut(&Point<T>),
    ) -> Result<Traversal, SearchError> {
        let Some(&first) = polygon.corners.first() else { return Ok(Traversal::Argument(0.0)) };
        let size = polygon.corners.iter().map(|&corner| modulus(corner - first)).fold(T::zero(), larger);
        let [shortest, longest, next] = polygon.steps.map(|part| size * T::from_f64(part));
        let corners = polygon.corners.iter().copied();
        let known = if polygon.rectangle.is_some() { self.known.roots() } else { &[] };
        if polygon.meets(self.known.with_images(), shortest) {
            return Ok(Traversal::MeetsRoot);
        }
        let angle = polygon.growth.turning(corners.clone())
            + known.iter().map(|root| self.known.turning(root, corners.clone())).sum::<f64>();
        let start = self.evaluation.at(first)?;
        let here = self.deflated(&start, polygon);
        let mut traverse =
            Traverse { polygon, next: 1, start, here, shortest, longest, angle, patience: 0, is_stuck: false };
        let mut steps = 0;
        while let Some(&corner) = polygon.corners.get(traverse.next) {
            if traverse.here.lambda == corner {
                traverse.next += 1;
                continue;
            }
            steps += 1;
            self.evaluation.check_effort::<T>(self.known.roots().len())?;
            if traverse.here.is_root || steps > STEPS || !self.step(&mut traverse, corner)? {
                return Ok(Traversal::MeetsRoot);
            }
            visit(&traverse.here);
            if steps == 1 {
                let bend = bend(&self.deflated(&start, polygon), &traverse.here);
                traverse.longest = smaller(bend * T::from_f64(SECOND_STEP), next);
            }
        }
        if traverse.here.is_root { Ok(Traversal::MeetsRoot) } else { Ok(Traversal::Argument(traverse.angle)) }
    }

    /// Δ without its growth and, along a rectangle, with the known roots divided out.
    fn deflated(&self, point: &Point<T>, polygon: &Polygon<'_, T>) -> Point<T> {
        let point = polygon.growth.taken_from(point);
        if polygon.rectangle.is_some() { self.known.divided(&point, self.known.roots()) } else { point }
    }

    /// Makes a step towards a corner; false if steps become too short.
    ///
    /// A step must be short beside `Δ/Δ'` at both ends, and the mean of `Δ'/Δ` must predict Δ: a phase alone could hide a
    /// whole turn. Where a step fails or would have to be short, roots nearby are divided out.
    fn step(&mut self, traverse: &mut Traverse<'_, T>, corner: Complex<T>) -> Result<bool, SearchError> {
        let rest = corner - traverse.here.lambda;
        let length = modulus(rest);
        let wanted = smaller(traverse.longest, length);
        while self.divide_out(traverse, traverse.here, wanted)? {}
        let mut step = smaller(T::from_f64(HELD_UP) / modulus(traverse.here.rate), traverse.longest);
        if step < smaller(traverse.shortest, length) {
            return Ok(false);
        }
        loop {
            let there = if step < length { traverse.here.lambda + rest * (step / length) } else { corner };
            if traverse.is_stuck || there == traverse.here.lambda {
                return Ok(false);
            }
            let seen = if there == traverse.start.lambda { traverse.start } else { self.evaluation.at(there)? };
            loop {
                let there = self.deflated(&seen, traverse.polygon);
                if let Some(change) = change_of_argument(&traverse.here, &there) {
                    traverse.go(there, corner, change);
                    return Ok(true);
                }
                if !self.divide_out(traverse, there, smaller(step, length))? {
                    break;
                }
            }
            step = smaller(step, length) * T::from_f64(0.5);
            if step < traverse.shortest {
                return Ok(false);
            }
        }
    }

    /// Divides out a root near a point of the polygon that keeps steps shorter than wanted; false if none is found.
    fn divide_out(&mut self, traverse: &mut Traverse<'_, T>, from: Point<T>, wanted: T) -> Result<bool, SearchError> {
        let Some(rectangle) = traverse.polygon.rectangle else { return Ok(false) };
        let rate = modulus(from.rate);
        let hold = rate * wanted;
        let ahead = from.lambda - Complex::from(T::one()) / from.rate;
        // a root outside costs more than it saves, unless it is close
        let is_worth_it =
            hold > T::from_f64(CLOSE) || (hold > T::from_f64(HELD_UP) && rectangle.contains(ahead, T::zero()));
        let is_ready = traverse.patience == 0 && !self.known.is_full();
        // Newton's method would hardly leave the real axis
        let is_low = from.lambda.im.abs() * rate < T::from_f64(LOW);
        if !is_ready || !is_worth_it || is_low {
            return Ok(false);
        }
        traverse.patience = PATIENCE;
        let Some(root) = self.find(&from, rectangle)? else { return Ok(false) };
        traverse.is_stuck = traverse.polygon.meets(self.known.with_image(&root), traverse.shortest);
        traverse.angle += self.known.turning(&root, traverse.rest());
        traverse.here = self.known.divided(&traverse.here, &[root]);
        // a root that does not explain the rate does not keep steps short
        if modulus(self.known.divided(&from, &[root]).rate) < rate {
            traverse.patience = 0;
        }
        Ok(!traverse.is_stuck)
    }
}

/// The length over which `Δ'/Δ` changes by its inverse. The root nearest to two close points is no nearer than that if all roots
/// lie on a line with them: contributions to the change do not cancel, as those to `Δ'/Δ` do half-way between two roots.
fn bend<T: Real>(here: &Point<T>, there: &Point<T>) -> T {
    (modulus(there.lambda - here.lambda) / modulus(there.rate - here.rate)).sqrt()
}

/// Growth of the argument of Δ from one point to the next, if the step is short enough.
fn change_of_argument<T: Real>(here: &Point<T>, there: &Point<T>) -> Option<f64> {
    let step = there.lambda - here.lambda;
    let bound = T::from_f64(STEP_BOUND);
    if there.is_root || modulus(step) * larger(modulus(here.rate), modulus(there.rate)) > bound {
        return None;
    }
    let predicted = step * (here.rate + there.rate) * T::from_f64(0.5);
    let (sin, cos) = predicted.im.sin_cos();
    let found = there.value.over(here.value).value() / (Complex::new(cos, sin) * predicted.re.exp());
    let mismatch = found - Complex::from(T::one());
    let change = || predicted.im.to_f64() + argument(found.re.to_f64(), found.im.to_f64());
    (modulus(mismatch) <= T::from_f64(STEP_MISMATCH)).then(change)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scaled;

    /// Closed form: amid roots on a line `Δ'/Δ` vanishes half-way between two of them, where its change still shows how near
    /// they are.
    #[test]
    fn two_points_half_way_between_roots_show_how_near_these_are() {
        let at = |im: f64| {
            let lambda = Complex::new(0.01, im);
            let rate = (-20..=20).map(|k| (lambda - Complex::new(0.0, f64::from(k) + 0.5)).inv()).sum();
            Point { lambda, value: Scaled::new(Complex::from(1.0), 0), rate, is_root: false }
        };
        assert!(modulus(at(0.0).rate) < 0.2);
        let bend = bend(&at(0.0), &at(1e-6));
        assert!(bend > 0.2 && bend < 0.5, "{bend}");
    }
}
