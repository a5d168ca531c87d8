//! The chart of a beam in planar motion: that of its bending and that of its longitudinal vibration.

use crate::element::Charted;
use crate::elements::planar_beam::{BuiltPlanarBeam, PlanarBeam};
use crate::elements::shared::bending_chart::{BendingWaves, beam_units};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::number::{Frequency, FrequencyPowers, Parameter};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// Places of the variables of bending and of longitudinal vibration among those of the member.
const BENDING: [usize; 4] = [1, 2, 4, 5];
const LONGITUDINAL: [usize; 2] = [0, 3];

impl<T: Parameter> BuiltPlanarBeam<T> {
    /// The waves at a frequency; in extended precision computed from the parameters anew, since `build` has rounded.
    fn waves<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S) -> (BendingWaves<S>, LongitudinalWaves<S>) {
        let PlanarBeam { axial_stiffness, bending_stiffness, mass_per_length, .. } = self.parameters;
        if !S::IS_EXTENDED {
            let bending = BendingWaves {
                z_fourth: -at.lambda_squared * self.wave_fourth,
                z: at.powers[0] * self.wave,
                stiffness: S::from_parameter(self.bending),
                length,
            };
            let longitudinal = LongitudinalWaves {
                square: at.lambda_squared * self.axial_wave_squared,
                stiffness: S::from_parameter(self.longitudinal),
            };
            return (bending, longitudinal);
        }
        let bending = BendingWaves::exact(at, [bending_stiffness, mass_per_length], length);
        let longitudinal = LongitudinalWaves::exact(at, [axial_stiffness, mass_per_length], length);
        (bending, longitudinal)
    }
}

impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for PlanarBeam<T> {
    fn chart(built: &BuiltPlanarBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let (bending, longitudinal) = built.waves(at, length);
        let PlanarBeam { length, bending_stiffness, mass_per_length, .. } = built.parameters;
        let measures = [length, bending_stiffness, mass_per_length];
        let units = beam_units(&bending, measures, longitudinal.unit(), at.lambda_squared);
        let mut chart = Chart::empty(Freedoms::ALL, units);
        S::enter_bending(&bending, &mut chart, BENDING);
        S::enter_longitudinal(&longitudinal, &mut chart, LONGITUDINAL);
        chart
    }
}
