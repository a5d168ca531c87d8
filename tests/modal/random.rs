//! Random frames of the plane: what bounds and ranges are tried on.

use mstmm::elements::Spring;
use mstmm::frame::{Frame, Member, OfBeam, Plane, Point, PointMass, RigidBody, Section};
use mstmm::network::{Freedoms, Support};

/// A generator of numbers between 0 and 1.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number up to a factor of 10 from another one, either way.
    fn about(&mut self, value: f64) -> f64 {
        value * 10.0_f64.powf(2.0 * self.next() - 1.0)
    }
}

/// A frame with its points and members.
pub(crate) struct RandomFrame {
    pub(crate) frame: Frame<Plane>,
    pub(crate) points: Vec<Point<Plane>>,
    pub(crate) members: Vec<Member<OfBeam>>,
}

/// The frame of a seed, each parameter at a share of a tolerance, from -1 for the soft and heavy end to 1 for the stiff and light one.
pub(crate) fn frame(seed: u64, tolerance: f64, mut share: impl FnMut() -> f64) -> RandomFrame {
    let mut random = Random::new(seed);
    let mut up = |value: f64| value * (1.0 + tolerance * share());
    let mut frame = Frame::new();
    let count = 4 + (random.next() * 3.0) as usize;
    let points: Vec<_> =
        (0..count).map(|k| frame.point([k as f64 + 0.6 * random.next(), 2.0 * random.next()])).collect();
    let mut members = Vec::new();
    for k in 1..count {
        let mut section = Section::new()
            .axial_stiffness(up(random.about(1e4)))
            .bending_stiffness(up(random.about(40.0)))
            .mass_per_length(1.0 / up(1.0 / random.about(1.0)));
        if random.next() < 0.4 {
            section = section.shear_stiffness(up(random.about(3e3))).rotary_inertia(1.0 / up(1.0 / random.about(0.01)));
        }
        members.push(frame.member(points[k - 1], points[k], section));
        if k > 1 && random.next() < 0.5 {
            members.push(frame.member(points[k - 2], points[k], section));
        }
    }
    frame.hold(points[0], Support::Fixed);
    if random.next() < 0.6 {
        let kind = if random.next() < 0.5 { Support::Pinned } else { Support::Roller };
        frame.hold(points[count - 1], kind);
    }
    let middle = points[count / 2];
    if random.next() < 0.5 {
        frame.body(
            [middle],
            PointMass { mass: 1.0 / up(1.0 / random.about(1.0)), inertia: 1.0 / up(1.0 / random.about(0.02)) },
        );
    } else {
        let (mass, inertia) = (1.0 / up(1.0 / random.about(1.0)), 1.0 / up(1.0 / random.about(0.05)));
        let centre = [count as f64 / 2.0 + random.next(), 1.0];
        frame.body([middle], RigidBody { mass, inertia, centre });
    }
    if random.next() < 0.5 {
        let along = [1.0, random.next()];
        let stiffness = up(random.about(30.0));
        frame.member(points[0].along(along), points[count - 1].along(along), Spring { stiffness });
        if points.len() > 5 {
            frame.hold(points[1], Freedoms::RZ);
        }
    }
    RandomFrame { frame, points, members }
}
