//! The chart of a beam that bends only.

use crate::element::Charted;
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::shared::bending_chart::{BendingWaves, beam_units};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::number::{Frequency, FrequencyPowers, Parameter};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for Beam<T> {
    fn chart(built: &BuiltBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let Beam { length: own, bending_stiffness, mass_per_length } = built.parameters;
        let waves = if S::IS_EXTENDED {
            BendingWaves::exact(at, [bending_stiffness, mass_per_length], length)
        } else {
            let stiffness = S::from_parameter(bending_stiffness) / (length * length * length);
            let (z, z_fourth) = (at.powers[0] * built.wave, -at.lambda_squared * built.wave_fourth);
            BendingWaves { z_fourth, z, stiffness, length }
        };
        let measures = [own, bending_stiffness, mass_per_length];
        let units = beam_units(&waves, measures, f64::INFINITY, at.lambda_squared);
        let mut chart = Chart::empty(Freedoms::Y.union(Freedoms::RZ), units);
        S::enter_bending(&waves, &mut chart, [0, 1, 2, 3]);
        chart
    }
}
