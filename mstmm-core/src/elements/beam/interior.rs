//! States between the ends of a beam, and integrals over products of them.

use crate::elements::beam::BuiltBeam;
use crate::elements::shared::krylov::krylov;
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Oscillation, Real, Scalar, exponential};
use num_complex::Complex;
use num_traits::Zero;

/// Nodes and weights of Gauss and Legendre on `[-1, 1]`, exact up to degree 13. They are exact to rounding for a product of two
/// deflections whose phase changes by less than 1 over the interval.
const GAUSS: [(f64, f64); 7] = [
    (-0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
    (-0.741_531_185_599_394_4, 0.279_705_391_489_276_7),
    (-0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.0, 0.417_959_183_673_469_4),
    (0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.741_531_185_599_394_4, 0.279_705_391_489_276_7),
    (0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
];

impl<T: Real> BuiltBeam<T> {
    /// The wave number times the length, `z = βl`.
    pub(super) fn z<S: Oscillation<T>>(&self, x: S) -> S {
        FrequencyPowers::new(x, true).powers[0] * self.wave
    }

    /// The state at a distance from the input end, given those at both ends.
    ///
    /// In a short beam it follows from the state at the input end. In a long one each of the four waves `e^{sx}`, `s⁴ = β⁴`, is taken
    /// from the end from which it decays, so that no digits are lost at any frequency.
    pub(crate) fn state_at<S: Oscillation<T>>(&self, ends: &Ends<S>, distance: T) -> State<S> {
        let z = self.z(ends.x);
        if z.size() > 1.0 {
            return self.state_of_waves(z.to_complex(), ends, distance);
        }
        self.state_of_series(ends, distance)
    }

    /// The state by the transfer matrix of a part of the beam, in a form that holds for a part of length zero.
    fn state_of_series<S: Oscillation<T>>(&self, ends: &Ends<S>, distance: T) -> State<S> {
        let flexibility = T::one() / self.parameters.bending_stiffness;
        let square = distance * distance;
        let [linear, squared, cubed] = [distance, square, square * distance].map(S::from_parameter);
        let inertia = -ends.x.lambda_squared() * self.parameters.mass_per_length;
        let [s, t, u, v] = krylov(inertia * (square * square * flexibility));
        let [t, u, v] = [t * linear, u * squared, v * cubed];
        let State { y, theta, m, q } = ends.input;
        let (curvature, slope) = (m * flexibility, q * flexibility);
        State {
            y: s * y + t * theta + u * curvature + v * slope,
            theta: v * inertia * flexibility * y + s * theta + t * curvature + u * slope,
            m: u * inertia * y + v * inertia * theta + s * m + t * q,
            q: t * inertia * y + u * inertia * theta + v * inertia * curvature + s * q,
        }
    }

    /// `Y = Σ_k c_k e^{s_k x}`, `s_k = β i^k`, with `c_k` from the end from which the wave decays.
    fn state_of_waves<S: Oscillation<T>>(&self, z: Complex<T>, ends: &Ends<S>, distance: T) -> State<S> {
        let (length, ei) = (self.parameters.length, self.parameters.bending_stiffness);
        let beta = z * (T::one() / length);
        let units = [Complex::from_f64(1.0), beta, beta * beta * ei, beta * beta * beta * ei];
        let at_input = amplitudes(ends.input.map(S::to_complex), units);
        let at_output = amplitudes(ends.output.map(S::to_complex), units);
        let mut derivatives: [Complex<T>; 4] = [Complex::zero(); 4];
        for k in 0..4 {
            let rate = turned(beta, k);
            let wave = if rate.re <= T::zero() {
                at_input[k] * exponential(rate * distance)
            } else {
                at_output[k] * exponential(rate * (distance - length))
            };
            for (order, derivative) in derivatives.iter_mut().enumerate() {
                *derivative += turned(wave, k * order);
            }
        }
        let [y, theta, m, q] = core::array::from_fn(|k| S::from_complex(derivatives[k] * units[k]));
        State { y, theta, m, q }
    }

    /// `[∫ Y₁ Y₂ dx, ∫ M₁ M₂ dx]` by Gauss's rule, on as many pieces as the waves need.
    pub(super) fn integrals<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let waves = self.z(first.x).size().max(self.z(second.x).size());
        let pieces = 1 + waves as u32;
        let half = self.parameters.length / T::from_f64(2.0 * f64::from(pieces));
        let mut sums = [S::zero(); 2];
        for piece in 0..pieces {
            let middle = half * T::from_f64(f64::from(2 * piece + 1));
            for (node, weight) in GAUSS {
                let distance = middle + half * T::from_f64(node);
                let state = self.state_at(first, distance);
                let other = if first == second { state } else { self.state_at(second, distance) };
                let width = half * T::from_f64(weight);
                sums = [sums[0] + state.y * other.y * width, sums[1] + state.m * other.m * width];
            }
        }
        sums
    }
}

/// `c_k = ¼ Σ_n (Y⁽ⁿ⁾/βⁿ) i^{-kn}`
fn amplitudes<T: Real>(state: State<Complex<T>>, units: [Complex<T>; 4]) -> [Complex<T>; 4] {
    let entries = [state.y, state.theta / units[1], state.m / units[2], state.q / units[3]];
    core::array::from_fn(|k| {
        let sum = entries.iter().enumerate().fold(Complex::zero(), |sum, (n, entry)| sum + turned(*entry, 3 * k * n));
        sum * T::from_f64(0.25)
    })
}

/// A number times `i^quarters`.
fn turned<T: Real>(value: Complex<T>, quarters: usize) -> Complex<T> {
    match quarters % 4 {
        0 => value,
        1 => Complex::new(-value.im, value.re),
        2 => -value,
        _ => Complex::new(value.im, -value.re),
    }
}
