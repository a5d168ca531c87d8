//! A uniform beam in the bounded basis: waves `e^{sx}`, `s⁴ = β⁴ = -mλ²/EI`, each counted from the end where it is largest.

use crate::mode_shapes::recorded::C;
use mstmm::element::State;

/// A beam at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Section {
    pub(crate) length: f64,
    pub(crate) bending_stiffness: f64,
    /// Its wave number, with the largest real part of the four.
    pub(crate) beta: C,
}

impl Section {
    pub(crate) fn new(length: f64, bending_stiffness: f64, mass_per_length: f64, lambda_squared: C) -> Self {
        let beta = (-lambda_squared * (mass_per_length / bending_stiffness)).sqrt().sqrt();
        Section { length, bending_stiffness, beta }
    }

    /// What makes entries comparable, `[1, 1/length, EI/length², EI/length³]`, with 1/β as length; l of a beam shorter than that.
    pub(crate) fn units(&self) -> [f64; 4] {
        let beta = self.beta.norm().max(1.0 / self.length);
        [1.0, beta, self.bending_stiffness * beta.powi(2), self.bending_stiffness * beta.powi(3)]
    }

    /// Amplitudes of the four waves at a place: of `Σ a_k e^{s_k x}`, `s_k = i^k β`.
    fn amplitudes(&self, state: &State<C>) -> [C; 4] {
        let (beta, ei) = (self.beta, self.bending_stiffness);
        let derivatives =
            [state.y, state.theta / beta, state.m / (beta * beta * ei), state.q / (beta * beta * beta * ei)];
        core::array::from_fn(|k| {
            let terms = derivatives.iter().enumerate().map(|(order, entry)| entry * C::i().powi(-((k * order) as i32)));
            terms.sum::<C>() * 0.25
        })
    }

    /// Differences of the waves at both ends, each taken to the end where it is smaller.
    pub(crate) fn mismatches(&self, input: &State<C>, output: &State<C>) -> [C; 4] {
        let (at_input, at_output) = (self.amplitudes(input), self.amplitudes(output));
        core::array::from_fn(|k| {
            let exponent = C::i().powi(k as i32) * self.beta * self.length;
            if exponent.re < 0.0 {
                at_input[k] * exponent.exp() - at_output[k]
            } else {
                at_output[k] * (-exponent).exp() - at_input[k]
            }
        })
    }

    /// The state inside, from those at the ends.
    pub(crate) fn inside(&self, input: &State<C>, output: &State<C>, distance: f64) -> [C; 4] {
        let (at_input, at_output) = (self.amplitudes(input), self.amplitudes(output));
        let mut derivatives = [C::new(0.0, 0.0); 4];
        for k in 0..4 {
            let rate = C::i().powi(k as i32) * self.beta;
            let wave = if rate.re < 0.0 {
                at_input[k] * (rate * distance).exp()
            } else {
                at_output[k] * (rate * (distance - self.length)).exp()
            };
            for (order, derivative) in derivatives.iter_mut().enumerate() {
                *derivative += wave * rate.powi(order as i32);
            }
        }
        let [y, theta, curvature, third] = derivatives;
        [y, theta, curvature * self.bending_stiffness, third * self.bending_stiffness]
    }

    /// `EI Y'''' = -mλ² Y` as a power series from one place to another, for short distances.
    pub(crate) fn series(&self, from: &State<C>, distance: f64) -> [C; 4] {
        let ei = self.bending_stiffness;
        let start = [from.y, from.theta, from.m / ei, from.q / ei];
        let beta4 = self.beta.powi(4);
        let mut result = [C::new(0.0, 0.0); 4];
        // Y⁽ⁿ⁺⁴⁾ = β⁴ Y⁽ⁿ⁾: the n-th derivative at the start in terms of the first four
        let derivative = |n: usize| start[n % 4] * beta4.powi((n / 4) as i32);
        for (order, entry) in result.iter_mut().enumerate() {
            let mut power = 1.0;
            for n in 0..24 {
                *entry += derivative(n + order) * power;
                power *= distance / (n + 1) as f64;
            }
        }
        let [y, theta, curvature, third] = result;
        [y, theta, curvature * ei, third * ei]
    }

    /// Whether waves say less than a series: they cancel in a beam shorter than 1/β.
    pub(crate) fn is_short(&self) -> bool {
        self.beta.norm() * self.length < 2.0
    }
}
