//! States of a general beam between its ends.

use crate::element::Deflection;
use crate::elements::general_beam::constants::SectionAt;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::units_of_states;
use crate::elements::general_beam::wave_pair::{Form, WavePair, larger_sum};
use crate::model::{Ends, State};
use crate::number::gauss::Decaying;
use crate::number::{Oscillation, Real, Scalar, exponential};
use num_complex::Complex;
use num_traits::{One, Zero};

/// A beam at the frequency of a motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct BeamMotion<T: Real, S> {
    /// Its parameters without damping.
    pub(super) beam: BeamParameters<T>,
    pub(super) x: S,
    pub(super) section: SectionAt<Complex<T>>,
    /// The factor e by which damping multiplies EI and kGA.
    pub(super) loss: S,
    /// What damping adds to the stiffness of the foundation.
    pub(super) external: S,
    /// σ.
    pub(super) sigma: S,
    /// `σ f`, with damping over e.
    pub(super) flexibility: S,
}

/// Y, Θ, M, Q in units of l and EI.
pub(super) type Vector<T> = [Complex<T>; 4];

/// Growth along the beam, a power of e, up to which states follow from the input end alone.
const GROWTH: f64 = 2.0;

/// A motion of a beam at a frequency.
///
/// States are sums of parts that decay along the beam, which follow from the input end, and of parts that grow, which follow from the output
/// end, so that no digits are lost in long beams. Parts are taken by projections onto pairs of wave numbers, not onto single waves, which
/// would have no limit where wave numbers coincide.
pub(crate) struct Inside<T> {
    section: SectionAt<Complex<T>>,
    input: Vector<T>,
    output: Vector<T>,
    units: [T; 4],
    /// The factor e by which damping multiplies forces.
    loss: Complex<T>,
    length: T,
}

impl<T: Real> Inside<T> {
    /// The motion with given states at both ends.
    pub(crate) fn new<S: Oscillation<T>>(motion: &BeamMotion<T, S>, ends: &Ends<S>) -> Self {
        let (units, loss) = (units_of_states(&motion.beam), motion.loss.to_complex());
        let vector = |state: State<S>| {
            let State { y, theta, m, q } = state.map(S::to_complex);
            let [of_y, of_theta, of_m, of_q] = units;
            [y / of_y, theta / of_theta, m / of_m / loss, q / of_q / loss]
        };
        let (input, output) = (vector(ends.input), vector(ends.output));
        Inside { section: motion.section, input, output, units, loss, length: motion.beam.length }
    }

    /// The state at a distance from the input end.
    pub(crate) fn state_at<S: Oscillation<T>>(&self, distance: T) -> State<S> {
        let part = distance / self.length;
        let [y, theta, m, q] = self.vector_at(part);
        let [of_y, of_theta, of_m, of_q] = self.units;
        let entries = [y * of_y, theta * of_theta, m * of_m * self.loss, q * of_q * self.loss];
        let [y, theta, m, q] = entries.map(S::from_complex);
        State { y, theta, m, q }
    }

    /// The deflection along the beam.
    pub(super) fn deflection<S: Oscillation<T>>(&self) -> Deflection<S> {
        let derivatives = |mut vector: Vector<T>| {
            core::array::from_fn(|_| {
                let [own, ..] = vector;
                vector = self.section.derivative(vector);
                S::from_complex(own * self.length)
            })
        };
        let WavePair { sum, product, square } = self.section.waves;
        let [sum, product, square] = [sum, product, square].map(S::from_complex);
        Deflection { sum, product, square, ends: [self.input, self.output].map(derivatives) }
    }

    fn vector_at(&self, part: T) -> Vector<T> {
        if self.section.waves.largest_growth() <= GROWTH {
            return self.by_input(part);
        }
        match self.section.waves.form() {
            Form::Short => self.by_input(part),
            Form::Apart { squares: [first, second], difference } => {
                let one = self.of_square(first, second, difference, part);
                plus(one, self.of_square(second, first, -difference, part))
            }
            Form::Together { difference, .. } => self.of_both(difference, part),
        }
    }

    /// By the transfer matrix of the part of the beam before it.
    fn by_input(&self, part: T) -> Vector<T> {
        let c = self.section.waves.along(Complex::from(part)).in_form().functions().c;
        let mut power = Complex::one();
        let mut derivative = self.input;
        let mut sum = [Complex::zero(); 4];
        for factor in c {
            sum = plus(sum, times(derivative, factor * power));
            derivative = self.section.derivative(derivative);
            power *= part;
        }
        sum
    }

    /// The part of the waves of one κ, which the other one and `κ - other` single out.
    fn of_square(&self, square: Complex<T>, other: Complex<T>, difference: Complex<T>, part: T) -> Vector<T> {
        let projected = |vector: Vector<T>| {
            let second = self.section.derivative(self.section.derivative(vector));
            times(plus(second, times(vector, -other)), Complex::<T>::one() / difference)
        };
        let root = square.sqrt();
        let input = projected(self.input);
        if root.re.to_f64() <= GROWTH {
            let waves = (square * (part * part)).even_waves();
            let slope = times(self.section.derivative(input), waves.sinhc * part);
            return times(
                plus(times(input, waves.cosh), slope),
                Complex::from_f64(1.0).times_power_of_two(waves.exponent),
            );
        }
        let output = projected(self.output);
        let half = Complex::from(T::from_f64(0.5));
        let decaying = plus(input, times(self.section.derivative(input), -Complex::<T>::one() / root));
        let growing = plus(output, times(self.section.derivative(output), Complex::<T>::one() / root));
        plus(
            times(decaying, half * exponential(-root * part)),
            times(growing, half * exponential(-root * (T::one() - part))),
        )
    }

    /// All waves, where their κ are close to each other: those that decay and those that grow are told apart by the sign of the matrix A of
    /// the equations, `A (√d + s - A²)/(√d √u)`.
    fn of_both(&self, difference: Complex<T>, part: T) -> Vector<T> {
        let sum = self.section.waves.sum;
        let root = self.section.waves.product_of_roots(difference);
        let u = sum + root + root;
        let rate = u.sqrt() * T::from_f64(0.5);
        let quarter = (sum - root - root) * T::from_f64(0.25);
        let factor = Complex::<T>::one() / (root * (rate + rate));
        // the part with the given direction, and its state so far along that direction
        let along = |vector: Vector<T>, direction: T, distance: T| {
            let derivative = |vector: Vector<T>| times(self.section.derivative(vector), Complex::from(direction));
            let second = self.section.derivative(self.section.derivative(vector));
            let reduced = plus(times(vector, root + sum), times(second, -Complex::<T>::one()));
            let sign = times(derivative(reduced), factor);
            let decaying = times(plus(vector, times(sign, -Complex::<T>::one())), Complex::from_f64(0.5));
            let waves = (quarter * (distance * distance)).even_waves();
            let change = plus(derivative(decaying), times(decaying, rate));
            let state = plus(times(decaying, waves.cosh), times(change, waves.sinhc * distance));
            times(state, exponential(-rate * distance).times_power_of_two(waves.exponent))
        };
        plus(along(self.input, T::one(), part), along(self.output, -T::one(), T::one() - part))
    }
}

pub(super) fn plus<T: Real>(first: Vector<T>, second: Vector<T>) -> Vector<T> {
    core::array::from_fn(|k| first[k] + second[k])
}

pub(super) fn times<T: Real>(vector: Vector<T>, factor: Complex<T>) -> Vector<T> {
    vector.map(|entry| entry * factor)
}

impl<T: Real> SectionAt<Complex<T>> {
    /// The derivative along the beam, times l.
    pub(super) fn derivative(&self, [y, theta, m, q]: Vector<T>) -> Vector<T> {
        let SectionAt { sigma, tau, g, h, .. } = *self;
        [sigma * theta - tau * q, m, g * theta + sigma * q, h * y]
    }
}

impl<T: Real> WavePair<Complex<T>> {
    /// κ₁ and κ₂, good to half the digits where they coincide.
    pub(super) fn squares(&self) -> [Complex<T>; 2] {
        let (larger, _) = larger_sum(self.sum, Scalar::sqrt(self.square));
        let larger = larger * T::from_f64(0.5);
        [larger, if larger.is_zero() { larger } else { self.product / larger }]
    }

    /// The largest wave number times l, of whatever kind.
    pub(super) fn largest_wave(&self) -> f64 {
        let [larger, smaller] = self.squares().map(|square| Scalar::sqrt(square).size());
        larger.max(smaller)
    }

    /// The largest number times l by which a wave turns along the beam.
    pub(super) fn largest_travelling(&self) -> f64 {
        let [first, second] = self.squares().map(|square| Scalar::sqrt(square).im.to_f64().abs());
        first.max(second)
    }

    /// Both waves, the shorter one first.
    pub(super) fn decaying(&self) -> [Decaying; 2] {
        let roots = self.squares().map(Scalar::sqrt);
        let [one, other] = roots.map(|root| Decaying { number: root.size(), decay: root.re.to_f64() });
        if one.number < other.number { [other, one] } else { [one, other] }
    }

    /// The largest power of e by which a wave grows along the beam.
    fn largest_growth(&self) -> f64 {
        let [first, second] = self.squares().map(|square| Scalar::sqrt(square).re.to_f64());
        first.max(second)
    }

    /// `√κ₁ √κ₂` with both roots in the half plane of growing waves, given one of the roots of their product.
    fn product_of_roots(&self, root: Complex<T>) -> Complex<T> {
        let [first, second] = self.squares().map(Scalar::sqrt);
        let product = first * second;
        if (product - root).size() <= (product + root).size() { root } else { -root }
    }

    /// The pair of a part of the beam.
    fn along(&self, part: Complex<T>) -> Self {
        let square = part * part;
        let fourth = square * square;
        WavePair { sum: self.sum * square, product: self.product * fourth, square: self.square * fourth }
    }
}
