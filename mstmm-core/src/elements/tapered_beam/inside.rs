//! States of a tapered beam between its ends.

use crate::elements::tapered_beam::BuiltTaperedBeam;
use crate::elements::tapered_beam::walk::{Places, Tapered};
use crate::model::{Ends, State};
use crate::number::gauss::integrals;
use crate::number::{Oscillation, Real, Single, binary_exponent};
use crate::subspace::{Covector, Plane, Subspace};

/// Places at which covectors are kept, so that each is taken back through a part of the beam alone.
const KEPT: usize = 16;

/// Gauss's rule is exact to rounding on fourths of a part, along which phases change by less than 1.
const FOURTHS: f64 = 3.0;

/// A motion of a beam at a frequency.
///
/// A plane through the state at the input end goes along the beam, and against it goes the covector that picks the state at the output end
/// out of that plane: both by series without divisions, so that no digits are lost where waves grow or decay.
pub(super) struct Inside<S> {
    beam: Tapered<S>,
    reversed: Tapered<S>,
    input: State<S>,
    plane: Plane<S>,
    /// Covectors at multiples of the length over [`KEPT`], the last at the output end.
    covectors: [Covector<S>; KEPT + 1],
}

impl<S> Inside<S> {
    /// The motion with given states at both ends.
    pub(super) fn new<T: Real>(built: &BuiltTaperedBeam<T>, ends: &Ends<S>) -> Self
    where
        S: Oscillation<T>,
    {
        let square = ends.x.lambda_squared();
        let beam: Tapered<S> = built.at(square);
        let reversed: Tapered<S> = built.reversed().at(square);
        let [units, behind] = [0.0, 1.0].map(|share| beam.units_at(share).map(S::from_f64));
        let plane = plane_through(ends.input, units);
        let output = beam.plane(plane, 0.0, 1.0);
        let last = covector_of(ends.output, &output, behind);
        let mut covectors = [last; KEPT + 1];
        for k in (0..KEPT).rev() {
            let [start, end] = [KEPT - k - 1, KEPT - k].map(|place| place as f64 / KEPT as f64);
            covectors[k] = reversed.covector(covectors[k + 1], start, end);
        }
        Inside { beam, reversed, input: ends.input, plane, covectors }
    }

    /// The state at a share of the length.
    pub(super) fn state_at<T: Real>(&self, share: f64) -> State<S>
    where
        S: Oscillation<T>,
    {
        self.picked(&self.beam.plane(self.plane, 0.0, share), share)
    }

    /// The state at a share of the length, given the plane there.
    fn picked<T: Real>(&self, plane: &Plane<S>, share: f64) -> State<S>
    where
        S: Oscillation<T>,
    {
        if share <= 0.0 {
            return self.input;
        }
        // the place behind it at which the covector is known
        let kept = (1..KEPT).find(|place| *place as f64 / KEPT as f64 >= share).unwrap_or(KEPT);
        let start = 1.0 - kept as f64 / KEPT as f64;
        let covector = self.reversed.covector(self.covectors[kept], start, 1.0 - share);
        covector.pick(&Subspace::Plane(*plane)).shifted(0)
    }
}

/// The integrals over x of numbers that two motions have at each share of the length. Within a part states follow from that at its start.
pub(super) fn along<T: Real, S: Oscillation<T>, const N: usize>(
    [first, second]: [&Inside<S>; 2],
    at: impl Fn(f64, [State<S>; 2]) -> [S; N],
) -> [S; N] {
    let both = [first, second];
    let length = first.beam.profile.length;
    // the faster motion has the shorter parts
    let slower = first.beam.sizes.lambda_squared < second.beam.sizes.lambda_squared;
    let sizes = both[usize::from(slower)].beam.sizes;
    let mut planes = both.map(|motion| motion.plane);
    let mut sums = [S::zero(); N];
    for place in Places::new(sizes, 0.0, 1.0) {
        let Some([start, width]) = place else { return [S::from_f64(f64::NAN); N] };
        let states: [State<S>; 2] = [0, 1].map(|k| both[k].picked(&planes[k], start));
        let parts = integrals(T::from_f64(width), FOURTHS, |distance: T| {
            let share = start + distance.to_f64();
            at(share, [0, 1].map(|k| both[k].beam.follow(states[k], start, share)))
        });
        for (sum, part) in sums.iter_mut().zip(parts) {
            *sum += part * length;
        }
        planes = [0, 1].map(|k| both[k].beam.plane(planes[k], start, start + width));
    }
    sums
}

impl<S: Single> Tapered<S> {
    /// The state at a share of the length behind that at another, close to it.
    fn follow(&self, State { y, theta, m, q }: State<S>, start: f64, end: f64) -> State<S> {
        let (entries, exponent) = self.state([y, theta, m, q], start, end);
        let [y, theta, m, q] = entries.map(|entry| entry.times_power_of_two(exponent));
        State { y, theta, m, q }
    }

    /// Usual sizes of Y, Θ, M, Q at a share of the length.
    fn units_at(&self, share: f64) -> [f64; 4] {
        let length = self.sizes.length / self.sizes.phase().max(1.0);
        let stiffness = self.sizes.stiffness_at(share) / length;
        [length, 1.0, stiffness, stiffness / length]
    }
}

/// A plane of two states.
fn spanned<S: Single>(a: [S; 4], b: [S; 4]) -> Plane<S> {
    let minor = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    Plane::unscaled([minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 3), minor(2, 3)], 0)
}

fn minors<S: Single>(plane: &Plane<S>) -> [S; 5] {
    [plane.y_theta, plane.y_m, plane.w, plane.theta_q, plane.m_q]
}

fn entries<S>(State { y, theta, m, q }: State<S>) -> [S; 4] {
    [y, theta, m, q]
}

/// A plane that holds a state, and in which no force does work between two states. Of the two that turn Y and Θ as well as M and Q the
/// larger is taken: where waves travel one of them is a multiple of the state.
fn plane_through<S: Single>(state: State<S>, units: [S; 4]) -> Plane<S> {
    let state = entries(state);
    let [y, theta, m, q]: [S; 4] = core::array::from_fn(|k| state[k] / units[k]);
    let own = [y, theta, m, q];
    let candidates = [spanned(own, [theta, -y, -q, m]), spanned(own, [theta, y, -q, -m])];
    let [one, other] = candidates.map(|plane| minors(&plane).map(|minor| minor.size()).into_iter().fold(0.0, f64::max));
    let plane = if one < other { candidates[1] } else { candidates[0] };
    let [y_theta, y_m, w, theta_q, m_q] = minors(&plane);
    let [of_y, of_theta, of_m, of_q] = units;
    let minors =
        [y_theta * of_y * of_theta, y_m * of_y * of_m, w * of_y * of_q, theta_q * of_theta * of_q, m_q * of_m * of_q];
    Plane::new(minors, 0)
}

/// The covector `Pᴴ z/|P|²`, which picks a state out of a plane that holds it; zero for a state at rest.
fn covector_of<T: Real, S: Oscillation<T>>(state: State<S>, plane: &Plane<S>, units: [S; 4]) -> Covector<S> {
    let (state, [y_theta, y_m, w, theta_q, m_q]) = (entries(state), minors(plane));
    let [of_y, of_theta, of_m, of_q] = units;
    let balanced = [
        y_theta / (of_y * of_theta),
        y_m / (of_y * of_m),
        w / (of_y * of_q),
        theta_q / (of_theta * of_q),
        m_q / (of_m * of_q),
    ];
    let size = balanced.map(|minor| minor.size()).into_iter().fold(0.0, f64::max);
    if size == 0.0 {
        return Covector::Plane([S::zero(); 4], 0);
    }
    let shift = binary_exponent(size);
    let balanced = balanced.map(|minor| minor.times_power_of_two(-shift));
    let square = |minor: S| minor * minor.conjugate();
    let [a, b, c, d, e] = balanced.map(square);
    // w stands for two minors
    let norm = a + b + c + c + d + e;
    let turned = Plane::unscaled(balanced.map(|minor| -minor.conjugate()), 0);
    let own = core::array::from_fn(|k| state[k] / units[k]);
    let picked = entries(Covector::Plane(own, 0).pick(&Subspace::Plane(turned)).shifted(0));
    let covector = core::array::from_fn(|k| picked[k] / (norm * units[k]));
    Covector::Plane(covector, -plane.exponent.saturating_add(shift))
}
