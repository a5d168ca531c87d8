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
use crate::scaled::binary_exponent;
use core::marker::PhantomData;

/// Samples of a polynomial.
const SAMPLES: usize = 12;
/// The samples as parts of the highest frequency, `cos((2k + 1)π/48)`: for an even function Chebyshev's points.
const PARTS: [f64; SAMPLES] = [
    0.9978589232386035,
    0.9807852804032304,
    0.9469301294951057,
    0.8968727415326884,
    0.8314696123025452,
    0.7518398074789774,
    0.6593458151000688,
    0.5555702330196024,
    0.44228869021900125,
    0.3214394653031617,
    0.19509032201612833,
    0.06540312923014327,
];
/// The last coefficients of a Chebyshev series: of samples of a smooth function they are noise.
const LAST: usize = 3;
/// Ranges of frequencies that are tried in each direction, each half as long as the one before, or twice as long.
const RANGES: i32 = 40;
/// Roundings by which the limits of two ranges differ where nothing is left to gain.
const SETTLED: f64 = 16.0;
/// A range that changes the limit by so much more than another did leads away from the best one.
const WORSE: f64 = 1e4;
/// Roundings of a sample within which a pole is none.
const ROUNDING: f64 = 256.0;
/// The same for noise, which may be larger: it shows in a coefficient as a sixth of what a single sample has.
const NOISE: f64 = 64.0;
/// Roundings of samples within which a limit is none.
const LEFT: f64 = 16.0;
/// Change of a limit from one range to the next, relative to what the response is in the first range, from which on there is no
/// limit.
const UNSETTLED: f64 = 1e-9;

/// A response at one frequency, and a size beside which its rounding is small.
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

/// The weights of samples in the value of their polynomial at zero, and in its last coefficients.
struct Polynomial<T, S> {
    weights: [S; SAMPLES],
    last: [[S; SAMPLES]; LAST],
    meaning: PhantomData<fn() -> T>,
}

/// What a pole is made of at one frequency: itself and what is smooth, and a size beside which rounding is small.
type Residues<S> = [(S, f64); SAMPLES];

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
    /// [`MotionError::Unsettled`] where h₀ goes on changing, and what the response says where there is no range at all.
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
                    return Ok(best.limit.beyond_rounding().refined(exponent, &response));
                }
                // downwards several ranges may hold poles, and change at random, before one has none
                let may_improve = direction < 0 && best.change > UNSETTLED * largest;
                if change > WORSE * best.change && !may_improve {
                    break;
                }
            }
        }
        let best = best.ok_or(first.err().unwrap_or(MotionError::NotFinite { frequency: 0.0 }))?;
        let change = best.change / largest.max(best.limit.finite.size());
        if change > UNSETTLED && best.change > ROUNDING * best.limit.rounding {
            return Err(MotionError::Unsettled { change });
        }
        Ok(best.limit.beyond_rounding().refined(exponent, &response))
    }

    /// With the digits of the leading pole that a single sample has: so near to zero that nothing else counts, where it agrees with
    /// the pole that is known. Elsewhere rounding grows towards zero.
    fn refined<T>(self, exponent: i32, response: &impl Fn(S) -> Result<Part<S>, MotionError>) -> Self
    where
        T: Real,
        S: Oscillation<T>,
    {
        let closer = exponent + binary_exponent(S::EPSILON) / 2 - 1;
        let x = S::of_omega(T::one().times_power_of_two(closer));
        let Ok(Part { value, .. }) = response(x) else { return self };
        let half = S::from_f64(0.5);
        let agreed = |pole: S, sample: S| {
            let is_near = (sample - pole).size() <= ROUNDING * S::EPSILON * pole.size();
            if is_near { sample } else { pole }
        };
        let double = agreed(self.double, (value + value.conjugate()) * half * x.lambda_squared());
        let simple = agreed(self.simple, (value - value.conjugate()) * half * x.lambda());
        AtRest { double, simple, ..self }
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
        // T_k by its recurrence, over the square of the frequency
        let last = |k: usize| {
            squares.map(|square| {
                let twice = (square + square - S::one()) * S::from_f64(2.0);
                let (mut before, mut own) = (S::one(), twice * S::from_f64(0.5));
                for _ in 1..SAMPLES - LAST + k {
                    (before, own) = (own, twice * own - before);
                }
                own * S::from_f64(2.0 / SAMPLES as f64)
            })
        };
        Polynomial { weights: core::array::from_fn(weight), last: core::array::from_fn(last), meaning: PhantomData }
    }

    /// The value at zero of the polynomial through samples.
    fn at_zero(&self, samples: impl Iterator<Item = S>) -> S {
        samples.zip(self.weights).fold(S::zero(), |sum, (sample, weight)| sum + sample * weight)
    }

    /// A pole; zero where rounding or noise explains it.
    fn pole(&self, samples: &Residues<S>) -> S {
        let sum = |weights: &[S; SAMPLES]| {
            samples.iter().zip(weights).fold(S::zero(), |sum, ((sample, _), weight)| sum + *sample * *weight)
        };
        let noise = self.last.iter().map(|weights| sum(weights).size()).fold(0.0, f64::max);
        let size = samples.iter().zip(self.weights).fold(0.0, |sum, ((_, size), weight)| sum + weight.size() * size);
        let pole = sum(&self.weights);
        if pole.size() > ROUNDING * S::EPSILON * size + NOISE * noise { pole } else { S::zero() }
    }

    /// The coefficients from samples up to `2^exponent` rad/s.
    fn fit(
        &self,
        exponent: i32,
        response: &impl Fn(S) -> Result<Part<S>, MotionError>,
    ) -> Result<AtRest<S>, MotionError> {
        let half = S::from_f64(0.5);
        let (mut even, mut double, mut simple) =
            ([S::zero(); SAMPLES], [(S::zero(), 0.0); SAMPLES], [(S::zero(), 0.0); SAMPLES]);
        let (mut squares, mut rounding) = (even, 0.0);
        for (k, part) in PARTS.into_iter().enumerate() {
            let x = S::of_omega(T::from_f64(part).times_power_of_two(exponent));
            let Part { value, size } = response(x)?;
            let (square, mirrored) = (x.lambda_squared(), value.conjugate());
            let odd = (value - mirrored) * half;
            (squares[k], even[k]) = (square, (value + mirrored) * half);
            double[k] = (even[k] * square, size * square.size());
            simple[k] = (odd * x.lambda(), size * x.lambda().size());
            rounding += self.weights[k].size() * size * S::EPSILON;
        }
        let (double, simple) = (self.pole(&double), self.pole(&simple));
        let left = || even.iter().zip(squares).map(|(even, square)| *even - double / square);
        let finite = self.at_zero(left());
        let largest = left().map(Scalar::size).fold(0.0, f64::max);
        if [double, simple, finite].iter().all(|value| value.size().is_finite()) {
            Ok(AtRest { double, simple, finite, largest, rounding })
        } else {
            Err(MotionError::NotFinite { frequency: 0.0 })
        }
    }
}
