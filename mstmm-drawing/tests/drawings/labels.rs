//! All labels of a model are there, each once, and none covers another.

use crate::frames::for_each_frame;
use crate::reading::{Label, Picture};
use mstmm::motion::{Drawn, DrawnPart, DrawnTree};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, Force};
use paper::models;
use std::collections::BTreeSet;

/// Sizes of letters, as the style sheet has them, half of their width as a part of that: few letters are wider; and half of the height of one.
const SIZE: f64 = 13.0;
const HALF_WIDTH: f64 = 0.3;
const HALF_HEIGHT: f64 = 0.38;

/// Half of the width of the widest line but that of a body, which has one of its own.
const THICK: f64 = 0.6;

fn check(name: &str, labels: &[Label], expected: &BTreeSet<String>) {
    let of_class = |is_joint: bool| {
        let own = labels.iter().filter(move |label| label.class != "value" && (label.class == "joint") == is_joint);
        own.map(|label| label.name.clone()).collect::<BTreeSet<String>>()
    };
    // a joint without room beside it has no label
    let (shown, joints) = (&of_class(false) | &of_class(true), of_class(true));
    assert!(shown.is_subset(expected), "{name}");
    let without = expected.difference(&shown).filter(|label| !is_joint(label)).count();
    assert!(without == 0, "{name}: {:?}", expected.difference(&shown));
    assert!(joints.iter().all(|label| is_joint(label)), "{name}");
    let count = labels.iter().filter(|label| label.class != "value").count();
    assert_eq!(count, shown.len(), "{name}: one twice");
    for label in labels.iter().filter(|label| label.class != "value") {
        assert_eq!(Some(label.text.as_str()), label.name.rsplit(' ').next(), "{name}");
    }
    check_apart(name, labels);
}

/// No label covers another one.
fn check_apart(name: &str, labels: &[Label]) {
    for (index, label) in labels.iter().enumerate() {
        for other in &labels[..index] {
            let half = |label: &Label| HALF_WIDTH * SIZE * label.text.chars().count() as f64;
            let [x, y] = [0, 1].map(|axis| (label.at[axis] - other.at[axis]).abs());
            assert!(x >= half(label) + half(other) || y >= SIZE, "{name}: {} covers {}", label.name, other.name);
        }
    }
}

/// Whether a name is that of a joint.
fn is_joint(name: &str) -> bool {
    ["pin", "hinge", "slider", "release", "planar_hinge"].iter().any(|word| name.starts_with(word))
}

/// How far a place is from a line.
fn distance(place: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let [way, arm] = [to, place].map(|end| [end[0] - from[0], end[1] - from[1]]);
    let square = way[0] * way[0] + way[1] * way[1];
    let part = if square > 0.0 { ((way[0] * arm[0] + way[1] * arm[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (arm[0] - part * way[0]).hypot(arm[1] - part * way[1])
}

/// No line of the model or of its motion passes through a label, looked at in a net of places of its box.
fn check_clear(name: &str, picture: &Picture, class: &str) {
    let shown = picture.shown(class);
    for label in picture.labels() {
        let half = [HALF_WIDTH * SIZE * label.text.chars().count() as f64, HALF_HEIGHT * SIZE];
        let net = (0..=8).flat_map(|k| (0..=8).map(move |l| [k, l].map(|part| f64::from(part) / 4.0 - 1.0)));
        let places: Vec<[f64; 2]> = net.map(|way| [0, 1].map(|axis| label.at[axis] + way[axis] * half[axis])).collect();
        for part in &shown {
            // in a body or a block its own number, above what ends there
            if ["rigid_body", "body", "mass"].iter().any(|word| label.name.starts_with(word)) {
                continue;
            }
            let lines = part.lines(false).flat_map(|path| path.windows(2).map(|pair| [pair[0], pair[1]]));
            for line in lines {
                let least = places.iter().map(|place| distance(*place, line)).fold(f64::INFINITY, f64::min);
                assert!(least > THICK, "{name}: {} on {}", label.name, part.name);
            }
        }
    }
}

/// The names of a frame that its source has.
fn of_frame<Y: Drawn + FrameAnalysis>(frame: &Y) -> BTreeSet<String> {
    let sketch = FrameAnalysis::sketch(frame);
    let points = sketch
        .points()
        .map(|point| point.name.to_string())
        .filter(|name| name.starts_with("conn ") || name.starts_with("node "));
    let members = sketch.members().filter(|member| member.kind != "tie").map(|member| member.name.to_string());
    points.chain(members).chain(sketch.bodies().map(|body| body.name.to_string())).collect()
}

/// The names of a tree that its source has.
fn of_tree<Y: DrawnTree>(tree: &Y) -> BTreeSet<String> {
    let steps = ModalAnalysis::sketch(tree);
    let named = steps.steps().filter(|step| !matches!(step.part, DrawnPart::Support(_)));
    named.map(|step| step.name.to_string()).collect()
}

fn check_frame<Y>(name: &str, frame: &Y)
where
    Y: Drawn + FrameAnalysis,
{
    let picture = Picture::of(Drawing::of(frame).unwrap());
    check(name, &picture.labels(), &of_frame(frame));
    check_clear(name, &picture, "model");
}

fn check_tree<Y>(name: &str, tree: &Y)
where
    Y: DrawnTree,
{
    let picture = Picture::of(Drawing::of(tree).unwrap());
    check(name, &picture.labels(), &of_tree(tree));
    check_clear(name, &picture, "model");
}

#[test]
fn labels_are_there_once_and_cover_no_other() {
    for_each_frame!(|name, frame| check_frame(name, frame));
    check_tree("4.1", &models::light_tip_body().build().unwrap());
    check_tree("4.2", &models::restrained_beam().build().unwrap());
    check_tree("4.3", &models::spring_and_mass().build().unwrap());
    check_tree("4.4", &models::two_spans().build().unwrap());
    check_tree("4.5", &models::damped_oscillator().build().unwrap());
    check_tree("chain", &crate::trees::chain());
    check_tree("fork", &crate::trees::fork());
    check_tree("plane", &crate::trees::plane());
}

/// In a body or a block nothing is drawn over its number, and that is within its sides.
#[test]
fn numbers_of_bodies_stand_in_them() {
    let picture = Picture::of(Drawing::of(&crate::frames::vehicle()).unwrap());
    let (labels, shown) = (picture.labels(), picture.shown("model"));
    for name in ["mass 3", "mass 6", "mass 9", "rigid_body 1"] {
        let label = labels.iter().find(|label| label.name == name).unwrap();
        let block = &shown.iter().find(|part| part.name == name).unwrap().paths[0];
        for axis in 0..2 {
            let [low, high] =
                [f64::min, f64::max].map(|of| block.iter().map(|corner| corner[axis]).reduce(of).unwrap());
            assert!(low - 9.0 < label.at[axis] - 6.0 && label.at[axis] + 6.0 < high + 9.0, "{name}");
        }
        assert!(picture.leaders().iter().all(|[_, end]| distance(label.at, [*end; 2]) > 12.0), "{name}");
    }
}

/// Along a vehicle's axle each number is nearer to its own part than to any other: strut, wheel and tyre are told apart.
#[test]
fn numbers_in_a_row_are_beside_their_own_part() {
    let picture = Picture::of(Drawing::of(&crate::frames::vehicle()).unwrap());
    let (labels, shown) = (picture.labels(), picture.shown("model"));
    let middle = |name: &str| {
        let points = shown.iter().find(|part| part.name == name).unwrap().paths.concat();
        [f64::min, f64::max].map(|of| points.iter().map(|[_, y]| *y).reduce(of).unwrap()).iter().sum::<f64>() / 2.0
    };
    for (name, others) in [("spring 2", ["mass 3", "spring 4"]), ("spring 4", ["mass 3", "spring 2"])] {
        let [_, y] = labels.iter().find(|label| label.name == name).unwrap().at;
        let beside = (y - middle(name)).abs();
        assert!(others.iter().all(|other| (y - middle(other)).abs() > 2.0 * beside + 10.0), "{name}");
    }
}

/// A line leads to a label that stands far from its point, and passes through no other label.
#[test]
fn lines_lead_to_labels_that_stand_far_away() {
    let truss = crate::frames::truss();
    let shape = truss.mode_shape(&truss.first_frequencies::<2>().unwrap()[1]).unwrap();
    let picture = Picture::of(Drawing::of(&truss).unwrap().forces(&shape, Force::Axial).unwrap());
    let leaders = picture.leaders();
    assert!(!leaders.is_empty());
    for [from, to] in leaders {
        for label in picture.labels() {
            let beside = distance(label.at, [from, to]);
            let own = distance(label.at, [to; 2]);
            // it ends at the side of its own label, and is as far from each other one as half of a line of text
            assert!(own < 0.6 * SIZE + HALF_WIDTH * SIZE * label.text.len() as f64 || beside > 6.0, "{}", label.name);
        }
    }
}

#[test]
fn labels_are_clear_of_motions_and_diagrams() {
    let truss = crate::frames::truss();
    let shape = truss.mode_shape(&truss.first_frequencies::<2>().unwrap()[1]).unwrap();
    let picture = Picture::of(Drawing::of(&truss).unwrap().mode(&shape).unwrap());
    check_clear("truss", &picture, "rest");
    check_clear("truss", &picture, "still");
    let picture = Picture::of(Drawing::of(&truss).unwrap().forces(&shape, Force::Axial).unwrap());
    check_clear("truss", &picture, "model");
    check_clear("truss", &picture, "force");
    let vehicle = crate::frames::vehicle();
    let shape = vehicle.mode_shape(&vehicle.first_eigenvalues::<3>().unwrap()[1]).unwrap();
    let picture = Picture::of(Drawing::of(&vehicle).unwrap().mode(&shape).unwrap());
    check_clear("vehicle", &picture, "rest");
    check_clear("vehicle", &picture, "still");
}

#[test]
fn values_of_diagrams_cover_no_label() {
    let truss = crate::frames::truss();
    let shape = truss.mode_shape(&truss.first_frequencies::<2>().unwrap()[1]).unwrap();
    for force in [Force::Axial, Force::Shear, Force::Moment] {
        let drawing = Drawing::of(&truss).unwrap().mode(&shape).unwrap().forces(&shape, force).unwrap();
        let labels = Picture::of(drawing).labels();
        assert!(labels.iter().filter(|label| label.class == "value").count() > 5);
        check("truss", &labels, &of_frame(&truss));
    }
}

/// Ten points within a hair's breadth: the labels of as many as have room stand around them, the others are left out.
#[test]
fn many_labels_at_one_place_stand_around_it() {
    let section = mstmm::network::Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };
    let nodes: [_; 10] =
        std::array::from_fn(|k| mstmm::network::Node::at([if k == 0 { 0.0 } else { 1.0 + 1e-5 * k as f64 }, 0.0]));
    type Member = mstmm::network::Member<mstmm::network::UndampedMember<f64>>;
    let members: [_; 9] = std::array::from_fn(|k| Member::new(k, k + 1, section));
    let crowd = mstmm::network::Network::new(&nodes, &members).unwrap();
    let picture = Picture::of(Drawing::of(&crowd).unwrap());
    let labels = picture.labels();
    assert!(labels.len() >= 10, "{}", labels.len());
    check_apart("crowd", &labels);
    check_clear("crowd", &picture, "model");
    assert!(picture.leaders().len() >= 8);
}
