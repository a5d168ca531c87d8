//! Axial forces that are refused: what has no parameter for them, what slides, forces of all sizes.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::axial_forces::{Portal, dead};
use crate::models::assert_close;
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::frame::{Frame, Hinge, InFrame, Pin, Plane, Point, RigidLink, Section};
use mstmm::motion::{AxialForceError, MotionError};
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;
use mstmm::search::{SearchError, Spot};

#[test]
fn what_has_no_parameter_for_its_force_is_refused() {
    system! {
        struct Strut {}
        conn a at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e8, bending_stiffness: 1e5, mass_per_length: 5.0 } -> conn b at (2.0, 0.0);
        fixed -> conn a;
    }
    let strut = Strut {}.build().unwrap();
    let refused = strut.axial_forces(&[(Strut::conn_b.force_x(), 10.0)]).unwrap_err();
    let member = Spot::Named("beam 1");
    assert_eq!(refused, AxialForceError::NoAxialForce { member, name: "beam 1", force: 10.0 });
    assert!(refused.to_string().starts_with(
        "beam 1 carries an axial force of 10 N and has no parameter for it: a beam or a bar has one if it is named"
    ));
    // across it there is none
    assert!(strut.axial_forces(&[(Strut::conn_b.force_y(), 10.0)]).is_ok());

    // a spring between two places would turn; in a direction of its own it does not
    let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
    let spring = |turns: bool| {
        let mut frame = Frame::<Plane>::new();
        let [a, b, c] = [[0.0, 0.0], [2.0, 0.0], [2.0, -1.0]].map(|place| frame.point(place));
        frame.member(a, b, section);
        frame.hold(a, Support::Pinned);
        frame.hold(c, Support::Fixed);
        let stiffness = 1e4;
        if turns {
            frame.member(b, c, Spring { stiffness });
        } else {
            frame.member(b.along([0.0, 1.0]), c.along([0.0, 1.0]), Spring { stiffness });
        }
        frame.member(a, mstmm::frame::Ground, TorsionSpring { stiffness: 10.0 });
        let structure = frame.build().unwrap();
        structure.axial_forces(&[(b.force_y(), -10.0)]).map(|_| ()).map_err(|error| error.to_string())
    };
    assert!(spring(true).unwrap_err().starts_with("member 1 (Spring) carries an axial force of -"));
    assert_eq!(spring(false), Ok(()));
}

/// A rigid link under its load turns more, and one across its load does not.
#[test]
fn forces_on_levers_of_what_is_rigid_are_refused() {
    let under = |reach: f64, rise: f64| {
        let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
        let mut frame = Frame::<Plane>::new();
        let [a, b, c] = [[0.0, 0.0], [0.0, 2.0], [reach, 2.0 + rise]].map(|place| frame.point(place));
        let column = frame.member(a, b, section);
        frame.body([b, c], RigidLink);
        frame.hold(a, Support::Fixed);
        let structure = frame.build().unwrap();
        let forces = structure.axial_forces(&[(c.force_y(), -1e3)]);
        forces.map(|forces| forces.get(column).unwrap())
    };
    assert_close(under(0.5, 0.0).unwrap(), -1e3, 1e-15);
    for rise in [0.3, -0.2] {
        let Err(AxialForceError::Lever { stiffness, .. }) = under(0.5, rise) else { panic!("{:?}", under(0.5, rise)) };
        assert_close(stiffness, -1e3 * rise, 1e-14);
    }
}

fn steel() -> Section {
    Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0)
}

/// What becomes of a column of two pieces under a load at its top, given what joins them.
fn joined(
    join: impl Fn(&mut Frame<Plane>, Point<Plane>, Point<Plane>),
    load: fn(Point<Plane>) -> PlaneLoad<InFrame>,
) -> Result<(), AxialForceError> {
    let mut frame = Frame::<Plane>::new();
    let [foot, one, other, top] = [0.0, 1.5, 1.5, 3.0].map(|height| frame.point([0.0, height]));
    frame.member(foot, one, steel());
    join(&mut frame, one, other);
    frame.member(other, top, steel());
    frame.hold(foot, Support::Fixed);
    frame.build().unwrap().axial_forces(&[(load(top), -1e5)]).map(|_| ())
}

/// What slides across a force turns what it slides on, and a path between two places turns with these.
#[test]
fn slides_and_paths_under_forces_are_refused() {
    let [down, beside] = [|top: Point<Plane>| top.force_y(), |top: Point<Plane>| top.force_x()];
    let hinge = |frame: &mut Frame<Plane>, one, other| _ = frame.member(one, other, Hinge::new().stiffness_x(2e5));
    let refused = joined(hinge, down).unwrap_err();
    assert!(matches!(refused, AxialForceError::Slides { force, .. } if (force / 1e5 - 1.0).abs() < 1e-14), "{refused}");
    assert!(refused.to_string().starts_with("member 1 (joint) slides across a force of"), "{refused}");
    // along its direction it carries the load as a spring does
    assert_eq!(joined(hinge, beside), Ok(()));
    let turning = |frame: &mut Frame<Plane>, one, other| _ = frame.member(one, other, Hinge::new().stiffness_rz(2e5));
    assert_eq!(joined(turning, down), Ok(()));
    let released = |frame: &mut Frame<Plane>, one: Point<Plane>, other: Point<Plane>| {
        let far = frame.point([0.5, 1.5]);
        frame.member(one, other, Pin);
        frame.member(other.releasing(Freedoms::Y), far, steel());
        frame.member(far.along([1.0, 0.0]), one.along([1.0, 0.0]), Spring { stiffness: 1e4 });
        frame.hold(far, Support::Fixed);
    };
    assert!(!matches!(joined(released, down), Err(AxialForceError::Slides { .. })));
    assert!(matches!(joined(released, beside), Err(AxialForceError::Slides { .. })));

    system! {
        struct Strut { k: f64 }
        fixed at (0.0, 0.0) -> spring 1 { stiffness: k } -> mass 2 { mass: 0.1 } -> spring 3 { stiffness: k } -> conn b at (0.0, 1.0);
        conn b -> point_mass 4 { mass: 1.0 };
        conn b -> along (1.0, 0.0) -> spring 5 { stiffness: 100.0 } -> fixed;
    }
    let strut = Strut { k: 1e6 }.build().unwrap();
    let refused = strut.axial_forces(&[(Strut::conn_b.force_y(), -1.0)]).map(|_| ()).unwrap_err();
    assert!(matches!(refused, AxialForceError::NoAxialForce { name: "spring 1", .. }), "{refused}");
}

/// Forces are small only beside the rounding of what carries them; a tiny one changes nothing, and one out of range is told.
#[test]
fn forces_of_all_sizes_are_taken() {
    let steel = |stiffness: f64| {
        Section::new().axial_stiffness(1e3 * stiffness).bending_stiffness(stiffness).mass_per_length(1.0)
    };
    let mut frame = Frame::<Plane>::new();
    let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 2.0]].map(|place| frame.point(place));
    frame.member(a, b, steel(1e9));
    frame.member(a, c, steel(1e9));
    let weak = frame.member(c, d, steel(1e-3));
    frame.hold(a, Support::Fixed);
    let structure = frame.build().unwrap();
    let forces = structure.axial_forces(&[(b.force_x(), 1e9), (d.force_y(), -2e-3)]).unwrap();
    assert_close(forces.get(weak).unwrap(), -2e-3, 1e-15);
    let cancelling =
        structure.axial_forces(&[(b.force_x(), 1e15), (b.force_x(), -1e15), (d.force_y(), -2e-3)]).unwrap();
    assert_close(cancelling.get(weak).unwrap(), -2e-3, 1e-15);

    let mut frame = Frame::<Plane>::new();
    let [foot, tip] = [[0.0, 0.0], [3.0, 4.0]].map(|place| frame.point(place));
    let mast =
        frame.member(foot, tip, Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0));
    frame.hold(foot, Support::Fixed);
    let structure = frame.build().unwrap();
    let sway = |structure: &mstmm::frame::Structure<Plane>| {
        structure.frequency_response(tip.force_x(), tip.displacement_x()).unwrap().at(0.0).unwrap()
    };
    for load in [1e-30, 1e-100, 1e-250] {
        let loaded = structure.settled_under(&[(tip.force_y(), -load)]).unwrap();
        assert_close(sway(&loaded), sway(&structure), 1e-15);
    }
    assert_close(structure.axial_forces(&[(tip.force_y(), -1e155)]).unwrap().get(mast).unwrap(), -0.8e155, 1e-14);
    for value in [f64::INFINITY, f64::NAN] {
        let refused = structure.axial_forces(&[(tip.force_y(), 1.0), (tip.force_y(), value)]).map(|_| ()).unwrap_err();
        assert!(matches!(refused, AxialForceError::Load { index: 1, .. }), "{refused}");
    }
    let too_large = structure.axial_forces(&[(tip.force_y(), 1e308); 4]).map(|_| ()).unwrap_err();
    assert_eq!(too_large, AxialForceError::Motion(MotionError::NotFinite { frequency: 0.0 }));

    // a link behind which nothing acts carries rounding alone
    let mut frame = Frame::<Plane>::new();
    let [a, b, c, d] = [[0.0, 0.0], [1.3, 0.7], [1.55, 0.9], [2.3, 1.7]].map(|place| frame.point(place));
    frame.member(a, b, steel(1e6));
    frame.body([b, c], RigidLink);
    frame.member(c, d, steel(1e6));
    frame.hold(a, Support::Fixed);
    assert!(frame.build().unwrap().axial_forces(&[(b.force_y(), 1.0)]).is_ok());
}

#[test]
fn other_mistakes_are_told() {
    let portal = Portal::unloaded().build().unwrap();
    // near the critical load, 2.078 times these, forces do not settle, and beyond it they are those of a structure that falls
    let under = |factor: f64| portal.settled_under(&dead().map(|(load, value)| (load, factor * value)));
    assert!(matches!(under(2.07), Err(AxialForceError::Unsettled { change }) if change > 1.0));
    assert!(under(2.0).unwrap().first_frequencies::<1>().is_ok());
    let fallen = under(3.0).unwrap().first_frequencies::<1>();
    assert!(matches!(fallen, Err(SearchError::Unstable { modes: 1 })), "{fallen:?}");
    // forces of a frame with other members
    let mut frame = Frame::<Plane>::new();
    let section = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0);
    let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.member(a, b, section);
    frame.hold(a, Support::Fixed);
    let small = frame.build().unwrap();
    let c = frame.point([3.0, 0.0]);
    frame.member(b, c, section);
    let large = frame.build().unwrap();
    let forces = large.axial_forces(&[(c.force_x(), 5.0)]).unwrap();
    let refused = small.with_axial_forces(&forces).unwrap_err();
    assert_eq!((refused.parameter, refused.value), ("axial_force", 5.0));
    // a pin carries what its members carry
    let mut frame = Frame::<Plane>::new();
    let points = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    let beside = frame.point([0.0, 0.0]);
    frame.member(points[0], beside, Pin);
    frame.member(beside, points[1], section);
    frame.hold(points[0], Support::Fixed);
    frame.hold(points[1], Support::Roller);
    let pinned = frame.build().unwrap();
    assert!(pinned.axial_forces(&[(points[1].force_x(), -5.0)]).is_ok());
    // what loses energy at rest has no forces at rest
    let lossy = Section::new().axial_stiffness(1e8).bending_stiffness(1e5).mass_per_length(5.0).loss_factor(0.1);
    let mut frame = Frame::<Plane>::new();
    let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|place| frame.point(place));
    frame.member(a, b, lossy);
    frame.hold(a, Support::Fixed);
    let refused = frame.build_damped().unwrap().axial_forces(&[(b.force_x(), 1.0)]).map(|_| ()).unwrap_err();
    assert_eq!(refused, AxialForceError::Motion(MotionError::LossFactor));
}
