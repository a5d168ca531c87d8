//! Frames that the program describes, beside sketches of the same structures.

use super::lists::{Bodies, Chain, DampedFrame};
use super::{assert_near, eigenvalues, frequencies};
use crate::portal;
use mstmm::elements::{Damper, Spring, TorsionSpring};
use mstmm::frame::{
    Body, Frame, Ground, Hinge, Line, Member, OfBeam, OfJoint, OfSpring, Pin, Plane, Point, PointMass, RigidBody,
    RigidLink, Roller, Section, Slider,
};
use mstmm::motion::MotionError;
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;

const SECTION: Section = Section::new().axial_stiffness(900.0).bending_stiffness(2.0).mass_per_length(1.5);

#[track_caller]
fn assert_equal(sketch: &[f64], frame: &Frame<Plane>) {
    assert_near(sketch, &frequencies(&frame.build().unwrap()), 1e-14);
}

fn points<const N: usize>(frame: &mut Frame<Plane>, places: [[f64; 2]; N]) -> [Point<Plane>; N] {
    places.map(|place| frame.point(place))
}

#[test]
fn paths_move_along_their_directions() {
    let (k, mass, x) = (3.0, 0.7, 1.25);
    let mut frame = Frame::new();
    let [foot, a, g] = points(&mut frame, [[0.0, 0.0], [x, 0.5], [2.0, 2.0]]);
    frame.hold(foot, Support::Fixed);
    frame.hold(g, Support::Fixed);
    let [first, second, turning] = [(); 3].map(|()| frame.path_point());
    frame.member(foot, a, SECTION);
    frame.member(first, a.along([x, 1.0]), Spring { stiffness: k });
    frame.member(second, first, Spring { stiffness: 2.0 * k });
    frame.member(Ground, second, Spring { stiffness: 3.0 * k });
    frame.member(a, g, Spring { stiffness: k });
    frame.member(turning, a, TorsionSpring { stiffness: k });
    frame.mass(first, mass);
    frame.mass(second, 0.5 * mass);
    frame.mass(turning, 0.1 * mass);
    assert_equal(&frequencies(&Chain { k, mass, x }.build().unwrap()), &frame);
}

/// The frame of [`Bodies`], its first beam, and its points a, b, d, e and the one on a roller.
fn bodies(mass: f64, k: f64) -> (Frame<Plane>, Member<OfBeam>, [Point<Plane>; 5]) {
    let mut frame = Frame::new();
    let places = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.5], [2.0, 0.5], [3.0, 1.0], [3.0, 1.0], [3.0, 1.0], [4.0, 0.0]];
    let [foot, a, b, behind, c, slid, pinned, tip] = points(&mut frame, places);
    let [d, e] = points(&mut frame, [[1.5, -0.5], [1.75, -0.25]]);
    frame.hold(foot, Support::Fixed);
    frame.hold(d, Freedoms::Y);
    frame.hold(e, Roller::along([1.0, 5.0]));
    frame.hold(tip, Roller::along([3.0, 1.0]));
    frame.body([a, b, d, e], RigidBody { mass, inertia: 0.2, centre: [1.5, 0.25] });
    frame.body([d], PointMass { mass: 0.4, ..PointMass::default() });
    frame.body([b], PointMass { mass: 0.3, inertia: 0.05 });
    let column = frame.member(foot, a, SECTION);
    frame.member(b, behind, Hinge::new().stiffness_x(k).stiffness_y(2.0 * k).stiffness_rz(0.1 * k));
    frame.member(behind, c, SECTION);
    frame.member(c.along([1.0, 2.0]), slid.along([1.0, 2.0]), Slider);
    frame.member(slid, pinned, Pin);
    frame.member(pinned, tip, SECTION);
    (frame, column, [a, b, d, e, tip])
}

#[test]
fn bodies_joints_and_skew_supports_are_those_of_sketches() {
    let (mass, k) = (2.5, 40.0);
    assert_equal(&frequencies(&Bodies { mass, k }.build().unwrap()), &bodies(mass, k).0);
}

/// The portal of the example, with its points.
fn portal() -> (Frame<Plane>, [Point<Plane>; 5]) {
    let model = portal::steel();
    let steel = Section::new().axial_stiffness(model.ea).bending_stiffness(model.ei).mass_per_length(model.m);
    let mut frame = Frame::new();
    let all = points(&mut frame, [[0.0, 0.0], [0.0, 3.0], [2.0, 3.0], [4.0, 3.0], [4.0, 0.0]]);
    let [foot, corner, middle, far, other] = all;
    frame.hold(foot, Support::Fixed);
    frame.hold(other, Support::Pinned);
    frame.member(foot, corner, steel);
    frame.member(corner, middle, steel);
    frame.member(middle, far, steel);
    frame.member(other, far.releasing(Freedoms::RZ), steel);
    frame.member(corner, other, Spring { stiffness: model.brace });
    frame.body([middle], RigidBody { mass: model.machine, inertia: model.inertia, centre: [2.0, 3.4] });
    (frame, all)
}

#[test]
fn the_portal_of_the_example_is_that_of_its_frame() {
    let (frame, _) = portal();
    assert_near(&frequencies(&frame.build().unwrap()), &frequencies(&portal::steel().build().unwrap()), 1e-13);
}

/// Beside the sketch: what is asked at points and at ends of members, at rest, beside roots and beyond.
#[test]
fn a_body_on_two_supports_moves_as_that_of_its_sketch() {
    let (mass, k) = (2.5, 40.0);
    let sketch = Bodies { mass, k }.build().unwrap();
    let (frame, column, [a, b, d, e, tip]) = bodies(mass, k);
    let frame = frame.build().unwrap();
    let first = sketch.first_frequencies::<3>().unwrap();
    let pairs = [
        (b.force_x(), d.displacement_x(), Bodies::conn_b.force_x(), Bodies::conn_d.displacement_x()),
        (a.torque_z(), e.rotation_z(), Bodies::conn_a.torque_z(), Bodies::conn_e.rotation_z()),
        (b.force_y(), d.reaction_y(), Bodies::conn_b.force_y(), Bodies::conn_d.reaction_y()),
        (d.motion_y(), a.displacement_y(), Bodies::conn_d.motion_y(), Bodies::conn_a.displacement_y()),
    ];
    for (load, entry, of_sketch, entry_of_sketch) in pairs {
        let one = frame.frequency_response(load, entry).unwrap();
        let other = sketch.frequency_response(of_sketch, entry_of_sketch).unwrap();
        for omega in [0.0, 0.7 * first[0].omega, 1.3 * first[2].omega] {
            let [one, other] = [one.at(omega).unwrap(), other.at(omega).unwrap()];
            assert!((one - other).abs() <= 1e-13 * other.abs(), "{one:e} and {other:e} at {omega}");
        }
    }
    let inside = frame.frequency_response(b.force_y(), column.output().moment()).unwrap().at(0.0).unwrap();
    let of_sketch = Bodies::beam_1.output().moment();
    let of_sketch = sketch.frequency_response(Bodies::conn_b.force_y(), of_sketch).unwrap().at(0.0).unwrap();
    assert!((inside / of_sketch - 1.0).abs() < 1e-13);
    // the tip moves along its roller alone
    let [x, y] = [tip.displacement_x(), tip.displacement_y()];
    let [x, y] = [x, y].map(|entry| frame.frequency_response(b.force_y(), entry).unwrap().at(0.0).unwrap());
    assert!((y / x - 1.0 / 3.0).abs() < 1e-14);
}

#[test]
fn a_damped_frame_has_the_eigenvalues_of_its_sketch() {
    let mut frame = Frame::new();
    let [foot, a, b, ground] = points(&mut frame, [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [2.0, 0.0]]);
    frame.hold(foot, Support::Fixed);
    frame.hold(ground, Support::Fixed);
    frame.member(foot, a, SECTION);
    frame.member(a, b, SECTION);
    frame.member(ground, b, Damper { damping: 0.8 });
    let sketch = DampedFrame { c: 0.8 }.build().unwrap();
    for (one, other) in eigenvalues(&frame.build_damped().unwrap()).iter().zip(eigenvalues(&sketch)) {
        assert!((one - other).norm() < 1e-14 * other.norm(), "{one} and {other}");
    }
    let refused = frame.build().unwrap_err().to_string();
    assert_eq!(refused, "member 2: it has damping: `build_damped()` has eigenvalues");
}

system! {
    /// Beams along a line with all that they may name, a pin, and a spring across.
    struct Girder { l: f64, k: f64 }

    fixed at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at l -> pin 2 {}
        -> beam 3 {
            bending_stiffness: 2.0, mass_per_length: 1.5, shear_stiffness: 16.0, rotary_inertia: 0.1, axial_force: -0.25,
            foundation_stiffness: 3.0, foundation_shear_stiffness: 0.5
        } -> conn b at 2.5 * l <- pinned;
    conn a <- spring 4 { stiffness: k } <- mass 5 { mass: 0.7 } <- spring 6 { stiffness: 2.0 * k } <- fixed;
}

#[test]
fn a_line_is_that_of_its_sketch() {
    let (l, k) = (1.25, 3.0);
    let mut frame = Frame::new();
    let [foot, a, behind, b] = [0.0, l, l, 2.5 * l].map(|place| frame.point(place));
    let plain = Section::new().bending_stiffness(2.0).mass_per_length(1.5);
    let general = plain.shear_stiffness(16.0).rotary_inertia(0.1).axial_force(-0.25);
    let general = general.foundation_stiffness(3.0).foundation_shear_stiffness(0.5);
    frame.hold(foot, Support::Fixed);
    frame.hold(b, Support::Pinned);
    frame.member(foot, a, plain);
    frame.member(a, behind, Pin);
    frame.member(behind, b, general);
    let mass = frame.path_point();
    frame.member(mass, a, Spring { stiffness: k });
    frame.member(Ground, mass, Spring { stiffness: 2.0 * k });
    frame.mass(mass, 0.7);
    let built = frame.build().unwrap();
    assert_near(&frequencies(&built), &frequencies(&Girder { l, k }.build().unwrap()), 1e-14);
    // on a line nothing moves along it
    assert!(built.frequency_response(a.force_y(), behind.rotation_z()).unwrap().at(0.0).unwrap().is_finite());
}

#[test]
fn all_that_is_wrong_is_said_at_once_by_name() {
    let mut frame = Frame::new();
    let [foot, corner, far] = points(&mut frame, [[0.0, 0.0], [0.0, 3.0], [f64::NAN, 3.0]]);
    let other: Point<Plane> = Frame::new().point([1.0, 1.0]);
    frame.name(corner, "corner");
    frame.hold(foot, Support::Fixed);
    frame.hold(foot, Freedoms::X);
    let column = frame.member(foot, corner, Section::new().bending_stiffness(1.0));
    frame.name(column, "column");
    frame.member(corner, Ground, SECTION);
    frame.member(corner, Ground, Spring { stiffness: 1.0 });
    frame.member(corner, far, Hinge::new());
    frame.member(corner, other, SECTION);
    frame.body([other], RigidLink);
    frame.path_point();
    let errors = frame.build().unwrap_err();
    let told: Vec<String> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "body 0: a point or a member of another frame: each frame has handles of its own",
            "path point 0: springs that move and springs that turn meet at this point of a path, or nothing does",
            "member \"column\": `axial_stiffness` is missing: in the plane and in space beams and strings stretch, too; a large number is nearly rigid",
            "member 1: it ends at the ground or at a path, which have no place: end it at a point",
            "member 2: it acts on a point in no direction: `point.along(..)`",
            "member 3: it lets nothing go and would be rigid: a hinge names a stiffness, `stiffness_rz(0.0)`, or write `Pin`",
            "member 4: a point or a member of another frame: each frame has handles of its own",
            "point 0: it is held twice: name all that is held at once",
            "point 2: its place is not finite",
        ]
    );
}

#[test]
fn numbers_out_of_their_ranges_are_named() {
    let mut frame = Frame::new();
    let [foot, corner, same, far] = points(&mut frame, [[0.0, 0.0], [0.0, 3.0], [0.0, 3.0], [f64::NAN, 3.0]]);
    frame.hold(foot, Support::Fixed);
    frame.member(foot, corner, SECTION.mass_per_length(-1.0));
    frame.member(corner, same, SECTION);
    frame.member(foot, same, SECTION.shear_stiffness(0.0));
    frame.member(foot.along([0.0, 0.0]), Ground, Spring { stiffness: 1.0 });
    frame.member(corner, far, Spring { stiffness: 1.0 });
    frame.member(foot.along([1.0, 0.0]), corner, SECTION);
    frame.member(foot, corner, Hinge::new().stiffness_rz(2.0));
    frame.member(corner, same, Hinge::new().stiffness_rz(-2.0));
    frame.name(far, "far");
    let errors = frame.build().unwrap_err();
    let told: Vec<String> = errors.iter().map(ToString::to_string).collect();
    let direction = "its direction is zero, not finite, beyond 1e±70, or not its own to choose, as that of a beam";
    assert_eq!(
        told,
        [
            "member 2: shear_stiffness is 0, but must be positive".to_owned(),
            format!("member 3: {direction}"),
            format!("member 5: {direction}"),
            "member 0: mass_per_length is -1, but must be zero or positive, and finite".to_owned(),
            "member 1: both ends are at one place: beams and strings have a length, a spring there a direction"
                .to_owned(),
            "member 6: the ends of a joint are at one place, and its are at two".to_owned(),
            "member 7: stiffness_rz is -2, but must be zero, or positive and finite, with a finite reciprocal"
                .to_owned(),
            "point \"far\": its place is not finite".to_owned(),
        ]
    );
}

/// A structure goes to other threads, and is copied.
#[test]
fn structures_are_sent() {
    fn is_sent<T: Clone + Send + Sync>(_: &T) {}
    let (frame, _) = portal();
    is_sent(&frame);
    is_sent(&frame.build().unwrap());
    is_sent(&frame.build_damped().unwrap());
}

#[test]
fn handles_of_other_frames_are_refused() {
    let (frame, [_, corner, middle, ..]) = portal();
    let (other, _) = portal();
    let (frame, other) = (frame.build().unwrap(), other.build().unwrap());
    assert!(frame.frequency_response(corner.force_x(), middle.displacement_x()).is_ok());
    let refused = other.frequency_response(corner.force_x(), middle.displacement_x()).map(|_| ());
    assert_eq!(refused, Err(MotionError::OtherFrame { index: 1 }));
}

/// A frame that is changed is built again, and its handles stay.
#[test]
fn a_member_is_replaced() {
    let mut frame = Frame::<Line>::new();
    let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    let beam = frame.member(foot, tip, Section::new().bending_stiffness(2.0).mass_per_length(1.5));
    let first = frame.build().unwrap().frequencies(1).unwrap()[0].omega;
    frame.replace(beam, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    let second = frame.build().unwrap().frequencies(1).unwrap()[0].omega;
    assert!((second / first - 2.0).abs() < 1e-15);
}

/// A portal, with the handles of its parts.
struct Parts {
    frame: Frame<Plane>,
    column: Member<OfBeam>,
    girder: Member<OfBeam>,
    brace: Member<OfSpring>,
    hinge: Member<OfJoint>,
    machine: Body,
}

/// A portal whose parameters are numbers in a list.
fn with_parameters([ei, ea, shear, axial, k, kz, mass, inertia]: [f64; 8]) -> Parts {
    let mut frame = Frame::new();
    let [foot, corner, knee, far] = points(&mut frame, [[0.0, 0.0], [0.0, 3.0], [0.0, 3.0], [4.0, 3.5]]);
    let section = Section::new().axial_stiffness(ea).bending_stiffness(ei).mass_per_length(20.0);
    frame.hold(foot, Support::Fixed);
    frame.hold(far, Roller::along([1.0, 0.25]));
    let column = frame.member(foot, corner, section.axial_force(axial));
    let girder = frame.member(knee, far, section.shear_stiffness(shear));
    let hinge = frame.member(corner, knee, Hinge::new().stiffness_rz(kz));
    let brace = frame.member(corner.along([1.0, 0.5]), Ground, Spring { stiffness: k });
    let machine = frame.body([knee], RigidBody { mass, inertia, centre: [0.4, 3.3] });
    Parts { frame, column, girder, brace, hinge, machine }
}

/// Beside differences of frequencies: what each parameter does.
#[test]
fn sensitivities_are_differences_of_roots() {
    let at = [1e6, 4e8, 2e7, -3e4, 2e6, 5e5, 150.0, 12.0];
    let Parts { frame, column, girder, brace, hinge, machine } = with_parameters(at);
    let structure = frame.build().unwrap();
    let roots = structure.frequencies(4).unwrap();
    for (mode, root) in roots.iter().enumerate() {
        let slopes = structure.sensitivity(root).unwrap();
        let of = |member: Member<OfBeam>, name: &str| slopes.of(member, name).unwrap();
        let found = [
            of(column, "bending_stiffness") + of(girder, "bending_stiffness"),
            of(column, "axial_stiffness") + of(girder, "axial_stiffness"),
            of(girder, "shear_stiffness"),
            of(column, "axial_force"),
            slopes.of(brace, "stiffness").unwrap(),
            slopes.of(hinge, "stiffness_rz").unwrap(),
            slopes.of(machine, "mass").unwrap(),
            slopes.of(machine, "inertia").unwrap(),
        ];
        for (parameter, slope) in found.into_iter().enumerate() {
            let omega = |part: f64| {
                let mut moved = at;
                moved[parameter] *= 1.0 + part;
                with_parameters(moved).frame.build().unwrap().frequencies(4).unwrap()[mode].omega
            };
            let difference = (omega(1e-4) - omega(-1e-4)) / (2e-4 * at[parameter]);
            let size = root.omega / at[parameter].abs();
            assert!((slope - difference).abs() < 1e-7 * size, "{parameter} of mode {mode}: {slope:e}, {difference:e}");
        }
        assert_eq!(slopes.of(girder, "length"), Err(MotionError::NoSuchParameter));
        assert_eq!(slopes.of(machine, "centre"), Err(MotionError::NoSuchParameter));
    }
}
