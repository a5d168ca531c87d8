//! All labels of a model are there, each once, and none covers another.

use crate::frames::for_each_frame;
use crate::reading::{Label, Picture};
use mstmm::motion::{Drawn, DrawnPart, DrawnTree};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, Force};
use paper::models;
use std::collections::BTreeSet;

/// Sizes of letters, as the style sheet has them, and half of their width as a part of that: few letters are wider.
const SIZE: f64 = 13.0;
const HALF_WIDTH: f64 = 0.3;

fn check(name: &str, labels: &[Label], expected: &BTreeSet<String>) {
    let shown: BTreeSet<String> =
        labels.iter().filter(|label| label.class != "value").map(|label| label.name.clone()).collect();
    assert_eq!(&shown, expected, "{name}");
    let count = labels.iter().filter(|label| label.class != "value").count();
    assert_eq!(count, shown.len(), "{name}: one twice");
    for label in labels.iter().filter(|label| label.class != "value") {
        assert_eq!(Some(label.text.as_str()), label.name.rsplit(' ').next(), "{name}");
    }
    for (index, label) in labels.iter().enumerate() {
        for other in &labels[..index] {
            let half = |label: &Label| HALF_WIDTH * SIZE * label.text.chars().count() as f64;
            let [x, y] = [0, 1].map(|axis| (label.at[axis] - other.at[axis]).abs());
            assert!(x >= half(label) + half(other) || y >= SIZE, "{name}: {} covers {}", label.name, other.name);
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
    check(name, &Picture::of(Drawing::of(frame).unwrap()).labels(), &of_frame(frame));
}

fn check_tree<Y>(name: &str, tree: &Y)
where
    Y: DrawnTree,
{
    check(name, &Picture::of(Drawing::of(tree).unwrap()).labels(), &of_tree(tree));
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

/// Ten points within a hair's breadth: their labels stand apart all the same.
#[test]
fn many_labels_at_one_place_find_room() {
    let section = mstmm::network::Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };
    let nodes: [_; 10] =
        std::array::from_fn(|k| mstmm::network::Node::at([if k == 0 { 0.0 } else { 1.0 + 1e-5 * k as f64 }, 0.0]));
    type Member = mstmm::network::Member<mstmm::network::UndampedMember<f64>>;
    let members: [_; 9] = std::array::from_fn(|k| Member::new(k, k + 1, section));
    let crowd = mstmm::network::Network::new(&nodes, &members).unwrap();
    check_frame("crowd", &crowd);
}
