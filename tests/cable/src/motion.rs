//! How the string moves: for mode shapes, responses and sensitivities.

use crate::Cable;
use mstmm::element::{BackTransfer, Covector, Ends, Energies, FrequencyPowers, Inside, PlaneStep, State, Subspace};
use mstmm::number::{Oscillation, Real};

/// Nodes and weights of Gauss and Legendre on `[-1, 1]`.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Cable<T> {
    type BackCoefficients = ();
    const SYMMETRIC: bool = true;

    fn reversed(cable: &Self) -> Self {
        *cable
    }

    fn back_coefficients(_cable: &Self, _at: &FrequencyPowers<S>) {}

    /// The step multiplies lines by the transfer matrix and by nothing else.
    fn back_transfer(_links: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        covector
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Cable<T> {
    type Gradient = Cable<S>;

    fn units(cable: &Self, at: &FrequencyPowers<S>) -> [f64; 2] {
        let phi = Self::coefficients(cable, at).phi.size();
        [cable.tension.to_f64() / cable.length.to_f64() * phi.max(1.0), 0.0]
    }

    /// `∫ m Y₁ Y₂ dx`
    fn mass_form(cable: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        cable.integral(first, second, |state| state.y) * cable.mass_per_length
    }

    /// `∫ H Y₁' Y₂' dx` with `Q = -H Y'`
    fn stiffness_form(cable: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        cable.integral(first, second, |state| state.q) * (T::one() / cable.tension)
    }

    fn inside(cable: &Self, x: S) -> Option<Inside> {
        let (_, _, phi) = cable.waves(x.lambda_squared());
        let length = cable.length.to_f64();
        Some(Inside { length, wave_number: phi.size() / length })
    }

    fn state_at(cable: &Self, ends: &Ends<S>, distance: f64) -> State<S> {
        let part = Cable { length: T::from_f64(distance), ..*cable };
        let (cos, sinc, phi) = part.waves(ends.x.lambda_squared());
        let (y, q, flexibility) = (ends.input.y, ends.input.q, part.length / part.tension);
        let rise = if distance > 0.0 { phi * phi * sinc * (T::one() / flexibility) } else { S::zero() };
        State { y: cos * y - sinc * q * flexibility, q: rise * y + cos * q, ..State::default() }
    }

    /// Of the length it is `λ² m Y²/2 - Q²/(2 H)`, the same at every point of the string.
    fn gradient(cable: &Self, ends: &Ends<S>) -> Cable<S> {
        let half = T::from_f64(0.5);
        let (lambda_squared, State { y, q, .. }) = (ends.x.lambda_squared(), ends.input);
        let mass = Self::mass_form(cable, ends, ends);
        Cable {
            length: (lambda_squared * y * y * cable.mass_per_length - q * q * (T::one() / cable.tension)) * half,
            tension: Self::stiffness_form(cable, ends, ends) * (half / cable.tension),
            mass_per_length: lambda_squared * mass * (half / cable.mass_per_length),
        }
    }
}

impl<T: Real> Cable<T> {
    /// `∫ f(state₁) f(state₂) dx`, on pieces along which no wave turns by more than a quarter: exact to rounding.
    fn integral<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>, f: impl Fn(State<S>) -> S) -> S {
        let phi = |ends: &Ends<S>| self.waves(ends.x.lambda_squared()).2.size();
        let pieces = 1 + (4.0 * phi(first).max(phi(second))) as u32;
        let half = self.length.to_f64() / (2.0 * f64::from(pieces));
        let mut sum = S::zero();
        for piece in 0..pieces {
            let middle = half * f64::from(2 * piece + 1);
            for (node, weight) in GAUSS {
                let [a, b] = [first, second].map(|ends| f(Self::state_at(self, ends, middle + half * node)));
                sum += a * b * T::from_f64(half * weight);
            }
        }
        sum
    }
}
