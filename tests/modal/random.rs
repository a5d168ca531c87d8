//! Random frames of the plane: what bounds and ranges are tried on.

use crate::numbers::Random;
use mstmm::elements::Spring;
use mstmm::frame::{Frame, Member, OfBeam, Plane, Point, PointMass, RigidBody, Section};
use mstmm::network::{Freedoms, Support};

/// A number up to a factor of 10 from another one, either way.
fn about(random: &mut Random, value: f64) -> f64 {
    value * 10.0_f64.powf(2.0 * random.unit() - 1.0)
}

/// A frame with its points and members.
pub(crate) struct RandomFrame {
    pub(crate) frame: Frame<Plane>,
    pub(crate) points: Vec<Point<Plane>>,
    pub(crate) members: Vec<Member<OfBeam>>,
}

/// The frame of a seed, each parameter at a share of a tolerance, from -1 for the soft and heavy end to 1 for the stiff and light one.
pub(crate) fn frame(seed: u64, tolerance: f64, share: impl FnMut() -> f64) -> RandomFrame {
    with_sections(seed, tolerance, share, |_, section| section)
}

/// The frame of a seed whose members have axial forces, in their order.
pub(crate) fn frame_under(seed: u64, forces: &[f64]) -> RandomFrame {
    with_sections(
        seed,
        0.0,
        || 0.0,
        |member, section| match forces[member] {
            0.0 => section,
            force => section.axial_force(force),
        },
    )
}

/// The frame of a seed, with what a function makes of the section of each member.
fn with_sections(
    seed: u64,
    tolerance: f64,
    mut share: impl FnMut() -> f64,
    section_of: impl Fn(usize, Section) -> Section,
) -> RandomFrame {
    let mut random = Random(seed);
    let mut up = |value: f64| value * (1.0 + tolerance * share());
    let mut frame = Frame::new();
    let count = 4 + random.below(3);
    let points: Vec<_> =
        (0..count).map(|k| frame.point([k as f64 + 0.6 * random.unit(), 2.0 * random.unit()])).collect();
    let mut members = Vec::new();
    for k in 1..count {
        let mut section = Section::new()
            .axial_stiffness(up(about(&mut random, 1e4)))
            .bending_stiffness(up(about(&mut random, 40.0)))
            .mass_per_length(1.0 / up(1.0 / about(&mut random, 1.0)));
        if random.chance(0.4) {
            section = section
                .shear_stiffness(up(about(&mut random, 3e3)))
                .rotary_inertia(1.0 / up(1.0 / about(&mut random, 0.01)));
        }
        members.push(frame.member(points[k - 1], points[k], section_of(members.len(), section)));
        if k > 1 && random.chance(0.5) {
            members.push(frame.member(points[k - 2], points[k], section_of(members.len(), section)));
        }
    }
    frame.hold(points[0], Support::Fixed);
    if random.chance(0.6) {
        let kind = if random.chance(0.5) { Support::Pinned } else { Support::Roller };
        frame.hold(points[count - 1], kind);
    }
    let middle = points[count / 2];
    if random.chance(0.5) {
        frame.body(
            [middle],
            PointMass {
                mass: 1.0 / up(1.0 / about(&mut random, 1.0)),
                inertia: 1.0 / up(1.0 / about(&mut random, 0.02)),
            },
        );
    } else {
        let (mass, inertia) = (1.0 / up(1.0 / about(&mut random, 1.0)), 1.0 / up(1.0 / about(&mut random, 0.05)));
        let centre = [count as f64 / 2.0 + random.unit(), 1.0];
        frame.body([middle], RigidBody { mass, inertia, centre });
    }
    if random.chance(0.5) {
        let along = [1.0, random.unit()];
        let stiffness = up(about(&mut random, 30.0));
        frame.member(points[0].along(along), points[count - 1].along(along), Spring { stiffness });
        if points.len() > 5 {
            frame.hold(points[1], Freedoms::RZ);
        }
    }
    RandomFrame { frame, points, members }
}
