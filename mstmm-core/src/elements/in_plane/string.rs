//! Strings in the plane: they move across themselves as lines, and stretch as well.

use crate::elements::in_plane::across::{Across, AlongGradient, ChartedAcross, Stretching, line_along};
use crate::elements::in_plane::along::AlongWaves;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::dissipation::Dissipation;
use crate::elements::shared::uniform_line::{LineSection, UniformLine};
use crate::elements::{DampedString, TautString};
use crate::model::InvalidParameter;
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Parameter, Scalar, binary_exponent};
use crate::structure::{Chart, Units, unit_of};
use mstmm_plan::Freedoms;

/// The chart of a line across itself, beside a motion along it where that has an impedance.
fn chart<S: ChartScalar>(
    line: &impl AlongWaves<S>,
    at: &FrequencyPowers<S>,
    length: S,
    along: Option<f64>,
) -> Chart<S> {
    let waves = line.longitudinal(at, length);
    let unit = unit_of(binary_exponent(waves.unit().min(along.unwrap_or(f64::INFINITY))));
    let (freedoms, places) =
        if along.is_some() { (Freedoms::X.union(Freedoms::Y), [1, 3]) } else { (Freedoms::Y, [0, 1]) };
    let mut chart = Chart::empty(freedoms, Units { displacement: unit, rotation: unit });
    S::enter_longitudinal(&waves, &mut chart, places);
    chart
}

/// The line along a string.
fn line<T: Parameter>(across: &UniformLine<T>, axial_stiffness: T) -> Result<UniformLine<T>, InvalidParameter> {
    let LineSection { length, inertia, .. } = across.section;
    line_along([length, axial_stiffness, inertia])
}

impl<S: Scalar> Across for TautString<S> {
    type Number = S;

    fn of_length(self, length: S) -> Self {
        TautString { length, ..self }
    }

    fn and_along(mut self, along: AlongGradient<S>) -> Self {
        self.length += along.length;
        self.mass_per_length += along.mass;
        self
    }
}

impl<T: Parameter> Stretching for TautString<T> {
    type Line = UniformLine<T>;
    const IS_STRING: bool = true;

    fn line(built: &UniformLine<T>, axial_stiffness: T) -> Result<UniformLine<T>, InvalidParameter> {
        line(built, axial_stiffness)
    }
}

impl<T: Parameter, S: Frequency<T> + ChartScalar> ChartedAcross<S> for TautString<T> {
    fn chart_across(built: &UniformLine<T>, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
        chart(built, at, length, along)
    }
}

impl<S: Scalar> Across for DampedString<S> {
    type Number = S;

    fn of_length(self, length: S) -> Self {
        DampedString { length, ..self }
    }

    fn and_along(mut self, along: AlongGradient<S>) -> Self {
        let [_, _, external] = along.damping;
        self.length += along.length;
        self.mass_per_length += along.mass;
        self.external_damping += external;
        self
    }
}

/// The medium around it resists both displacements; neither its tension nor its axial stiffness has a loss.
impl<T: Parameter> Stretching for DampedString<T> {
    type Line = DampedLine<T>;
    const IS_STRING: bool = true;

    fn line(built: &DampedLine<T>, axial_stiffness: T) -> Result<DampedLine<T>, InvalidParameter> {
        let dissipation = Dissipation { loss_factor: T::zero(), time: T::zero(), ..built.dissipation };
        Ok(DampedLine { line: line(&built.line, axial_stiffness)?, dissipation })
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + ChartScalar> ChartedAcross<S> for DampedString<T> {
    fn chart_across(built: &DampedLine<T>, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
        chart(built, at, length, along)
    }
}
