//! Diagrams of internal forces: ordinates, sides and written values.

use crate::reading::Picture;
use mstmm::motion::PlaneLoad;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError, Force};
use paper::models;

const DIGIT: f64 = 0.0101;

system! {
    /// A beam on two supports.
    struct Simple { l: f64 }
    pinned at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> roller at (l, 0.0);
}

/// The ordinates of a member, at their feet, upwards and in its unit.
fn ordinates(picture: &Picture, name: &str) -> Vec<[f64; 2]> {
    let force = picture.shown("force");
    let area = &force.iter().find(|shown| shown.name == name).unwrap().paths[0];
    let scale = picture.number("data-force-scale");
    let (feet, tips) = area.split_at(2);
    tips.iter().rev().map(|[x, y]| [picture.in_model([*x, 0.0])[0], (feet[0][1] - y) / scale]).collect()
}

/// The moment of a beam on two supports under a uniform load downwards is `q x (l - x)/2`, drawn below it, where it is stretched; its shear
/// force `q (l/2 - x)`, drawn above where it is positive.
#[test]
fn diagrams_are_those_of_a_beam_on_two_supports() {
    let beam = Simple { l: 4.0 }.build().unwrap();
    let load = PlaneLoad::self_weight_y();
    let middle = beam.frequency_response(load, Simple::beam_1.input().rotation_z()).unwrap();
    // per m/s² upwards
    let states = middle.states(0.0).unwrap();
    let q = -20.0;
    let picture = Picture::of(Drawing::of(&beam).unwrap().forces(&states, Force::Moment).unwrap());
    let unit = DIGIT / picture.number("data-force-scale");
    let moments = ordinates(&picture, "beam 1");
    assert!(moments.len() >= 25);
    for [x, upwards] in moments {
        let moment = 0.5 * q * x * (4.0 - x);
        assert!((upwards + moment).abs() < 2.0 * unit, "{x}: {upwards}");
    }
    let written = |picture: &Picture| -> Vec<String> {
        picture.labels().into_iter().filter(|label| label.class == "value").map(|label| label.text).collect()
    };
    assert_eq!(written(&picture), ["−40.0"]);
    let picture = Picture::of(Drawing::of(&beam).unwrap().forces(&states, Force::Shear).unwrap());
    let unit = DIGIT / picture.number("data-force-scale");
    for [x, upwards] in ordinates(&picture, "beam 1") {
        assert!((upwards - q * (2.0 - x)).abs() < 2.0 * unit, "{x}: {upwards}");
    }
    assert_eq!(written(&picture), ["−40.0"]);
}

/// Along a beam of a tree, against the states of its shape.
#[test]
fn diagrams_of_trees_are_the_states_along_them() {
    let model = models::two_spans();
    let system = model.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<3>().unwrap()[2]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().forces(&shape, Force::Moment).unwrap());
    let unit = DIGIT / picture.number("data-force-scale");
    let values = ordinates(&picture, "beam 3");
    let moment = |index: usize| {
        let length = model.spring_position - model.support_position;
        let place = length * index as f64 / (values.len() - 1) as f64;
        shape.along(models::TwoSpans::beam_3, place.min(length)).unwrap().m
    };
    // a mode has no sign
    let sign = (-moment(0) * values[0][1]).signum();
    for (index, [_, upwards]) in values.iter().enumerate() {
        assert!((sign * upwards + moment(index)).abs() < 2.0 * unit, "{index}: {upwards} and {}", moment(index));
    }
}

#[test]
fn forces_that_no_member_has_are_an_error() {
    let system = models::two_spans().build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let error = Drawing::of(&system).unwrap().forces(&shape, Force::Axial).unwrap_err();
    assert!(matches!(error, DrawingError::NoForce { force: "axial force" }), "{error}");
}
