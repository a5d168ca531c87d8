//! The chart of a tapered beam between two points of a line.

use crate::element::Charted;
use crate::elements::in_plane::across::freedoms_of_beam;
use crate::elements::shared::bending_chart::{Impedances, units_of_waves};
use crate::elements::shared::chart_form::Factors;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::compound::Units;
use crate::elements::shared::relation::{Compound, Relation};
use crate::elements::tapered_beam::walk::Tapered;
use crate::elements::tapered_beam::{BuiltTaperedBeam, TaperedBeam};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar};
use crate::structure::Chart;
use crate::subspace::{Connecting, Plane, Subspace, WittrickWilliams};
use mstmm_plan::{Space, Support};

impl<S: Scalar> Tapered<S> {
    /// The minors behind the beam by those before it, and the states by the states, in units of the length and of EI at the input end, all over
    /// a power of two.
    fn compound(&self, units: &Units<S>) -> Compound<S> {
        let one = S::one();
        let (length, stiffness) = (self.profile.length, self.profile.stiffness);
        let [first, second, third, fourth] = units.factors;
        let of_minors = [one, first, second, third, fourth];
        let planes = [0, 1, 2, 3, 4].map(|column: usize| {
            let mut minors = [S::zero(); 5];
            minors[column] = of_minors[column];
            self.plane(Plane::unscaled(minors, 0), 0.0, 1.0)
        });
        let flexible = stiffness / (length * length);
        let of_states = [length, one, flexible * length, flexible];
        let states = [0, 1, 2, 3].map(|column: usize| {
            let mut entries = [S::zero(); 4];
            entries[column] = of_states[column];
            self.state(entries, 0.0, 1.0)
        });
        let exponent = planes.iter().map(|plane| plane.exponent).max().unwrap_or(0);
        let mut compound = Compound { minors: [[S::zero(); 5]; 5], states: [[S::zero(); 4]; 4], exponent };
        for (column, plane) in planes.iter().enumerate() {
            let Plane { y_theta, y_m, w, theta_q, m_q, exponent: own } = *plane;
            for (row, minor) in [y_theta, y_m, w, theta_q, m_q].into_iter().enumerate() {
                compound.minors[row][column] =
                    (minor / of_minors[row]).times_power_of_two(own.saturating_sub(exponent));
            }
        }
        for (column, (entries, own)) in states.into_iter().enumerate() {
            for (row, entry) in entries.into_iter().enumerate() {
                compound.states[row][column] =
                    (entry / of_states[row]).times_power_of_two(own.saturating_sub(exponent));
            }
        }
        compound
    }

    /// The number of its natural frequencies below with both ends held.
    fn held(&self) -> S::Size {
        let mut counter = WittrickWilliams::default();
        let plane = self.through(Subspace::Tip(Support::Fixed, Space::Bending).plane(), &mut counter);
        Subspace::Plane(plane).at_root(Support::Fixed, &mut counter);
        counter.count()
    }

    /// Enters the beam into its chart, at the places of deflections and rotations of both ends.
    pub(crate) fn enter(&self, chart: &mut Chart<S>, places: [usize; 4]) {
        let (length, stiffness) = (self.profile.length, self.profile.stiffness);
        let units = Units::new(stiffness, S::one() / length);
        let relation = Relation::new(self.compound(&units), &units, self.held());
        relation.enter(chart, places, &Factors::new(stiffness / (length * length * length), length));
    }

    /// The impedances by which the units of a chart are found, of the softer end.
    fn impedances(&self) -> Impedances {
        let sizes = &self.sizes;
        let [input, output] = [0.0, 1.0].map(|share| [sizes.stiffness_at(share), sizes.mass_at(share)]);
        let ei = input[0].min(output[0]);
        let [mass, length] = [input[1].max(output[1]), sizes.length];
        let wave = (sizes.phase() / length).max(1.0 / length);
        Impedances {
            wave,
            translation: ei * wave * wave * wave,
            rotation: ei * wave,
            mass: mass * length,
            inertia: mass * length * length * length,
        }
    }
}

impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for TaperedBeam<T> {
    fn chart(built: &BuiltTaperedBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let beam = built.of_length(at.lambda_squared, length);
        let (freedoms, places) = freedoms_of_beam(false);
        let mut chart = Chart::empty(freedoms, units_of_waves(&beam.impedances(), at.lambda_squared));
        S::enter_tapered(&beam, &mut chart, places);
        chart
    }
}
