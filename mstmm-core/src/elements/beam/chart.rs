//! The chart of a beam, and the line along it in the plane.

use crate::element::Charted;
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::in_plane::across::{
    Across, AlongGradient, ChartedAcross, Stretching, freedoms_of_beam, line_along,
};
use crate::elements::shared::bending_chart::{BendingWaves, beam_units};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::uniform_line::UniformLine;
use crate::model::InvalidParameter;
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar};
use crate::structure::Chart;

impl<T: Parameter, S: Frequency<T> + ChartScalar> ChartedAcross<S> for Beam<T> {
    fn chart_across(built: &BuiltBeam<T>, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
        let Beam { length: own, bending_stiffness, mass_per_length } = built.parameters;
        let waves = if S::IS_EXTENDED {
            BendingWaves::exact(at, [bending_stiffness, mass_per_length], length)
        } else {
            let stiffness = S::from_parameter(bending_stiffness) / (length * length * length);
            let (z, z_fourth) = (built.z(at), built.z_fourth(at));
            BendingWaves { z_fourth, z, stiffness, length }
        };
        let measures = [own, bending_stiffness, mass_per_length];
        let units = beam_units(&waves, measures, along.unwrap_or(f64::INFINITY), at.lambda_squared);
        let (freedoms, places) = freedoms_of_beam(along.is_some());
        let mut chart = Chart::empty(freedoms, units);
        S::enter_bending(&waves, &mut chart, places);
        chart
    }
}

impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for Beam<T> {
    fn chart(built: &BuiltBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        Self::chart_across(built, at, length, None)
    }
}

impl<S: Scalar> Across for Beam<S> {
    type Number = S;

    fn of_length(self, length: S) -> Self {
        Beam { length, ..self }
    }

    fn and_along(mut self, along: AlongGradient<S>) -> Self {
        self.length += along.length;
        self.mass_per_length += along.mass;
        self
    }
}

impl<T: Parameter> Stretching for Beam<T> {
    type Line = UniformLine<T>;

    fn line(built: &BuiltBeam<T>, axial_stiffness: T) -> Result<UniformLine<T>, InvalidParameter> {
        let Beam { length, mass_per_length, .. } = built.parameters;
        line_along([length, axial_stiffness, mass_per_length])
    }
}
