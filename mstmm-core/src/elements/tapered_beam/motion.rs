//! The motion of a tapered beam: its back transfer, its energies and their derivatives with respect to its parameters.

use crate::element::{BackTransfer, Energies, Inside as Interior};
use crate::elements::shared::line_forms::half;
use crate::elements::tapered_beam::inside::{Inside, along};
use crate::elements::tapered_beam::profile::Profile;
use crate::elements::tapered_beam::walk::Tapered;
use crate::elements::tapered_beam::{BuiltTaperedBeam, TaperedBeam};
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Oscillation, Real, Scalar, Single, twice};
use crate::subspace::{Covector, Subspace};

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for TaperedBeam<T> {
    /// The beam seen from its output end.
    type BackCoefficients = Tapered<S>;
    const SYMMETRIC: bool = false;

    fn reversed(built: &BuiltTaperedBeam<T>) -> BuiltTaperedBeam<T> {
        built.reversed()
    }

    fn back_coefficients(built: &BuiltTaperedBeam<T>, at: &FrequencyPowers<S>) -> Tapered<S> {
        built.reversed().at(at.lambda_squared)
    }

    fn back_transfer(reversed: &Tapered<S>, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        reversed.covector(covector, 0.0, 1.0)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for TaperedBeam<T> {
    type Gradient = TaperedBeam<S>;

    fn units(built: &BuiltTaperedBeam<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let Interior { length, wave_number } = built.interior(at.x);
        let wave = wave_number.max(1.0 / length);
        let stiffness = built.parameters.bending_stiffness.to_f64() * wave;
        [stiffness * wave * wave, stiffness]
    }

    fn mass_form(built: &BuiltTaperedBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        let profile: Profile<S> = built.at(first.x.lambda_squared()).profile;
        let [mass] = built.integrals(first, second, |share, [one, other]| {
            [one.y * other.y * profile.mass_at(share) + one.theta * other.theta * profile.rotary_at(share)]
        });
        mass
    }

    fn stiffness_form(built: &BuiltTaperedBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        // at rest a mass holds by its part of the centrifugal force alone
        let profile: Profile<S> = built.at(S::zero()).profile;
        let [stiffness] = built.integrals(first, second, |share, [one, other]| {
            let bending = one.m * other.m / profile.stiffness_at(share);
            [bending + one.theta * other.theta * profile.force_at(share) + one.y * other.y * profile.hold_at(share)]
        });
        stiffness
    }

    fn inside(built: &BuiltTaperedBeam<T>, x: S) -> Option<Interior> {
        Some(built.interior(x))
    }

    fn state_at(built: &BuiltTaperedBeam<T>, ends: &Ends<S>, distance: f64) -> State<S> {
        let share = distance / built.parameters.length.to_f64();
        if share >= 1.0 {
            return ends.output;
        }
        Inside::new(built, ends).state_at(share)
    }

    fn gradient(built: &BuiltTaperedBeam<T>, ends: &Ends<S>) -> TaperedBeam<S> {
        built.gradient(ends)
    }
}

impl<T: Real> BuiltTaperedBeam<T> {
    /// The beam seen from its other end.
    pub(super) fn reversed(self) -> Self {
        BuiltTaperedBeam { is_reversed: !self.is_reversed, ..self }
    }

    /// The length, and the largest of all wave numbers: of bending, and of waves that decay under tension.
    fn interior<S: Oscillation<T>>(&self, x: S) -> Interior {
        let sizes = self.at(x.lambda_squared()).sizes;
        let wave_at = |share: f64| {
            let stiffness = sizes.stiffness_at(share);
            let bending = Scalar::sqrt(sizes.most_hold(sizes.mass_at(share)) / stiffness);
            let by_force = (sizes.force_at(share).abs() + sizes.rotary_at(share) * sizes.lambda_squared) / stiffness;
            Scalar::sqrt(bending + by_force)
        };
        Interior { length: sizes.length, wave_number: wave_at(0.0).max(wave_at(1.0)) }
    }

    fn integrals<S: Oscillation<T>, const N: usize>(
        &self,
        first: &Ends<S>,
        second: &Ends<S>,
        at: impl Fn(f64, [State<S>; 2]) -> [S; N],
    ) -> [S; N] {
        let one = Inside::new(self, first);
        if first == second {
            return along([&one, &one], at);
        }
        along([&one, &Inside::new(self, second)], at)
    }

    /// `∂L/∂p` by the densities of `L = ½ ∫ M²/EI + N Θ² + (m (λ² - Ω² sin² ψ) + k) Y² + λ² r Θ²`, each times the relative derivative of what stands in it. A longer
    /// beam is the same shape over another length, less the work at the ends that turns them back.
    pub(super) fn gradient<S: Oscillation<T>>(&self, ends: &Ends<S>) -> TaperedBeam<S> {
        let profile: Profile<S> = self.at(ends.x.lambda_squared()).profile;
        let beam = self.parameters.map(S::from_parameter);
        let inverse = S::one() / beam.length;
        let sums = self.integrals(ends, ends, |share, [state, _]| {
            let densities = Densities::new(&profile, &state, share);
            densities.of_parameters(&profile, &beam, share)
        });
        let [length, stiffness, mass, width, height, rotary, force, load, speed, radius, angle, foundation] =
            sums.map(half);
        let work = |state: &State<S>| state.m * state.theta;
        TaperedBeam {
            length: (length + work(&ends.output) - work(&ends.input)) * inverse,
            bending_stiffness: stiffness,
            mass_per_length: mass,
            width_taper: width,
            height_taper: height,
            rotary_inertia: rotary,
            axial_force: force,
            axial_load: load,
            rotation_speed: speed,
            hub_radius: radius,
            setting_angle: angle,
            foundation_stiffness: foundation,
        }
    }
}

/// Twice the parts of L per length at a section.
struct Densities<S> {
    bending: S,
    /// `m (λ² - Ω² sin² ψ) Y²`
    mass: S,
    /// `λ² r Θ²`
    rotary: S,
    /// `Θ²`
    slope: S,
    /// `Y²`
    square: S,
}

impl<S: Single> Densities<S> {
    fn new(profile: &Profile<S>, state: &State<S>, share: f64) -> Self {
        let (slope, square) = (state.theta * state.theta, state.y * state.y);
        Densities {
            bending: state.m * state.m / profile.stiffness_at(share),
            mass: profile.of_mass * profile.mass_at(share) * square,
            rotary: profile.lambda_squared * profile.rotary_at(share) * slope,
            slope,
            square,
        }
    }

    /// Their derivatives with respect to the parameters, that to the length times the length.
    fn of_parameters(&self, profile: &Profile<S>, beam: &TaperedBeam<S>, share: f64) -> [S; 12] {
        let Densities { bending, mass, rotary, slope, square } = *self;
        // distance from the beam's input end as a share, which is not where shares are counted from if the beam is reversed
        let position = |share: f64| S::from_f64(if profile.outer > 0.0 { share } else { 1.0 - share });
        let pull = |at: &dyn Fn(f64) -> S| slope * profile.speed_squared * profile.up_to_end(share, at);
        let centrifugal = |at: f64| profile.mass_at(at) * profile.radius.at(at);
        let by_width = |at: f64| -position(at) / profile.width.at(at);
        let by_height = |at: f64| -position(at) / profile.height.at(at);
        let force = pull(&centrifugal);
        let stretched = pull(&|at| profile.mass_at(at) * position(at) * beam.length);
        let loaded = slope * beam.length * profile.rest_at(share);
        let three = S::from_f64(3.0);
        let shape = bending + rotary;
        let (sin, cos) = beam.setting_angle.sin_cos();
        let push = profile.mass_at(share) * sin * square;
        [
            mass + profile.foundation * square - three * bending - slope * profile.force_at(share) - rotary
                + force
                + stretched
                + loaded * beam.axial_load,
            bending / beam.bending_stiffness,
            (mass + force) / beam.mass_per_length,
            by_width(share) * (shape + mass) + pull(&|at| by_width(at) * centrifugal(at)),
            by_height(share) * (three * shape + mass) + pull(&|at| by_height(at) * centrifugal(at)),
            profile.lambda_squared * profile.shape_at(share) * slope,
            slope,
            loaded,
            twice(beam.rotation_speed * (slope * profile.up_to_end(share, centrifugal) - push * sin)),
            pull(&|at| profile.mass_at(at)),
            -twice(profile.speed_squared * push * cos),
            square,
        ]
    }
}
