//! The mean square of a response over a short range of frequencies, in closed form.
//!
//! Frequencies f are in hertz, and λ is counted in turns: `λ = if`. Over a range of half width h around a, with `f = a + h t`, the response is a power series in t beside poles `ρ/(t - q)` of the modes in it. With the far part F and the near poles
//!
//! `|H|² = |F|² + 2 Re Σ (F̄ + Σ_m ρ̄_m/(q_n - q̄_m)) ρ_n/(t - q_n)`,
//!
//! since `1/((t - q_n)(t - q̄_m))` is a difference of two poles over `q_n - q̄_m`, whose imaginary part is not small: both modes are damped. The level and the powers of f are a
//! binomial series in t. A polynomial over `t - q` is a polynomial beside its value at q over `t - q`, whose integral is a logarithm.
//!
//! A pole is far that is [`FAR`] half widths away: its series loses a factor of `1/FAR` with each term, and all numbers are exact to rounding once `FAR^-terms` is.

use crate::answer::modal::response::{ModalResponse, Term};
use crate::number::{List, Real, angle, binary_exponent, logarithm_of_ratio, modulus, twice};
use num_complex::Complex;
use num_traits::Zero;

/// Distance of a pole from the middle, in half widths, from which on it has a series.
pub(super) const FAR: f64 = 4.0;

/// Binary digits that a term of a series adds.
const DIGITS_OF_A_TERM: i32 = 2;

/// Terms beside those for the digits of a number: products of two series have as many parts of one size as they have terms.
const MORE_TERMS: i32 = 4;

/// Terms of the longest series: those of double-doubles.
const MOST_TERMS: usize = 64;

/// Widest distance of a pole from the range, in half widths over its height, at which it may stand beside it: what cancels is below two digits.
const BESIDE: f64 = 16.0;

/// Roundings of a frequency within which a pole counts as inside.
const ROUNDINGS: f64 = 8.0;

/// A power series in t.
type Series<T> = [Complex<T>; MOST_TERMS];

/// A range of frequencies, within an eighth of itself or from zero on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment<T> {
    ends: [T; 2],
    middle: T,
    half: T,
}

/// A pole `ρ/(t - q)`, with the logarithm `∫ dt/(t - q)`.
#[derive(Clone, Copy, Debug, Default)]
struct Near<T> {
    place: Complex<T>,
    residue: Complex<T>,
    logarithm: Complex<T>,
}

/// The number of terms of a series.
fn terms<T: Real>() -> usize {
    let needed = MORE_TERMS - binary_exponent(T::EPSILON) / DIGITS_OF_A_TERM;
    usize::try_from(needed).unwrap_or(MOST_TERMS).min(MOST_TERMS)
}

/// The frequency `-iλ` of an eigenvalue.
fn pole<T: Real>(lambda: Complex<T>) -> Complex<T> {
    Complex::new(lambda.im, -lambda.re)
}

impl<T: Real> Segment<T> {
    pub(super) fn new(ends @ [start, end]: [T; 2]) -> Self {
        let half = (end - start) * T::from_f64(0.5);
        // from zero on there is no binomial series: powers of f are those of t
        let [middle, half] = if start.is_zero() { [start, end] } else { [start + half, half] };
        Segment { ends, middle, half }
    }

    pub(super) fn middle(&self) -> T {
        self.middle
    }

    /// Whether a mode has a series here, or its pole is one that may be divided out.
    pub(super) fn suits(&self, lambda: Complex<T>) -> bool {
        self.is_far(lambda) || self.holds(lambda.im) || -lambda.re * T::from_f64(BESIDE) >= self.half
    }

    fn is_far(&self, lambda: Complex<T>) -> bool {
        modulus(pole(lambda) - self.middle) >= self.half * T::from_f64(FAR)
    }

    /// Whether a frequency is inside, to rounding.
    pub(super) fn holds(&self, hertz: T) -> bool {
        let rounding = T::from_f64(ROUNDINGS * T::EPSILON);
        let [start, end] = self.ends;
        hertz >= start - start * rounding && hertz <= end + end * rounding
    }

    /// A frequency as t.
    fn place(&self, hertz: T) -> T {
        (hertz - self.middle) / self.half
    }

    /// The integrals of the powers of t.
    fn moments(&self) -> [T; MOST_TERMS] {
        let [start, end] = self.ends.map(|hertz| self.place(hertz));
        let mut powers = [start, end];
        let mut moments = [T::zero(); MOST_TERMS];
        for (power, moment) in moments[..terms::<T>()].iter_mut().enumerate() {
            *moment = (powers[1] - powers[0]) / T::from_f64(power as f64 + 1.0);
            powers = [powers[0] * start, powers[1] * end];
        }
        moments
    }

    /// `(f/scale)^power` times a level that goes with `f^slope` and is 1 in the middle.
    fn weight(&self, slope: T, power: u8) -> [T; MOST_TERMS] {
        let mut weight = [T::zero(); MOST_TERMS];
        if self.middle.is_zero() {
            weight[usize::from(power)] = T::one();
            return weight;
        }
        let (exponent, part) = (slope + T::from_f64(f64::from(power)), self.half / self.middle);
        weight[0] = T::one();
        for n in 1..terms::<T>() {
            let number = T::from_f64(n as f64);
            weight[n] = weight[n - 1] * part * (exponent - number + T::one()) / number;
        }
        weight
    }

    /// The frequency to which powers of f are relative.
    fn scale(&self) -> T {
        if self.middle.is_zero() { self.half } else { self.middle }
    }

    /// Adds `g/(f - p)` to a series.
    fn add_simple(&self, series: &mut Series<T>, p: Complex<T>, g: Complex<T>) {
        let from = Complex::from(self.middle) - p;
        let ratio = -(Complex::from(self.half) / from);
        let mut term = g / from;
        for coefficient in &mut series[..terms::<T>()] {
            *coefficient += term;
            term *= ratio;
        }
    }

    /// Adds both poles of a mode: `(Re R λ - Re(R λ̄_n))/((λ - λ_n)(λ - λ̄_n))`, which far above it does not cancel as both poles do.
    fn add_mode(&self, series: &mut Series<T>, term: &Term<T>) {
        let p = pole(term.lambda);
        let [own, mirrored] = [Complex::from(self.middle) - p, Complex::from(self.middle) + p.conj()];
        let first = -(own.inv() * mirrored.inv());
        let step = |numerator: Complex<T>| numerator * first;
        let [below, before] = [own, mirrored].map(|from| Complex::from(self.half) / from);
        let (sum, product) = (below + before, below * before);
        let constant = -(term.residue * term.lambda.conj()).re;
        let mut last = [
            step(Complex::new(constant, term.residue.re * self.middle)),
            step(Complex::new(T::zero(), term.residue.re * self.half)),
        ];
        last[1] -= sum * last[0];
        for coefficient in &mut series[..terms::<T>()] {
            *coefficient += last[0];
            last = [last[1], -(sum * last[1] + product * last[0])];
        }
    }

    /// A pole of a mode, where `∫ df/(f - p)` is a logarithm: by the ends themselves, so that neighbours fit together however narrow the mode is.
    fn near(&self, term: &Term<T>) -> Near<T> {
        let p = pole(term.lambda);
        let [from, to] = self.ends.map(|hertz| Complex::from(hertz) - p);
        let turned = Complex::new(from.re * to.re + p.im * p.im, p.im * (self.ends[1] - self.ends[0]));
        let logarithm = logarithm_of_ratio(to.norm_sqr(), from.norm_sqr()) * T::from_f64(0.5);
        let [place, residue] = [p - self.middle, half_turned(term.residue)].map(|z| z / self.half);
        Near { place, residue, logarithm: Complex::new(logarithm, angle(turned)) }
    }
}

/// `z/(2i)`.
fn half_turned<T: Real>(z: Complex<T>) -> Complex<T> {
    Complex::new(z.im, -z.re) * T::from_f64(0.5)
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// `∫ |H|² G df` and `∫ f² |H|² G df` over a segment that suits all modes, for a level G that goes with `f^slope` and is 1 in the middle.
    pub(super) fn mean_squares(&self, segment: &Segment<T>, slope: T) -> [T; 2] {
        let mut near: List<Near<T>, N> = List::new();
        let far = self.far_part(segment, &mut near);
        let moments = segment.moments();
        let squared = segment.scale() * segment.scale();
        [(0, T::one()), (2, squared)].map(|(power, factor)| {
            let weight = segment.weight(slope, power);
            integral(&weight, &far, &near, &moments) * segment.half * factor
        })
    }

    /// The series of what is far, and what is not.
    fn far_part(&self, segment: &Segment<T>, near: &mut List<Near<T>, N>) -> Series<T> {
        let mut series = [Complex::zero(); MOST_TERMS];
        let late = self.late();
        for term in self.terms.iter().chain(&late) {
            let p = pole(term.lambda);
            if term.lambda.im.is_zero() {
                segment.add_simple(&mut series, p, Complex::new(T::zero(), -term.residue.re));
            } else if segment.is_far(term.lambda) || near.push(segment.near(term)).is_err() {
                segment.add_mode(&mut series, term);
            } else {
                segment.add_simple(&mut series, -p.conj(), half_turned(term.residue.conj()));
            }
        }
        if late.is_none() {
            series[0] += self.residual;
        }
        series[0] += Complex::new(T::zero(), self.flow * segment.middle);
        series[1] += Complex::new(T::zero(), self.flow * segment.half);
        if !self.away().is_zero() {
            let part = segment.half / segment.middle;
            let mut power = -(self.away() / (segment.middle * segment.middle));
            for (n, coefficient) in series[..terms::<T>()].iter_mut().enumerate() {
                *coefficient += power * T::from_f64(n as f64 + 1.0);
                power *= -part;
            }
        }
        series
    }
}

/// `∫ weight |F + Σ ρ/(t - q)|² dt`.
fn integral<T: Real>(weight: &[T; MOST_TERMS], far: &Series<T>, near: &[Near<T>], moments: &[T; MOST_TERMS]) -> T {
    let count = terms::<T>();
    // weight F̄
    let mut weighted: Series<T> = [Complex::zero(); MOST_TERMS];
    for (n, sum) in weighted[..count].iter_mut().enumerate() {
        *sum = (0..=n).fold(Complex::zero(), |sum, k| sum + far[k].conj() * weight[n - k]);
    }
    let square = |n: usize| (0..=n).fold(T::zero(), |sum, k| sum + (weighted[k] * far[n - k]).re);
    let of_far = (0..count).fold(T::zero(), |sum, n| sum + square(n) * moments[n]);
    near.iter().fold(of_far, |sum, own| {
        let others = near
            .iter()
            .fold(Complex::zero(), |sum, other| sum + other.residue.conj() / (own.place - other.place.conj()));
        sum + twice((own.residue * over_pole(own, |n| weighted[n] + others * weight[n], moments)).re)
    })
}

/// `∫ B(t)/(t - q) dt` of a polynomial B: with `B(t) = B(q) + (t - q) D(t)` the coefficients of D and, last, `B(q)` follow from the highest one down.
fn over_pole<T: Real>(
    pole: &Near<T>,
    coefficient: impl Fn(usize) -> Complex<T>,
    moments: &[T; MOST_TERMS],
) -> Complex<T> {
    let [mut quotient, mut sum] = [Complex::<T>::zero(); 2];
    for n in (1..terms::<T>()).rev() {
        quotient = quotient * pole.place + coefficient(n);
        sum += quotient * moments[n - 1];
    }
    sum + (quotient * pole.place + coefficient(0)) * pole.logarithm
}
