//! The chart of a general beam between two points.

use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::constants::{Constants, SectionAt};
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::Transfer;
use crate::elements::in_plane::across::freedoms_of_beam;
use crate::elements::shared::bending_chart::{Impedances, units_of_waves};
use crate::elements::shared::chart_form::Factors;
use crate::elements::shared::compound::Units;
use crate::elements::shared::relation::{Compound, Relation};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar};
use crate::structure::Chart;

impl<S: Scalar> BeamParameters<S> {
    /// The relation of both ends at λ², and the factors of its entries, from the parameters alone.
    pub(crate) fn relation(&self, lambda_squared: S) -> (Relation<S>, Factors<S>) {
        let units = Units::new(self.bending_stiffness, S::one() / self.length);
        self.relation_of(Constants::of(*self).at(lambda_squared), units)
    }

    /// The same with a moment against rotations, in the units of g.
    pub(super) fn relation_with_moment(&self, lambda_squared: S, moment: S) -> (Relation<S>, Factors<S>) {
        let units = Units::new(self.bending_stiffness, S::one() / self.length);
        self.relation_of(Constants::of(*self).with_moment(moment).at(lambda_squared), units)
    }

    fn relation_of(&self, section: SectionAt<S>, units: Units<S>) -> (Relation<S>, Factors<S>) {
        let BeamParameters { length, bending_stiffness, .. } = *self;
        let waves = section.waves.in_form();
        let compound = GeneralCompound::of_products(section, waves.products(), units);
        let transfer = Transfer::of_functions(&section, waves.functions());
        let exponent = compound.exponent;
        let minors = [0, 1, 2, 3, 4].map(|row| compound.row(row));
        let of_ends = Compound { minors, states: transfer.over_power(exponent), exponent };
        (
            Relation::new(of_ends, &units, compound.clamped_count()),
            Factors::new(bending_stiffness / (length * length * length), length),
        )
    }
}

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// The relation of both ends at a frequency, of a beam of a length, and the factors of its entries.
    pub(crate) fn relation<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S) -> (Relation<S>, Factors<S>) {
        let beam = BeamParameters { length, ..self.parameters_in() };
        if S::IS_EXTENDED {
            return beam.relation(at.lambda_squared);
        }
        beam.relation_of(self.at(at.lambda_squared), self.units())
    }

    /// A chart without entries, beside a motion along the beam where that has an impedance, and the places of bending in it.
    pub(super) fn empty_chart<S: Frequency<T>>(&self, lambda_squared: S, along: Option<f64>) -> (Chart<S>, [usize; 4]) {
        let impedances = self.impedances(lambda_squared, along.unwrap_or(f64::INFINITY));
        let (freedoms, places) = freedoms_of_beam(along.is_some());
        (Chart::empty(freedoms, units_of_waves(&impedances, lambda_squared)), places)
    }

    /// The impedances by which the units of a chart are found.
    fn impedances<S: Frequency<T>>(&self, lambda_squared: S, axial: f64) -> Impedances {
        let BeamParameters { length, bending_stiffness, mass_per_length, shear_flexibility, rotary_inertia, .. } =
            self.parameters;
        let [l, ei, m, f, r] =
            [length, bending_stiffness, mass_per_length, shear_flexibility, rotary_inertia].map(T::to_f64);
        let wave = self.at(lambda_squared).waves.largest_size().max(1.0) / l;
        let bending = ei * wave * wave * wave;
        let shear = if f > 0.0 { wave / f } else { f64::INFINITY };
        Impedances {
            wave,
            translation: bending.min(shear).min(axial),
            rotation: ei * wave,
            mass: m * l,
            inertia: m * l * l * l + r * l,
        }
    }
}
