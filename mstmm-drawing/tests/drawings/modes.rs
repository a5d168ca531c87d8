//! Modes over drawings: what is drawn is the shape, times one scale.

use crate::frames::for_each_frame;
use crate::reading::{Picture, Shown};
use crate::vehicle::Vehicle;
use mstmm::elements::Beam;
use mstmm::list::{AnyUndamped, ListStep, Room, StepList, Support};
use mstmm::motion::{Drawn, Label, MotionError, SystemStates};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError};
use paper::models;

/// Half of the last digit of a path, of a place and of its displacement.
const DIGIT: f64 = 0.0101;

fn part<'a>(all: &'a [Shown], name: &str) -> &'a Shown {
    all.iter().find(|shown| shown.name == name).unwrap()
}

/// The unit of an undamped motion on the paper, with the sign that it has there.
fn reach(picture: &Picture) -> f64 {
    picture.number("data-reach") * picture.number("data-phase").cos()
}

/// Compares the line of a member with displacements at parts of its length, in the model.
fn check_line(picture: &Picture, name: &str, displacement: impl Fn(f64) -> [f64; 2]) {
    let (rest, mode) = (picture.shown("rest"), picture.shown("still"));
    let straight = &part(&rest, name).paths[0];
    let (from, to) = (straight[0], straight[straight.len() - 1]);
    let line = &part(&mode, name).paths[0];
    let reach = reach(picture);
    assert!(line.len() >= 25, "{name}: {} points", line.len());
    for (index, point) in line.iter().enumerate() {
        let part = index as f64 / (line.len() - 1) as f64;
        let [u, v] = displacement(part);
        let expected = [from[0] + part * (to[0] - from[0]) + reach * u, from[1] + part * (to[1] - from[1]) - reach * v];
        let beside = (point[0] - expected[0]).abs().max((point[1] - expected[1]).abs());
        assert!(beside < DIGIT, "{name} at {part}: {point:?} and {expected:?}");
    }
}

system! {
    /// A string between two places, and a beam that carries it.
    struct Guyed { h: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 60.0, mass_per_length: 3.0 } -> conn head at (0.0, 2.5)
        -> string 2 { axial_stiffness: 800.0, tension: h, mass_per_length: 0.2 } -> pinned at (3.0, 0.0);
}

#[test]
fn lines_of_strings_between_places_are_their_shape() {
    let guyed = Guyed { h: 20.0 }.build().unwrap();
    for root in &guyed.first_frequencies::<3>().unwrap() {
        let shape = guyed.mode_shape(root).unwrap();
        let picture = Picture::of(Drawing::of(&guyed).unwrap().mode(&shape).unwrap());
        check_line(&picture, "string 2", |part| {
            let state = shape.along(Guyed::string_2, part * f64::hypot(3.0, 2.5)).unwrap();
            [state.displacement_x, state.displacement_y]
        });
    }
}

#[test]
fn lines_of_frames_are_the_shape_along_their_members() {
    let portal = crate::frames::portal();
    for root in &portal.first_frequencies::<4>().unwrap() {
        let shape = portal.mode_shape(root).unwrap();
        let picture = Picture::of(Drawing::of(&portal).unwrap().mode(&shape).unwrap());
        let sketch = FrameAnalysis::sketch(&portal);
        let mut count = 0;
        for member in sketch.members().filter(|member| member.kind == "Beam") {
            let [from, to] = member.ends.map(|end| end.position.unwrap());
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            check_line(&picture, &member.name.to_string(), |part| {
                let state = shape.along(member.label, part * length).unwrap();
                [state.displacement_x, state.displacement_y]
            });
            count += 1;
        }
        assert_eq!(count, 4);
        // the mass centre moves as a rigid body does, 0.4 m above its point
        let [x, y, turn] = [
            shape.value(crate::portal::Portal::conn_girder.displacement_x()).unwrap(),
            shape.value(crate::portal::Portal::conn_girder.displacement_y()).unwrap(),
            shape.value(crate::portal::Portal::conn_girder.rotation_z()).unwrap(),
        ];
        let (rest, mode) = (picture.shown("rest"), picture.shown("still"));
        let [before, after] = [&rest, &mode].map(|all| part(all, "rigid_body 6").paths[2][0]);
        let reach = reach(&picture);
        assert!((after[0] - before[0] - reach * (x - 0.4 * turn)).abs() < DIGIT);
        assert!((after[1] - before[1] + reach * y).abs() < DIGIT);
        // the brace ends where its points are
        let brace = &part(&mode, "spring 7").paths[0];
        assert!((brace[0][0] - part(&mode, "beam 2").paths[0][0][0]).abs() < DIGIT);
        assert!((brace[0][1] - part(&mode, "beam 2").paths[0][0][1]).abs() < DIGIT);
    }
}

/// The name of a beam, its label and its length.
type Line<'a, M, E> = (&'a str, Label<M, E>, f64);

fn check_tree<Y, E>(picture: &Picture, shape: &SystemStates<'_, Y, f64>, beams: &[Line<'_, Y::Model, E>])
where
    Y: mstmm::motion::Tree<f64, Parameter = f64>,
{
    for (name, label, length) in beams {
        check_line(picture, name, |part| [0.0, shape.along(*label, part * length).unwrap().y]);
    }
}

#[test]
fn lines_of_the_systems_of_the_paper_are_their_shapes() {
    let model = models::light_tip_body();
    let system = model.build().unwrap();
    for root in &system.first_frequencies::<3>().unwrap() {
        let shape = system.mode_shape(root).unwrap();
        let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
        check_tree(&picture, &shape, &[("beam 1", models::TipBody::beam_1, model.length)]);
        let end = shape.state(models::TipBody::beam_1.output());
        let (rest, mode) = (picture.shown("rest"), picture.shown("still"));
        let [before, after] = [&rest, &mode].map(|all| part(all, "body 2").paths[2][0]);
        let centre = end.y + model.eccentricity * end.theta;
        assert!((before[1] - after[1] - reach(&picture) * centre).abs() < DIGIT);
    }
    let model = models::two_spans();
    let system = model.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<2>().unwrap()[1]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
    let (support, spring) = (model.support_position, model.spring_position);
    let beams = [
        ("beam 1", models::TwoSpans::beam_1, support),
        ("beam 3", models::TwoSpans::beam_3, spring - support),
        ("beam 7", models::TwoSpans::beam_7, model.length - spring),
    ];
    check_tree(&picture, &shape, &beams);
    let moved = |name: &str, number: usize| {
        let [before, after] = ["rest", "still"].map(|class| part(&picture.shown(class), name).paths[0][number]);
        (before[1] - after[1]) / reach(&picture)
    };
    let tolerance = DIGIT / picture.number("data-reach");
    assert!((moved("mass 6", 0) - shape.state(models::TwoSpans::mass_6.output()).y).abs() < tolerance);
    let model = models::restrained_beam();
    let system = model.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<3>().unwrap()[2]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
    check_tree(&picture, &shape, &[("beam 3", models::RestrainedBeam::beam_3, model.length)]);
    let model = models::spring_and_mass();
    let system = model.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<3>().unwrap()[2]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
    check_tree(&picture, &shape, &[("beam 1", models::SpringAndMass::beam_1, model.spring_position)]);
}

/// The mode of a damper is complex: at each moment of a period it is the real part of the shape times a turning number.
#[test]
fn damped_modes_turn() {
    let model = models::damped_oscillator();
    let system = model.build().unwrap();
    let shape = system.mode_shape(&system.first_eigenvalues::<3>().unwrap()[2]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
    let moments = picture.moments("beam 4");
    assert_eq!(moments.len(), 17);
    let length = model.oscillator_position - model.spring_position;
    let reach = picture.number("data-reach");
    let height = part(&picture.shown("rest"), "beam 4").paths[0][0][1];
    let mut out_of_phase = 0.0_f64;
    for (index, line) in moments.iter().enumerate() {
        let turn =
            mstmm::Complex::from_polar(1.0, picture.number("data-phase") + std::f64::consts::TAU * index as f64 / 16.0);
        for (number, point) in line.iter().enumerate() {
            let place = length * number as f64 / (line.len() - 1) as f64;
            let y = shape.along(models::DampedOscillator::beam_4, place.min(length)).unwrap().y;
            assert!((height - point[1] - reach * (y * turn).re).abs() < DIGIT, "{index}, {number}");
            out_of_phase = out_of_phase.max(reach * y.im.abs());
        }
    }
    assert!(out_of_phase > 1.0, "the test says nothing of phases: {out_of_phase}");
}

system! {
    /// A body on two supports, the second of which is a member for the core, with beams at both ends.
    struct Held { l: f64 }
    conn a at (-1.0, 0.5) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn b at (0.0, 0.5);
    conn b -> rigid_body 2 { mass: 10.0, inertia: 5.0, centre: (0.5 * l, 0.5) } <- pinned at (0.0, 0.0);
    rigid_body 2 <- roller at (l, 0.0) along (1.0, 1.0);
    rigid_body 2 -> conn c at (l, 0.5)
        -> beam 3 { axial_stiffness: 4e8, bending_stiffness: 1e5, mass_per_length: 20.0 } -> conn d at (2.5 * l, 0.7);
}

/// Members that are not drawn leave no other in their place.
#[test]
fn lines_are_those_of_their_own_members() {
    let held = Held { l: 1.0 }.build().unwrap();
    for root in &held.first_frequencies::<3>().unwrap() {
        let shape = held.mode_shape(root).unwrap();
        let picture = Picture::of(Drawing::of(&held).unwrap().mode(&shape).unwrap());
        check_line(&picture, "beam 1", |part| {
            let state = shape.along(Held::beam_1, part).unwrap();
            [state.displacement_x, state.displacement_y]
        });
        let length = 1.5_f64.hypot(0.2);
        check_line(&picture, "beam 3", |part| {
            let state = shape.along(Held::beam_3, part * length).unwrap();
            [state.displacement_x, state.displacement_y]
        });
    }
}

/// Whatever phase a damped shape has, its largest displacement is seen in full at first.
#[test]
fn damped_modes_begin_where_they_show_most() {
    let vehicle = crate::frames::vehicle();
    let mut phases = 0.0_f64;
    for root in &vehicle.first_eigenvalues::<4>().unwrap() {
        let shape = vehicle.mode_shape(root).unwrap();
        let picture = Picture::of(Drawing::of(&vehicle).unwrap().mode(&shape).unwrap());
        let rest = picture.shown("rest");
        let moved =
            ["rigid_body 1", "mass 3", "mass 6", "mass 9"].map(|name| (part(&rest, name), picture.moments(name)));
        let farthest = |moment: usize| {
            let corners = moved.iter().flat_map(|(rest, moments)| rest.paths[0].iter().zip(&moments[moment]));
            corners.map(|(from, to)| (from[1] - to[1]).abs()).fold(0.0, f64::max)
        };
        let masses = [Vehicle::mass_3, Vehicle::mass_6, Vehicle::mass_9].map(|mass| mass.displacement_x());
        let body = [Vehicle::conn_front, Vehicle::conn_rear].map(|point| point.displacement_y());
        let sizes = masses.into_iter().chain(body).map(|entry| shape.value(entry).unwrap().norm());
        let largest = picture.number("data-reach") * sizes.fold(0.0, f64::max);
        assert!((farthest(0) - largest).abs() < DIGIT, "{} of {largest}", farthest(0));
        phases = phases.max(picture.number("data-phase").sin().abs());
    }
    // what is seen is less by the cosine of the phase where that is forgotten
    assert!(phases > 0.1, "the test says nothing of phases: {phases}");
}

/// An undamped mode swings from one side to the other; the largest displacement has a size that can be seen and is in the picture.
#[test]
fn modes_swing_and_stay_in_the_picture() {
    for_each_frame!(name, frame, check_swing(name, frame), girder star attached rail ring portal truss double_beam);
}

fn check_swing<Y>(name: &str, frame: &Y)
where
    Y: Drawn<Parameter = f64> + mstmm::motion::MovingNetwork<f64> + mstmm::search::Undamped,
{
    let roots = frame.frequencies(6).unwrap();
    for root in roots.iter().filter(|root| root.multiplicity == 1 && root.omega > 0.0) {
        let shape = FrameAnalysis::mode_shape(frame, root).unwrap();
        let picture = Picture::of(Drawing::of(frame).unwrap().mode(&shape).unwrap());
        let (rest, still) = (picture.shown("rest"), picture.shown("still"));
        let mut largest = 0.0_f64;
        for shown in still.iter().filter(|shown| shown.kind.contains("Beam")) {
            let straight = &part(&rest, &shown.name).paths[0];
            let (from, to) = (straight[0], straight[straight.len() - 1]);
            let line = &shown.paths[0];
            let [first, second, third] = &picture.moments(&shown.name)[..] else { panic!("three moments") };
            assert_eq!((first, first), (line, third), "{name}: {}", shown.name);
            for (index, (point, other)) in line.iter().zip(second).enumerate() {
                let part = index as f64 / (line.len() - 1) as f64;
                let place = [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
                let middle = [0, 1].map(|axis| 0.5 * (point[axis] + other[axis]) - place[axis]);
                assert!(middle[0].hypot(middle[1]) < DIGIT, "{name}: {}", shown.name);
                largest = largest.max((point[0] - place[0]).hypot(point[1] - place[1]));
            }
        }
        assert!(largest < 56.1, "{name}: {largest}");
    }
}

/// Many half waves: the line has so many points that it shows all of them.
#[test]
fn a_hundred_half_waves_are_drawn() {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let steps = [
        ListStep::Tip(Support::Pinned),
        ListStep::Element(AnyUndamped::try_from(beam).unwrap()),
        ListStep::Root(Support::Pinned),
    ];
    let mut room = Room::<3>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    let omega = (100.0 * std::f64::consts::PI).powi(2);
    let root = list.frequencies_in(0.999 * omega..=1.001 * omega).unwrap()[0];
    let shape = list.mode_shape(&root).unwrap();
    let picture = Picture::of(Drawing::of(&list).unwrap().mode(&shape).unwrap());
    let still = picture.shown("still");
    let line = &part(&still, "step 1").paths[0];
    let height = line[0][1];
    let signs: Vec<bool> =
        line.iter().filter(|point| (point[1] - height).abs() > 5.0).map(|point| point[1] > height).collect();
    assert_eq!(1 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count(), 100);
}

/// A shape of another list, whose members are not there.
#[test]
fn a_motion_that_is_not_known_is_an_error() {
    let section = mstmm::network::Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };
    type Member = mstmm::network::Member<mstmm::network::UndampedMember<f64>>;
    let nodes: [_; 4] = std::array::from_fn(|k| mstmm::network::Node::at([k as f64, 0.0]));
    let members: [_; 3] = std::array::from_fn(|k| Member::new(k, k + 1, section));
    let short = mstmm::network::Network::new(&nodes[..3], &members[..2]).unwrap();
    let long = mstmm::network::Network::new(&nodes, &members).unwrap();
    let root = short.frequencies(5).unwrap().into_iter().find(|root| root.omega > 1.0).unwrap();
    let shape = FrameAnalysis::mode_shape(&short, &root).unwrap();
    let error = Drawing::of(&long).unwrap().mode(&shape).unwrap_err();
    assert!(matches!(error, DrawingError::Motion(MotionError::NoSuchPoint { index: 3 })), "{error}");
}
