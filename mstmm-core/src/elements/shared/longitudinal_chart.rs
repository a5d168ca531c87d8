//! The chart of longitudinal vibration, and of that of strings and shafts.

use crate::elements::shared::chart_form::{Factors, Form};
use crate::number::{Scalar, Scaled, Size, Truth};
use crate::structure::Chart;
use core::f64::consts::FRAC_1_PI;

/// What longitudinal vibration is made of: the square of the wave number times the length, and the stiffness.
#[derive(Clone, Copy, Debug)]
pub struct LongitudinalWaves<S> {
    /// `κ = (mλ² + k)l²/EA`, negative where waves travel.
    pub(crate) square: S,
    /// `EA/l`.
    pub(crate) stiffness: S,
}

impl<S: Scalar> LongitudinalWaves<S> {
    /// The usual size of a force per displacement: the stiffness, or that times the wave number.
    pub(crate) fn unit(&self) -> f64 {
        let zeta = self.square.sqrt().size().first();
        self.stiffness.size().first() * if zeta > 1.0 { zeta } else { 1.0 }
    }

    /// Enters the displacements of both ends into a chart, at their places.
    pub(super) fn enter(&self, chart: &mut Chart<S>, places: [usize; 2]) {
        self.form().enter(chart, places, [false; 2], &Factors::new(self.stiffness, S::one()));
    }

    /// The form of longitudinal vibration: over the displacement of the input end and the force at the other, divided by cosh √κ, or over
    /// both displacements, divided by sinh √κ / √κ.
    fn form(&self) -> Form<S, 2, 3> {
        let square = self.square;
        let waves = square.even_waves();
        let (cosh, sinhc) = (waves.cosh, waves.sinhc);
        let is_short = !S::Size::of(1.0).is_below(square.size()).any();
        let is_mixed = is_short || !(cosh * cosh).size().is_below((square * sinhc * sinhc).size()).any();
        let half_waves = |shift: f64| {
            let travelling = S::select(square.is_negative(), -square, S::zero());
            let number = travelling.sqrt().size() * S::Size::of(FRAC_1_PI) + S::Size::of(shift);
            number.whole().0
        };
        let divisor = if is_mixed { cosh } else { sinhc };
        let (inverse, exponent) = (S::one() / divisor, i64::from(waves.exponent));
        let one = -(waves.one * inverse);
        if is_mixed {
            let below = half_waves(0.5) + S::Size::of(-1.0);
            let sinhc = sinhc * inverse;
            let entries = [square * sinhc, one, -sinhc];
            return Form { entries, forces: [false, true], product: Scaled::new(divisor, exponent), below };
        }
        let coth = cosh * inverse;
        let product = Scaled::new(divisor / self.stiffness, exponent);
        Form { entries: [coth, one, coth], forces: [false; 2], product, below: half_waves(0.0) }
    }
}
