//! The motion of a beam: its back transfer, its energies and their derivatives with respect to its parameters.

use crate::element::{BackTransfer, Energies, Inside};
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::shared::back_transfer::BendingBackTransfer;
use crate::elements::shared::compound::Units;
use crate::elements::shared::krylov::krylov;
use crate::elements::shared::line_forms::half;
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Oscillation, Real, WaveFunctions};
use crate::subspace::{Covector, Subspace};

/// Relative distance of two values of `z⁴` from which on the integral of a product is a difference at the ends.
const APART: f64 = 1e-3;
/// Value of `z⁴` above which the forms of a beam are differences between states at the ends: they cancel to this part.
const LONG: f64 = 1e-2;

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Beam<T> {
    type BackCoefficients = BendingBackTransfer<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &BuiltBeam<T>) -> BuiltBeam<T> {
        *built
    }

    fn back_coefficients(built: &BuiltBeam<T>, at: &FrequencyPowers<S>) -> BendingBackTransfer<S> {
        let z = at.powers[0] * built.wave;
        if z.size() <= 1.0 {
            return built.short_links(at);
        }
        let WaveFunctions { sin, cos, sh, ch, exponents: [j, k], .. } = z.wave_functions();
        let [sin, cos] = [sin, cos].map(|circular| circular.times_power_of_two(-k));
        let [sh, ch] = [sh, ch].map(|hyperbolic| hyperbolic.times_power_of_two(-j));
        let krylov = [ch + cos, sh + sin, ch - cos, sh - sin];
        let Units { factors: [first, second, ..], inverses: [first_inverse, second_inverse, ..] } = built.units(at);
        BendingBackTransfer {
            krylov,
            raised: [krylov[1], krylov[2], krylov[3]],
            factors: [second * first_inverse, first, second],
            inverses: [first * second_inverse, first_inverse, second_inverse],
            // above stands twice of each
            exponent: j.saturating_add(k) - 1,
        }
    }

    fn back_transfer(
        coefficients: &BendingBackTransfer<S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        coefficients.back_transfer(covector)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Beam<T> {
    type Gradient = Beam<S>;

    fn units(built: &BuiltBeam<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        if S::size(at.powers[0] * built.wave) <= 1.0 {
            return [2, 0].map(|k| built.length_units.factors[k].size());
        }
        [2, 0].map(|k| S::size(at.powers[k] * built.wave_units.factors[k]))
    }

    /// Where the frequencies differ, `(λ₂² - λ₁²) ∫ m Y₁ Y₂ dx = [Q₁ Y₂ - M₁ Θ₂ + Θ₁ M₂ - Y₁ Q₂]` between the ends.
    fn mass_form(built: &BuiltBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second)[0]
    }

    fn stiffness_form(built: &BuiltBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second)[1]
    }

    fn inside(built: &BuiltBeam<T>, x: S) -> Option<Inside> {
        let length = built.parameters.length.to_f64();
        Some(Inside { length, wave_number: S::size(built.z(x)) / length })
    }

    fn state_at(built: &BuiltBeam<T>, ends: &Ends<S>, distance: f64) -> State<S> {
        built.state_at(ends, T::from_f64(distance))
    }

    /// The derivative with respect to the length is constant along the beam, `λ² m Y²/2 - M²/(2 EI) + Θ Q`.
    fn gradient(built: &BuiltBeam<T>, ends: &Ends<S>) -> Beam<S> {
        let [mass, stiffness] = built.forms(ends, ends).map(half);
        let Beam { bending_stiffness, mass_per_length, .. } = built.parameters;
        Beam {
            length: built.flow(ends),
            bending_stiffness: stiffness * (T::one() / bending_stiffness),
            mass_per_length: ends.x.lambda_squared() * mass * (T::one() / mass_per_length),
        }
    }
}

impl<T: Real> BuiltBeam<T> {
    /// The coefficients for `|z| <= 1`, entire in `z⁴`.
    fn short_links<S: Oscillation<T>>(&self, at: &FrequencyPowers<S>) -> BendingBackTransfer<S> {
        let x = -at.lambda_squared * self.wave_fourth;
        let functions = krylov(x);
        let Units { factors: [first, second, ..], inverses: [first_inverse, second_inverse, ..] } = self.short_units();
        let length = S::from_parameter(self.parameters.length);
        BendingBackTransfer {
            krylov: functions,
            raised: [functions[1] * x, functions[2] * x, functions[3] * x],
            factors: [S::one() / length, first, second],
            inverses: [length, first_inverse, second_inverse],
            exponent: 0,
        }
    }

    /// Mass and stiffness form of two motions: `[∫ m Y₁ Y₂ dx, ∫ M₁ M₂/EI dx]`.
    ///
    /// In a long beam the stiffness form is `[M₁ Θ₂ - Q₁ Y₂] - λ₁² ∫ m Y₁ Y₂ dx`. The mass form is a difference of the ends, too, if
    /// the frequencies are apart; that of one motion with itself follows from its flow. In other cases both are integrated.
    fn forms<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let (a, b) = (first.x.lambda_squared(), second.x.lambda_squared());
        let size = S::size(a).max(S::size(b));
        let is_long = size * self.wave_fourth.to_f64() > LONG;
        let mass = if is_long && S::size(a - b) > APART * size {
            let mixed = |u: &State<S>, v: &State<S>| u.q * v.y - u.m * v.theta + u.theta * v.m - u.y * v.q;
            (mixed(&first.output, &second.output) - mixed(&first.input, &second.input)) / (b - a)
        } else if is_long && first == second {
            self.mass_form_of(first)
        } else {
            let [deflection, moment] = self.integrals(first, second);
            let Beam { bending_stiffness, mass_per_length, .. } = self.parameters;
            return [deflection * mass_per_length, moment * (T::one() / bending_stiffness)];
        };
        let work = |u: &State<S>, v: &State<S>| u.m * v.theta - u.q * v.y;
        let work = work(&first.output, &second.output) - work(&first.input, &second.input);
        [mass, work - a * mass]
    }

    /// `λ² m Y²/2 - M²/(2 EI) + Θ Q` at the end where its terms are smaller, since they cancel where waves decay.
    fn flow<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        let (ei, m) = (self.parameters.bending_stiffness, self.parameters.mass_per_length);
        let [at_input, at_output] = [ends.input, ends.output].map(|state| {
            [
                half(ends.x.lambda_squared() * state.y * state.y) * m,
                -half(state.m * state.m) * (T::one() / ei),
                state.theta * state.q,
            ]
        });
        let size = |parts: &[S; 3]| parts.iter().map(|part| part.size()).sum::<f64>();
        let parts = if size(&at_input) < size(&at_output) { at_input } else { at_output };
        parts[0] + parts[1] + parts[2]
    }

    /// `∫ m Y² dx = (l/2) flow/λ² - [3 Y Q - Θ M]/(4 λ²)`, for a beam that is not short.
    fn mass_form_of<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        let at_end = |state: &State<S>| (state.y + state.y + state.y) * state.q - state.theta * state.m;
        let ends_part = at_end(&ends.output) - at_end(&ends.input);
        let flow = half(self.flow(ends)) * self.parameters.length;
        (flow - ends_part * S::from_f64(0.25)) / ends.x.lambda_squared()
    }
}
