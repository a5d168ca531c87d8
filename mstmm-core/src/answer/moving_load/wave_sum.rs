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
        // a NaN is not told apart either
        if !(difference.size() >= APART * first.size().max(second.size())) {
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
