//! Strings, rods and shafts: the elements with waves of translation and rotation paths.
//!
//! They differ in their coordinate, in the names of their stiffness and inertia, and in whether they have a foundation.

use crate::element::{
    BackTransfer, CarriesLoad, Charted, Deflection, Element, Energies, Forms, Inside, MemberEnds, MemberGradient,
    MemberMotion, MemberNumbers, PlaneStep, TransferMatrix, along_member,
};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::line_forms::unit_of;
use crate::elements::shared::line_step::through_waves;
use crate::elements::shared::rod_motion::{Stretch, path_state};
use crate::elements::shared::uniform_line::{LineSection, LineWaves, UniformLine, axial_force_of_line};
use crate::model::{EndMotion, Ends, Extent, FrequencyEstimates, InvalidParameter, Rotation, State, Translation};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Coordinate;
use nalgebra::Matrix2;

/// The foundation of a line that has one.
macro_rules! foundation {
    ($element:ident $foundation:ident) => {
        $element.$foundation
    };
    ($element:ident) => {
        T::zero()
    };
}

/// Whether a line turns.
macro_rules! is_rotation {
    (Translation) => {
        false
    };
    (Rotation) => {
        true
    };
}

/// The motion of a line between its ends.
macro_rules! along {
    ($space:ident, $ends:expr) => {
        Stretch::of_path($ends, is_rotation!($space))
    };
}

/// The mass per length of a line; one that turns has no weight.
macro_rules! weight {
    (Translation) => {
        fn mass_per_length(built: &UniformLine<T>) -> S {
            S::from_parameter(built.section.inertia)
        }
    };
    (Rotation) => {};
}

/// What a load along a line between points does to it; a torque along a shaft between points is none.
macro_rules! under_load {
    (Translation) => {
        fn load_work(built: &UniformLine<T>, motion: &MemberEnds<S>) -> Option<[S; 2]> {
            Some([built.section.undamped_load_work(&Stretch::of(motion)), S::zero()])
        }

        fn motion_under_load(
            built: &UniformLine<T>,
            motion: &MemberEnds<S>,
            [load, _]: [S; 2],
            distance: f64,
        ) -> EndMotion<S> {
            let at = built.section.undamped_at_under(&Stretch::of(motion), load, T::from_f64(distance));
            EndMotion::at_rest().stretched(at)
        }
    };
    (Rotation) => {};
}

/// The freedom of a member in which a line moves: along it, or about z.
macro_rules! freedom {
    (Translation) => {
        0
    };
    (Rotation) => {
        2
    };
}

/// Declares lines by their space and coordinate, and their parameters with the estimates that they enter.
macro_rules! wave_lines {
    ($(
        $(#[$doc:meta])*
        $element:ident in $space:ident, $coordinate:ident {
            $(#[$length_doc:meta])*
            $length:ident;
            $(#[$stiffness_doc:meta])*
            $stiffness:ident: $stiffness_estimate:ident;
            $(#[$inertia_doc:meta])*
            $inertia:ident: $inertia_estimate:ident;
            $($(#[$foundation_doc:meta])* $foundation:ident;)?
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $element<T> {
            $(#[$length_doc])*
            pub $length: T,
            $(#[$stiffness_doc])*
            pub $stiffness: T,
            $(#[$inertia_doc])*
            pub $inertia: T,
            $($(#[$foundation_doc])* pub $foundation: T,)?
        }

        impl<T: Parameter> Element for $element<T> {
            type State = $space;
            type Built = UniformLine<T>;

            fn build(self) -> Result<UniformLine<T>, InvalidParameter> {
                let section = LineSection {
                    length: self.$length,
                    stiffness: self.$stiffness,
                    inertia: self.$inertia,
                    foundation: foundation!(self $($foundation)?),
                };
                section.build([stringify!($length), stringify!($stiffness), stringify!($inertia), stringify!($($foundation)?)])
            }

            axial_force_of_line!(UniformLine $stiffness of);

            fn estimate(built: &UniformLine<T>, estimates: &mut FrequencyEstimates) {
                built.estimate(estimates, [FrequencyEstimates::$stiffness_estimate, FrequencyEstimates::$inertia_estimate]);
            }

            fn extent(built: &UniformLine<T>) -> Extent {
                Extent::along(built.section.length.to_f64())
            }

            fn member_numbers(built: &UniformLine<T>) -> MemberNumbers {
                MemberNumbers::Line(freedom!($space), built.numbers())
            }
        }

        impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for $element<T> {
            fn transfer_matrix(built: &UniformLine<T>, x: S) -> Matrix2<S> {
                built.transfer_matrix(x, is_rotation!($space))
            }
        }

        impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = LineWaves<S>;

            #[inline(always)]
            fn coefficients(built: &UniformLine<T>, at: &FrequencyPowers<S>) -> LineWaves<S> {
                built.waves(at)
            }

            #[inline(always)]
            fn step<C: RootCounter<S>>(waves: &LineWaves<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                through_waves(waves, input, counter)
            }
        }

        /// A step is the transfer matrix itself, so that the factor of a line stays.
        impl<T: Real, S: Frequency<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = ();
            const SYMMETRIC: bool = true;

            fn reversed(built: &UniformLine<T>) -> UniformLine<T> {
                *built
            }

            fn back_coefficients(_built: &UniformLine<T>, _at: &FrequencyPowers<S>) {}

            fn back_transfer(_coefficients: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                covector
            }
        }

        impl<T: Real> CarriesLoad for $element<T> {}

        impl<T: Real, S: Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &UniformLine<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
                unit_of(Coordinate::$coordinate, built.longitudinal(at.lambda_squared).unit())
            }

            fn mass_form(built: &UniformLine<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                built.section.forms(&along!($space, first), &along!($space, second))[0]
            }

            fn stiffness_form(built: &UniformLine<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                built.section.forms(&along!($space, first), &along!($space, second))[1]
            }

            fn inside(built: &UniformLine<T>, x: S) -> Option<Inside> {
                Some(built.section.inside(x))
            }

            fn state_at(built: &UniformLine<T>, ends: &Ends<S>, distance: f64) -> State<S> {
                path_state(built.section.at(&along!($space, ends), T::from_f64(distance)), is_rotation!($space))
            }

            fn load_work(built: &UniformLine<T>, ends: &Ends<S>) -> Option<S> {
                Some(built.section.undamped_load_work(&along!($space, ends)))
            }

            weight!($space);

            fn gradient(built: &UniformLine<T>, ends: &Ends<S>) -> $element<S> {
                let [length, stiffness, inertia, _foundation] = built.section.gradient(&along!($space, ends));
                $element { $length: length, $stiffness: stiffness, $inertia: inertia, $($foundation: _foundation)? }
            }
        }

        impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for $element<T> {
            fn chart(built: &UniformLine<T>, at: &FrequencyPowers<S>, _distance: S) -> Chart<S> {
                built.chart(at, along_member::<Self>())
            }
        }

        impl<T: Real, S: Oscillation<T>> MemberMotion<S> for $element<T> {
            fn forms(built: &UniformLine<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                let [first, second] = [first, second].map(|motion| Stretch::in_freedom(motion, freedom!($space)));
                let [mass, stiffness] = built.section.forms(&first, &second);
                Forms { mass, stiffness, ..Forms::none() }
            }

            fn inside(built: &UniformLine<T>, x: S) -> Option<Inside> {
                Some(built.section.inside(x))
            }

            fn motion_at(built: &UniformLine<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
                let inside = built.section.at(&Stretch::in_freedom(motion, freedom!($space)), T::from_f64(distance));
                EndMotion::at_rest().in_freedom(freedom!($space), inside)
            }

            fn deflection(built: &UniformLine<T>, motion: &MemberEnds<S>) -> Option<Deflection<S>> {
                Some(built.section.deflection(&Stretch::in_freedom(motion, freedom!($space))))
            }

            under_load!($space);
            weight!($space);
        }

        impl<T: Real, S: Oscillation<T>> MemberGradient<S> for $element<T> {
            type Gradient = $element<S>;

            fn member_gradient(built: &UniformLine<T>, motion: &MemberEnds<S>) -> $element<S> {
                let [length, stiffness, inertia, _foundation] = built.section.gradient(&Stretch::in_freedom(motion, freedom!($space)));
                $element { $length: length, $stiffness: stiffness, $inertia: inertia, $($foundation: _foundation)? }
            }
        }

        #[cfg(test)]
        impl super::laws::Sample for $element<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                // short, so that the first frequency of the line with both ends held is above 2
                $element { $length: 0.2 * next(), $stiffness: next(), $inertia: next(), $($foundation: next())? }
            }

            fn halves(self) -> Option<Self> {
                Some($element { $length: self.$length / 2.0, ..self })
            }

            fn phase(&self, s: f64) -> f64 {
                self.build().map_or(0.0, |line| line.square(s.powi(4)).sqrt())
            }

            fn untied(self) -> Self {
                $element { $($foundation: 0.0,)? ..self }
            }
        }
    )*};
}

wave_lines! {
    /// Taut string on an elastic foundation, exact at every frequency: `H Y'' = (mλ² + k) Y` with the tension H.
    ///
    /// Transfer matrix on `[Y, Q]`, `Q = -H Y'`, with `φ² = -(mλ² + k) l²/H`:
    ///
    /// ```text
    /// cos φ            -(l/H) sin φ/φ
    /// (H/l) φ sin φ     cos φ
    /// ```
    ///
    /// Every entry is an entire function of φ². Below the cut-on frequency `√(k/m)`, φ is imaginary: waves decay.
    ///
    /// # Source
    /// The wave equation on a Winkler foundation, e.g. Graff, Wave Motion in Elastic Solids (1975), sections 1.1 and 1.6.
    TautString in Translation, Y {
        /// Length l \[m\], positive.
        length;
        /// Tension H \[N\], positive.
        tension: translational_stiffness;
        /// Mass per length m [kg/m], zero or positive.
        mass_per_length: mass;
        /// Stiffness k of the foundation per length [N/m²], zero or positive.
        foundation_stiffness;
    }

    /// Rod in longitudinal vibration, exact at every frequency: `EA Y'' = (mλ² + k) Y`. The path of its translation runs along it.
    ///
    /// Transfer matrix on `[Y, Q]`, `Q = -EA Y'`: that of a [`TautString`] with EA in place of its tension.
    ///
    /// # Source
    /// Longitudinal vibration as in [`InPlane`](crate::elements::InPlane), here with a foundation, as of a pile in soil.
    Rod in Translation, Y {
        /// Length l \[m\], positive.
        length;
        /// Axial stiffness EA \[N\], positive.
        axial_stiffness: translational_stiffness;
        /// Mass per length m [kg/m], zero or positive.
        mass_per_length: mass;
        /// Stiffness k of the foundation along the rod, per length [N/m²], zero or positive.
        foundation_stiffness;
    }

    /// Shaft in torsional vibration, exact at every frequency: `GJ Θ'' = ρI_p λ² Θ`.
    ///
    /// Transfer matrix on `[Θ, M]`, `M = GJ Θ'`, with `φ² = -ρI_p λ² l²/GJ`:
    ///
    /// ```text
    /// cos φ             (l/GJ) sin φ/φ
    /// -(GJ/l) φ sin φ    cos φ
    /// ```
    ///
    /// # Source
    /// Saint-Venant's torsion with the polar inertia of the section; the sign of M is that of eq. (4) of the paper.
    Shaft in Rotation, Theta {
        /// Length l \[m\], positive.
        length;
        /// Torsional stiffness GJ [N m²], positive.
        torsional_stiffness: torsional_stiffness;
        /// Polar inertia per length ρI_p [kg m], zero or positive.
        inertia_per_length: moment_of_inertia;
    }
}
