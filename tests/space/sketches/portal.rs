//! A portal with a braced side, joints, a machine on a mount, springs along and about directions.

use super::{assert_near, proven};
use mstmm::elements::Spring;
use mstmm::frame::{Bar, Frame, Ground, Hinge, RigidBody, Roller, Section, Space, Tensor, Tie};
use mstmm::network::Support;
use mstmm::prelude::*;

system! {
    /// Space portal with a braced side and a machine on a mount.
    pub(super) struct Portal { height: f64, span: f64, depth: f64, e: f64, g: f64, rho: f64, machine: f64, mount: f64 }

    let area = 3.5e-3;
    let i = 5.3e-6;
    let j = 1.06e-5;
    section steel {
        axial_stiffness: e * area, torsional_stiffness: g * j, bending_stiffness: e * i, mass_per_length: rho * area,
        polar_inertia_per_length: 2.0 * rho * i,
    }
    section tie { axial_stiffness: e * 1e-4, bending_stiffness: 120.0, mass_per_length: 0.8 }

    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 0.0, height) -> beam 2 { ..steel } -> conn b at (span, 0.0, height)
        -> beam 3 { ..steel } -> conn c at (span, depth, height) <- beam 4 { ..steel } <- roller at (span, depth, 0.0) normal (0.0, 0.0, 1.0);
    conn a -> revolute_joint 5 { axis: (1.0, 0.0, 0.0) } -> beam 6 { ..steel } -> conn d at (0.0, depth, height)
        <- beam 7 { ..steel } <- fixed at (0.0, depth, 0.0);
    conn b -> bar 8 { ..tie } -> pinned at (span, depth, 0.2);
    conn c -> hinge 9 {
        stiffness_x: mount, stiffness_y: mount, stiffness_z: 3.0 * mount, stiffness_rx: 900.0, stiffness_ry: 900.0, stiffness_rz: 400.0,
    } -> rigid_body 10 { mass: machine, inertia: (3.0, 4.0, 5.0, 0.1, 0.0, -0.2), centre: (span, depth, height + 0.3) };
    conn d <- along (0.6, 0.0, 0.8) <- spring 11 { stiffness: mount } <- fixed;
}

pub(super) const PORTAL: Portal =
    Portal { height: 3.0, span: 4.0, depth: 2.5, e: 2.1e11, g: 8.1e10, rho: 7850.0, machine: 120.0, mount: 4e5 };

pub(super) fn frame(model: &Portal) -> Frame<Space> {
    let &Portal { height, span, depth, e, g, rho, machine, mount } = model;
    let (area, i, j) = (3.5e-3, 5.3e-6, 1.06e-5);
    let steel = Section::new()
        .axial_stiffness(e * area)
        .torsional_stiffness(g * j)
        .bending_stiffness(e * i)
        .mass_per_length(rho * area)
        .polar_inertia_per_length(2.0 * rho * i);
    let tie = Bar(Section::new().axial_stiffness(e * 1e-4).bending_stiffness(120.0).mass_per_length(0.8));
    let mut frame = Frame::new();
    let mut point = |place| frame.point(place);
    let [first, a, b, c] = [[0.0; 3], [0.0, 0.0, height], [span, 0.0, height], [span, depth, height]].map(&mut point);
    let [rolling, behind, d] = [[span, depth, 0.0], [0.0, 0.0, height], [0.0, depth, height]].map(&mut point);
    let [last, foot, on_mount] = [[0.0, depth, 0.0], [span, depth, 0.2], [span, depth, height]].map(&mut point);
    frame.hold(first, Support::Fixed);
    frame.hold(rolling, Roller::normal([0.0, 0.0, 1.0]));
    frame.hold(last, Support::Fixed);
    frame.hold(foot, Support::Pinned);
    for ends in [[first, a], [a, b], [b, c], [rolling, c], [behind, d], [last, d]] {
        frame.member(ends[0], ends[1], steel);
    }
    frame.member(a.along([1.0, 0.0, 0.0]), behind.along([1.0, 0.0, 0.0]), Tie::revolute());
    frame.member(b, foot, tie);
    let mounting = Hinge::new().stiffness_x(mount).stiffness_y(mount).stiffness_z(3.0 * mount);
    frame.member(c, on_mount, mounting.stiffness_rx(900.0).stiffness_ry(900.0).stiffness_rz(400.0));
    let inertia = Tensor::new([3.0, 4.0, 5.0, 0.1, 0.0, -0.2]);
    frame.body([on_mount], RigidBody { mass: machine, inertia, centre: [span, depth, height + 0.3] });
    frame.member(Ground, d.along([0.6, 0.0, 0.8]), Spring { stiffness: mount });
    frame
}

#[test]
fn the_portal_has_the_frequencies_of_its_frame() {
    let found = proven::<12, _>(&PORTAL.build().unwrap());
    assert_near(&found, &proven::<12, _>(&frame(&PORTAL).build().unwrap()), 1e-14);
}
