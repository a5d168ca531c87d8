//! The tapered beam: width and height vary evenly along it, with axial force and rotation.

use crate::element::{Element, MemberNumbers, PlaneStep, TaperedNumbers, TransferMatrix};
use crate::elements::shared::compound::Units;
use crate::model::{Bending, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scaled, Single};
use crate::subspace::{RootCounter, Subspace};
use mstmm_plan::Support;
use nalgebra::Matrix4;
use profile::Profile;
pub(crate) use walk::Tapered;

mod chart;
mod inside;
mod member;
mod motion;
mod part;
mod profile;
mod series;
mod walk;

/// Beam whose width and height vary evenly along it, as wedges, blades and masts do, exact at every frequency.
///
/// At the distance x from the input end the section has the width `b = 1 - c_b x/l` and the height `h = 1 - c_h x/l`, as parts of those at
/// the input end, so that `EI ~ b h³`, `m ~ b h` and the rotary inertia `r ~ b h³`. With `N(x) = N_l + p (l - x) + Ω² ∫_x^l m (R + ξ) dξ`,
/// `g = N + r λ²` and `q = -m (λ² - Ω² sin² ψ) - k` the state obeys
///
/// ```text
/// Y' = Θ     EI Θ' = M     M' = g Θ + Q     Q' = q Y
/// ```
///
/// Q does work on Y: `-Q = -M' + N Y' + ..` contains the slope times the axial force. The minors of a plane obey `EI p_YΘ' = p_YM`,
/// `p_YM' = g p_YΘ + 2w`, `w' = p_ΘQ`, `EI p_ΘQ' = p_MQ - EI q p_YΘ`, `p_MQ' = g p_ΘQ - q p_YM`, and are taken through the beam by Taylor
/// series of themselves, in parts that are short beside waves and beside the distance to where the section would vanish. None of these
/// parts, with both ends clamped, has a frequency below, so that counts are those of a chain of beams.
///
/// The beam rotates about an axis at the distance R before its input end, and moves at the setting angle ψ to that axis: along it (flapping
/// of a blade) where `ψ = 0`, in the plane of rotation (lagging) where `ψ = π/2`. There the centrifugal force has a part along the motion,
/// which it pushes on, as a foundation of the stiffness `-m Ω²` would. Coriolis forces do not act in either. Where the arrow points towards
/// the axis R is negative, and the axial force is that at the inner end.
///
/// Up to some 1600 half waves are taken; beyond, results are not a number, which searches refuse.
///
/// # Source
/// Bernoulli's beam with variable section, `V = ½ ∫ EI Y''² + N Y'² + (k - m Ω² sin² ψ) Y²`, kinetic energy `½ ∫ m Ẏ² + r Ẏ'²`; centrifugal force as in
/// Wright, Smith, Thresher and Wang (1982).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TaperedBeam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Bending stiffness EI at the input end [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m at the input end [kg/m], positive.
    pub mass_per_length: T,
    /// Taper of the width `c_b`, from -1e6 to 0.999999; zero for a constant width.
    pub width_taper: T,
    /// Taper of the height `c_h`, from -1e6 to 0.999999; zero for a constant height.
    pub height_taper: T,
    /// Rotary inertia per length `r = ρ I` at the input end [kg m], zero or positive.
    pub rotary_inertia: T,
    /// Axial force `N_l` at the output end \[N\], positive in tension.
    pub axial_force: T,
    /// Axial load p per length [N/m], towards the output end: it adds `p (l - x)` to the axial force. A column that stands on its input end has the negative of its weight per
    /// length.
    pub axial_load: T,
    /// Speed of rotation Ω [rad/s], zero or positive.
    pub rotation_speed: T,
    /// Position R of the input end from the axis of rotation \[m\], negative where the beam points towards the axis.
    pub hub_radius: T,
    /// Setting angle ψ between the motion and the axis of rotation \[rad\]: 0 is flapping, π/2 lagging.
    pub setting_angle: T,
    /// Stiffness k of a foundation per length [N/m²], the same all along, of either sign.
    pub foundation_stiffness: T,
}

/// A beam whose parameters are valid, seen from one of its ends.
#[derive(Clone, Copy, Debug)]
pub struct BuiltTaperedBeam<T> {
    parameters: TaperedBeam<T>,
    /// Whether distances are taken from the output end.
    is_reversed: bool,
}

/// Tapers between which the section at the output end is not extreme beside that at the input end.
const TAPERS: Requirement = Requirement::Between { least: -1e6, most: 0.999_999 };

impl<T: Parameter> Element for TaperedBeam<T> {
    type State = Bending;
    type Built = BuiltTaperedBeam<T>;
    const MAY_BUCKLE: bool = true;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<BuiltTaperedBeam<T>, InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("bending_stiffness", self.bending_stiffness)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)?;
        TAPERS.check("width_taper", self.width_taper)?;
        TAPERS.check("height_taper", self.height_taper)?;
        Requirement::NonNegative.check("rotary_inertia", self.rotary_inertia)?;
        Requirement::Finite.check("axial_force", self.axial_force)?;
        Requirement::Finite.check("axial_load", self.axial_load)?;
        Requirement::NonNegative.check("rotation_speed", self.rotation_speed)?;
        Requirement::Finite.check("hub_radius", self.hub_radius)?;
        Requirement::Finite.check("setting_angle", self.setting_angle)?;
        Requirement::Finite.check("foundation_stiffness", self.foundation_stiffness)?;
        if !Units::new(self.bending_stiffness, T::one() / self.length).are_in_range() {
            let powers = [("bending_stiffness", self.bending_stiffness), ("length", self.length)];
            return Err(InvalidParameter::most_extreme(powers));
        }
        // where nothing turns, no position is beside an axis
        let hub_radius = T::select(self.rotation_speed.vanishes(), T::zero(), self.hub_radius);
        Ok(BuiltTaperedBeam { parameters: TaperedBeam { hub_radius, ..self }, is_reversed: false })
    }

    fn estimate(built: &BuiltTaperedBeam<T>, estimates: &mut FrequencyEstimates) {
        let profile = Profile::of(built.parameters.map(T::to_f64), 1.0, built.is_reversed);
        let phase = profile.phase();
        // the frequency at which the waves along the beam add up to 1
        estimates.waves(1.0 / (phase * phase));
        let l = profile.length;
        estimates.length(l);
        estimates.translational_stiffness(Parameter::abs(profile.foundation) * l);
        for end in [0.0, 1.0] {
            let ei = profile.stiffness_at(end);
            estimates.translational_stiffness(ei / (l * l * l));
            estimates.torsional_stiffness(ei / l);
            estimates.translational_stiffness(Parameter::abs(profile.force_at(end)) / l);
            let m = profile.mass_at(end);
            estimates.mass(m * l);
            estimates.moment_of_inertia(m * l * l * l);
            estimates.moment_of_inertia(profile.rotary_at(end) * l);
        }
    }

    fn extent(built: &BuiltTaperedBeam<T>) -> Extent {
        let [length, stiffness] = [built.parameters.length, built.parameters.bending_stiffness].map(T::to_f64);
        Extent::along(length).of_stiffness(stiffness)
    }

    fn member_numbers(built: &BuiltTaperedBeam<T>) -> MemberNumbers {
        let beam = built.parameters.map(T::words);
        MemberNumbers::Tapered(TaperedNumbers {
            length: beam.length,
            bending_stiffness: beam.bending_stiffness,
            mass_per_length: beam.mass_per_length,
            width_taper: beam.width_taper,
            height_taper: beam.height_taper,
            rotary_inertia: beam.rotary_inertia,
            axial_force: beam.axial_force,
            axial_load: beam.axial_load,
            rotation_speed: beam.rotation_speed,
            hub_radius: beam.hub_radius,
            setting_angle: beam.setting_angle,
            foundation_stiffness: beam.foundation_stiffness,
        })
    }
}

impl<T: Parameter> TaperedBeam<T> {
    /// The beam between two stations of a table, each with its bending stiffness EI [N m²] and its mass per length m [kg/m].
    ///
    /// With `EI ~ b h³` and `m ~ b h` both numbers are met at both stations: at the second one `h = √((EI₂/EI₁)/(m₂/m₁))` and `b = (m₂/m₁)/h`. Between them width and height vary evenly. That is the
    /// law of a cone with a thin wall, whose diameter is h and whose thickness is b. Where a number of the second station is no positive one, `build` refuses the taper that follows. Axial force, rotation, rotary inertia and foundation are zero.
    ///
    /// ```
    /// use mstmm_core::elements::TaperedBeam;
    ///
    /// // a wall of 20 mm that becomes 10 mm, on a diameter of 4 m that becomes 3 m: r t³ and r t
    /// let beam = TaperedBeam::between(30.0, [4.0_f64.powi(3) * 0.02, 3.0_f64.powi(3) * 0.01], [4.0 * 0.02, 3.0 * 0.01]);
    /// assert!((beam.height_taper - 0.25).abs() < 1e-15 && (beam.width_taper - 0.5).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn between(length: T, bending_stiffness: [T; 2], mass_per_length: [T; 2]) -> Self {
        let of_mass = mass_per_length[1] / mass_per_length[0];
        let height = (bending_stiffness[1] / bending_stiffness[0] / of_mass).sqrt();
        let [zero, one] = [T::zero(), T::one()];
        TaperedBeam {
            length,
            bending_stiffness: bending_stiffness[0],
            mass_per_length: mass_per_length[0],
            width_taper: one - of_mass / height,
            height_taper: one - height,
            rotary_inertia: zero,
            axial_force: zero,
            axial_load: zero,
            rotation_speed: zero,
            hub_radius: zero,
            setting_angle: zero,
            foundation_stiffness: zero,
        }
    }

    /// The parameters as numbers of another type.
    fn map<S>(self, to: impl Fn(T) -> S) -> TaperedBeam<S> {
        TaperedBeam {
            length: to(self.length),
            bending_stiffness: to(self.bending_stiffness),
            mass_per_length: to(self.mass_per_length),
            width_taper: to(self.width_taper),
            height_taper: to(self.height_taper),
            rotary_inertia: to(self.rotary_inertia),
            axial_force: to(self.axial_force),
            axial_load: to(self.axial_load),
            rotation_speed: to(self.rotation_speed),
            hub_radius: to(self.hub_radius),
            setting_angle: to(self.setting_angle),
            foundation_stiffness: to(self.foundation_stiffness),
        }
    }
}

impl<T: Parameter> BuiltTaperedBeam<T> {
    /// The beam of another length at a frequency, seen from its input end.
    fn of_length<S: Frequency<T>>(&self, lambda_squared: S, length: S) -> Tapered<S> {
        let parameters = TaperedBeam { length, ..self.parameters.map(S::from_parameter) };
        Tapered::new(parameters, self.parameters.map(T::to_f64), lambda_squared, false)
    }

    /// The beam at a frequency.
    fn at<S: Frequency<T>>(&self, lambda_squared: S) -> Tapered<S> {
        Tapered::new(
            self.parameters.map(S::from_parameter),
            self.parameters.map(T::to_f64),
            lambda_squared,
            self.is_reversed,
        )
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for TaperedBeam<T> {
    fn transfer_matrix(built: &BuiltTaperedBeam<T>, x: S) -> Matrix4<S> {
        let beam = built.at(x.lambda_squared());
        let columns: [[S; 4]; 4] = core::array::from_fn(|column| {
            let unit = core::array::from_fn(|row| if row == column { S::one() } else { S::zero() });
            let (entries, exponent) = beam.state(unit, 0.0, 1.0);
            entries.map(|entry| entry.times_power_of_two(exponent))
        });
        Matrix4::from_fn(|row, column| columns[column][row])
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for TaperedBeam<T> {
    type Coefficients = Tapered<S>;

    fn coefficients(built: &BuiltTaperedBeam<T>, at: &FrequencyPowers<S>) -> Tapered<S> {
        built.at(at.lambda_squared)
    }

    fn step<C: RootCounter<S>>(beam: &Tapered<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        Subspace::Plane(beam.through(input.plane(), counter))
    }

    fn root<C: RootCounter<S>>(beam: &Tapered<S>, input: Subspace<S>, support: Support, counter: &mut C) -> Scaled<S> {
        beam.root(input.plane(), support, counter)
    }
}

#[cfg(test)]
impl super::laws::Sample for TaperedBeam<f64> {
    /// A beam whose clamped frequencies are above 2.
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        TaperedBeam {
            length: next(),
            bending_stiffness: next(),
            mass_per_length: next(),
            width_taper: next() - 1.25,
            height_taper: (next() - 1.25) * 0.4,
            rotary_inertia: next() * 0.005,
            axial_force: (next() - 1.25) * 0.5,
            axial_load: (next() - 1.25) * 0.3,
            rotation_speed: next(),
            hub_radius: next(),
            setting_angle: next() * 0.2,
            foundation_stiffness: (next() - 1.25) * 0.3,
        }
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn phase(&self, s: f64) -> f64 {
        let profile = Profile::of(*self, s.powi(4), false);
        profile.phase().max(profile.force_at(0.0).abs().sqrt())
    }

    fn untied(self) -> Self {
        TaperedBeam { axial_force: 0.0, axial_load: 0.0, rotation_speed: 0.0, foundation_stiffness: 0.0, ..self }
    }
}

#[cfg(test)]
mod tests;
