//! Whether one system is softer and heavier than another one, parameter by parameter.
//!
//! With the potential energy V and the kinetic energy T over ω² of the same motion, `ω_n² = min max V/T` over all spaces of n motions. Where a system has `V <= V'` and `T >= T'` for all
//! motions, each of its frequencies is at most that of the other one. V grows with stiffnesses, tensions and axial forces, T with masses and inertias; what acts both ways, as
//! places and lengths of beams do, has to be the same. For a whirl of a rotor the counts say the same: at each ω its dynamic stiffness `K - ω² M + ω G` is at most that of the other one
//! where G is, too: the gyroscopic moments, which grow with the speed forward and fall with it backward. There K has to be positive, as a search of the soft system finds.

use crate::element::{BeamNumbers, BodyNumbers, Exact, LineNumbers, MemberNumbers, SpinNumbers, TaperedNumbers};
use crate::model::{MemberPlane, Spot, ToleranceError};
use crate::number::double_double::DoubleDouble;
use crate::number::{Parameter, Scalar};
use crate::pass::characteristic::System;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visitor};
use mstmm_plan::{Freedoms, Space, Support};

/// Parts that are looked at in one visit of each system.
const AT_ONCE: usize = 16;
/// Roundings that a difference has to exceed, of a minor of two tensors or of two inertias about a mass centre: eight times the most that it has.
const ROUNDINGS: f64 = 64.0;

/// A part of a system.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Tip(usize, Support),
    Element(usize, usize, Space, MemberNumbers),
    /// With the number of its inputs, which follow.
    Connection(usize, usize, Option<Space>),
    Input(usize, usize),
    Root(usize, Support),
    /// Behind its ends.
    Member((usize, Freedoms, MemberPlane<Exact>), MemberNumbers),
    End(usize, MemberEnd),
    Body(NodeNumbers, Exact, [Exact; 6], [Exact; 3]),
}

/// Parts of a system from one on.
struct Parts {
    left: usize,
    parts: [Option<Part>; AT_ONCE],
    count: usize,
}

impl Parts {
    fn of<Y: System + ?Sized>(system: &Y, first: usize) -> Self {
        let mut parts = Parts { left: first, parts: [None; AT_ONCE], count: 0 };
        system.name_parts(&mut parts);
        parts
    }

    fn take(&mut self, part: Part) {
        if self.left > 0 {
            self.left -= 1;
        } else if self.count < AT_ONCE {
            self.parts[self.count] = Some(part);
            self.count += 1;
        }
    }
}

impl Visitor for Parts {
    fn tip(&mut self, step: usize, support: Support) {
        self.take(Part::Tip(step, support));
    }

    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers) {
        self.take(Part::Element(step, input, space, *numbers));
    }

    fn connection(&mut self, step: usize, inputs: &[usize], output: Option<Space>) {
        self.take(Part::Connection(step, inputs.len(), output));
        inputs.iter().for_each(|input| self.take(Part::Input(step, *input)));
    }

    fn root(&mut self, input: usize, support: Support) {
        self.take(Part::Root(input, support));
    }

    fn member(
        &mut self,
        member: (usize, Freedoms, MemberPlane<Exact>),
        numbers: &MemberNumbers,
        ends: &[MemberEnd; 2],
        _: usize,
    ) {
        // where it stands comes first: its length follows from that
        ends.iter().for_each(|end| self.take(Part::End(member.0, *end)));
        self.take(Part::Member(member, *numbers));
    }

    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: &[Exact; 6], centre: [Exact; 3]) {
        self.take(Part::Body(*node, mass, *inertia, centre));
    }

    fn leave(&mut self, _: usize) {}
}

/// Checks that a system is softer and heavier than another one, or as soft and as heavy, in each parameter.
///
/// # Errors
/// [`ToleranceError`] for the first parameter by which it is not.
pub(super) fn check_domination<Y: System + ?Sized>(soft: &Y, stiff: &Y) -> Result<(), ToleranceError> {
    for block in 0.. {
        let [one, other] = [soft, stiff].map(|system| Parts::of(system, AT_ONCE * block));
        for (one, other) in one.parts.iter().zip(&other.parts) {
            match (one, other) {
                (None, None) => return Ok(()),
                (Some(one), Some(other)) => check_part(soft, one, other)?,
                (Some(part), None) | (None, Some(part)) => {
                    return Err(ToleranceError::NotAlike { at: spot_of(soft, part) });
                }
            }
        }
    }
    Ok(())
}

/// Where a part is.
fn spot_of<Y: System + ?Sized>(system: &Y, part: &Part) -> Spot {
    system.spot_of(match part {
        Part::Tip(step, _) | Part::Element(step, ..) | Part::Connection(step, ..) | Part::Input(step, _) => *step,
        Part::Root(step, _) => *step,
        Part::Member((member, ..), _) | Part::End(member, _) => return system.spot_of_member(*member),
        Part::Body(node, ..) => node.index,
    })
}

fn check_part<Y: System + ?Sized>(system: &Y, soft: &Part, stiff: &Part) -> Result<(), ToleranceError> {
    let at = spot_of(system, soft);
    let ordered = match (soft, stiff) {
        (Part::Element(step, input, space, one), Part::Element(other_step, other_input, other_space, other))
            if (step, input, space) == (other_step, other_input, other_space) =>
        {
            by_numbers(one, other)
        }
        (Part::Member(member, one), Part::Member(twin, other)) if member == twin => by_numbers(one, other),
        (Part::Body(node, mass, inertia, centre), Part::Body(other, other_mass, other_inertia, other_centre))
            if node == other =>
        {
            by_body([*mass, *other_mass], [inertia, other_inertia], [centre, other_centre])
        }
        (one, other) if one == other => Ok(()),
        _ => return Err(ToleranceError::NotAlike { at }),
    };
    ordered.map_err(|wrong| match wrong {
        Wrong::Parameter(parameter, [soft, stiff]) => {
            let [soft, stiff] = [soft, stiff].map(|[hi, lo]| hi + lo);
            ToleranceError::NotOrdered { element: at, parameter, soft, stiff }
        }
        Wrong::Kind => ToleranceError::NotAlike { at },
        Wrong::Unknown => ToleranceError::NotKnown { at },
    })
}

/// Why a part is not softer than another one.
enum Wrong {
    Parameter(&'static str, [Exact; 2]),
    Kind,
    Unknown,
}

/// How a parameter acts on frequencies.
#[derive(Clone, Copy)]
enum Effect {
    /// They grow with it.
    Up,
    /// They fall with it.
    Down,
    /// It has to be the same.
    Same,
    /// It is looked at elsewhere.
    Any,
    /// They grow with it, and without it they are highest: of a shear stiffness zero is none, which is rigid.
    UpOrRigid,
}

/// Checks parameters, each with its effect and its values.
fn check(parameters: &[(&'static str, Effect, [Exact; 2])]) -> Result<(), Wrong> {
    for (name, effect, values @ [soft, stiff]) in parameters {
        let is_ordered = match effect {
            Effect::Up => at_most(*soft, *stiff),
            Effect::Down => at_most(*stiff, *soft),
            Effect::Same => soft == stiff,
            Effect::Any => true,
            Effect::UpOrRigid => *stiff == [0.0; 2] || *soft != [0.0; 2] && at_most(*soft, *stiff),
        };
        if !is_ordered {
            return Err(Wrong::Parameter(name, *values));
        }
    }
    Ok(())
}

/// Whether a sum of two words is at most another one; the second word is below the rounding of the first one.
fn at_most([hi, lo]: Exact, [other_hi, other_lo]: Exact) -> bool {
    hi < other_hi || hi == other_hi && lo <= other_lo
}

fn by_numbers(soft: &MemberNumbers, stiff: &MemberNumbers) -> Result<(), Wrong> {
    use MemberNumbers as N;
    match (soft, stiff) {
        (N::Beam(one), N::Beam(other)) => by_beam(one, other),
        (N::SpinningBeam(one, spin), N::SpinningBeam(other, other_spin)) => {
            by_spin(spin, other_spin).and_then(|()| by_beam(one, other))
        }
        (N::Gyroscope(one), N::Gyroscope(other)) => by_spin(one, other),
        (N::Disc(one, spin), N::Disc(other, other_spin)) => {
            by_spin(spin, other_spin).and_then(|()| by_rigid(one, other))
        }
        (N::Tapered(one), N::Tapered(other)) => by_tapered(one, other),
        (N::Line(freedom, one), N::Line(twin, other)) | (N::LineBetween(freedom, one), N::LineBetween(twin, other))
            if freedom == twin =>
        {
            by_line(one, other)
        }
        (N::String(one), N::String(other)) => one.iter().zip(other).try_for_each(|(one, other)| by_line(one, other)),
        (N::Spring(freedom, one), N::Spring(twin, other)) if freedom == twin => {
            check(&[("stiffness", Effect::Up, [*one, *other])])
        }
        (N::Joint(rigid, one), N::Joint(twin, other)) if rigid == twin => {
            one.iter().zip(other).try_for_each(|(one, other)| check(&[("stiffness", Effect::Up, [*one, *other])]))
        }
        (N::Body(one), N::Body(other)) => by_rigid(one, other),
        (N::Other, _) | (_, N::Other) => Err(Wrong::Unknown),
        _ => Err(Wrong::Kind),
    }
}

fn by_beam(soft: &BeamNumbers, stiff: &BeamNumbers) -> Result<(), Wrong> {
    check(&[
        ("length", Effect::Same, [soft.length, stiff.length]),
        ("bending_stiffness", Effect::Up, [soft.bending_stiffness, stiff.bending_stiffness]),
        ("mass_per_length", Effect::Down, [soft.mass_per_length, stiff.mass_per_length]),
        ("axial_stiffness", Effect::Up, [soft.axial_stiffness, stiff.axial_stiffness]),
        ("shear_stiffness", Effect::UpOrRigid, [soft.shear_stiffness, stiff.shear_stiffness]),
        ("rotary_inertia", Effect::Down, [soft.rotary_inertia, stiff.rotary_inertia]),
        ("axial_force", Effect::Up, [soft.axial_force, stiff.axial_force]),
        ("foundation_shear_stiffness", Effect::Up, [soft.shear_layer, stiff.shear_layer]),
        ("foundation_stiffness", Effect::Up, [soft.foundation_stiffness, stiff.foundation_stiffness]),
    ])
}

/// A gyroscopic moment is a speed, in the sense of the whirl, times a polar inertia. The inertia acts as the speed does in forward whirl, against it in backward whirl, and both ways
/// where speeds have both signs.
fn by_spin(soft: &SpinNumbers, stiff: &SpinNumbers) -> Result<(), Wrong> {
    let of_inertia = match [soft.speed[0], stiff.speed[0]] {
        [0.0, 0.0] => return Ok(()),
        speeds if speeds.iter().all(|speed| *speed >= 0.0) => Effect::Up,
        speeds if speeds.iter().all(|speed| *speed <= 0.0) => Effect::Down,
        _ => Effect::Same,
    };
    check(&[
        ("speed", Effect::Up, [soft.speed, stiff.speed]),
        ("polar_inertia", of_inertia, [soft.polar_inertia, stiff.polar_inertia]),
    ])
}

/// A longer line is softer and heavier, unless it has a foundation.
fn by_line(soft: &LineNumbers, stiff: &LineNumbers) -> Result<(), Wrong> {
    let is_alone = soft.foundation == [0.0; 2] && stiff.foundation == [0.0; 2];
    check(&[
        ("length", if is_alone { Effect::Down } else { Effect::Same }, [soft.length, stiff.length]),
        ("stiffness", Effect::Up, [soft.stiffness, stiff.stiffness]),
        ("inertia", Effect::Down, [soft.inertia, stiff.inertia]),
        ("foundation_stiffness", Effect::Up, [soft.foundation, stiff.foundation]),
    ])
}

/// The kinetic energy of a body is that of its mass in the mass centre and of its inertia about that. An inertia about the input holds a part of the mass, and is less than the other
/// one by more than that then.
fn by_rigid(soft: &BodyNumbers, stiff: &BodyNumbers) -> Result<(), Wrong> {
    if soft.is_central != stiff.is_central {
        return Err(Wrong::Kind);
    }
    let inertias = [soft.inertia, stiff.inertia];
    let holds_mass = !soft.is_central && soft.centre_x != [0.0; 2] && soft.mass != stiff.mass;
    if holds_mass && !falls_about_centre(soft, stiff) {
        return Err(Wrong::Parameter("inertia_about_input", inertias));
    }
    let of_inertia = if holds_mass { Effect::Any } else { Effect::Down };
    check(&[
        ("mass", Effect::Down, [soft.mass, stiff.mass]),
        ("inertia", of_inertia, inertias),
        ("centre_x", Effect::Same, [soft.centre_x, stiff.centre_x]),
        ("output_x", Effect::Same, [soft.output_x, stiff.output_x]),
        ("axial_force", Effect::Up, [soft.axial_force, stiff.axial_force]),
    ])
}

/// Whether the inertia about the mass centre, `J - m c²`, of one body is more than that of another one, beyond rounding: three of differences, squares and products each, of some
/// ε each.
fn falls_about_centre(soft: &BodyNumbers, stiff: &BodyNumbers) -> bool {
    let number = DoubleDouble::of_words;
    let [centre, heavy, light] = [soft.centre_x, soft.mass, stiff.mass].map(number);
    let [more, less] = [soft.inertia, stiff.inertia].map(number);
    let difference = (more - less) - (heavy - light) * (centre * centre);
    let size = more.abs() + less.abs() + (heavy.abs() + light.abs()) * (centre * centre);
    difference > size * DoubleDouble::from_f64(ROUNDINGS * DoubleDouble::EPSILON)
}

/// The mass of a blade that turns stiffens it, too.
fn by_tapered(soft: &TaperedNumbers, stiff: &TaperedNumbers) -> Result<(), Wrong> {
    let of_mass = if soft.rotation_speed == [0.0; 2] { Effect::Down } else { Effect::Same };
    check(&[
        ("length", Effect::Same, [soft.length, stiff.length]),
        ("bending_stiffness", Effect::Up, [soft.bending_stiffness, stiff.bending_stiffness]),
        ("mass_per_length", of_mass, [soft.mass_per_length, stiff.mass_per_length]),
        ("width_taper", Effect::Same, [soft.width_taper, stiff.width_taper]),
        ("height_taper", Effect::Same, [soft.height_taper, stiff.height_taper]),
        ("rotary_inertia", of_mass, [soft.rotary_inertia, stiff.rotary_inertia]),
        ("axial_force", Effect::Up, [soft.axial_force, stiff.axial_force]),
        ("axial_load", Effect::Up, [soft.axial_load, stiff.axial_load]),
        ("rotation_speed", Effect::Same, [soft.rotation_speed, stiff.rotation_speed]),
        ("hub_radius", Effect::Same, [soft.hub_radius, stiff.hub_radius]),
        ("setting_angle", Effect::Same, [soft.setting_angle, stiff.setting_angle]),
        ("foundation_stiffness", Effect::Up, [soft.foundation_stiffness, stiff.foundation_stiffness]),
    ])
}

fn by_body(
    [mass, other_mass]: [Exact; 2],
    [inertia, other_inertia]: [&[Exact; 6]; 2],
    [centre, other_centre]: [&[Exact; 3]; 2],
) -> Result<(), Wrong> {
    check(&[("mass", Effect::Down, [mass, other_mass])])?;
    centre.iter().zip(other_centre).try_for_each(|(one, other)| check(&[("centre", Effect::Same, [*one, *other])]))?;
    for (one, other) in inertia.iter().zip(other_inertia).take(3) {
        check(&[("inertia", Effect::Down, [*one, *other])])?;
    }
    if inertia[3..] == other_inertia[3..] || is_no_less(inertia, other_inertia) {
        return Ok(());
    }
    let off = (3..6).find(|entry| inertia[*entry] != other_inertia[*entry]).unwrap_or(3);
    Err(Wrong::Parameter("inertia", [inertia[off], other_inertia[off]]))
}

/// Whether the difference of two tensors xx, yy, zz, xy, yz, zx is definite beyond rounding: its leading minors are positive, Sylvester's criterion.
///
/// An entry of the difference has one rounding of itself, and where its second words count at most two of `ε²` of the tensors, which is nothing beside a diagonal of more than 64 ε of them.
/// A product of three entries has six roundings at most, a sum of five products two more.
fn is_no_less(soft: &[Exact; 6], stiff: &[Exact; 6]) -> bool {
    let [xx, yy, zz, xy, yz, zx]: [f64; 6] =
        core::array::from_fn(|entry| (soft[entry][0] - stiff[entry][0]) + (soft[entry][1] - stiff[entry][1]));
    let size = soft.iter().chain(stiff).fold(0.0, |sum, entry| sum + entry[0].abs());
    // each minor over the one before it is a pivot, which is beyond the rounding of the tensors, too
    let beyond = |terms: &[f64], before: f64| {
        let (sum, sizes) = terms.iter().fold((0.0, 0.0_f64), |(sum, sizes), term| (sum + term, sizes + term.abs()));
        (sum > ROUNDINGS * f64::EPSILON * sizes.max(size * before)).then_some(sum)
    };
    let volume = [xx * yy * zz, 2.0 * xy * yz * zx, -(xx * yz * yz), -(yy * zx * zx), -(zz * xy * xy)];
    let minors = beyond(&[xx], 1.0).and_then(|first| beyond(&[xx * yy, -(xy * xy)], first));
    minors.and_then(|second| beyond(&volume, second)).is_some()
}
