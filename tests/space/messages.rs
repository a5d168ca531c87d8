//! What is wrong with frames in space is said at once, by names.

use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{Bar, Frame, Ground, Hinge, Pin, RigidBody, RigidLink, Roller, Section, Space, Tensor, Tie};
use mstmm::motion::MotionError;
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;

const STEEL: Section = Section::new()
    .axial_stiffness(4e6)
    .bending_stiffness_y(3e4)
    .bending_stiffness_z(1e4)
    .torsional_stiffness(2e4)
    .mass_per_length(20.0)
    .polar_inertia_per_length(0.5);

/// What `build` says of a cantilever with something else.
fn said(change: impl Fn(&mut Frame<Space>, [mstmm::frame::Point<Space>; 3])) -> String {
    let mut frame = Frame::new();
    let points = [[0.0; 3], [2.0, 0.0, 0.0], [2.0, 1.0, 0.5]].map(|place| frame.point(place));
    frame.hold(points[0], Support::Fixed);
    frame.member(points[0], points[1], STEEL);
    frame.member(points[1], points[2], STEEL);
    change(&mut frame, points);
    frame.build().map_or_else(|errors| errors.to_string(), |_| "built".into())
}

#[test]
fn mistakes_in_space_are_said_by_names() {
    assert_eq!(said(|_, _| ()), "built");
    let plain = Section::new().axial_stiffness(4e6).bending_stiffness(1e4).mass_per_length(20.0);
    let start = "member 2: `torsional_stiffness` is missing: a beam in space stretches and bends both ways";
    assert!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, plain)).starts_with(start));
    let both = STEEL.bending_stiffness(1e4);
    let start = "member 2: `bending_stiffness_z` is named, and that without an index";
    assert!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, both)).starts_with(start));
    let negative = STEEL.bending_stiffness_y(-3e4);
    let start = "member 2: bending_stiffness_y is -30000, but must be positive";
    assert!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, negative)).starts_with(start));
    let start = "member 2: a bar has no `torsional_stiffness`";
    assert_eq!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, Bar(STEEL))), start);
    let one = Section::new().axial_stiffness(4e6).bending_stiffness_y(1e4).mass_per_length(20.0);
    let start = "member 2: `bending_stiffness_z` is missing";
    assert!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, one)).starts_with(start));
    let start = "member 2: shear_stiffness_z is -3, but must be positive";
    assert_eq!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, STEEL.shear_stiffness_z(-3.0))), start);
    let start = "member 2: its `up` is zero, not finite or beyond 1e±70";
    assert_eq!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, STEEL.up([0.0; 3]))), start);
    let start = "member 2: both ends are at one place";
    assert!(said(|frame, [_, tip, _]| _ = frame.member(tip, tip, STEEL)).starts_with(start));
    let along = STEEL.up([2.0, 1.0, 0.5]);
    let start = "member 2: it leads along its `up`, which is [0, 0, 1] unless it is named, and both its planes differ";
    assert!(said(|frame, [foot, _, far]| _ = frame.member(foot, far, along)).starts_with(start));
}

#[test]
fn directions_and_axes_in_space_are_asked_for() {
    let (spring, torsion) = (Spring { stiffness: 1.0 }, TorsionSpring { stiffness: 1.0 });
    let start = "member 2: it acts on a point in no direction";
    assert!(said(|frame, [_, tip, _]| _ = frame.member(tip, Ground, spring)).starts_with(start));
    let start = "member 2: it turns about no axis: `point.about([x, y, z])`";
    assert_eq!(said(|frame, [_, tip, _]| _ = frame.member(tip, Ground, torsion)), start);
    let start = "member 2: springs and dampers act `along` a direction, and torsion springs, torsion dampers and shafts `about` an axis";
    let x = [1.0, 0.0, 0.0];
    assert_eq!(said(|frame, [_, tip, _]| _ = frame.member(tip.about(x), Ground, spring)), start);
    assert_eq!(said(|frame, [_, tip, _]| _ = frame.member(tip.along(x), Ground, torsion)), start);
    let start = "member 2: its direction is zero, not finite";
    assert!(said(|frame, [_, tip, _]| _ = frame.member(tip.along([0.0; 3]), Ground, spring)).starts_with(start));
    let start = "point 1: a roller or a guide in space says which way";
    assert!(said(|frame, [_, tip, _]| frame.hold(tip, Support::Roller)).starts_with(start));
    let start = "point 1: its direction is zero";
    assert!(said(|frame, [_, tip, _]| frame.hold(tip, Roller::normal([0.0; 3]))).starts_with(start));
}

#[test]
fn joints_and_bodies_in_space_are_checked() {
    let start = "member 2: the ends of a joint are at one place";
    assert!(said(|frame, [_, tip, far]| _ = frame.member(tip, far, Pin)).starts_with(start));
    let start = "member 2: it lets nothing go and would be rigid";
    let at_one_place = |element: Hinge| {
        move |frame: &mut Frame<Space>, [_, tip, _]: [mstmm::frame::Point<Space>; 3]| {
            let beside = frame.point([2.0, 0.0, 0.0]);
            frame.member(tip, beside, element);
        }
    };
    assert!(said(at_one_place(Hinge::new())).starts_with(start));
    let start = "member 2: both ends are at one point, or at points of one body";
    assert!(said(|frame, [_, tip, _]| _ = frame.member(tip, tip, Pin)).starts_with(start));
    let start = "member 2: its ends have two directions, and a joint has one";
    let turned = |frame: &mut Frame<Space>, [_, tip, _]: [mstmm::frame::Point<Space>; 3]| {
        let beside = frame.point([2.0, 0.0, 0.0]);
        frame.member(tip.along([1.0, 0.0, 0.0]), beside.along([-1.0, 0.0, 0.0]), Tie::revolute());
    };
    assert!(said(turned).starts_with(start));
    let negative = said(at_one_place(Hinge::new().stiffness_ry(f64::NAN)));
    assert!(negative.starts_with("member 2: stiffness_ry is NaN"), "{negative}");
    let body = |inertia| {
        move |frame: &mut Frame<Space>, [_, tip, _]: [mstmm::frame::Point<Space>; 3]| {
            frame.body([tip], RigidBody { mass: 1.0, inertia, centre: [2.0, 0.0, 0.0] });
        }
    };
    let start = "body 0: its tensor of inertia is not finite, or indefinite: a moment about some axis is negative";
    assert_eq!(said(body(Tensor::new([1.0, 1.0, 1.0, 2.0, 0.0, 0.0]))), start);
    assert_eq!(said(body(Tensor::principal([1.0, -1.0, 1.0]))), start);
    let start = "body 0: mass and inertia must be zero or positive, and finite like the mass centre";
    let two = |frame: &mut Frame<Space>, [_, tip, _]: [mstmm::frame::Point<Space>; 3]| {
        for mass in [-1.0, 3.0] {
            frame.body([tip], RigidBody { mass, inertia: Tensor::default(), centre: [2.0, 0.0, 0.0] });
        }
    };
    assert_eq!(said(two), start);
    assert_eq!(said(|frame, [_, tip, _]| _ = frame.body([tip], RigidLink)), "built");
    assert_eq!(
        said(|frame, [foot, tip, _]| _ = frame.member(foot.along([1.0, 0.0, 0.0]), tip, Tie::ball())).lines().count(),
        1
    );
}

#[test]
fn what_a_point_has_not_is_said() {
    let mut frame = Frame::new();
    let [one, two] = [[0.0; 3], [1.0, 2.0, 2.0]].map(|place| frame.point(place));
    frame.hold(one, Support::Pinned);
    frame.hold(two, Support::Pinned);
    let bar = Bar(Section::new().axial_stiffness(1e3).bending_stiffness(1.0).mass_per_length(1.0));
    let bar = frame.member(one, two, bar);
    let truss = frame.build().unwrap();
    let asked = |entry| truss.frequency_response(two.force_z(), entry).unwrap_err();
    assert_eq!(asked(two.rotation_x()), MotionError::NoSuchFreedom { freedom: Freedoms::RX });
    assert_eq!(asked(bar.input().torque()), MotionError::NoSuchFreedom { freedom: Freedoms::RX });
    assert_eq!(Freedoms::X.union(Freedoms::RY).to_string(), "x, ry");
    let text = "this point has no rotation or moment about x: no element there brings it, or a joint releases it";
    assert_eq!(asked(two.rotation_x()).to_string(), text);
    assert!(truss.frequency_response(two.force_z(), bar.input().shear_z()).is_ok());
}
