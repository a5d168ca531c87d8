//! Simple eigenvalues that rounding has blurred, found again in extended precision from where a search has left them.

use crate::number::{Dual, Parameter, Real, Scalar, Store, modulus};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::search::damped::deflation::meets_any;
use crate::search::damped::found::{Eigenvalue, exactly};
use crate::search::damped::newton::{is_in_the_middle, rim, settled};
use crate::search::damped::session::EigenvalueSearch;
use crate::subspace::Watch;
use num_complex::Complex;

/// Steps of Newton's method. Each doubles the digits: five lead from one digit to 32, and three are left for an estimate without one.
const STEPS: usize = 8;

/// Part of the distance to the nearest other eigenvalue that steps may lead away: circles of less than half of it about both do not meet.
const NEAREST: f64 = 0.25;

/// Radius of the circle, relative to the modulus, in units of eps of the model's numbers: what these round of the eigenvalue.
const RADIUS: f64 = 0.5;

/// A number in extended precision, of the model's numbers.
type Extended<T> = Complex<<T as Real>::Extended>;

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// Finds those of the known eigenvalues that are wanted and doubtful in extended precision. The search is doubtful where that fails.
    pub(super) fn settle(&mut self, is_wanted: impl Fn(&Eigenvalue<T>) -> bool) {
        if !self.may_ask_extended() {
            return;
        }
        for place in 0..self.known.roots().len() {
            let root = self.known.roots()[place];
            // the stiffness of a frame loses as many digits as the stiffnesses that meet are apart, and no circle shows it
            let is_doubtful = const { Y::IS_NETWORK } || self.is_blurred(&root);
            if !is_wanted(&root) || !is_doubtful {
                continue;
            }
            match self.found_again(&root) {
                Some(root) => self.known.replace(place, root),
                None => self.evaluation.is_doubtful = true,
            }
        }
        let mut roots = self.known.roots();
        while let [root, others @ ..] = roots {
            self.evaluation.is_doubtful |= meets_any(root, others);
            roots = others;
        }
    }

    /// A simple eigenvalue in extended precision, next to where it was found, with its circle.
    fn found_again(&mut self, root: &Eigenvalue<T>) -> Option<Eigenvalue<T>> {
        if root.multiplicity > 1 {
            return None;
        }
        let scale = self.scale(root.lambda);
        let reach = exactly(self.distances_to_others(root, scale)[0] * T::from_f64(NEAREST));
        let start = Complex::new(exactly(root.lambda.re), exactly(root.lambda.im));
        let radius = exactly(scale) * exactly(T::from_f64(RADIUS * self.precision));
        let mut lambda = start;
        for number in 0..STEPS {
            // at the eigenvalue itself Δ is rounding alone
            let at_root = (number > 0).then_some(<Extended<T> as Scalar>::from_f64(0.0));
            let step = self.extended_step(lambda).or(at_root)?;
            lambda -= step;
            if modulus(lambda - start) > reach {
                return None;
            }
            if modulus(step) <= radius.times_power_of_two(-1) {
                return self.certified(settled(lambda, radius, self.known.have_images), radius, scale);
            }
        }
        None
    }

    /// An eigenvalue in the middle of a circle, if two opposite points of the rim show it there.
    fn certified(&mut self, centre: Extended<T>, radius: T::Extended, scale: T) -> Option<Eigenvalue<T>> {
        let rim = rim(radius);
        let offsets = [centre - rim, centre + rim].map(|point| Some(point - centre - self.extended_step(point)?));
        let is_certified = is_in_the_middle([offsets[0]?, offsets[1]?], radius);
        let plainly = |part: T::Extended| T::from_f64(part.to_f64());
        let lambda = Complex::new(plainly(centre.re), plainly(centre.im));
        // with room for what the model's numbers round
        let error = plainly(radius + radius) + scale * T::from_f64(self.precision);
        is_certified.then_some(Eigenvalue { lambda, error, multiplicity: 1, is_proven: false })
    }

    /// Newton's step in extended precision, negative; none where sums cancel.
    fn extended_step(&mut self, lambda: Extended<T>) -> Option<Extended<T>> {
        self.evaluation.evaluations += 2;
        let (watch, dual) = counted_pass(self.evaluation.system, Dual::variable(lambda), Watch::default());
        let Dual { value, derivative } = dual.mantissa();
        let step = value / derivative;
        (!watch.cancelled.any() && step.size().is_finite()).then_some(step)
    }
}
