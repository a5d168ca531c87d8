//! The chart of longitudinal vibration.

use crate::elements::shared::chart_form::{Factors, Form};
use crate::number::{Scalar, Scaled, Size, Truth, series};
use crate::subspace::Chart;
use core::f64::consts::FRAC_1_PI;

/// What longitudinal vibration is made of: the wave number times the length, and the stiffness.
#[derive(Clone, Copy, Debug)]
pub struct LongitudinalWaves<S> {
    /// `ζ² = -mλ²l²/EA` and ζ.
    pub(crate) zeta_squared: S,
    pub(crate) zeta: S,
    /// `EA/l`.
    pub(crate) stiffness: S,
}

impl<S: Scalar> LongitudinalWaves<S> {
    /// Enters the displacements of both ends into a chart, at their places.
    pub(super) fn enter(&self, chart: &mut Chart<S>, places: [usize; 2]) {
        self.form().enter(chart, places, [false; 2], &Factors::new(self.stiffness, S::one()));
    }

    /// The form of longitudinal vibration: over the displacement of the input end and the force at the other, divided by cos ζ, or over
    /// both displacements, divided by sin ζ.
    fn form(&self) -> Form<S, 2, 3> {
        let x = self.zeta_squared;
        let is_short = !S::Size::of(1.0).is_below(x.size()).any();
        let (cos, sinc, one, exponent) = if is_short {
            (series(-x, 0, 2), series(-x, 1, 2), S::one(), 0)
        } else {
            let waves = self.zeta.wave_functions();
            let exponent = waves.exponents[0];
            (waves.cos, waves.sin / self.zeta, S::one().times_power_of_two(-exponent), exponent)
        };
        let is_mixed = is_short || !cos.size().is_below((sinc * self.zeta).size()).any();
        let half_waves = |shift: f64| {
            let number = self.zeta.size() * S::Size::of(FRAC_1_PI) + S::Size::of(shift);
            number.whole().0
        };
        let divisor = if is_mixed { cos } else { sinc };
        let (inverse, exponent) = (S::one() / divisor, i64::from(exponent));
        let (sinc, one) = (sinc * inverse, -(one * inverse));
        if is_mixed {
            let below = half_waves(0.5) + S::Size::of(-1.0);
            let entries = [-(x * sinc), one, -sinc];
            return Form { entries, forces: [false, true], product: Scaled::new(divisor, exponent), below };
        }
        let cot = cos * inverse;
        let product = Scaled::new(divisor / self.stiffness, exponent);
        Form { entries: [cot, one, cot], forces: [false; 2], product, below: half_waves(0.0) }
    }
}
