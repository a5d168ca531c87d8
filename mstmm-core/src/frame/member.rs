//! Members of frames: which element a section or a connector is.

use crate::element::CarriesLoad;
use crate::elements::any_member::{AnyMember, Section as PlainSection};
use crate::elements::{
    DampedBeam, DampedRod, DampedShaft, DampedSpring, DampedString, DampedTorsionSpring, Damper, GeneralBeam,
    PlanarDampedBeam, PlanarGeneralBeam, Rod, Shaft, Spring, SpringDamper, TautString, TorsionDamper, TorsionSpring,
    TorsionSpringDamper,
};
use crate::frame::dimension::{Dimension, Line, Plane};
use crate::frame::error::Mistake;
use crate::frame::point::InFrame;
use crate::frame::section::{Parameter, Section, name_of};
use crate::model::MemberLabel;

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

/// What stands between two ends of a frame: an element, or why it is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMember {
    pub(crate) element: Result<AnyMember<f64>, Mistake>,
}

impl FrameMember {
    /// An element that is known.
    pub(crate) fn known(element: impl Into<AnyMember<f64>>) -> Self {
        FrameMember { element: Ok(element.into()) }
    }
}

/// An element that stands between two ends of a frame of a dimension.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not stand between two ends of a frame of dimension `{D}`",
    note = "a `Section` is a beam; `Spring`, `Damper`, `Hinge` and others stand there, too"
)]
pub trait FrameElement<D: Dimension> {
    /// The kind of its handle.
    type Kind;

    /// The element.
    #[doc(hidden)]
    fn member(self) -> FrameMember;
}

/// The parameters that select a general beam.
const GENERAL: [Parameter; 5] = [
    Parameter::shear_stiffness,
    Parameter::rotary_inertia,
    Parameter::axial_force,
    Parameter::foundation_stiffness,
    Parameter::foundation_shear_stiffness,
];

/// The parameters that select a damped beam.
const LOSSES: [Parameter; 3] = [Parameter::loss_factor, Parameter::kelvin_voigt_time, Parameter::external_damping];

/// A parameter that a beam needs.
fn needed(section: &Section, parameter: Parameter) -> Result<f64, Mistake> {
    section.get(parameter).ok_or(Mistake::Missing { parameter: name_of(parameter) })
}

/// The general beam of a section, without a length.
fn general(section: &Section) -> Result<GeneralBeam<f64>, Mistake> {
    let [shear, rotary_inertia, axial_force, foundation_stiffness, foundation_shear_stiffness] =
        GENERAL.map(|parameter| section.get(parameter));
    let shear = shear.unwrap_or(f64::INFINITY);
    // a negative or vanishing stiffness has no flexibility that could be checked
    if shear.is_nan() || shear <= 0.0 {
        return Err(Mistake::ShearStiffness { value: shear });
    }
    Ok(GeneralBeam {
        length: 0.0,
        bending_stiffness: needed(section, Parameter::bending_stiffness)?,
        mass_per_length: needed(section, Parameter::mass_per_length)?,
        shear_flexibility: 1.0 / shear,
        rotary_inertia: rotary_inertia.unwrap_or(0.0),
        axial_force: axial_force.unwrap_or(0.0),
        foundation_stiffness: foundation_stiffness.unwrap_or(0.0),
        foundation_shear_stiffness: foundation_shear_stiffness.unwrap_or(0.0),
    })
}

/// Whether a section names one of some parameters.
fn names(section: &Section, parameters: &[Parameter]) -> bool {
    parameters.iter().any(|parameter| section.get(*parameter).is_some())
}

/// The damping of a section.
fn losses(section: &Section) -> [f64; 3] {
    LOSSES.map(|parameter| section.get(parameter).unwrap_or(0.0))
}

/// The beam of a section along a line.
fn along_line(section: &Section) -> Result<AnyMember<f64>, Mistake> {
    if section.get(Parameter::axial_stiffness).is_some() {
        return Err(Mistake::AxialStiffness);
    }
    let beam = general(section)?;
    if !names(section, &LOSSES) {
        return Ok(beam.into());
    }
    let GeneralBeam { length, bending_stiffness, mass_per_length, .. } = beam;
    let GeneralBeam { shear_flexibility, rotary_inertia, axial_force, .. } = beam;
    let GeneralBeam { foundation_stiffness, foundation_shear_stiffness, .. } = beam;
    let [loss_factor, kelvin_voigt_time, external_damping] = losses(section);
    Ok(AnyMember::from(DampedBeam {
        length,
        bending_stiffness,
        mass_per_length,
        shear_flexibility,
        rotary_inertia,
        axial_force,
        foundation_stiffness,
        foundation_shear_stiffness,
        loss_factor,
        kelvin_voigt_time,
        external_damping,
    }))
}

/// The beam of a section in the plane.
fn in_plane(section: &Section) -> Result<AnyMember<f64>, Mistake> {
    let axial_stiffness = needed(section, Parameter::axial_stiffness)?;
    let beam = general(section)?;
    let GeneralBeam { length, bending_stiffness, mass_per_length, .. } = beam;
    let GeneralBeam { shear_flexibility, rotary_inertia, axial_force, .. } = beam;
    let GeneralBeam { foundation_stiffness, foundation_shear_stiffness, .. } = beam;
    if names(section, &LOSSES) {
        let [loss_factor, kelvin_voigt_time, external_damping] = losses(section);
        return Ok(AnyMember::from(PlanarDampedBeam {
            length,
            axial_stiffness,
            bending_stiffness,
            mass_per_length,
            shear_flexibility,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
            loss_factor,
            kelvin_voigt_time,
            external_damping,
        }));
    }
    if !names(section, &GENERAL) {
        return Ok(AnyMember::from(PlainSection { axial_stiffness, bending_stiffness, mass_per_length }));
    }
    Ok(AnyMember::from(PlanarGeneralBeam {
        length,
        axial_stiffness,
        bending_stiffness,
        mass_per_length,
        shear_flexibility,
        rotary_inertia,
        axial_force,
        foundation_stiffness,
        foundation_shear_stiffness,
    }))
}

impl FrameElement<Line> for Section {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember { element: along_line(&self) }
    }
}

impl FrameElement<Plane> for Section {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember { element: in_plane(&self) }
    }
}

/// Elements that are the same in all dimensions.
macro_rules! everywhere {
    ($($kind:ident: $($element:ident)*;)*) => {$($(
        impl<D: Dimension> FrameElement<D> for $element<f64> {
            type Kind = $kind;

            fn member(self) -> FrameMember {
                FrameMember::known(self)
            }
        }
    )*)*};
}
everywhere! {
    OfSpring: Spring TorsionSpring Damper TorsionDamper SpringDamper TorsionSpringDamper DampedSpring DampedTorsionSpring;
    OfLine: TautString Rod Shaft DampedString DampedRod DampedShaft;
}
