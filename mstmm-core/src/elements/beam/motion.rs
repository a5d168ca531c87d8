//! The motion of a beam: its back transfer, its energies and their derivatives with respect to its parameters.

use crate::element::{BackTransfer, CarriesLoad, Energies, Inside};
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::shared::back_transfer::BendingBackTransfer;
use crate::elements::shared::bending_motion::BendingMotion;
use crate::elements::shared::compound::Units;
use crate::elements::shared::krylov::krylov;
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Oscillation, Real, WaveFunctions};
use crate::subspace::{Covector, Subspace};

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Beam<T> {
    type BackCoefficients = BendingBackTransfer<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &BuiltBeam<T>) -> BuiltBeam<T> {
        *built
    }

    fn back_coefficients(built: &BuiltBeam<T>, at: &FrequencyPowers<S>) -> BendingBackTransfer<S> {
        let z = built.z(at);
        if z.size() <= 1.0 {
            return built.short_links(at);
        }
        let WaveFunctions { sin, cos, sh, ch, exponents: [j, k], .. } = z.wave_functions();
        let [sin, cos] = [sin, cos].map(|circular| circular.times_power_of_two(-k));
        let [sh, ch] = [sh, ch].map(|hyperbolic| hyperbolic.times_power_of_two(-j));
        let krylov = [ch + cos, sh + sin, ch - cos, sh - sin];
        let Units { factors: [first, second, ..], inverses: [first_inverse, second_inverse, ..] } = built.units(z, at);
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

impl<T: Real> CarriesLoad for Beam<T> {}

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
        built.motion().forms(first, second)[0]
    }

    fn stiffness_form(built: &BuiltBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.motion().forms(first, second)[1]
    }

    fn inside(built: &BuiltBeam<T>, x: S) -> Option<Inside> {
        Some(built.motion().inside(x))
    }

    fn state_at(built: &BuiltBeam<T>, ends: &Ends<S>, distance: f64) -> State<S> {
        built.motion().state_at(ends, T::from_f64(distance))
    }

    fn load_work(built: &BuiltBeam<T>, ends: &Ends<S>) -> Option<S> {
        Some(built.motion().load_work(ends))
    }

    fn mass_per_length(built: &BuiltBeam<T>) -> S {
        S::from_parameter(built.parameters.mass_per_length)
    }

    fn gradient(built: &BuiltBeam<T>, ends: &Ends<S>) -> Beam<S> {
        built.motion().gradient(ends)
    }
}

impl<T: Real> BuiltBeam<T> {
    /// What its motions need of it.
    pub(crate) fn motion(&self) -> BendingMotion<T> {
        BendingMotion { parameters: self.parameters, wave: self.wave, wave_fourth: self.wave_fourth }
    }

    /// The coefficients for `|z| <= 1`, entire in `z⁴`.
    fn short_links<S: Oscillation<T>>(&self, at: &FrequencyPowers<S>) -> BendingBackTransfer<S> {
        let x = self.z_fourth(at);
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
}
