//! Motions of a beam that bends: states between its ends, and the forms of mass and stiffness of two motions.

use crate::element::{Deflection, Forms, Inside, MemberEnds};
use crate::elements::beam::Beam;
use crate::elements::shared::krylov::krylov;
use crate::elements::shared::line_forms::{half, smaller_sum};
use crate::model::{Ends, State};
use crate::number::gauss::integrals;
use crate::number::{FrequencyPowers, Oscillation, Real, Scalar, exponential};
use num_complex::Complex;
use num_traits::Zero;

/// Relative distance of two values of `z⁴`, or of `ζ²`, from which on the integral of a product is a difference at the ends.
pub(crate) const APART: f64 = 1e-3;
/// Value of `z⁴`, or of `ζ²`, above which forms are differences between states at the ends: they cancel to this part.
pub(crate) const LONG: f64 = 1e-2;

/// What the motions of a uniform beam need of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BendingMotion<T> {
    pub(crate) parameters: Beam<T>,
    /// `z / sqrt(ω) = (m/EI)^(1/4) l` and `z⁴ / ω²`.
    pub(crate) wave: T,
    pub(crate) wave_fourth: T,
}

impl<T: Real> BendingMotion<T> {
    /// The forms of bending of a member.
    pub(crate) fn member_forms<S: Oscillation<T>>(&self, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let [mass, stiffness] = self.forms(&first.bending(), &second.bending());
        Forms { mass, stiffness, ..Forms::none() }
    }

    /// The length of a beam and its wave number.
    pub(crate) fn inside<S: Oscillation<T>>(&self, x: S) -> Inside {
        let length = self.parameters.length.to_f64();
        Inside { length, wave_number: self.z(x).size() / length }
    }

    /// The wave number times the length, `z = βl`.
    pub(crate) fn z<S: Oscillation<T>>(&self, x: S) -> S {
        FrequencyPowers::new(x, true).powers[0] * self.wave
    }

    /// The deflection with given states at both ends: `y'''' = z⁴ y`.
    pub(crate) fn deflection<S: Oscillation<T>>(&self, ends: &Ends<S>) -> Deflection<S> {
        let (length, ei) = (self.parameters.length, self.parameters.bending_stiffness);
        let fourth = -ends.x.lambda_squared() * self.wave_fourth;
        let square = length * length;
        let derivatives =
            |State { y, theta, m, q }: State<S>| [y, theta * length, m * (square / ei), q * (square * length / ei)];
        Deflection {
            sum: S::zero(),
            product: -fourth,
            square: fourth * S::from_f64(4.0),
            ends: [ends.input, ends.output].map(derivatives),
        }
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
    fn integrals<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let waves = self.z(first.x).size().max(self.z(second.x).size());
        integrals(self.parameters.length, waves, |distance| {
            let state = self.state_at(first, distance);
            let other = if first == second { state } else { self.state_at(second, distance) };
            [state.y * other.y, state.m * other.m]
        })
    }

    /// Mass and stiffness form of two motions: `[∫ m Y₁ Y₂ dx, ∫ M₁ M₂/EI dx]`.
    pub(crate) fn forms<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let [square, strain] = self.squares(first, second);
        [square * self.parameters.mass_per_length, strain]
    }

    /// The derivatives of the dynamic work with respect to length, stiffness and mass. That with respect to the length is constant along the beam.
    pub(crate) fn gradient<S: Oscillation<T>>(&self, ends: &Ends<S>) -> Beam<S> {
        let [square, strain] = self.squares(ends, ends).map(half);
        Beam {
            length: self.flow(ends),
            bending_stiffness: strain * (T::one() / self.parameters.bending_stiffness),
            mass_per_length: ends.x.lambda_squared() * square,
        }
    }

    /// `[∫ Y₁ Y₂ dx, ∫ M₁ M₂/EI dx]`.
    ///
    /// In a long beam the second is `[M₁ Θ₂ - Q₁ Y₂] - λ₁² ∫ m Y₁ Y₂ dx`. The first is a difference of the ends, too, if the frequencies are apart; that of one motion with
    /// itself follows from its flow. In other cases both are integrated.
    fn squares<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let (a, b) = (first.x.lambda_squared(), second.x.lambda_squared());
        let size = S::size(a).max(S::size(b));
        let is_long = size * self.wave_fourth.to_f64() > LONG;
        let Beam { bending_stiffness, mass_per_length, .. } = self.parameters;
        let square = if is_long && S::size(a - b) > APART * size {
            let mixed = |u: &State<S>, v: &State<S>| u.q * v.y - u.m * v.theta + u.theta * v.m - u.y * v.q;
            (mixed(&first.output, &second.output) - mixed(&first.input, &second.input)) / ((b - a) * mass_per_length)
        } else if is_long && first == second {
            self.square_of(first)
        } else {
            let [square, moment] = self.integrals(first, second);
            return [square, moment * (T::one() / bending_stiffness)];
        };
        let work = |u: &State<S>, v: &State<S>| u.m * v.theta - u.q * v.y;
        let work = work(&first.output, &second.output) - work(&first.input, &second.input);
        [square, work - a * square * mass_per_length]
    }

    /// `λ² m Y²/2 - M²/(2 EI) + Θ Q` at the end where its terms are smaller, since they cancel where waves decay.
    pub(crate) fn flow<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        let (ei, m) = (self.parameters.bending_stiffness, self.parameters.mass_per_length);
        smaller_sum([ends.input, ends.output].map(|state| {
            [
                half(ends.x.lambda_squared() * state.y * state.y) * m,
                -half(state.m * state.m) * (T::one() / ei),
                state.theta * state.q,
            ]
        }))
    }

    /// `∫ Y² dx = ((l/2) flow - [3 Y Q - Θ M]/4)/(m λ²)`, for a beam that is not short.
    fn square_of<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        let at_end = |state: &State<S>| (state.y + state.y + state.y) * state.q - state.theta * state.m;
        let ends_part = at_end(&ends.output) - at_end(&ends.input);
        let flow = half(self.flow(ends)) * self.parameters.length;
        (flow - ends_part * S::from_f64(0.25)) / (ends.x.lambda_squared() * self.parameters.mass_per_length)
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
