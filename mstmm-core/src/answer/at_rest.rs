//! Responses about rest, where λ = 0 may be a pole: `H(λ) = r₂/λ² + r₁/λ + h₀ + …`.
//!
//! A rigid body that the load sets in motion causes r₂; a part that only dampers hold causes r₁. Where both are zero h₀ is the
//! static limit, although Δ vanishes at λ = 0 itself.
//!
//! At `λ = iω` the even part of H is `r₂/λ² + h₀ + h₂ λ² + …` and its odd part times λ is `r₁ + h₁ λ² + …`: its real and its
//! imaginary part, unless something has a loss factor. Without their poles both are smooth in λ² up to the first other root. A
//! polynomial through samples on the imaginary axis gives their values at zero, for real frequencies as for complex ones.

use crate::model::MotionError;
use crate::number::{Oscillation, Real, Scalar, Single, binary_exponent};
use core::marker::PhantomData;

/// Number of samples of a polynomial.
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
/// Number of last coefficients of a Chebyshev series that are noise, for samples of a smooth function.
const LAST: usize = 3;
/// Number of ranges of frequencies tried downwards, each half as long as the one before, and upwards from there.
const RANGES: i32 = 40;
/// Difference between the limits of two ranges, in roundings, below which no better range is sought.
const SETTLED: f64 = 16.0;
/// Largest change of the limit between two ranges without another pole, relative to the largest size of samples.
const COARSE: f64 = 1e-6;
/// Factor on the least change of the limit beyond which ranges lead away from the best one.
const WORSE: f64 = 1e3;
/// Size of a pole, in roundings of a sample, up to which it counts as zero.
const ROUNDING: f64 = 256.0;
/// Size of a pole, in noise of the last coefficients, up to which it counts as zero. Their noise is a sixth of a sample's.
const NOISE: f64 = 64.0;
/// Size of a limit, in roundings of samples, up to which it counts as zero.
const LEFT: f64 = 16.0;
/// Change of a limit at the best range, relative to the response without its poles there, from which on there is no limit.
const UNSETTLED: f64 = 1e-9;

/// A response at one frequency x, and a size compared with which its rounding is small.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<S> {
    pub(crate) value: S,
    pub(crate) size: f64,
    /// The response at -x as the one above the real axis goes on below: the conjugate, unless something has a loss factor.
    pub(crate) mirrored: S,
}

impl<S> Part<S> {
    /// A response whose conjugate is that at the conjugate frequency.
    pub(crate) fn new<T: Real>(value: S, size: f64) -> Self
    where
        S: Oscillation<T>,
    {
        Part { value, size, mirrored: value.conjugate() }
    }
}

/// The first coefficients of a response about λ = 0. Poles that may be rounding alone are zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AtRest<S> {
    /// `r₂`, one over the mass that the load feels.
    pub(crate) double: S,
    /// `r₁`, one over the damping.
    pub(crate) simple: S,
    /// `h₀`, the value of the response without its poles.
    pub(crate) finite: S,
    /// Relative uncertainty of h₀; zero where most digits are known.
    pub(crate) uncertainty: f64,
    /// The largest of the sizes of samples, and the largest sample of the response without its poles.
    size: f64,
    largest: f64,
    /// Bound of the change of h₀ by the rounding of samples.
    rounding: f64,
}

/// The weights of samples in the value of their polynomial at zero, and in its last coefficients.
struct Polynomial<T, S> {
    weights: [S; SAMPLES],
    last: [[S; SAMPLES]; LAST],
    meaning: PhantomData<fn() -> T>,
}

/// Samples times the power of λ that takes out a pole, and the sizes compared with which their rounding is small.
type Residues<S> = [(S, f64); SAMPLES];

/// The coefficients of two ranges, up to `2^exponent` rad/s and twice as far.
#[derive(Clone, Copy, Debug)]
struct Pair<S> {
    shorter: AtRest<S>,
    longer: AtRest<S>,
    exponent: i32,
}

impl<S: Single> Pair<S> {
    /// The difference of h₀.
    fn change(&self) -> f64 {
        (self.shorter.finite - self.longer.finite).size()
    }

    /// Whether both ranges seem to hold no other pole.
    fn seems_free(&self) -> bool {
        self.change() <= COARSE * self.shorter.size.max(self.longer.size)
    }
}

impl<S: Single> AtRest<S> {
    /// The coefficients of a response that is given on the imaginary axis, found in ranges from about `2^exponent` rad/s on.
    ///
    /// A range that is too long holds another pole. In one that is too short h₀ is small beside the poles at zero, and rounding may
    /// hold a body that nothing else holds. So ranges are halved while h₀ changes less and less, and then doubled to the one at which
    /// it changes least. `scale` is a size compared with which changes do not count.
    ///
    /// # Errors
    /// [`MotionError::Unsettled`] where h₀ goes on changing and nothing moves off; the error of the response where no range has
    /// samples.
    pub(crate) fn of<T>(
        exponent: i32,
        scale: f64,
        response: impl Fn(S) -> Result<Part<S>, MotionError>,
    ) -> Result<Self, MotionError>
    where
        T: Real,
        S: Oscillation<T>,
    {
        let polynomial = Polynomial::<T, S>::new();
        let mut longer = polynomial.fit(exponent, &response);
        let mut failure = longer.err().unwrap_or(MotionError::Unsettled { change: 1.0 });
        let mut lowest: Option<(f64, Pair<S>)> = None;
        for range in 1..=RANGES {
            let shorter = polynomial.fit(exponent - range, &response);
            let pair = shorter.ok().zip(longer.ok()).map(|(shorter, longer)| Pair {
                shorter,
                longer,
                exponent: exponent - range,
            });
            longer = shorter;
            let pair = pair.filter(Pair::seems_free).map(|pair| (pair.change(), pair));
            let improves = pair.is_some_and(|(change, _)| lowest.is_none_or(|(least, _)| change < least));
            // below the rounding of samples there is nothing to gain
            let is_exact = pair.is_some_and(|(change, pair)| change <= pair.shorter.rounding);
            let start = if improves && is_exact { pair } else { lowest.filter(|_| !improves) };
            if let Some((_, start)) = start {
                let limit = polynomial.upwards(start, scale, &response);
                let moves_off = !(limit.double.is_zero() && limit.simple.is_zero());
                // a body that moves off here does so at rest; farther down rounding holds it
                if moves_off || limit.uncertainty == 0.0 {
                    return Ok(limit.beyond_rounding());
                }
                failure = MotionError::Unsettled { change: limit.uncertainty };
            }
            lowest = pair;
        }
        Err(failure)
    }

    /// The coefficients with a limit of zero where it may be rounding alone.
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

    /// The coefficients of the range at which h₀ changes least, from a pair of ranges upwards.
    fn upwards(
        &self,
        mut pair: Pair<S>,
        scale: f64,
        response: &impl Fn(S) -> Result<Part<S>, MotionError>,
    ) -> AtRest<S> {
        let mut best = (f64::INFINITY, pair.shorter);
        for _ in 0..RANGES {
            let change = pair.change();
            if change < best.0 {
                // poles beyond the shorter range enter there by many powers of four less
                best = (change, pair.shorter);
            }
            if best.0 <= SETTLED * S::EPSILON * (best.1.finite.size() + scale) {
                return best.1;
            }
            if change > WORSE * best.0 {
                break;
            }
            let Ok(next) = self.fit(pair.exponent + 2, response) else { break };
            pair = Pair { shorter: pair.longer, longer: next, exponent: pair.exponent + 1 };
        }
        let (least, limit) = best;
        let change = least / limit.largest.max(scale).max(limit.finite.size());
        let is_settled = change <= UNSETTLED.max(ROUNDING * S::EPSILON) || least <= ROUNDING * limit.rounding;
        AtRest { uncertainty: if is_settled { 0.0 } else { change }, ..limit }
    }

    /// The coefficient of a pole; zero where it may be rounding or noise alone.
    fn pole(&self, samples: &Residues<S>) -> S {
        let sum = |weights: &[S; SAMPLES]| weighted(samples.iter().map(|&(sample, _)| sample), weights);
        let noise = self.last.iter().map(|weights| sum(weights).size()).fold(0.0, f64::max);
        let size = samples.iter().zip(self.weights).fold(0.0, |sum, ((_, size), weight)| sum + weight.size() * size);
        let pole = sum(&self.weights);
        if pole.size() > ROUNDING * S::EPSILON * size + NOISE * noise { pole } else { S::zero() }
    }

    /// The poles with all digits of the leading one, from a single sample so near to zero that nothing else counts. It is taken if it
    /// agrees with the known value, since rounding of the others grows towards zero.
    fn refined(poles: [S; 2], exponent: i32, response: &impl Fn(S) -> Result<Part<S>, MotionError>) -> [S; 2] {
        let closer = exponent + binary_exponent(S::EPSILON) / 2 - 1;
        let x = S::of_omega(T::one().times_power_of_two(closer));
        let Ok(Part { value, mirrored, .. }) = response(x) else { return poles };
        let half = S::from_f64(0.5);
        let agreed = |pole: S, sample: S| {
            let is_near = (sample - pole).size() <= ROUNDING * S::EPSILON * pole.size();
            if is_near { sample } else { pole }
        };
        let samples = [(value + mirrored) * half * x.lambda_squared(), (value - mirrored) * half * x.lambda()];
        [agreed(poles[0], samples[0]), agreed(poles[1], samples[1])]
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
        let (mut squares, mut rounding, mut whole) = (even, 0.0, 0.0_f64);
        for (k, part) in PARTS.into_iter().enumerate() {
            let x = S::of_omega(T::from_f64(part).times_power_of_two(exponent));
            let Part { value, size, mirrored } = response(x)?;
            let square = x.lambda_squared();
            let odd = (value - mirrored) * half;
            (squares[k], even[k]) = (square, (value + mirrored) * half);
            double[k] = (even[k] * square, size * square.size());
            simple[k] = (odd * x.lambda(), size * x.lambda().size());
            whole = whole.max(size);
            rounding += self.weights[k].size() * size * S::EPSILON;
        }
        let poles = [self.pole(&double), self.pole(&simple)];
        let [double, simple] = Self::refined(poles, exponent, response);
        let left = || even.iter().zip(squares).map(|(even, square)| *even - double / square);
        let finite = weighted(left(), &self.weights);
        let largest = left().map(Scalar::size).fold(0.0, f64::max);
        if [double, simple, finite].iter().all(|value| value.size().is_finite()) {
            Ok(AtRest { double, simple, finite, uncertainty: 0.0, size: whole, largest, rounding })
        } else {
            Err(MotionError::NotFinite { frequency: 0.0 })
        }
    }
}

/// The sum of samples with their weights.
fn weighted<S: Single>(samples: impl Iterator<Item = S>, weights: &[S; SAMPLES]) -> S {
    samples.zip(weights).fold(S::zero(), |sum, (sample, &weight)| sum + sample * weight)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::DoubleDouble;
    use num_complex::Complex;

    fn part<T: Real, S: Oscillation<T>>(value: S) -> Result<Part<S>, MotionError> {
        Ok(Part::new::<T>(value, value.size()))
    }

    fn agrees<S: Single>(actual: S, expected: f64, limit: f64) -> bool {
        (actual - S::from_f64(expected)).size() <= limit * expected
    }

    /// Closed form: `3/λ² + 2/λ + 5/(λ + 1)`, whose next pole is at 1, from estimates of that pole which are far off.
    #[test]
    fn coefficients_of_a_sum_of_poles() {
        fn check<T: Real>(limit: f64) {
            let of = |value: f64| Complex::<T>::from_f64(value);
            for exponent in [-9, -4, -1, 0, 3] {
                let response = |x: Complex<T>| part(of(3.0) / (x * x) + of(2.0) / x + of(5.0) / (x + of(1.0)));
                let AtRest { double, simple, finite, .. } = AtRest::of::<T>(exponent, 0.0, response).unwrap();
                assert!(agrees(double, 3.0, limit) && agrees(simple, 2.0, limit), "{exponent}: {double:?} {simple:?}");
                assert!(agrees(finite, 5.0, limit), "{exponent}: {finite:?}");
            }
        }
        check::<f64>(1e-12);
        check::<DoubleDouble>(1e-26);
    }

    /// Closed form: `-3/ω² + 1/(4 - ω²)`, of real frequencies.
    #[test]
    fn coefficients_at_real_frequencies() {
        let response = |x: f64| part(-3.0 / (x * x) + 1.0 / (4.0 - x * x));
        let AtRest { double, simple, finite, .. } = AtRest::of::<f64>(-3, 0.0, response).unwrap();
        assert!(
            agrees(double, 3.0, 1e-15) && simple == 0.0 && agrees(finite, 0.25, 1e-11),
            "{double} {simple} {finite}"
        );
    }

    /// A pole as small as rounding is none, and a response without a limit is not settled.
    #[test]
    fn what_cannot_be_told() {
        let noisy = |x: f64| Ok(Part::new::<f64>(1e-15 / (x * x) + 1.0 / (4.0 - x * x), 1.0 + 10.0 / (x * x)));
        let AtRest { double, finite, .. } = AtRest::of::<f64>(-3, 0.0, noisy).unwrap();
        assert!(double == 0.0 && agrees(finite, 0.25, 1e-9), "{double} {finite}");
        let endless = AtRest::of::<f64>(-3, 0.0, |x: f64| part(x.ln().sin()));
        assert!(matches!(endless, Err(MotionError::Unsettled { .. })), "{endless:?}");
        let infinite = AtRest::of::<f64>(-3, 0.0, |_: f64| Err(MotionError::Resonance { frequency: 1.0 }));
        assert!(matches!(infinite, Err(MotionError::Resonance { .. })), "{infinite:?}");
    }
}
