//! Strings, rods and shafts with damping.
//!
//! They differ in their coordinate, in the names of their stiffness and inertia, and in which of foundation and loss they have.

use crate::element::{
    BackTransfer, CarriesLoad, Charted, Element, Energies, Forms, Inside, MemberEnds, MemberGradient, MemberMotion,
    MemberNumbers, PlaneStep, TransferMatrix, along_member,
};
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::dissipation::Dissipation;
use crate::elements::shared::line_forms::unit_of;
use crate::elements::shared::line_step::through_waves;
use crate::elements::shared::rod_motion::{Stretch, path_state};
use crate::elements::shared::uniform_line::{LineSection, LineWaves, axial_force_of_line, line_chart};
use crate::model::{
    EndMotion, Ends, Extent, FrequencyEstimates, InvalidParameter, Rotation, State, StateSpace, Translation,
};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Space};
use nalgebra::Matrix2;

/// A parameter of a line, or zero where it has none of that name.
macro_rules! or_zero {
    ($element:ident $field:ident) => {
        $element.$field
    };
    ($element:ident) => {
        T::zero()
    };
}

/// Declares lines by their space and coordinate, and their parameters with the estimates that they enter.
macro_rules! damped_wave_lines {
    ($(
        $(#[$doc:meta])*
        $element:ident in $space:ident, $coordinate:ident {
            $(#[$stiffness_doc:meta])*
            $stiffness:ident: $stiffness_estimate:ident;
            $(#[$inertia_doc:meta])*
            $inertia:ident: $inertia_estimate:ident;
            foundation { $($(#[$foundation_doc:meta])* $foundation:ident;)? }
            loss { $($(#[$loss_doc:meta])* $loss:ident; $(#[$time_doc:meta])* $time:ident;)? }
        }
    )*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $element<T> {
            /// Length l \[m\], positive.
            pub length: T,
            $(#[$stiffness_doc])*
            pub $stiffness: T,
            $(#[$inertia_doc])*
            pub $inertia: T,
            $($(#[$foundation_doc])* pub $foundation: T,)?
            $($(#[$loss_doc])* pub $loss: T, $(#[$time_doc])* pub $time: T,)?
            /// Damping c_e per length against its displacement, zero or positive.
            pub external_damping: T,
        }

        impl<T: Parameter> Element for $element<T> {
            type State = $space;
            type Built = DampedLine<T>;
            const IS_STRAIGHT: bool = false;

            fn build(self) -> Result<DampedLine<T>, InvalidParameter> {
                let section = LineSection {
                    length: self.length,
                    stiffness: self.$stiffness,
                    inertia: self.$inertia,
                    foundation: or_zero!(self $($foundation)?),
                };
                let names = ["length", stringify!($stiffness), stringify!($inertia), stringify!($($foundation)?)];
                let dissipation = Dissipation {
                    loss_factor: or_zero!(self $($loss)?),
                    time: or_zero!(self $($time)?),
                    external: self.external_damping,
                };
                dissipation.check()?;
                Ok(DampedLine { line: section.build(names)?, dissipation })
            }

            axial_force_of_line!(DampedLine $stiffness of line);

            fn estimate(built: &DampedLine<T>, estimates: &mut FrequencyEstimates) {
                built.estimate(estimates, [FrequencyEstimates::$stiffness_estimate, FrequencyEstimates::$inertia_estimate]);
            }

            fn extent(built: &DampedLine<T>) -> Extent {
                Extent::along(built.line.section.length.to_f64())
            }

            fn member_numbers(built: &DampedLine<T>) -> MemberNumbers {
                MemberNumbers::Line(freedom::<Self>(), built.line.numbers()).damped(built.dissipation.numbers())
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for $element<T> {
            fn transfer_matrix(built: &DampedLine<T>, x: S) -> Matrix2<S> {
                built.waves(&FrequencyPowers::new(x, false)).transfer_matrix(is_rotation::<Self>())
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T>> PlaneStep<S> for $element<T> {
            type Coefficients = LineWaves<S>;

            fn coefficients(built: &DampedLine<T>, at: &FrequencyPowers<S>) -> LineWaves<S> {
                built.waves(at)
            }

            fn step<C: RootCounter<S>>(waves: &LineWaves<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
                through_waves(waves, input, counter)
            }
        }

        /// A step is the transfer matrix itself, so that the factor of a line stays.
        impl<T: Real, S: ComplexFrequency<T>> BackTransfer<S> for $element<T> {
            type BackCoefficients = ();
            const SYMMETRIC: bool = true;

            fn reversed(built: &DampedLine<T>) -> DampedLine<T> {
                *built
            }

            fn back_coefficients(_built: &DampedLine<T>, _at: &FrequencyPowers<S>) {}

            fn back_transfer(_coefficients: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
                covector
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for $element<T> {
            type Gradient = $element<S>;

            fn units(built: &DampedLine<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
                unit_of(Coordinate::$coordinate, built.longitudinal(at, S::from_parameter(built.line.section.length)).unit())
            }

            fn mass_form(built: &DampedLine<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                forms::<Self, T, S>(built, first, second).mass
            }

            fn stiffness_form(built: &DampedLine<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                forms::<Self, T, S>(built, first, second).stiffness
            }

            fn damping_form(built: &DampedLine<T>, first: &Ends<S>, second: &Ends<S>) -> S {
                forms::<Self, T, S>(built, first, second).damping
            }

            fn inside(built: &DampedLine<T>, x: S) -> Option<Inside> {
                Some(built.inside(x))
            }

            fn state_at(built: &DampedLine<T>, ends: &Ends<S>, distance: f64) -> State<S> {
                let stretch = Stretch::of_path(ends, is_rotation::<Self>());
                path_state(built.state_at(&stretch, T::from_f64(distance)), is_rotation::<Self>())
            }

            fn load_work(built: &DampedLine<T>, ends: &Ends<S>) -> Option<S> {
                Some(built.load_work(&Stretch::of_path(ends, is_rotation::<Self>())))
            }

            fn mass_per_length(built: &DampedLine<T>) -> S {
                weight::<Self, T, S>(built)
            }

            fn gradient(built: &DampedLine<T>, ends: &Ends<S>) -> $element<S> {
                $element::of_gradient(built.gradient(&Stretch::of_path(ends, is_rotation::<Self>())))
            }
        }

        impl<T: Real> CarriesLoad for $element<T> {}

        impl<S> $element<S> {
            /// The derivatives with respect to length, stiffness, inertia and foundation, and to those of damping.
            fn of_gradient(([length, stiffness, inertia, _foundation], [_loss, _time, external]): ([S; 4], [S; 3])) -> Self {
                $element {
                    length,
                    $stiffness: stiffness,
                    $inertia: inertia,
                    $($foundation: _foundation,)?
                    $($loss: _loss, $time: _time,)?
                    external_damping: external,
                }
            }
        }

        impl<T: Parameter, S: ComplexFrequency<T> + ChartScalar> Charted<S> for $element<T> {
            fn chart(built: &DampedLine<T>, at: &FrequencyPowers<S>, _distance: S) -> Chart<S> {
                let length = S::from_parameter(built.line.section.length);
                line_chart(&built.longitudinal(at, length), along_member::<Self>())
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for $element<T> {
            fn forms(built: &DampedLine<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
                let [first, second] = [first, second].map(|motion| Stretch::in_freedom(motion, freedom::<Self>()));
                built.forms(&first, &second)
            }

            fn inside(built: &DampedLine<T>, x: S) -> Option<Inside> {
                Some(built.inside(x))
            }

            fn motion_at(built: &DampedLine<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
                let stretch = Stretch::in_freedom(motion, freedom::<Self>());
                EndMotion::at_rest().in_freedom(freedom::<Self>(), built.state_at(&stretch, T::from_f64(distance)))
            }

            fn load_work(built: &DampedLine<T>, motion: &MemberEnds<S>) -> Option<[S; 2]> {
                (!is_rotation::<Self>()).then(|| [built.load_work(&Stretch::of(motion)), S::zero()])
            }

            fn mass_per_length(built: &DampedLine<T>) -> S {
                weight::<Self, T, S>(built)
            }

            fn motion_under_load(
                built: &DampedLine<T>,
                motion: &MemberEnds<S>,
                [load, _]: [S; 2],
                distance: f64,
            ) -> EndMotion<S> {
                if is_rotation::<Self>() {
                    return Self::motion_at(built, motion, distance);
                }
                EndMotion::at_rest().stretched(built.state_under(&Stretch::of(motion), load, T::from_f64(distance)))
            }
        }

        impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for $element<T> {
            type Gradient = $element<S>;

            fn member_gradient(built: &DampedLine<T>, motion: &MemberEnds<S>) -> $element<S> {
                $element::of_gradient(built.gradient(&Stretch::in_freedom(&motion, freedom::<Self>())))
            }
        }

        #[cfg(test)]
        impl super::laws::Sample for $element<f64> {
            fn sample(mut next: impl FnMut() -> f64) -> Self {
                let parameters = [0.2 * next(), next(), next(), 0.0];
                let mut element = $element::of_gradient((parameters, [0.0; 3]));
                $(element.$foundation = next();)?
                // the stiffness vanishes far from the frequencies of the laws
                $((element.$loss, element.$time) = (0.2 * next(), 0.005 * next());)?
                element.external_damping = 0.5 * next();
                element
            }

            fn halves(self) -> Option<Self> {
                Some($element { length: self.length / 2.0, ..self })
            }

            fn phase(&self, s: f64) -> f64 {
                // near λ = -1/c the stiffness is a small part of what it is at rest
                self.build().map_or(0.0, |built| 10.0 * built.line.square(s.powi(4)).sqrt())
            }

            fn untied(self) -> Self {
                $element { $($foundation: 0.0,)? ..self }
            }

            fn lossless(self) -> Self {
                $element { $($loss: 0.0,)? ..self }
            }
        }
    )*};
}

/// Whether a line turns.
const fn is_rotation<E: Element>() -> bool {
    E::State::SPACE.is(Space::Rotation)
}

/// The freedom of a member in which a line moves: along it, or about z.
const fn freedom<E: Element>() -> usize {
    if is_rotation::<E>() { 2 } else { 0 }
}

/// The mass per length of a line; one that turns has no weight.
fn weight<E: Element, T: Parameter, S: ComplexFrequency<T>>(built: &DampedLine<T>) -> S {
    if is_rotation::<E>() { S::zero() } else { S::from_parameter(built.line.section.inertia) }
}

/// The forms of two motions of a path.
fn forms<E: Element, T: Real, S: ComplexFrequency<T> + Oscillation<T>>(
    built: &DampedLine<T>,
    first: &Ends<S>,
    second: &Ends<S>,
) -> Forms<S> {
    let [first, second] = [first, second].map(|ends| Stretch::of_path(ends, is_rotation::<E>()));
    built.forms(&first, &second)
}

damped_wave_lines! {
    /// Taut string in a medium that damps it: `H Y'' = (mλ² + c_e λ + k) Y`, at complex frequencies λ only. Its stiffness is its tension, which
    /// has no loss.
    ///
    /// # Source
    /// That of [`TautString`](crate::elements::TautString), with viscous damping by a medium.
    DampedString in Translation, Y {
        /// Tension H \[N\], positive.
        tension: translational_stiffness;
        /// Mass per length m [kg/m], zero or positive.
        mass_per_length: mass;
        foundation {
            /// Stiffness k of the foundation per length [N/m²], zero or positive.
            foundation_stiffness;
        }
        loss {}
    }

    /// Rod with damping of its material and of a medium around it: `EA (1 + iη)(1 + cλ) Y'' = (mλ² + c_e λ + k) Y`, at complex frequencies λ
    /// only.
    ///
    /// # Source
    /// That of [`Rod`](crate::elements::Rod), with the damping of [`DampedBeam`](crate::elements::DampedBeam).
    DampedRod in Translation, Y {
        /// Axial stiffness EA \[N\], positive.
        axial_stiffness: translational_stiffness;
        /// Mass per length m [kg/m], zero or positive.
        mass_per_length: mass;
        foundation {
            /// Stiffness k of the foundation along the rod, per length [N/m²], zero or positive.
            foundation_stiffness;
        }
        loss {
            /// Loss factor η of EA, zero or positive.
            loss_factor;
            /// Time c of Kelvin and Voigt \[s\], zero or positive.
            kelvin_voigt_time;
        }
    }

    /// Shaft with damping of its material and of a medium around it: `GJ (1 + iη)(1 + cλ) Θ'' = (ρI_p λ² + c_e λ) Θ`, at complex frequencies λ
    /// only.
    ///
    /// # Source
    /// That of [`Shaft`](crate::elements::Shaft), with the damping of [`DampedBeam`](crate::elements::DampedBeam).
    DampedShaft in Rotation, Theta {
        /// Torsional stiffness GJ [N m²], positive.
        torsional_stiffness: torsional_stiffness;
        /// Polar inertia per length ρI_p [kg m], zero or positive.
        inertia_per_length: moment_of_inertia;
        foundation {}
        loss {
            /// Loss factor η of GJ, zero or positive.
            loss_factor;
            /// Time c of Kelvin and Voigt \[s\], zero or positive.
            kelvin_voigt_time;
        }
    }
}
