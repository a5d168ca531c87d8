//! General beams between points: along a line, and what they are across themselves in the plane.

use crate::element::{Charted, Deflection, Forms, Inside, MemberEnds, MemberGradient, MemberMotion};
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::kinds::{BeamColumn, FoundationBeam, GeneralBeam, RayleighBeam, TimoshenkoBeam};
use crate::elements::general_beam::of_built::members_of_built;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::in_plane::across::{Across, AlongGradient, ChartedAcross, Stretching, line_along};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::uniform_line::UniformLine;
use crate::model::{EndMotion, InvalidParameter};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar};
use crate::structure::Chart;

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// The chart of bending, beside a motion along the beam where that has an impedance.
    fn chart<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
        let (mut chart, places) = self.empty_chart(at.lambda_squared, along);
        let (relation, factors) = self.relation(at, length);
        relation.enter(&mut chart, places, &factors);
        chart
    }

    /// The line of an axial stiffness along the beam.
    pub(super) fn line_along(&self, axial_stiffness: T) -> Result<UniformLine<T>, InvalidParameter> {
        let BeamParameters { length, mass_per_length, .. } = self.parameters;
        line_along([length, axial_stiffness, mass_per_length])
    }
}

/// Implements what a beam without damping is between two points.
macro_rules! members {
    ($($kind:ident),*) => {$(
        members_of_built!($kind at Frequency);

        impl<T: Real, S: Oscillation<T>> MemberGradient<S> for $kind<T> {
            type Gradient = $kind<S>;

            fn member_gradient(built: &BuiltGeneralBeam<T>, motion: &MemberEnds<S>) -> $kind<S> {
                let ends = motion.bending();
                $kind::of_gradient(built.motion(motion.x).gradient(&ends), &built.parameters)
            }
        }

        impl<S: Scalar> Across for $kind<S> {
            type Number = S;

            fn of_length(self, length: S) -> Self {
                $kind { length, ..self }
            }

            fn and_along(mut self, along: AlongGradient<S>) -> Self {
                self.length += along.length;
                self.mass_per_length += along.mass;
                self
            }
        }

        impl<T: Parameter> Stretching for $kind<T> {
            type Line = UniformLine<T>;

            fn line(built: &BuiltGeneralBeam<T>, axial_stiffness: T) -> Result<UniformLine<T>, InvalidParameter> {
                built.line_along(axial_stiffness)
            }
        }
    )*};
}
members!(RayleighBeam, TimoshenkoBeam, BeamColumn, FoundationBeam, GeneralBeam);
