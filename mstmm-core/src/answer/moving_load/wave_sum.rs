//! The deflection of a member as a sum of waves, and what a mode has of a force that moves along it.

use crate::element::Deflection;
use crate::number::{Real, Scalar, exponential, phi_1};
use num_complex::Complex;
use num_traits::Zero;

/// Wave number times l up to which both pairs of waves are one series: their κ may coincide there.
const ALL_SHORT: f64 = 1.0;

/// Wave number times l up to which a pair of waves is a series beside a longer one: each of its two waves is up to so many times as large as their sum as the inverse says.
const SHORT: f64 = 0.5;

/// Relative distance of κ₁ and κ₂ below which waves are not told apart: the inverse is how many times as large as their sum they may be.
const APART: f64 = 1e-4;

/// Size of `λ/u` from which on the integral of a series is a closed form. Its denominator is `s²` less κ, where `|κ| <= 2`.
const FAST: f64 = 2.0;

/// A deflection along `ξ = x/l`: waves that decay from both ends, and a series.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WaveSum<T> {
    /// `√κ₁` and `√κ₂` with real parts that are not negative; zero of a pair without waves.
    rates: [Complex<T>; 2],
    /// Of each pair the factors of `e^{-√κ ξ}` and of `e^{√κ (ξ - 1)}`.
    waves: [[Complex<T>; 2]; 2],
    /// The first four derivatives of the series at ξ = 0, from the zeroth on.
    series: [T; 4],
    /// `s` and `d` of the series, whose derivatives obey `a_{k+4} = s a_{k+2} - d a_k`.
    sum: T,
    product: T,
}

impl<T: Real> WaveSum<T> {
    /// A deflection as a sum of waves; none where these are not told apart.
    ///
    /// The part of κ₁ is `(y'' - κ₂ y)/(κ₁ - κ₂)`. Of it `(y ∓ y'/√κ)/2` decays and grows, each known where it is largest.
    pub(crate) fn new(deflection: &Deflection<T>) -> Option<Self> {
        let Deflection { sum, product, ends, .. } = *deflection;
        let [first, second] = squares(deflection);
        let roots = [first, second].map(Scalar::sqrt);
        if roots.iter().all(|root| root.size() <= ALL_SHORT) {
            return Some(WaveSum { series: ends[0], sum, product, ..WaveSum::default() });
        }
        let difference = first - second;
        let apart = difference.size() / first.size().max(second.size());
        if apart.is_nan() || apart < APART {
            return None;
        }
        let mut whole = WaveSum::default();
        let pairs = [(first, second, difference), (second, first, -difference)];
        for (pair, (own, other, difference)) in pairs.into_iter().enumerate() {
            let part = |[y, slope, second, third]: [T; 4]| {
                [(y, second), (slope, third)].map(|(y, second)| (Complex::from(second) - other * y) / difference)
            };
            let ([y, slope], [y_beyond, slope_beyond]) = (part(ends[0]), part(ends[1]));
            let root = roots[pair];
            if root.size() <= SHORT {
                whole.series = [y, slope, own * y, own * slope].map(|derivative| derivative.re);
                whole.sum = own.re;
                continue;
            }
            let half = T::from_f64(0.5);
            whole.rates[pair] = root;
            whole.waves[pair] = [(y - slope / root) * half, (y_beyond + slope_beyond / root) * half];
        }
        Some(whole)
    }

    /// The deflection times a factor.
    pub(crate) fn times(self, factor: T) -> Self {
        let series = self.series.map(|derivative| derivative * factor);
        WaveSum { series, waves: self.waves.map(|pair| pair.map(|wave| wave * factor)), ..self }
    }

    /// The deflection at ξ \[m\].
    pub(crate) fn at(&self, part: T) -> T {
        let [mut sum, ..] = self.series_at(part);
        for (rate, [decaying, growing]) in self.rates.into_iter().zip(self.waves) {
            let (away, beyond) = (exponential(-rate * part), exponential(rate * (part - T::one())));
            sum += (decaying * away + growing * beyond).re;
        }
        sum
    }

    /// `∫₀^ξ e^{s(ξ-x)} y(x) dx`: what a force that moves along the member by 1 in a unit of time makes of a mode with the eigenvalue s.
    pub(crate) fn passed(&self, part: T, s: Complex<T>) -> Complex<T> {
        let mut sum = self.series_passed(part, s);
        for (rate, [decaying, growing]) in self.rates.into_iter().zip(self.waves) {
            sum += decaying * wave_passed(-rate, Complex::zero(), part, s);
            sum += growing * wave_passed(rate, -rate, part, s);
        }
        sum
    }

    /// The series at ξ with its first three derivatives.
    fn series_at(&self, part: T) -> [T; 4] {
        let (mut sums, mut factor) = ([T::zero(); 4], T::one());
        let mut derivatives = self.series;
        for k in 1..=terms::<T>() {
            for (sum, derivative) in sums.iter_mut().zip(derivatives) {
                *sum += derivative * factor;
            }
            derivatives = self.next(derivatives);
            factor *= part / T::from_f64(k as f64);
        }
        sums
    }

    /// The next four derivatives at ξ = 0.
    fn next(&self, [zeroth, first, second, third]: [T; 4]) -> [T; 4] {
        [first, second, third, self.sum * second - self.product * zeroth]
    }

    /// The integral of the series: by the series of it where s is small, else by parts, from
    /// `∫ e^{s(ξ-x)} y'(x) dx = y(ξ) - e^{sξ} y(0) + s ∫ e^{s(ξ-x)} y(x) dx`.
    fn series_passed(&self, part: T, s: Complex<T>) -> Complex<T> {
        if self.series == [T::zero(); 4] {
            return Complex::zero();
        }
        if s.size() >= FAST {
            let (start, growth) = (self.series, exponential(s * part));
            let after = self.series_at(part);
            let [b0, b1, b2, b3]: [Complex<T>; 4] =
                core::array::from_fn(|k| Complex::from(after[k]) - growth * start[k]);
            let square = s * s;
            let rest = square - Complex::from(self.sum);
            return -(b3 + s * b2 + rest * (b1 + s * b0)) / (square * rest + Complex::from(self.product));
        }
        let (mut sum, mut factor) = (Complex::<T>::zero(), T::one());
        let (mut own, mut derivatives) = (Complex::<T>::zero(), self.series);
        for k in 1..=terms::<T>() {
            sum += own * factor;
            own = s * own + Complex::from(derivatives[0]);
            derivatives = self.next(derivatives);
            factor *= part / T::from_f64(k as f64);
        }
        sum
    }
}

/// Number of terms of a series whose terms are below `k 3^k/k!`.
fn terms<T: Scalar>() -> usize {
    8 * T::SERIES_TERMS
}

/// κ₁ and κ₂, the larger one first.
fn squares<T: Real>(deflection: &Deflection<T>) -> [Complex<T>; 2] {
    let [sum, product, square] = [deflection.sum, deflection.product, deflection.square].map(Complex::from);
    let root = Scalar::sqrt(square);
    let (more, less) = (sum + root, sum - root);
    let larger = (if more.size() >= less.size() { more } else { less }) * T::from_f64(0.5);
    [larger, if larger.is_zero() { larger } else { product / larger }]
}

/// `∫₀^ξ e^{s(ξ-x)} e^{rate x + offset} dx`, which is entire in `s - rate`: by the larger of both exponentials, so that nothing overflows.
fn wave_passed<T: Real>(rate: Complex<T>, offset: Complex<T>, part: T, s: Complex<T>) -> Complex<T> {
    let apart = (s - rate) * part;
    if apart.re <= T::zero() {
        return exponential(rate * part + offset) * phi_1(apart) * part;
    }
    exponential(s * part + offset) * phi_1(-apart) * part
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{DoubleDouble, Parameter, modulus};
    use num_traits::One;

    type Wide = Complex<DoubleDouble>;

    fn wide(z: Complex<f64>) -> Wide {
        Complex::new(DoubleDouble::from_f64(z.re), DoubleDouble::from_f64(z.im))
    }

    /// Numbers of `[0, 1)`, the same at each run.
    fn random(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Waves with some κ: factor, rate and offset of each in many digits. Those of a short pair are large beside their sum, which begins with a value and a slope; those of a
    /// complex pair are conjugate.
    fn waves_of(squares: [Complex<f64>; 2], state: &mut u64) -> [(Wide, Wide, Wide); 4] {
        let zero = Wide::zero();
        let mut waves = [(zero, zero, zero); 4];
        let mut numbers = [0.0; 2];
        for (pair, square) in squares.into_iter().enumerate() {
            let root = Scalar::sqrt(wide(square));
            if pair == 0 || square.im.is_zero() {
                numbers = [0; 2].map(|_| 2.0 * random(state) - 1.0);
            }
            let ([value, slope], half) = (numbers.map(|number| wide(number.into())), DoubleDouble::from_f64(0.5));
            // waves that travel are conjugate to each other, and have no end from which they decay
            let length = if root.size() > 1.0 { modulus(root) } else { DoubleDouble::one() };
            let slope = slope * length / root;
            let decays = root.size() > 1.0 && root.re > DoubleDouble::zero();
            let beyond = if decays { -root } else { zero };
            waves[2 * pair] = ((value - slope) * half, -root, zero);
            waves[2 * pair + 1] = ((value + slope) * half, root, beyond);
        }
        waves
    }

    /// The deflection of waves, in numbers that it is rounded to.
    fn deflection_of(squares: [Complex<f64>; 2], waves: &[(Wide, Wide, Wide); 4]) -> Deflection<f64> {
        let derivative = |part: f64, order: i32| {
            let one = |(factor, rate, offset): &(Wide, Wide, Wide)| {
                let power = (0..order).fold(Complex::from(DoubleDouble::from_f64(1.0)), |power, _| power * *rate);
                *factor * power * exponential(*rate * DoubleDouble::from_f64(part) + *offset)
            };
            waves.iter().fold(Wide::zero(), |sum, wave| sum + one(wave)).re.to_f64()
        };
        let [first, second] = squares.map(wide);
        let difference = first - second;
        let [sum, product, square] = [first + second, first * second, difference * difference].map(|z| z.re.to_f64());
        let ends = [0.0, 1.0].map(|part| [0, 1, 2, 3].map(|order| derivative(part, order)));
        Deflection { sum, product, square, ends }
    }

    /// Oracle: `Σ c (e^{rξ} - e^{sξ})/(r - s)` in 32 digits, of which the differences leave enough; κ real of both signs and complex, short and long, and s at the rate of a
    /// wave but for a part of 1e-9.
    #[test]
    fn integrals_agree_with_their_definition_in_twice_the_digits() {
        let mut state = 7;
        let mut worst = 0.0_f64;
        for case in 0..4000 {
            let size = |state: &mut u64| 10.0_f64.powf(7.0 * random(state) - 3.0);
            let (first, part) = (size(&mut state), random(&mut state));
            let second = first * 10.0_f64.powf(-0.3 - 5.0 * random(&mut state));
            let squares = match case % 4 {
                0 => [Complex::from(first), Complex::from(-first)],
                1 => [Complex::from(-first), Complex::from(second)],
                2 => [Complex::from(-first), Complex::from(-second)],
                _ => {
                    let square = Scalar::sqrt(Complex::from(-1.0)) * first + second;
                    [square, square.conj()]
                }
            };
            let waves = waves_of(squares, &mut state);
            let own = WaveSum::new(&deflection_of(squares, &waves)).unwrap_or_default();
            let travelling = squares.map(|square| Scalar::sqrt(square).im).into_iter().fold(0.0, f64::max);
            let turned = if case % 3 == 0 { travelling * (1.0 + 1e-9) } else { size(&mut state) };
            let s = Complex::new(-0.02 * random(&mut state) * turned * f64::from(case % 2), turned);
            let (xi, s_wide) = (DoubleDouble::from_f64(part), wide(s));
            let (mut at, mut passed) = (Wide::zero(), Wide::zero());
            for (factor, rate, offset) in waves {
                let (here, begin) = (exponential(rate * xi + offset), exponential(offset));
                at += factor * here;
                passed += factor * (here - exponential(s_wide * xi) * begin) / (rate - s_wide);
            }
            let expected = Complex::new(passed.re.to_f64(), passed.im.to_f64());
            let error = (own.passed(part, s) - expected).size() / (expected.size() + 1.0 / (1.0 + s.size()));
            let at_error = (own.at(part) - at.re.to_f64()).abs();
            worst = worst.max(error).max(at_error);
            assert!(error < 1e-12 && at_error < 1e-12, "{case}: {squares:?} {s} {part}: {error:e} {at_error:e}");
        }
        assert!(worst > 0.0);
    }

    /// Waves whose κ are as good as equal are not told apart, unless they are so long that they need not be.
    #[test]
    fn waves_that_coincide_are_told() {
        let of = |square: f64, beside: f64| {
            let squares = [Complex::from(square), Complex::from(square * (1.0 + beside))];
            WaveSum::new(&deflection_of(squares, &waves_of(squares, &mut 3)))
        };
        assert!(of(40.0, 1e-5).is_none() && of(-40.0, 0.0).is_none());
        assert!(of(40.0, 1e-3).is_some() && of(0.5, 0.0).is_some());
        let broken = Deflection { sum: f64::NAN, product: 1.0, square: 1.0, ends: [[0.0; 4]; 2] };
        assert!(WaveSum::new(&broken).is_none());
    }
}
