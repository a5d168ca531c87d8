//! Frames in space that are drawn: supports, joints and paths of all kinds.

use mstmm::elements::{Damper, Spring, TorsionSpring};
use mstmm::frame::{
    Bar, DampedStructure, Frame, Ground, Hinge, Hold, PointMass, RigidBody, RigidLink, Roller, Section, Space,
    Structure, TautString, Tensor, Tie,
};
use mstmm::network::{Freedoms, Support};

/// All rotations.
const ROTATIONS: Freedoms = Freedoms::RX.union(Freedoms::RY).union(Freedoms::RZ);

/// A tube of steel.
pub(crate) fn tube() -> Section {
    let steel = Section::new().axial_stiffness(4e8).torsional_stiffness(4e5).bending_stiffness(2e6);
    steel.mass_per_length(20.0).polar_inertia_per_length(0.06)
}

/// A row of columns below a beam, each on a support of another kind.
pub(crate) fn row() -> Structure<Space> {
    let holds: [Hold<Space>; 8] = [
        Support::Fixed.into(),
        Support::Pinned.into(),
        Roller::normal([0.0, 0.0, 1.0]).into(),
        Roller::along([1.0, 0.0, 0.0]).into(),
        Roller::normal([0.0, 0.6, 0.8]).without_rotation().into(),
        Roller::along([0.0, 1.0, 0.0]).without_rotation().into(),
        ROTATIONS.into(),
        Freedoms::X.into(),
    ];
    let mut frame = Frame::new();
    let mut last = None;
    for (k, hold) in holds.into_iter().enumerate() {
        let x = 1.5 * k as f64;
        let [foot, head] = [0.0, 2.0].map(|z| frame.point([x, 0.0, z]));
        frame.member(foot, head, tube());
        frame.hold(foot, hold);
        if let Some(last) = last.replace(head) {
            frame.member(last, head, tube());
        }
    }
    frame.build().unwrap()
}

/// A chain of beams with a joint of another kind between each two.
pub(crate) fn joints() -> Structure<Space> {
    let mut frame = Frame::new();
    let ties =
        [Tie::ball(), Tie::universal(), Tie::revolute(), Tie::prismatic(), Tie::cylindrical(), Tie::of(ROTATIONS)];
    let start = frame.point([0.0, 0.0, 0.0]);
    frame.hold(start, Support::Fixed);
    let mut last = start;
    for (k, tie) in ties.into_iter().enumerate() {
        let place = [1.2 * (k + 1) as f64, 0.4 * (k % 2) as f64, 0.0];
        let [end, next] = [frame.point(place), frame.point(place)];
        frame.member(last, end, tube());
        frame.member(end, next, tie);
        let ground = frame.point([place[0], place[1], -1.0]);
        frame.member(ground, next, tube().up([1.0, 0.0, 0.0]));
        frame.hold(ground, Support::Fixed);
        last = next;
    }
    let tip = frame.point([9.0, 0.0, 0.5]);
    frame.member(last, tip.releasing(Freedoms::RY), tube());
    let far = frame.point([9.0, 1.5, 0.5]);
    frame.member(tip, far.releasing(Freedoms::RY.union(Freedoms::RZ)), tube());
    frame.hold(far, Support::Fixed);
    frame.build().unwrap()
}

/// A mast with guys, a crossing pair of bars, a body on two points, and a mass on a spring.
pub(crate) fn mast() -> Structure<Space> {
    let mut frame = Frame::new();
    let [foot, middle, top] = [0.0, 2.0, 4.0].map(|z| frame.point([0.0, 0.0, z]));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, middle, tube());
    frame.member(middle, top, tube());
    for [x, y] in [[2.0, 0.0], [-1.0, 1.8], [-1.0, -1.8]] {
        let anchor = frame.point([x, y, 0.0]);
        frame.hold(anchor, Support::Pinned);
        frame.member(anchor, top, TautString(Section::new().tension(2e4).axial_stiffness(1e7).mass_per_length(1.0)));
        frame.member(
            anchor,
            middle,
            Bar(Section::new().axial_stiffness(1e8).bending_stiffness(1e4).mass_per_length(3.0)),
        );
    }
    let [left, right] = [-0.7, 0.7].map(|y| frame.point([0.8, y, 4.2]));
    frame.member(top, left, tube());
    frame.member(top, right, tube());
    frame.body([left, right], RigidBody { mass: 40.0, inertia: Tensor::of_sphere(2.0), centre: [1.1, 0.0, 4.4] });
    let tip = frame.point([-1.4, 0.0, 4.0]);
    frame.member(top, tip, tube());
    frame.body([tip], PointMass { mass: 10.0, inertia: Tensor::of_sphere(0.1) });
    let hanging = frame.path_point();
    frame.member(tip.along([0.0, 0.0, 1.0]), hanging, Spring { stiffness: 2e4 });
    frame.mass(hanging, 15.0);
    frame.member(middle.about([0.0, 0.0, 1.0]), Ground, TorsionSpring { stiffness: 1e4 });
    frame.build().unwrap()
}

/// A damped platform: a plate on a spring, a damper and bushings, with a link beside it.
pub(crate) fn platform() -> DampedStructure<Space> {
    let mut frame = Frame::new();
    let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]].map(|[x, y]| frame.point([x, y, 1.0]));
    frame.body(
        corners,
        RigidBody { mass: 300.0, inertia: Tensor::principal([90.0, 160.0, 240.0]), centre: [1.5, 1.0, 1.2] },
    );
    for (k, corner) in corners.into_iter().enumerate() {
        let [x, y] = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]][k];
        let foot = frame.point([x, y, 0.0]);
        frame.hold(foot, Support::Fixed);
        frame.member(foot, corner, Spring { stiffness: 4e4 + 1e3 * k as f64 });
        frame.member(corner.along([0.6, 0.8, 0.0]), Ground, Damper { damping: 300.0 });
    }
    let [seat, base] = [[1.5, 1.0, 1.0]; 2].map(|place| frame.point(place));
    frame.body([corners[0], seat], RigidLink);
    let mount = Hinge::new().stiffness_x(2e4).stiffness_y(2e4).stiffness_z(6e4).damping_z(50.0);
    let mount = mount.stiffness_rx(900.0).stiffness_ry(900.0).stiffness_rz(400.0);
    frame.member(seat, base, mount);
    frame.hold(base, Support::Fixed);
    frame.build_damped().unwrap()
}
