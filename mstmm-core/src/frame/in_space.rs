//! Members of frames in space: the parts of a section.

use crate::elements::InPlane;
use crate::elements::any_member::{AnyMember, Section as PlainSection};
use crate::elements::sideways::Sideways;
use crate::elements::twist::{DampedTwist, Twist};
use crate::frame::dimension::Space;
use crate::frame::error::Mistake;
use crate::frame::member::{
    Bar, FrameElement, FrameMember, GENERAL, LOSSES, OfBeam, Strings, TautString, check, damped, general, names,
    needed, or_neutral, stretching, string,
};
use crate::frame::parts::Parts;
use crate::frame::section::{Parameter, Section, name_of};
use mstmm_plan::{Freedoms, HINGE_PARTS};

/// A parameter of both planes of a beam, with those of the plane of x and y and of the plane of x and z: of what is about an axis z and y.
struct Pair {
    both: Parameter,
    planes: [Parameter; 2],
}

/// The parameters that differ between both planes of a beam.
const PAIRS: [Pair; 5] = [
    Pair {
        both: Parameter::bending_stiffness,
        planes: [Parameter::bending_stiffness_z, Parameter::bending_stiffness_y],
    },
    Pair { both: Parameter::shear_stiffness, planes: [Parameter::shear_stiffness_y, Parameter::shear_stiffness_z] },
    Pair { both: Parameter::rotary_inertia, planes: [Parameter::rotary_inertia_z, Parameter::rotary_inertia_y] },
    Pair {
        both: Parameter::foundation_stiffness,
        planes: [Parameter::foundation_stiffness_y, Parameter::foundation_stiffness_z],
    },
    Pair {
        both: Parameter::foundation_shear_stiffness,
        planes: [Parameter::foundation_shear_stiffness_y, Parameter::foundation_shear_stiffness_z],
    },
];

/// The section of one of both planes, by the names that a beam in the plane has.
fn in_plane(section: &Section, plane: usize) -> Result<Section, Mistake> {
    let mut own = *section;
    for Pair { both, planes } in PAIRS {
        match (section.get(both), section.get(planes[plane])) {
            (Some(_), Some(_)) => return Err(Mistake::Twice { parameter: name_of(planes[plane]) }),
            (None, Some(value)) => own.set(both, value),
            _ => {}
        }
    }
    Ok(own)
}

/// What a parameter of a part of a beam was called in a section, or that of a part of a hinge.
pub(crate) fn called_in(named: u32, part: usize, parameter: &'static str) -> &'static str {
    if named == 0 {
        let of_hinge = HINGE_PARTS.into_iter().find(|(_, of, own)| *of == part && *own == parameter);
        return of_hinge.map_or(parameter, |(name, ..)| name);
    }
    let pair = PAIRS.into_iter().find(|pair| name_of(pair.both) == parameter);
    let of_plane = pair.and_then(|pair| pair.planes.get(part).copied()).filter(|own| named >> *own as u32 & 1 == 1);
    of_plane.map_or(parameter, name_of)
}

/// What a parameter of a member is called in a part of it; none where it is that of another part.
pub(crate) fn name_in(name: &str, part: usize) -> Option<&str> {
    if let Some((_, of, own)) = HINGE_PARTS.into_iter().find(|(of_hinge, ..)| *of_hinge == name) {
        return (of == part).then_some(own);
    }
    let mut of_planes = PAIRS.iter().flat_map(|pair| [(0, pair), (1, pair)]);
    match of_planes.find(|(plane, pair)| name_of(pair.planes[*plane]) == name) {
        Some((plane, pair)) => (plane == part).then_some(name_of(pair.both)),
        None => Some(name),
    }
}

/// A parameter that a beam in space needs.
fn needed_in_space(section: &Section, parameter: Parameter) -> Result<f64, Mistake> {
    section.get(parameter).ok_or(Mistake::MissingInSpace { parameter: name_of(parameter) })
}

/// The parts of a beam in space. A bar has no twist.
fn beam(section: &Section, twists: bool) -> Result<Parts, Mistake> {
    let planes = [in_plane(section, 0)?, in_plane(section, 1)?];
    if section.get(Parameter::speed).is_some() {
        return Err(Mistake::Foreign { element: "beam in space", parameter: name_of(Parameter::speed) });
    }
    let axial_stiffness = needed_in_space(section, Parameter::axial_stiffness)?;
    for (plane, own) in planes.iter().enumerate() {
        let [Pair { planes: bending, .. }, Pair { planes: shear, .. }, ..] = PAIRS;
        let named = bending.iter().any(|of_plane| section.get(*of_plane).is_some());
        if own.get(Parameter::bending_stiffness).is_none() {
            let parameter = name_of(if named { bending[plane] } else { Parameter::bending_stiffness });
            return Err(Mistake::MissingInSpace { parameter });
        }
        needed_in_space(own, Parameter::mass_per_length)?;
        check(own).map_err(|mistake| match mistake {
            Mistake::ShearStiffness { value, .. } if section.get(shear[plane]).is_some() => {
                Mistake::ShearStiffness { parameter: name_of(shear[plane]), value }
            }
            mistake => mistake,
        })?;
    }
    let [first, second] = &planes;
    let is_damped = names(section, &LOSSES);
    let first_part: AnyMember<f64> = if is_damped {
        InPlane { axial_stiffness, across: damped(first)? }.into()
    } else if names(first, &GENERAL) {
        InPlane { axial_stiffness, across: general(first)? }.into()
    } else {
        let bending_stiffness = needed(first, Parameter::bending_stiffness)?;
        let mass_per_length = needed(first, Parameter::mass_per_length)?;
        PlainSection { axial_stiffness, bending_stiffness, mass_per_length }.into()
    };
    let second_part: AnyMember<f64> = if is_damped { damped(second)?.into() } else { general(second)?.into() };
    let mut elements = [Some(first_part), Some(second_part), None];
    let of_twist = [Parameter::torsional_stiffness, Parameter::polar_inertia_per_length];
    if twists {
        let [torsional_stiffness, polar_inertia_per_length] =
            [needed_in_space(section, of_twist[0])?, needed_in_space(section, of_twist[1])?];
        let length = 0.0;
        let [loss_factor, kelvin_voigt_time] =
            [Parameter::loss_factor, Parameter::kelvin_voigt_time].map(|loss| or_neutral(section, loss));
        elements[2] = Some(if is_damped {
            DampedTwist { length, torsional_stiffness, polar_inertia_per_length, loss_factor, kelvin_voigt_time }.into()
        } else {
            Twist { length, torsional_stiffness, polar_inertia_per_length }.into()
        });
    } else if let Some(parameter) = of_twist.into_iter().find(|own| section.get(*own).is_some()) {
        return Err(Mistake::Foreign { element: "bar", parameter: name_of(parameter) });
    }
    let is_symmetric = PAIRS.iter().all(|pair| first.get(pair.both) == second.get(pair.both));
    Ok(Parts { up: section.z_axis(), is_symmetric, named: section.named(), ..Parts::of(elements) })
}

impl FrameElement<Space> for Section {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        FrameMember::of_parts(beam(&self, true))
    }
}

impl FrameElement<Space> for TautString {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        let parts = || {
            let second = match string(&self.0)?.0 {
                Strings::Undamped(across) => Sideways { across }.into(),
                Strings::Damped(across) => Sideways { across }.into(),
            };
            let elements = [Some(stretching(string(&self.0)?)), Some(second), None];
            Ok(Parts { up: self.0.z_axis(), is_symmetric: true, ..Parts::of(elements) })
        };
        FrameMember::of_parts(parts())
    }
}

impl FrameElement<Space> for Bar {
    type Kind = OfBeam;

    fn member(self) -> FrameMember {
        let released = Freedoms::RY.union(Freedoms::RZ);
        FrameMember { released, ..FrameMember::of_parts(beam(&self.0, false)) }
    }
}
