//! Responses about rest, where λ = 0 may be a pole: `H(λ) = r₂/λ² + r₁/λ + h₀ + …`.
//!
//! A rigid body that the load sets in motion makes r₂, what a damper alone holds makes r₁. Where both are zero h₀ is the static
//! limit, although Δ vanishes at λ = 0 itself.
//!
//! At `λ = iω` the real part of H is `r₂/λ² + h₀ + h₂ λ² + …` and its imaginary part times λ is `r₁ + h₁ λ² + …`: without their
//! poles both are smooth in λ² up to the first other root. A polynomial through samples on the imaginary axis gives what they
//! are at zero, of real frequencies as of complex ones.

use super::error::MotionError;
use crate::scalar::{Oscillation, Real, Scalar};
use core::marker::PhantomData;

/// Samples of a polynomial.
const SAMPLES: usize = 12;
/// The samples as parts of the highest frequency, near `cos((2k + 1)π/48)`: as even functions Chebyshev's points.
const PARTS: [f64; SAMPLES] = [
    0.997_8, 0.980_8, 0.947_0, 0.896_9, 0.831_5, 0.751_9, 0.659_3, 0.555_6, 0.442_3, 0.321_4, 0.195_1, 0.065_4,
];
/// Ranges of frequencies that are tried in each direction, each half as long as the one before, or twice as long.
const RANGES: i32 = 40;
/// Roundings by which the limits of two ranges differ where nothing is left to gain.
const SETTLED: f64 = 16.0;
/// A range that changes the limit by so much more than another did leads away from the best one.
const WORSE: f64 = 1e4;
/// Roundings of a sample within which a pole is none.
const ROUNDING: f64 = 256.0;
/// Roundings of a limit that is none: those of samples near the pole cancel in part.
const LEFT: f64 = 4.0;
/// Change of a limit from one range to the next, relative to what the response is in the first range, from which on there is no
/// limit.
const UNSETTLED: f64 = 1e-9;

/// A response at one frequency, and the size of what it is the sum of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<S> {
    pub(super) value: S,
    pub(super) size: f64,
}

/// The first coefficients of a response about λ = 0; poles that rounding explains are zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct AtRest<S> {
    /// `r₂`, one over the mass that the load feels.
    pub(super) double: S,
    /// `r₁`, one over the damping.
    pub(super) simple: S,
    /// `h₀`, what is left of the response without its poles.
    pub(super) finite: S,
    /// The largest sample of what is left.
    largest: f64,
    /// By how much the rounding of samples may move h₀ at most.
    rounding: f64,
}

/// The weights of samples in the value of their polynomial at zero.
struct Polynomial<T, S> {
    weights: [S; SAMPLES],
    meaning: PhantomData<fn() -> T>,
}

/// The best range so far.
#[derive(Clone, Copy, Debug)]
struct Best<S> {
    limit: AtRest<S>,
    /// How much h₀ differs from that of the next range.
    change: f64,
}

impl<S: Scalar> AtRest<S> {
    /// The coefficients of a response that is given on the imaginary axis, found in ranges from about `2^exponent` rad/s on.
    ///
    /// A range that is too long holds another pole, one that is too short leaves little of h₀ beside the poles at zero: that is
    /// taken at which h₀ changes least. `scale` is a size beside which changes do not count.
    ///
    /// # Errors
    /// [`MotionError::Unresolved`] where h₀ goes on changing, and what the response says where there is no range at all.
    pub(super) fn of<T>(
        exponent: i32,
        scale: f64,
        response: impl Fn(S) -> Result<Part<S>, MotionError>,
    ) -> Result<Self, MotionError>
    where
        T: Real,
        S: Oscillation<T>,
    {
        let polynomial = Polynomial::<T, S>::new();
        let first = polynomial.fit(exponent, &response);
        let largest = first.map_or(0.0, |first| first.largest).max(scale);
        let mut best: Option<Best<S>> = None;
        for direction in [-1, 1] {
            let mut before = first;
            for range in 1..=RANGES {
                let now = polynomial.fit(exponent + direction * range, &response);
                // what lies beyond the shorter range shows there by many powers of four less
                let (shorter, longer) = if direction < 0 { (now, before) } else { (before, now) };
                before = now;
                let (Ok(shorter), Ok(longer)) = (shorter, longer) else { continue };
                let change = (shorter.finite - longer.finite).size();
                if best.is_none_or(|best| change < best.change) {
                    best = Some(Best { limit: shorter, change });
                }
                let Some(best) = best else { continue };
                if best.change <= SETTLED * S::EPSILON * (best.limit.finite.size() + scale) {
                    return Ok(best.limit.beyond_rounding());
                }
                if best.change <= UNSETTLED * largest && change > WORSE * best.change {
                    break;
                }
            }
        }
        let best = best.ok_or(first.err().unwrap_or(MotionError::NotFinite { frequency: 0.0 }))?;
        let misfit = best.change / largest.max(best.limit.finite.size());
        if misfit <= UNSETTLED { Ok(best.limit.beyond_rounding()) } else { Err(MotionError::Unresolved { root: 0.0, misfit }) }
    }

    /// The same without a limit that rounding explains.
    fn beyond_rounding(self) -> Self {
        let is_none = self.finite.size() <= LEFT * self.rounding;
        AtRest { finite: if is_none { S::zero() } else { self.finite }, ..self }
    }
}

impl<T: Real, S: Oscillation<T>> Polynomial<T, S> {
    /// Lagrange's weights at zero, in the square of the frequency.
    fn new() -> Self {
        let squares = PARTS.map(|part| S::from_f64(part) * S::from_f64(part));
        let weight = |own: usize| {
            let others = (0..SAMPLES).filter(|&other| other != own);
            others.fold(S::one(), |product, other| product * squares[other] / (squares[other] - squares[own]))
        };
        Polynomial { weights: core::array::from_fn(weight), meaning: PhantomData }
    }

    /// The coefficients from samples up to `2^exponent` rad/s.
    fn fit(
        &self,
        exponent: i32,
        response: &impl Fn(S) -> Result<Part<S>, MotionError>,
    ) -> Result<AtRest<S>, MotionError> {
        let half = S::from_f64(0.5);
        let mut samples = [(S::zero(), S::zero(), S::zero()); SAMPLES];
        // sums of sizes in the units of both poles: what rounding may make of them
        let (mut of_double, mut of_simple, mut of_finite) = (0.0, 0.0, 0.0);
        for ((sample, part), weight) in samples.iter_mut().zip(PARTS).zip(self.weights) {
            let omega = T::from_f64(part).times_power_of_two(exponent);
            let x = S::of_omega(omega);
            let Part { value, size } = response(x)?;
            let (square, mirrored) = (x.lambda_squared(), value.conjugate());
            *sample = (square, (value + mirrored) * half, (value - mirrored) * half * x.lambda());
            of_finite += weight.size() * size;
            of_double += weight.size() * size * square.size();
            of_simple += weight.size() * size * x.lambda().size();
        }
        let at_zero = |entry: &dyn Fn(&(S, S, S)) -> S| {
            samples.iter().zip(self.weights).fold(S::zero(), |sum, (sample, weight)| sum + entry(sample) * weight)
        };
        let known = |pole: S, size: f64| if pole.size() > ROUNDING * S::EPSILON * size { pole } else { S::zero() };
        let double = known(at_zero(&|(square, even, _)| *square * *even), of_double);
        let simple = known(at_zero(&|(_, _, odd)| *odd), of_simple);
        let left = |(square, even, _): &(S, S, S)| *even - double / *square;
        let finite = at_zero(&left);
        let largest = samples.iter().map(|sample| left(sample).size()).fold(0.0, f64::max);
        if [double, simple, finite].iter().all(|value| value.size().is_finite()) {
            Ok(AtRest { double, simple, finite, largest, rounding: S::EPSILON * of_finite })
        } else {
            Err(MotionError::NotFinite { frequency: 0.0 })
        }
    }
}
