//! The way along a tapered beam in parts, for planes and states.

use crate::elements::tapered_beam::TaperedBeam;
use crate::elements::tapered_beam::part::{Part, is_short};
use crate::elements::tapered_beam::profile::Profile;
use crate::number::{Scalar, Scaled, Size, Truth};
use crate::subspace::{Connecting, Covector, Plane, RootCounter, Subspace};
use mstmm_plan::Support;

/// Parts that a beam may have at most: some 1600 half waves.
const MOST_PARTS: usize = 2048;

/// The phase that a part may have at most.
const PHASE: f64 = 2.5;

/// The shortest part, a share of the length: sums of such shares with few digits are exact.
const SHORTEST: f64 = 1.0 / (1_u64 << 48) as f64;

/// A tapered beam at a frequency.
#[derive(Clone, Copy, Debug)]
pub struct Tapered<S> {
    pub(super) profile: Profile<S>,
    /// The beam in plain numbers, with the size of λ².
    pub(super) sizes: Profile<f64>,
}

impl<S: Scalar> Tapered<S> {
    pub(super) fn new(beam: TaperedBeam<S>, plain: TaperedBeam<f64>, lambda_squared: S, is_reversed: bool) -> Self {
        Tapered {
            profile: Profile::of(beam, lambda_squared, is_reversed),
            sizes: Profile::of(plain, lambda_squared.size().first(), is_reversed),
        }
    }

    /// The plane behind the beam.
    pub(super) fn through<C: RootCounter<S>>(&self, input: Plane<S>, counter: &mut C) -> Plane<S> {
        if S::IN_LANES {
            // lanes would need parts of their own: each is evaluated alone
            return unknown();
        }
        let mut plane = input;
        for place in Places::new(self.sizes, 0.0, 1.0) {
            let Some([start, width]) = place else { return unknown() };
            let part = Part::new(&self.profile, start, width);
            let Some(after) = part.plane(&plane) else { return unknown() };
            let after = after.in_range();
            if C::COUNTS {
                let Some(held) = part.held() else { return unknown() };
                counter.plane(&plane, &after, held);
            }
            plane = after;
        }
        plane
    }

    /// Takes a plane into the root.
    pub(super) fn root<C: RootCounter<S>>(&self, input: Plane<S>, support: Support, counter: &mut C) -> Scaled<S> {
        Subspace::Plane(self.through(input, counter)).at_root(support, counter)
    }

    /// The plane at a share of the length behind that at another.
    pub(super) fn plane(&self, plane: Plane<S>, start: f64, end: f64) -> Plane<S> {
        let mut plane = plane;
        for place in Places::new(self.sizes, start, end) {
            let part = place.map(|[start, width]| Part::new(&self.profile, start, width));
            let Some(after) = part.and_then(|part| part.plane(&plane)) else { return unknown() };
            plane = after.in_range();
        }
        plane
    }

    /// Y, Θ, M, Q at a share of the length behind those at another, over a power of two.
    pub(super) fn state(&self, state: [S; 4], start: f64, end: f64) -> ([S; 4], i32) {
        let (mut entries, mut exponent) = (state, 0_i32);
        for place in Places::new(self.sizes, start, end) {
            let part = place.map(|[start, width]| Part::new(&self.profile, start, width));
            let Some(after) = part.and_then(|part| part.state(entries)) else {
                return ([S::from_f64(f64::NAN); 4], 0);
            };
            let size = after.iter().map(|entry| entry.size().first()).fold(0.0, f64::max);
            let shift = size.exponent().unwrap_or(0);
            entries = after.map(|entry| entry.times_power_of_two(-shift));
            exponent = exponent.saturating_add(shift);
        }
        (entries, exponent)
    }

    /// The covector at a share of the length before that at another, both counted from the output end: `Uᵀ η` has its entries in the
    /// opposite order of the state that goes through the beam from the other side.
    pub(super) fn covector(&self, covector: Covector<S>, start: f64, end: f64) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let ([q, m, theta, y], shift) = self.state([q, m, theta, y], start, end);
        Covector::Plane([y, theta, m, q], exponent.saturating_add(shift))
    }
}

/// A plane of which nothing is known.
fn unknown<S: Scalar>() -> Plane<S> {
    let unknown = S::from_f64(f64::NAN).valid_if(S::Truth::of(false));
    Plane::unscaled([unknown; 5], 0)
}

/// Where the parts of a beam start, and how wide they are, in shares of the length. `None` is a beam that needs too many of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Places {
    beam: Profile<f64>,
    start: f64,
    end: f64,
    /// The width of the part before.
    width: f64,
    left: usize,
}

impl Places {
    pub(super) fn new(beam: Profile<f64>, start: f64, end: f64) -> Self {
        let can_be_taken = beam.phase() < PHASE * MOST_PARTS as f64;
        Places { beam, start, end, width: end - start, left: if can_be_taken { MOST_PARTS } else { 0 } }
    }
}

impl Iterator for Places {
    type Item = Option<[f64; 2]>;

    fn next(&mut self) -> Option<Option<[f64; 2]>> {
        let rest = self.end - self.start;
        if rest <= 0.0 {
            return None;
        }
        let mut width = rest.min(2.0 * self.width);
        while !is_short(&self.beam, self.start, width) && width >= SHORTEST {
            width *= 0.75;
        }
        if width < rest {
            width = with_few_digits(width);
        }
        if self.left == 0 || width.is_nan() || width < SHORTEST.min(rest) {
            self.start = self.end;
            return Some(None);
        }
        let place = [self.start, width];
        (self.start, self.width, self.left) = (self.start + width, width, self.left - 1);
        Some(Some(place))
    }
}

/// A width cut to three binary digits behind the first, so that places are exact sums, also where numbers have more digits than an `f64`.
fn with_few_digits(width: f64) -> f64 {
    f64::from_bits(width.to_bits() & !((1 << 49) - 1))
}
