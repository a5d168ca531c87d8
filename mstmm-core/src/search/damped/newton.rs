//! Newton's method for one eigenvalue, with known ones divided out, and the circle that certifies it.

use crate::model::SearchError;
use crate::number::{Dual, NOISE, Real, Scalar, Store, UNPROVEN_WIDTH, larger, modulus};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::contour::{Polygon, Traversal};
use crate::search::damped::found::Eigenvalue;
use crate::search::damped::growth::Growth;
use crate::search::damped::point::Point;
use crate::search::damped::rectangle::{Rectangle, whole};
use crate::search::damped::session::EigenvalueSearch;
use num_complex::Complex;

/// Radius of the first circle, relative to the modulus, in units of eps. A certified circle is twice as large as the one along
/// which Δ was evaluated, which leaves room for rounding.
const RADIUS: f64 = 8.0;

/// Steps around a root: from corner to corner. Where much shorter ones are not short enough, rounding rules.
const STEPS_AROUND: [f64; 3] = [0.02, 1.0, 1.0];

/// The radius grows by this factor until the circle holds the root in spite of rounding.
const GROWTH: f64 = 4.0;

/// Relative radius beyond which no circle is tried: rounding blurs a root of multiplicity 4 to about a tenth of it.
const LARGEST_RADIUS: f64 = 1e-3;

/// Steps of Newton's method: a start that needs more is given up.
const NEWTON_STEPS: u32 = 40;

/// Largest distance from the centre of a circle, as a part of its radius, of the root that Δ and its slope at the rim predict;
/// also the largest relative difference of the slope from the one farther away.
const OFF_CENTRE: f64 = 0.4;

/// Least inverse of the length over which Δ is assumed to bend, in units of the inverse modulus. The steps of two methods may
/// agree by accident.
const LEAST_BEND: f64 = 0.1;

/// Point of the unit circle at which Δ is evaluated: off both axes, since near critical damping the real part of Δ along one of
/// them is rounding alone.
const RIM: (f64, f64) = (0.8, 0.6);

/// Corners of a regular octagon of radius 1, closed.
const OCTAGON: [(f64, f64); 9] = {
    const H: f64 = core::f64::consts::FRAC_1_SQRT_2;
    [(1.0, 0.0), (H, H), (0.0, 1.0), (-H, H), (-1.0, 0.0), (-H, -H), (0.0, -1.0), (H, -H), (1.0, 0.0)]
};

/// An approximate root.
pub(super) struct Estimate<T> {
    pub(super) lambda: Complex<T>,
    /// The last point at which Δ was evaluated; none if Δ vanishes at the root itself.
    nearest: Option<Point<T>>,
    /// The last point with roots divided out, or the start.
    last: Point<T>,
}

impl<T: Real> Estimate<T> {
    /// The estimate or its mirror image in the upper half plane.
    fn upper(self) -> Self {
        if self.lambda.im < T::zero() {
            let nearest = self.nearest.map(|point| point.mirrored());
            return Estimate { lambda: self.lambda.conj(), nearest, last: self.last.mirrored() };
        }
        self
    }
}

/// A sequence of Newton's method in progress.
struct Sequence<T> {
    /// The previous point.
    previous: Option<Point<T>>,
    /// Size of the last step.
    last: T,
    /// Whether steps shrink as they do at multiple roots.
    is_slow: bool,
    /// Whether cubics are used.
    cubic: bool,
}

/// A step, and the distance from the root at which it will end.
struct Next<T> {
    step: Complex<T>,
    error: T,
}

impl<T: Real> Sequence<T> {
    /// The step from a point, with roots divided out.
    fn next(&mut self, here: &Point<T>, scale: T) -> Next<T> {
        let newton = -Complex::from(T::one()) / here.rate;
        let size = modulus(newton);
        if self.cubic
            && let Some(previous) = &self.previous
            && let Some(step) = hermite(previous, here)
            && modulus(step - newton) <= size * T::from_f64(0.25)
        {
            self.is_slow = false;
            // the error of Newton's step shows the length over which Δ bends; (ab)² by its cube is that of the cubic
            let bend = larger(modulus(step - newton) / (size * size), T::from_f64(LEAST_BEND) / scale);
            let product = size * modulus(here.lambda + step - previous.lambda);
            return Next { step, error: product * product * bend * bend * bend };
        }
        // at a root of multiplicity m the steps shrink by 1 - 1/m only
        let shrinkage = (size / self.last).to_f64();
        let shrinks_slowly = (0.4..0.95).contains(&shrinkage);
        let times =
            if self.is_slow && shrinks_slowly { f64::from((1.0 / (1.0 - shrinkage) + 0.5) as u32) } else { 1.0 };
        self.is_slow = shrinks_slowly && !self.is_slow;
        let step = newton * T::from_f64(times);
        let size = modulus(step);
        Next { step, error: size * (size / self.last) * (size / self.last) }
    }
}

/// The step from the second of two points to the zero of the inverse cubic through both with their slopes: of order
/// 1 + sqrt(3). `None` where Δ did not fall from the first to the second.
fn hermite<T: Real>(previous: &Point<T>, here: &Point<T>) -> Option<Complex<T>> {
    let one = Complex::from(T::one());
    let ratio = previous.value.over(here.value).value();
    if !(ratio.size() > 2.0 && ratio.size().is_finite()) {
        return None;
    }
    let height = ratio - one;
    let t = -(one / height);
    let (start, end) = (height / here.rate, height / (ratio * previous.rate));
    let chord = previous.lambda - here.lambda;
    let rest = one - t;
    // Hermite's cubic for λ(Δ) on t in [0, 1]
    let three = one + one + one;
    Some(t * t * (three - t - t) * chord + t * rest * (rest * start - t * end))
}

/// Half a diagonal of the rim of a circle.
pub(super) fn rim<T: Real>(radius: T) -> Complex<T> {
    Complex::new(T::from_f64(RIM.0), T::from_f64(RIM.1)) * radius
}

/// Whether the roots that Δ and its slope predict from two opposite points of a rim are one near the centre, given their distances from that.
pub(super) fn is_in_the_middle<T: Real>(offsets: [Complex<T>; 2], radius: T) -> bool {
    offsets.iter().all(|&offset| modulus(offset) <= radius * T::from_f64(OFF_CENTRE))
}

/// Makes parts within a radius of zero exactly zero. A root next to the real axis is real where complex ones come in pairs; else one next to
/// zero is.
pub(super) fn settled<T: Real>(estimate: Complex<T>, radius: T, have_images: bool) -> Complex<T> {
    let re = if estimate.re.abs() <= radius { T::zero() } else { estimate.re };
    let is_real = estimate.im.abs() <= radius && (have_images || re.is_zero());
    Complex::new(re, if is_real { T::zero() } else { estimate.im })
}

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// Finds and certifies an unknown root near a point at which known ones are divided out; from then on it is known.
    pub(super) fn find(
        &mut self,
        start: &Point<T>,
        rectangle: &Rectangle<T>,
    ) -> Result<Option<Eigenvalue<T>>, SearchError> {
        let have_images = self.known.have_images;
        let upper = |estimate: Estimate<T>| if have_images { estimate.upper() } else { estimate };
        let Some(estimate) = self.newton(start, rectangle, true)?.map(upper) else { return Ok(None) };
        let mut root = self.single(&estimate)?;
        if root.is_none() {
            // in a cluster cubics may end too early
            let slow = self.newton(&estimate.last, rectangle, false)?.map(upper);
            let Some(slow) = slow else { return Ok(None) };
            root = self.certify(&slow)?;
        }
        let Some(root) = root else { return Ok(None) };
        if self.known.holds(&root) || self.may_be_a_cluster(&root, rectangle) {
            return Ok(None);
        }
        Ok(self.known.push(root).is_ok().then_some(root))
    }

    /// An unknown root near a start; `None` if the steps lead away or do not end.
    ///
    /// Known roots, with their mirror images, are divided out of Δ: `Δ'/Δ - Σ m/(λ - λ_k)`.
    fn newton(
        &mut self,
        start: &Point<T>,
        rectangle: &Rectangle<T>,
        cubic: bool,
    ) -> Result<Option<Estimate<T>>, SearchError> {
        let (mut here, mut nearest) = (*start, None);
        let mut sequence = Sequence { previous: None, last: T::zero(), is_slow: false, cubic };
        let (eps, coarse) = (T::from_f64(0.5 * self.precision), T::from_f64(T::EPSILON).sqrt());
        for _ in 0..NEWTON_STEPS {
            if here.is_root {
                return Ok(Some(Estimate { lambda: here.lambda, nearest: None, last: here }));
            }
            let scale = self.scale(here.lambda);
            let Next { step, error } = sequence.next(&here, scale);
            if !step.size().is_finite() {
                // at a known root, or where Δ is flat
                return Ok(None);
            }
            let (size, last) = (modulus(step), sequence.last);
            let lambda = here.lambda + step;
            // the next step of a quadratic sequence, and the noise of Δ, at which steps no longer shrink
            let is_quadratic = size <= T::from_f64(1e-3) * scale && size * T::from_f64(8.0) < last;
            if (is_quadratic && error <= eps * scale) || (size <= coarse * scale && size + size > last) {
                return Ok(Some(Estimate { lambda, nearest, last: here }));
            }
            if !rectangle.contains(lambda, rectangle.size()) {
                return Ok(None);
            }
            (sequence.previous, sequence.last) = (Some(here), size);
            let point = self.evaluation.at(lambda)?;
            nearest = Some(point);
            here = self.known.divided(&point, self.known.roots());
        }
        // steps are slow at a multiple root, and where there is none
        let is_near = sequence.last <= T::from_f64(1e-3) * self.scale(here.lambda);
        Ok(is_near.then_some(Estimate { lambda: here.lambda, nearest: None, last: here }))
    }

    /// The smallest circle around an estimate along which the argument of Δ turns: the turns are the multiplicity.
    fn certify(&mut self, estimate: &Estimate<T>) -> Result<Option<Eigenvalue<T>>, SearchError> {
        if let Some(root) = self.single(estimate)? {
            return Ok(Some(root));
        }
        let mut root = self.circle(estimate.lambda)?;
        if let Some(Eigenvalue { lambda, multiplicity: multiplicity @ 2.., error, .. }) = root {
            // Newton's step for a root of that multiplicity is good where the plain one is slow
            let point = self.evaluation.at(lambda)?;
            let step = Complex::from(T::from_f64(multiplicity as f64)) / point.rate;
            // on the plateau around a multiple root Δ' may vanish, and the step with it lead out of the circle that holds the roots
            if !point.is_root
                && modulus(step) <= error
                && let Some(better) = self.circle(lambda - step)?
                && better.multiplicity == multiplicity
            {
                root = Some(better);
            }
        }
        Ok(root)
    }

    /// The smallest circle around an estimate if Δ is straight there, with one zero: the values and slopes at two opposite points
    /// of the rim predict one root near the centre, and the slopes agree with the one farther away.
    fn single(&mut self, estimate: &Estimate<T>) -> Result<Option<Eigenvalue<T>>, SearchError> {
        let Some(nearest) = &estimate.nearest else { return Ok(None) };
        let mut centre = estimate.lambda;
        for _ in 0..2 {
            let radius = self.scale(centre) * T::from_f64(RADIUS * self.precision);
            let lambda = settled(centre, radius, self.known.have_images);
            let rim = rim(radius);
            let (left, right) = (self.evaluation.at(lambda - rim)?, self.evaluation.at(lambda + rim)?);
            let bound = T::from_f64(OFF_CENTRE);
            let is_straight = |point: &Point<T>| {
                let ratio = point.slope().over(nearest.slope()).value();
                modulus(ratio - Complex::from(T::one())) <= bound
            };
            if !(is_straight(&left) && is_straight(&right)) {
                return Ok(None);
            }
            let offset = |point: &Point<T>| point.lambda - lambda - Complex::from(T::one()) / point.rate;
            let offsets = [offset(&left), offset(&right)];
            if is_in_the_middle(offsets, radius) {
                // both predict one root, but for rounding
                let is_noisy = modulus(offsets[0] - offsets[1]) > radius * T::from_f64(NOISE);
                let width = if is_noisy { UNPROVEN_WIDTH } else { 1.0 };
                let error = (radius + radius) * T::from_f64(width);
                return Ok(Some(Eigenvalue { lambda, error, multiplicity: 1, is_proven: false }));
            }
            if modulus(offsets[0] - offsets[1]) > radius * (bound + bound) {
                return Ok(None);
            }
            centre = lambda + (offsets[0] + offsets[1]) * T::from_f64(0.5);
        }
        Ok(None)
    }

    /// Counts the roots in growing circles about an estimate until there are some.
    fn circle(&mut self, estimate: Complex<T>) -> Result<Option<Eigenvalue<T>>, SearchError> {
        let scale = self.scale(estimate);
        let mut radius = scale * T::from_f64(RADIUS * self.precision);
        while radius < scale * T::from_f64(LARGEST_RADIUS) {
            let lambda = settled(estimate, radius, self.known.have_images);
            let corner = |(re, im): (f64, f64)| lambda + Complex::new(T::from_f64(re), T::from_f64(im)) * radius;
            let polygon =
                Polygon { corners: &OCTAGON.map(corner), steps: STEPS_AROUND, rectangle: None, growth: Growth::none() };
            if let Traversal::Argument(argument) = self.traverse(&polygon, |_| ())?
                && let Some(multiplicity @ 1..) = whole(argument / core::f64::consts::TAU)
            {
                return Ok(Some(Eigenvalue { lambda, error: radius + radius, multiplicity, is_proven: false }));
            }
            radius *= T::from_f64(GROWTH);
        }
        Ok(None)
    }
}
