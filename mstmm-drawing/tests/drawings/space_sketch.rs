//! A sketch with three coordinates is drawn as the frame that it describes.

use crate::reading::{Picture, Shown};
use crate::space::beside;
use crate::space_frames::tube;
use mstmm::elements::Spring;
use mstmm::frame::{Bar, Frame, Ground, Hinge, RigidBody, Roller, Section, Tensor, Tie};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, View};
use std::path::Path;

system! {
    /// A portal with a machine on a mount, a tie, a revolute joint and a spring.
    pub(crate) struct Shed { height: f64, span: f64, depth: f64, mount: f64 }

    section steel {
        axial_stiffness: 4e8, torsional_stiffness: 4e5, bending_stiffness: 2e6, mass_per_length: 20.0, polar_inertia_per_length: 0.06,
    }

    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 0.0, height) -> beam 2 { ..steel } -> conn b at (span, 0.0, height)
        -> beam 3 { ..steel } -> conn c at (span, depth, height) <- beam 4 { ..steel } <- roller at (span, depth, 0.0) normal (0.0, 0.0, 1.0);
    conn a -> revolute_joint 5 { axis: (0.0, 1.0, 0.0) } -> beam 6 { ..steel } -> conn d at (0.0, depth, height)
        <- beam 7 { ..steel } <- fixed at (0.0, depth, 0.0);
    conn b -> bar 8 { axial_stiffness: 1e8, bending_stiffness: 1e4, mass_per_length: 3.0 } -> pinned at (span, depth, 0.2);
    conn c -> hinge 9 {
        stiffness_x: mount, stiffness_y: mount, stiffness_z: 3.0 * mount, stiffness_rx: 900.0, stiffness_ry: 900.0, stiffness_rz: 400.0,
    } -> rigid_body 10 { mass: 90.0, inertia: (3.0, 4.0, 5.0), centre: (span, depth, height + 0.3) };
    conn d <- along (0.6, 0.0, 0.8) <- spring 11 { stiffness: mount } <- fixed;
}

const SHED: Shed = Shed { height: 3.0, span: 4.0, depth: 2.5, mount: 2e5 };

/// The same as a frame, in the same order.
fn frame() -> mstmm::frame::Structure<mstmm::frame::Space> {
    let mut frame = Frame::new();
    let [foot, a, b, c, roller] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [4.0, 0.0, 3.0], [4.0, 2.5, 3.0], [4.0, 2.5, 0.0]]
        .map(|place| frame.point(place));
    let [behind, d, far, tied, machine] =
        [[0.0, 0.0, 3.0], [0.0, 2.5, 3.0], [0.0, 2.5, 0.0], [4.0, 2.5, 0.2], [4.0, 2.5, 3.0]]
            .map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.hold(far, Support::Fixed);
    frame.hold(roller, Roller::normal([0.0, 0.0, 1.0]));
    frame.hold(tied, Support::Pinned);
    for (from, to) in [(foot, a), (a, b), (b, c), (roller, c)] {
        frame.member(from, to, tube());
    }
    frame.member(a.along([0.0, 1.0, 0.0]), behind.along([0.0, 1.0, 0.0]), Tie::revolute());
    frame.member(behind, d, tube());
    frame.member(far, d, tube());
    frame.member(b, tied, Bar(Section::new().axial_stiffness(1e8).bending_stiffness(1e4).mass_per_length(3.0)));
    let mount = Hinge::new().stiffness_x(2e5).stiffness_y(2e5).stiffness_z(6e5);
    frame.member(c, machine, mount.stiffness_rx(900.0).stiffness_ry(900.0).stiffness_rz(400.0));
    frame.body(
        [machine],
        RigidBody { mass: 90.0, inertia: Tensor::principal([3.0, 4.0, 5.0]), centre: [4.0, 2.5, 3.3] },
    );
    frame.member(Ground, d.along([0.6, 0.0, 0.8]), Spring { stiffness: 2e5 });
    frame.build().unwrap()
}

/// The largest distance of a corner in one picture from what is drawn in another one, but for points, which have names in one of them alone.
fn apart(one: &[Shown], other: &[Shown]) -> f64 {
    let paths = |shown: &[Shown]| -> Vec<Vec<[f64; 2]>> {
        let parts = shown.iter().filter(|shown| shown.kind != "point");
        parts.flat_map(|shown| shown.lines(false)).map(|path| [&path[..], &path[..1]].concat()).collect()
    };
    let (one, other) = (paths(one), paths(other));
    assert!(!one.is_empty());
    let nearest = |corner: &[f64; 2]| other.iter().map(|path| beside(path, *corner)).fold(f64::INFINITY, f64::min);
    one.iter().flatten().map(nearest).fold(0.0, f64::max)
}

/// Asserts that two pictures show the same in groups of a class.
fn assert_alike(one: &Picture, other: &Picture, class: &str) {
    let (one, other) = (one.shown(class), other.shown(class));
    let apart = apart(&one, &other).max(apart(&other, &one));
    assert!(apart < 0.05, "{class}: {apart}");
}

#[test]
fn a_sketch_is_drawn_as_its_frame() {
    let (shed, frame) = (SHED.build().unwrap(), frame());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    std::fs::create_dir_all(&folder).unwrap();
    Drawing::of(&shed).unwrap().write(folder.join("space_shed.svg")).unwrap();
    for view in [View::isometric(), View::front(), View::of(20.0, 30.0)] {
        let one = Picture::of(Drawing::of(&shed).unwrap().view(view).unwrap());
        let other = Picture::of(Drawing::of(&frame).unwrap().view(view).unwrap());
        for class in ["model", "supports", "pins"] {
            assert_alike(&one, &other, class);
        }
        let labels = one.labels();
        for name in ["conn a", "conn d", "beam 6", "revolute_joint 5", "bar 8", "hinge 9", "rigid_body 10", "spring 11"]
        {
            assert_eq!(labels.iter().filter(|label| label.name == name).count(), 1, "{name}");
        }
    }
}

#[test]
fn a_mode_of_a_sketch_is_that_of_its_frame() {
    let (shed, frame) = (SHED.build().unwrap(), frame());
    let roots = shed.first_frequencies::<3>().unwrap();
    let others = frame.frequencies(3).unwrap();
    for (root, other) in roots.iter().zip(&others) {
        assert!((root.omega - other.omega).abs() < 1e-12 * root.omega);
        let one = Picture::of(Drawing::of(&shed).unwrap().mode(&shed.mode_shape(root).unwrap()).unwrap());
        let other = Picture::of(Drawing::of(&frame).unwrap().mode(&frame.mode_shape(other).unwrap()).unwrap());
        assert_alike(&one, &other, "still");
    }
}
