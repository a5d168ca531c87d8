//! Small models of one thing each, beside frames.

use super::{assert_near, proven};
use mstmm::elements::Spring;
use mstmm::frame::{Bar, End, Frame, Ground, Hinge, Point, RigidBody, Roller, Section, Space, Tensor, Tie};
use mstmm::network::Support;
use mstmm::prelude::*;

/// What all members of the models below have.
const STEEL: Section = Section::new()
    .axial_stiffness(900.0)
    .torsional_stiffness(3.0)
    .bending_stiffness_y(2.0)
    .bending_stiffness_z(5.0)
    .mass_per_length(1.5)
    .polar_inertia_per_length(0.25);

/// A frame of points, the members between some of them, and a support of the first.
fn arch(places: &[[f64; 3]], members: &[[usize; 2]]) -> (Frame<Space>, Vec<Point<Space>>) {
    let mut frame = Frame::new();
    let points: Vec<_> = places.iter().map(|place| frame.point(*place)).collect();
    frame.hold(points[0], Support::Fixed);
    for ends in members {
        frame.member(points[ends[0]], points[ends[1]], STEEL);
    }
    (frame, points)
}

#[track_caller]
fn assert_same<Y: NaturalFrequencies<Parameter = f64> + mstmm::search::Undamped>(sketch: &Y, frame: &Frame<Space>) {
    assert_near(&proven::<10, _>(sketch), &proven::<10, _>(&frame.build().unwrap()), 1e-14);
}

macro_rules! arch {
    ($name:ident($l:ident): $($rest:tt)*) => {
        system! {
            pub(super) struct $name { pub(super) $l: f64 }
            section steel {
                axial_stiffness: 900.0, torsional_stiffness: 3.0, bending_stiffness_y: 2.0, bending_stiffness_z: 5.0,
                mass_per_length: 1.5, polar_inertia_per_length: 0.25,
            }
            $($rest)*
        }
    };
}

arch! { Cantilever(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn tip at (l, 0.5, 0.25); }

#[test]
fn a_cantilever() {
    assert_same(&Cantilever { l: 2.0 }.build().unwrap(), &arch(&[[0.0; 3], [2.0, 0.5, 0.25]], &[[0, 1]]).0);
}

arch! { Rolling(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> roller at (l, 0.5, 0.25) normal (1.0, 2.0, 3.0); }

#[test]
fn a_roller_across() {
    let (mut frame, points) = arch(&[[0.0; 3], [2.0, 0.5, 0.25]], &[[0, 1]]);
    frame.hold(points[1], Roller::normal([1.0, 2.0, 3.0]));
    assert_same(&Rolling { l: 2.0 }.build().unwrap(), &frame);
}

arch! { RollingAlong(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> roller at (l, 0.5, 0.25) along (1.0, 2.0, 3.0); }

#[test]
fn a_roller_along() {
    let (mut frame, points) = arch(&[[0.0; 3], [2.0, 0.5, 0.25]], &[[0, 1]]);
    frame.hold(points[1], Roller::along([1.0, 2.0, 3.0]));
    assert_same(&RollingAlong { l: 2.0 }.build().unwrap(), &frame);
}

arch! { Upside(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, up: (1.0, 0.25, 0.0) } -> conn a at (0.0, 0.0, l) -> beam 2 { ..steel } -> conn b at (1.0, 1.0, l); }

#[test]
fn up() {
    let (mut frame, points) = arch(&[[0.0; 3], [0.0, 0.0, 2.0], [1.0, 1.0, 2.0]], &[[1, 2]]);
    frame.member(points[0], points[1], STEEL.up([1.0, 0.25, 0.0]));
    assert_same(&Upside { l: 2.0 }.build().unwrap(), &frame);
}

arch! { Turning(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25) -> revolute_joint 2 { axis: (1.0, 2.0, 0.0) }
-> beam 3 { ..steel } -> fixed at (3.0, 3.0, 3.0); }

#[test]
fn a_revolute_joint() {
    let places = [[0.0; 3], [2.0, 0.5, 0.25], [2.0, 0.5, 0.25], [3.0, 3.0, 3.0]];
    let (mut frame, points) = arch(&places, &[[0, 1], [2, 3]]);
    frame.hold(points[3], Support::Fixed);
    let axis = |point: Point<Space>| -> End<Space> { point.along([1.0, 2.0, 0.0]) };
    frame.member(axis(points[1]), axis(points[2]), Tie::revolute());
    assert_same(&Turning { l: 2.0 }.build().unwrap(), &frame);
}

arch! { Bracing(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25)
-> bar 3 { axial_stiffness: 900.0, bending_stiffness_y: 2.0, bending_stiffness_z: 5.0, mass_per_length: 1.5 } -> pinned at (3.0, 3.0, 3.0); }

#[test]
fn a_bar() {
    let places = [[0.0; 3], [2.0, 0.5, 0.25], [3.0, 3.0, 3.0]];
    let (mut frame, points) = arch(&places, &[[0, 1]]);
    frame.hold(points[2], Support::Pinned);
    let tie = Section::new().axial_stiffness(900.0).bending_stiffness_y(2.0).bending_stiffness_z(5.0);
    frame.member(points[1], points[2], Bar(tie.mass_per_length(1.5)));
    assert_same(&Bracing { l: 2.0 }.build().unwrap(), &frame);
}

arch! { OnMount(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25)
-> hinge 2 { stiffness_x: 1.0, stiffness_y: 2.0, stiffness_z: 3.0, stiffness_rx: 4.0, stiffness_ry: 5.0, stiffness_rz: 6.0 }
-> rigid_body 3 { mass: 2.0, inertia: (3.0, 4.0, 5.0, 0.1, 0.0, -0.2), centre: (l, 0.5, 1.0) }; }

#[test]
fn a_body_on_a_mount() {
    let places = [[0.0; 3], [2.0, 0.5, 0.25], [2.0, 0.5, 0.25]];
    let (mut frame, points) = arch(&places, &[[0, 1]]);
    let mount = Hinge::new().stiffness_x(1.0).stiffness_y(2.0).stiffness_z(3.0);
    frame.member(points[1], points[2], mount.stiffness_rx(4.0).stiffness_ry(5.0).stiffness_rz(6.0));
    let inertia = Tensor::new([3.0, 4.0, 5.0, 0.1, 0.0, -0.2]);
    frame.body([points[2]], RigidBody { mass: 2.0, inertia, centre: [2.0, 0.5, 1.0] });
    assert_same(&OnMount { l: 2.0 }.build().unwrap(), &frame);
}

arch! { Sprung(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25) <- along (0.6, 0.0, 0.8) <- spring 11 { stiffness: 7.0 } <- fixed; }

#[test]
fn a_spring_along_a_direction() {
    let (mut frame, points) = arch(&[[0.0; 3], [2.0, 0.5, 0.25]], &[[0, 1]]);
    frame.member(Ground, points[1].along([0.6, 0.0, 0.8]), Spring { stiffness: 7.0 });
    assert_same(&Sprung { l: 2.0 }.build().unwrap(), &frame);
}

macro_rules! mounted {
    ($($name:ident, $test:ident, $($parameter:ident),*;)*) => { $(
        arch! { $name(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25)
            -> hinge 2 { $($parameter: 1.0),* } -> beam 3 { ..steel } -> fixed at (3.0, 3.0, 3.0); }

        #[test]
        fn $test() {
            let places = [[0.0; 3], [2.0, 0.5, 0.25], [2.0, 0.5, 0.25], [3.0, 3.0, 3.0]];
            let (mut frame, points) = arch(&places, &[[0, 1], [2, 3]]);
            frame.hold(points[3], Support::Fixed);
            frame.member(points[1], points[2], Hinge::new()$(.$parameter(1.0))*);
            assert_same(&$name { l: 2.0 }.build().unwrap(), &frame);
        }
    )* };
}

mounted! {
    FlexibleX, a_hinge_along_x, stiffness_x;
    FlexibleY, a_hinge_along_y, stiffness_y;
    FlexibleZ, a_hinge_along_z, stiffness_z;
    FlexibleRx, a_hinge_about_x, stiffness_rx;
    FlexibleRy, a_hinge_about_y, stiffness_ry;
    FlexibleRz, a_hinge_about_z, stiffness_rz;
    Flexible, a_hinge_of_six, stiffness_x, stiffness_y, stiffness_z, stiffness_rx, stiffness_ry, stiffness_rz;
}

arch! { Bodied(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25)
-> rigid_body 3 { mass: 2.0, inertia: (3.0, 4.0, 5.0, 0.1, 0.0, -0.2), centre: (l, 0.5, 1.0) }; }

#[test]
fn a_body() {
    let places = [[0.0; 3], [2.0, 0.5, 0.25]];
    let (mut frame, points) = arch(&places, &[[0, 1]]);
    let inertia = Tensor::new([3.0, 4.0, 5.0, 0.1, 0.0, -0.2]);
    frame.body([points[1]], RigidBody { mass: 2.0, inertia, centre: [2.0, 0.5, 1.0] });
    assert_same(&Bodied { l: 2.0 }.build().unwrap(), &frame);
}

macro_rules! jointed {
    ($($name:ident, $test:ident, { $($joint:tt)* }, $axis:expr, $tie:expr;)*) => { $(
        arch! { $name(l): fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.5, 0.25)
            -> $($joint)* -> beam 3 { ..steel } -> fixed at (3.0, 3.0, 3.0); }

        #[test]
        fn $test() {
            let places = [[0.0; 3], [2.0, 0.5, 0.25], [2.0, 0.5, 0.25], [3.0, 3.0, 3.0]];
            let (mut frame, points) = arch(&places, &[[0, 1], [2, 3]]);
            frame.hold(points[3], Support::Fixed);
            let along = |point: Point<Space>| point.along($axis);
            frame.member(along(points[1]), along(points[2]), $tie);
            assert_same(&$name { l: 2.0 }.build().unwrap(), &frame);
        }
    )* };
}

jointed! {
    Ball, a_ball_joint, { ball_joint 2 {} }, [1.0, 0.0, 0.0], Tie::ball();
    Universal, a_universal_joint, { universal_joint 2 { axis: (1.0, 1.0, 2.0) } }, [1.0, 1.0, 2.0], Tie::universal();
    Prismatic, a_prismatic_joint, { prismatic_joint 2 { axis: (1.0, 1.0, 2.0) } }, [1.0, 1.0, 2.0], Tie::prismatic();
    Cylindrical, a_cylindrical_joint, { cylindrical_joint 2 { axis: (1.0, 1.0, 2.0) } }, [1.0, 1.0, 2.0], Tie::cylindrical();
    SkewX, a_skew_hinge_along_x, { hinge 2 { axis: (1.0, 1.0, 2.0), stiffness_x: 1.0 } }, [1.0, 1.0, 2.0], Hinge::new().stiffness_x(1.0);
    SkewRx, a_skew_hinge_about_x, { hinge 2 { axis: (1.0, 1.0, 2.0), stiffness_rx: 1.0 } }, [1.0, 1.0, 2.0], Hinge::new().stiffness_rx(1.0);
    LooseRx, a_skew_hinge_that_lets_go, { hinge 2 { axis: (1.0, 1.0, 2.0), stiffness_rx: 0.0 } }, [1.0, 1.0, 2.0], Hinge::new().stiffness_rx(0.0);
    SkewRz, a_skew_hinge_about_z, { hinge 2 { axis: (1.0, 1.0, 2.0), stiffness_rz: 1.0 } }, [1.0, 1.0, 2.0], Hinge::new().stiffness_rz(1.0);
}

arch! { EachPlane(l): fixed at (0.0, 0.0, 0.0) -> beam 1 {
    ..steel, shear_stiffness_y: 20.0, shear_stiffness_z: 45.0, rotary_inertia_y: 0.125, rotary_inertia_z: 0.5,
    foundation_stiffness_y: 3.0, foundation_stiffness_z: 0.75, foundation_shear_stiffness_y: 0.25, foundation_shear_stiffness_z: 1.5,
    axial_force: 0.5, up: (0.0, 1.0, 2.0),
} -> conn a at (l, 0.5, 0.25); }

/// What is named for one plane is that of this plane.
#[test]
fn a_general_beam_with_other_numbers_in_each_plane() {
    let (mut frame, points) = arch(&[[0.0; 3], [2.0, 0.5, 0.25]], &[]);
    let section = STEEL.shear_stiffness_y(20.0).shear_stiffness_z(45.0).rotary_inertia_y(0.125).rotary_inertia_z(0.5);
    let section = section.foundation_stiffness_y(3.0).foundation_stiffness_z(0.75).foundation_shear_stiffness_y(0.25);
    let section = section.foundation_shear_stiffness_z(1.5).axial_force(0.5).up([0.0, 1.0, 2.0]);
    frame.member(points[0], points[1], section);
    assert_same(&EachPlane { l: 2.0 }.build().unwrap(), &frame);
}
