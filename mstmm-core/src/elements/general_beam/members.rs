//! General beams between points: along a line, and in the plane, where they stretch as well.

use crate::element::{
    CarriesLoad, Charted, Element, Forms, Inside, MatrixOf, MemberEnds, MemberGradient, MemberMotion, MemberNumbers,
    MemberWork, TransferMatrix,
};
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::kinds::{BeamColumn, FoundationBeam, GeneralBeam, RayleighBeam, TimoshenkoBeam};
use crate::elements::general_beam::of_built::member_motion_of_built;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::shared::bending_chart::units_of_waves;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::elements::shared::planar_matrix::planar_matrix;
use crate::elements::shared::rod_motion::Stretch;
use crate::elements::shared::section_gradient::SectionGradient;
use crate::elements::shared::uniform_line::{LineSection, UniformLine};
use crate::model::{EndMotion, Extent, FrequencyEstimates, InvalidParameter, Planar};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// A general beam that stretches, with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltPlanarGeneralBeam<T> {
    bending: BuiltGeneralBeam<T>,
    pub(super) rod: UniformLine<T>,
}

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// The chart of bending, at its places among the freedoms of a member, beside an axial impedance.
    fn chart<S: Frequency<T> + ChartScalar>(
        &self,
        at: &FrequencyPowers<S>,
        length: S,
        (freedoms, places): (Freedoms, [usize; 4]),
        axial: f64,
    ) -> Chart<S> {
        let units = units_of_waves(&self.impedances(at.lambda_squared, axial), at.lambda_squared);
        let mut chart = Chart::empty(freedoms, units);
        let (relation, factors) = self.relation(at, length);
        relation.enter(&mut chart, places, &factors);
        chart
    }
}

impl<T: Real> BuiltGeneralBeam<T> {
    fn motion_at<S: Oscillation<T>>(&self, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        EndMotion::bent(self.motion(motion.x).state_at(&motion.bending(), T::from_f64(distance)))
    }

    fn work_gradient<S: Oscillation<T>>(&self, work: &MemberWork<S>) -> BeamParameters<S> {
        self.motion(work.x).gradient(&MemberEnds { x: work.x, ends: work.ends }.bending())
    }
}

impl<T: Parameter> BuiltPlanarGeneralBeam<T> {
    pub(super) fn new(bending: BuiltGeneralBeam<T>, axial_stiffness: T) -> Result<Self, InvalidParameter> {
        let BeamParameters { length, mass_per_length, .. } = bending.parameters;
        let foundation = T::zero();
        let section = LineSection { length, stiffness: axial_stiffness, inertia: mass_per_length, foundation };
        let rod = section.build(["length", "axial_stiffness", "mass_per_length", "foundation_stiffness"])?;
        Ok(BuiltPlanarGeneralBeam { bending, rod })
    }

    fn estimate(&self, estimates: &mut FrequencyEstimates) {
        self.bending.estimate(estimates);
        estimates.translational_stiffness((self.rod.section.stiffness / self.rod.section.length).to_f64());
    }

    /// The longitudinal waves, in extended precision from the parameters and the length.
    fn longitudinal<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S) -> LongitudinalWaves<S> {
        if S::IS_EXTENDED {
            return LongitudinalWaves::exact(at, [self.rod.section.stiffness, self.rod.section.inertia], length);
        }
        self.rod.longitudinal(at.lambda_squared)
    }

    /// The chart of a beam in the plane.
    fn chart<S: Frequency<T> + ChartScalar>(&self, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let longitudinal = self.longitudinal(at, length);
        let mut chart = self.bending.chart(at, length, (Freedoms::ALL, [1, 2, 4, 5]), longitudinal.unit());
        S::enter_longitudinal(&longitudinal, &mut chart, [0, 3]);
        chart
    }
}

/// Implements what a beam is between two points of a line.
macro_rules! along_line {
    ($($kind:ident),*) => {$(
        impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for $kind<T> {
            fn chart(built: &BuiltGeneralBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                built.chart(at, length, (Freedoms::Y.union(Freedoms::RZ), [0, 1, 2, 3]), f64::INFINITY)
            }
        }

        member_motion_of_built!($kind at Oscillation);

        impl<T: Real, S: Oscillation<T>> MemberGradient<S> for $kind<T> {
            type Gradient = $kind<S>;

            fn member_gradient(built: &BuiltGeneralBeam<T>, work: &MemberWork<S>) -> $kind<S> {
                $kind::of_gradient(built.work_gradient(work), &built.parameters)
            }
        }
    )*};
}
along_line!(RayleighBeam, TimoshenkoBeam, BeamColumn, FoundationBeam, GeneralBeam);

/// Declares beams of the plane by what they are in bending and by the parameters beside length, stiffnesses and mass.
macro_rules! in_plane {
    ($($(#[$doc:meta])* $planar:ident of $kind:ident { $($(#[$field_doc:meta])* $field:ident,)* })*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $planar<T> {
            /// Length l \[m\], positive.
            pub length: T,
            /// Axial stiffness EA \[N\], positive.
            pub axial_stiffness: T,
            /// Bending stiffness EI [N m²], positive.
            pub bending_stiffness: T,
            /// Mass per length m [kg/m], positive.
            pub mass_per_length: T,
            $($(#[$field_doc])* pub $field: T,)*
        }

        impl<T> $planar<T> {
            fn in_bending(self) -> $kind<T> {
                let $planar { length, bending_stiffness, mass_per_length, $($field,)* .. } = self;
                $kind { length, bending_stiffness, mass_per_length, $($field),* }
            }
        }

        impl<T: Parameter> Element for $planar<T> {
            type State = Planar;
            type Built = BuiltPlanarGeneralBeam<T>;
            const MAY_BUCKLE: bool = $kind::<T>::MAY_BUCKLE;

            fn build(self) -> Result<BuiltPlanarGeneralBeam<T>, InvalidParameter> {
                BuiltPlanarGeneralBeam::new(self.in_bending().build()?, self.axial_stiffness)
            }

            fn estimate(built: &BuiltPlanarGeneralBeam<T>, estimates: &mut FrequencyEstimates) {
                built.estimate(estimates);
            }

            fn extent(built: &BuiltPlanarGeneralBeam<T>) -> Extent {
                built.bending.extent()
            }

            fn member_numbers(built: &BuiltPlanarGeneralBeam<T>) -> MemberNumbers {
                MemberNumbers::Beam(built.bending.numbers(built.rod.section.stiffness))
            }
        }

        impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for $planar<T> {
            fn transfer_matrix(built: &BuiltPlanarGeneralBeam<T>, x: S) -> MatrixOf<Self, S> {
                planar_matrix(&built.bending.transfer_matrix(x), &built.rod.transfer_matrix(x, false))
            }
        }

        impl<T: Parameter, S: Frequency<T> + ChartScalar> Charted<S> for $planar<T> {
            fn chart(built: &BuiltPlanarGeneralBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
                built.chart(at, length)
            }
        }

        impl<T: Real> CarriesLoad for $planar<T> {}

        impl<T: Real, S: Oscillation<T>> MemberMotion<S> for $planar<T> {
            fn forms(built: &BuiltPlanarGeneralBeam<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                let [mass, stiffness] = built.rod.section.forms(&Stretch::of(first), &Stretch::of(second));
                built.bending.forms(&first.bending(), &second.bending()).plus(Forms { mass, stiffness, ..Forms::none() })
            }

            fn inside(built: &BuiltPlanarGeneralBeam<T>, x: S) -> Option<Inside> {
                let (bending, rod) = (built.bending.motion(x).interior(), built.rod.section.inside(x));
                Some(Inside { wave_number: bending.wave_number.max(rod.wave_number), ..bending })
            }

            fn motion_at(built: &BuiltPlanarGeneralBeam<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
                let stretch = built.rod.section.at(&Stretch::of(motion), T::from_f64(distance));
                built.bending.motion_at(motion, distance).stretched(stretch)
            }

            fn load_work(built: &BuiltPlanarGeneralBeam<T>, motion: &MemberEnds<S>) -> Option<[S; 2]> {
                let along = built.rod.section.load_work(&Stretch::of(motion));
                Some([along, built.bending.motion(motion.x).load_work(&motion.bending())])
            }

            fn mass_per_length(built: &BuiltPlanarGeneralBeam<T>) -> S {
                S::from_parameter(built.bending.mass_per_length())
            }

            fn motion_under_load(
                built: &BuiltPlanarGeneralBeam<T>,
                motion: &MemberEnds<S>,
                [along, across]: [S; 2],
                distance: f64,
            ) -> EndMotion<S> {
                let distance = T::from_f64(distance);
                let stretch = built.rod.section.at_under(&Stretch::of(motion), along, distance);
                EndMotion::bent(built.bending.motion(motion.x).state_under(&motion.bending(), across, distance)).stretched(stretch)
            }
        }

        impl<T: Real, S: Oscillation<T>> MemberGradient<S> for $planar<T> {
            type Gradient = $planar<S>;

            fn member_gradient(built: &BuiltPlanarGeneralBeam<T>, work: &MemberWork<S>) -> $planar<S> {
                let bending = $kind::of_gradient(built.bending.work_gradient(work), &built.bending.parameters);
                let rod = SectionGradient::of_rod(work, [built.rod.section.stiffness, built.rod.section.inertia]);
                $planar {
                    length: bending.length + rod.length,
                    axial_stiffness: rod.stiffness,
                    bending_stiffness: bending.bending_stiffness,
                    mass_per_length: bending.mass_per_length + rod.mass,
                    $($field: bending.$field),*
                }
            }
        }

        #[cfg(test)]
        impl crate::elements::laws::Sample for $planar<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                let axial_stiffness = next();
                let $kind { length, bending_stiffness, mass_per_length, $($field),* } = $kind::sample(next);
                $planar { length, axial_stiffness, bending_stiffness, mass_per_length, $($field),* }
            }

            fn length(&self) -> f64 {
                self.length
            }

            fn halves(self) -> Option<Self> {
                Some($planar { length: self.length / 2.0, ..self })
            }

            fn phase(&self, s: f64) -> f64 {
                self.in_bending().phase(s)
            }

            fn untied(self) -> Self {
                let $kind { length, bending_stiffness, mass_per_length, $($field),* } = self.in_bending().untied();
                $planar { length, bending_stiffness, mass_per_length, $($field,)* ..self }
            }
        }
    )*};
}

in_plane! {
    /// [`RayleighBeam`] between two points of the plane, with exact longitudinal vibration.
    ///
    /// # Source
    /// That of the beam; along it `EA X'' = mλ² X`, as in [`PlanarBeam`](crate::elements::PlanarBeam).
    PlanarRayleighBeam of RayleighBeam {
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
    }

    /// [`TimoshenkoBeam`] between two points of the plane, with exact longitudinal vibration.
    ///
    /// # Source
    /// That of the beam; along it `EA X'' = mλ² X`, as in [`PlanarBeam`](crate::elements::PlanarBeam).
    PlanarTimoshenkoBeam of TimoshenkoBeam {
        /// Shear stiffness `k G A` \[N\], positive, with a finite reciprocal.
        shear_stiffness,
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
    }

    /// [`BeamColumn`] between two points of the plane, with exact longitudinal vibration about the state under its axial force.
    ///
    /// # Source
    /// That of the beam; along it `EA X'' = mλ² X`, as in [`PlanarBeam`](crate::elements::PlanarBeam).
    PlanarBeamColumn of BeamColumn {
        /// Axial force N \[N\], positive in tension.
        axial_force,
    }

    /// [`FoundationBeam`] between two points of the plane, with exact longitudinal vibration; the foundation acts across it.
    ///
    /// # Source
    /// That of the beam; along it `EA X'' = mλ² X`, as in [`PlanarBeam`](crate::elements::PlanarBeam).
    PlanarFoundationBeam of FoundationBeam {
        /// Stiffness k of the foundation per length [N/m²], zero or positive.
        foundation_stiffness,
        /// Stiffness G of the shear layer \[N\], zero or positive.
        foundation_shear_stiffness,
    }

    /// [`GeneralBeam`] between two points of the plane, with exact longitudinal vibration; the foundation acts across it.
    ///
    /// # Source
    /// That of the beam; along it `EA X'' = mλ² X`, as in [`PlanarBeam`](crate::elements::PlanarBeam).
    PlanarGeneralBeam of GeneralBeam {
        /// Shear stiffness `k G A` \[N\], positive, with a finite reciprocal; infinite is a beam without shear.
        shear_stiffness,
        /// Rotary inertia per length `r = ρ I` [kg m], zero or positive.
        rotary_inertia,
        /// Axial force N \[N\], positive in tension; greater than `-kGA - G`.
        axial_force,
        /// Stiffness k of the foundation per length [N/m²], zero or positive.
        foundation_stiffness,
        /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
        foundation_shear_stiffness,
    }
}
