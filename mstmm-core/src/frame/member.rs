//! Members of frames: which element a section or a connector is.

use crate::element::CarriesLoad;
use crate::elements::any_member::{AnyMember, Section as PlainSection};
use crate::elements::rotor_member::RotorMember;
use crate::elements::{
    CrossCoupledSpring, DampedBeam, DampedRod, DampedShaft, DampedSpinningBeam, DampedSpring, DampedString,
    DampedTorsionSpring, Damper, GeneralBeam, InPlane, Rod, Shaft, SpinningBeam, Spring, SpringDamper,
    TautString as PathString, TorsionDamper, TorsionSpring, TorsionSpringDamper,
};
use crate::frame::dimension::{Dimension, Line, Plane};
use crate::frame::error::Mistake;
use crate::frame::parts::Parts;
use crate::frame::point::InFrame;
use crate::frame::section::{Parameter, Section, name_of};
use crate::model::MemberLabel;
use mstmm_plan::Freedoms;

/// A member of a frame, of the kind of its element.
pub type Member<K> = MemberLabel<InFrame, K>;

/// A beam as a member.
#[derive(Clone, Copy, Debug)]
pub enum OfBeam {}

/// A spring or a damper as a member.
#[derive(Clone, Copy, Debug)]
pub enum OfSpring {}

/// A string, a rod or a shaft of a path as a member.
#[derive(Clone, Copy, Debug)]
pub enum OfLine {}

/// A joint as a member.
#[derive(Clone, Copy, Debug)]
pub enum OfJoint {}

impl CarriesLoad for OfBeam {}
impl CarriesLoad for OfLine {}

/// A bar of a truss: a beam of the plane with a pin at each end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar(pub Section);

/// A taut string of the plane, which moves across itself against its tension, and stretches.
///
/// ```
/// use mstmm_core::Support;
/// use mstmm_core::frame::{Frame, Section, TautString};
///
/// let wire = Section::new().tension(5e4).axial_stiffness(2e7).mass_per_length(1.5);
/// let mut frame = Frame::new();
/// let [left, right] = [[0.0, 0.0], [30.0, 40.0]].map(|place| frame.point(place));
/// frame.hold(left, Support::Pinned);
/// frame.hold(right, Support::Pinned);
/// frame.member(left, right, TautString(wire));
/// let first = frame.build()?.frequencies(1)?[0].omega;
/// assert!((first - core::f64::consts::PI / 50.0 * (5e4_f64 / 1.5).sqrt()).abs() < 1e-12);
/// # use mstmm_core::search::NaturalFrequencies;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TautString(pub Section);

/// What stands between two ends of a frame: an element, or why it is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMember {
    pub(crate) parts: Result<Parts, Mistake>,
    /// The freedoms that its ends do not share with their points, whatever these say, in its own axes.
    pub(crate) released: Freedoms,
}

impl FrameMember {
    fn of(element: Result<impl Into<RotorMember<f64>>, Mistake>) -> Self {
        FrameMember::of_parts(element.map(Parts::one))
    }

    /// A member of parts.
    pub(crate) fn of_parts(parts: Result<Parts, Mistake>) -> Self {
        FrameMember { parts, released: Freedoms::NONE }
    }

    /// An element that is known.
    pub(crate) fn known(element: impl Into<RotorMember<f64>>) -> Self {
        FrameMember::of(Ok(element))
    }
}

/// An element that stands between two ends of a frame of a dimension.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not stand between two ends of a frame of dimension `{D}`",
    note = "a `Section` is a beam, a `Bar` one with pins at its ends, a `TautString` a string of the plane; `Spring`, `Damper`, `Hinge` and others \
            stand there, too"
)]
pub trait FrameElement<D: Dimension> {
    /// The kind of its handle.
    type Kind;

    /// The element.
    #[doc(hidden)]
    fn member(self) -> FrameMember;
}

/// The parameters that select a beam with more than bending and mass.
pub(super) const GENERAL: [Parameter; 5] = [
    Parameter::shear_stiffness,
    Parameter::rotary_inertia,
    Parameter::axial_force,
    Parameter::foundation_stiffness,
    Parameter::foundation_shear_stiffness,
];

/// The parameters that select a damped beam.
pub(super) const LOSSES: [Parameter; 3] =
    [Parameter::loss_factor, Parameter::kelvin_voigt_time, Parameter::external_damping];

/// The parameters that a beam in the plane has not: parameters of beams in space and of shafts that spin.
const ELSEWHERE: [Parameter; 13] = [
    Parameter::polar_inertia_per_length,
    Parameter::speed,
    Parameter::torsional_stiffness,
    Parameter::bending_stiffness_y,
    Parameter::bending_stiffness_z,
    Parameter::shear_stiffness_y,
    Parameter::shear_stiffness_z,
    Parameter::rotary_inertia_y,
    Parameter::rotary_inertia_z,
    Parameter::foundation_stiffness_y,
    Parameter::foundation_stiffness_z,
    Parameter::foundation_shear_stiffness_y,
    Parameter::foundation_shear_stiffness_z,
];

/// The parameters of beams in space alone.
const SPATIAL: &[Parameter] = ELSEWHERE.split_at(2).1;

/// Checks that a section names none of some parameters, and no `up`.
fn refuse(section: &Section, parameters: &[Parameter], element: &'static str) -> Result<(), Mistake> {
    if section.z_axis().is_some() {
        return Err(Mistake::Foreign { element, parameter: "up" });
    }
    match parameters.iter().find(|parameter| section.get(**parameter).is_some()) {
        Some(parameter) => Err(Mistake::Foreign { element, parameter: name_of(*parameter) }),
        None => Ok(()),
    }
}

/// A parameter that a beam needs.
pub(super) fn needed(section: &Section, parameter: Parameter) -> Result<f64, Mistake> {
    section.get(parameter).ok_or(Mistake::Missing { parameter: name_of(parameter) })
}

/// A parameter that may be left out: what is not named is rigid, or not there.
pub(super) fn or_neutral(section: &Section, parameter: Parameter) -> f64 {
    let is_rigid = matches!(parameter, Parameter::shear_stiffness);
    section.get(parameter).unwrap_or(if is_rigid { f64::INFINITY } else { 0.0 })
}

/// Whether a section names one of some parameters.
pub(super) fn names(section: &Section, parameters: &[Parameter]) -> bool {
    parameters.iter().any(|parameter| section.get(*parameter).is_some())
}

/// The beam of a section with all parameters of a type. Its length is that between its ends.
macro_rules! beam {
    ($beam:ident of $section:ident { $($optional:ident),* }) => {
        $beam {
            length: 0.0,
            bending_stiffness: needed($section, Parameter::bending_stiffness)?,
            mass_per_length: needed($section, Parameter::mass_per_length)?,
            $($optional: or_neutral($section, Parameter::$optional),)*
        }
    };
}

/// The general beam of a section.
pub(super) fn general(section: &Section) -> Result<GeneralBeam<f64>, Mistake> {
    Ok(beam!(GeneralBeam of section {
        shear_stiffness, rotary_inertia, axial_force, foundation_stiffness, foundation_shear_stiffness
    }))
}

/// The beam with damping of a section.
pub(super) fn damped(section: &Section) -> Result<DampedBeam<f64>, Mistake> {
    Ok(beam!(DampedBeam of section {
        shear_stiffness, rotary_inertia, axial_force, foundation_stiffness, foundation_shear_stiffness,
        loss_factor, kelvin_voigt_time, external_damping
    }))
}

/// Checks that a beam has no tension, and that its shear stiffness is positive.
pub(super) fn check(section: &Section) -> Result<(), Mistake> {
    if section.get(Parameter::tension).is_some() {
        return Err(Mistake::Foreign { element: "beam", parameter: name_of(Parameter::tension) });
    }
    match or_neutral(section, Parameter::shear_stiffness) {
        value if value > 0.0 => Ok(()),
        value => Err(Mistake::ShearStiffness { parameter: name_of(Parameter::shear_stiffness), value }),
    }
}

/// The parameters that a beam names all together, or none of them but the first.
const OF_SPIN: [Parameter; 3] = [Parameter::rotary_inertia, Parameter::polar_inertia_per_length, Parameter::speed];

/// Whether a section is that of a shaft that spins.
fn spins(section: &Section) -> bool {
    names(section, &OF_SPIN[1..])
}

/// The beam of a section that spins.
fn shaft(section: &Section) -> Result<RotorMember<f64>, Mistake> {
    if let Some(missing) = OF_SPIN.into_iter().find(|parameter| section.get(*parameter).is_none()) {
        return Err(Mistake::MissingOfShaft { parameter: name_of(missing) });
    }
    let spin = [needed(section, OF_SPIN[1])?, needed(section, OF_SPIN[2])?];
    if section.get(Parameter::loss_factor).is_some() {
        let parameter = name_of(Parameter::loss_factor);
        return Err(Mistake::Foreign { element: "beam that spins", parameter });
    }
    if !names(section, &[Parameter::kelvin_voigt_time, Parameter::external_damping]) {
        return Ok(SpinningBeam::spinning(general(section)?, spin).into());
    }
    let DampedBeam { kelvin_voigt_time, external_damping, .. } = damped(section)?;
    let shaft = SpinningBeam::spinning(general(section)?, spin);
    Ok(DampedSpinningBeam::with_damping(shaft, [kelvin_voigt_time, external_damping]).into())
}

/// The beam of a section along a line.
fn along_line(section: &Section) -> Result<RotorMember<f64>, Mistake> {
    refuse(section, SPATIAL, "beam along a line")?;
    if section.get(Parameter::axial_stiffness).is_some() {
        return Err(Mistake::AxialStiffness);
    }
    check(section)?;
    if spins(section) {
        return shaft(section);
    }
    let standing: AnyMember<f64> =
        if names(section, &LOSSES) { damped(section)?.into() } else { general(section)?.into() };
    Ok(standing.into())
}

/// The beam of a section in the plane.
fn in_plane(section: &Section) -> Result<AnyMember<f64>, Mistake> {
    refuse(section, &ELSEWHERE, "beam in the plane")?;
    let axial_stiffness = needed(section, Parameter::axial_stiffness)?;
    check(section)?;
    Ok(if names(section, &LOSSES) {
        InPlane { axial_stiffness, across: damped(section)? }.into()
    } else if names(section, &GENERAL) {
        InPlane { axial_stiffness, across: general(section)? }.into()
    } else {
        let bending_stiffness = needed(section, Parameter::bending_stiffness)?;
        let mass_per_length = needed(section, Parameter::mass_per_length)?;
        PlainSection { axial_stiffness, bending_stiffness, mass_per_length }.into()
    })
}

/// The parameters of a string.
const OF_STRING: [Parameter; 5] = [
    Parameter::axial_stiffness,
    Parameter::tension,
    Parameter::mass_per_length,
    Parameter::foundation_stiffness,
    Parameter::external_damping,
];

/// A string: without damping, or in a medium.
pub(super) enum Strings {
    Undamped(PathString<f64>),
    Damped(DampedString<f64>),
}

/// The string of a section across itself, and its axial stiffness.
pub(super) fn string(section: &Section) -> Result<(Strings, f64), Mistake> {
    if let Some(parameter) = section.named_beside(&OF_STRING) {
        return Err(Mistake::Foreign { element: "string", parameter });
    }
    let axial_stiffness = needed(section, Parameter::axial_stiffness)?;
    let length = 0.0;
    let tension = needed(section, Parameter::tension)?;
    let mass_per_length = needed(section, Parameter::mass_per_length)?;
    let foundation_stiffness = or_neutral(section, Parameter::foundation_stiffness);
    let string = match section.get(Parameter::external_damping) {
        None => Strings::Undamped(PathString { length, tension, mass_per_length, foundation_stiffness }),
        Some(external_damping) => {
            Strings::Damped(DampedString { length, tension, mass_per_length, foundation_stiffness, external_damping })
        }
    };
    Ok((string, axial_stiffness))
}

/// A string that stretches.
pub(super) fn stretching((string, axial_stiffness): (Strings, f64)) -> AnyMember<f64> {
    match string {
        Strings::Undamped(across) => InPlane { axial_stiffness, across }.into(),
        Strings::Damped(across) => InPlane { axial_stiffness, across }.into(),
    }
}

impl FrameElement<Line> for Section {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember::of(along_line(&self))
    }
}

impl FrameElement<Line> for CrossCoupledSpring<f64> {
    type Kind = OfSpring;

    fn member(self) -> FrameMember {
        FrameMember::known(self)
    }
}

impl FrameElement<Plane> for Section {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember::of(in_plane(&self))
    }
}

impl FrameElement<Plane> for TautString {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        let in_plane = |section: &Section| {
            refuse(section, &ELSEWHERE, "string in the plane")?;
            string(section).map(stretching)
        };
        FrameMember::of(in_plane(&self.0))
    }
}

impl FrameElement<Plane> for Bar {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember { released: Freedoms::RZ, ..FrameMember::of(in_plane(&self.0)) }
    }
}

/// Elements that are the same in all dimensions.
macro_rules! everywhere {
    ($($kind:ident: $($element:ident)*;)*) => {$($(
        impl<D: Dimension> FrameElement<D> for $element<f64> {
            type Kind = $kind;

            fn member(self) -> FrameMember {
                FrameMember::known(AnyMember::from(self))
            }
        }
    )*)*};
}
everywhere! {
    OfSpring: Spring TorsionSpring Damper TorsionDamper SpringDamper TorsionSpringDamper DampedSpring DampedTorsionSpring;
    OfLine: PathString Rod Shaft DampedString DampedRod DampedShaft;
}
