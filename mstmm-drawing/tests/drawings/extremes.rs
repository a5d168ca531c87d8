//! Models of all sizes, and such as have none: a drawing or an error, and no panic.

use crate::reading::Picture;
use mstmm::elements::{Beam, Mass, Spring};
use mstmm::list::{AnyUndamped, ListStep, Room, StepList, Support};
use mstmm::network::{Member, Network, Node, Section, UndampedMember};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError};

/// A cantilever of a length, as a frame.
fn frame(length: f64, stiffness: f64) -> Result<String, DrawingError> {
    let section =
        Section { axial_stiffness: stiffness, bending_stiffness: stiffness * length * length, mass_per_length: 1.0 };
    let nodes = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), Node::at([length, 0.0])];
    let members = [Member::<UndampedMember<f64>>::new(0, 1, section)];
    let network = Network::new(&nodes, &members).unwrap();
    Ok(Drawing::of(&network)?.to_string())
}

/// A cantilever of a length, as a tree.
fn tree(length: f64) -> Result<String, DrawingError> {
    let beam = Beam { length, bending_stiffness: length.powi(3), mass_per_length: 1.0 };
    let Ok(beam) = AnyUndamped::try_from(beam) else { return Ok(String::new()) };
    let steps = [ListStep::Tip(Support::Fixed), ListStep::Element(beam), ListStep::Root(Support::Free)];
    let mut room = Room::<3>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    Ok(Drawing::of(&list)?.to_string())
}

#[test]
fn models_of_all_sizes_fill_the_same_paper() {
    let width = |picture: &str| Picture::of(picture).number("width");
    let usual = width(&frame(1.0, 1.0).unwrap());
    for exponent in [-60, -9, -3, 3, 9, 60] {
        let length = 10.0_f64.powi(exponent);
        assert_eq!(width(&frame(length, 1.0).unwrap()), usual, "{length}");
        let drawn = tree(length).unwrap();
        assert!(drawn.is_empty() || width(&drawn) == width(&tree(1.0).unwrap()), "{length}");
    }
}

#[test]
fn models_of_one_place_are_drawn() {
    let element = |element: Result<AnyUndamped<f64>, _>| ListStep::Element(element.unwrap());
    let steps = [
        ListStep::Tip(Support::Fixed),
        element(Spring { stiffness: 1.0 }.try_into()),
        element(Mass { mass: 1.0 }.try_into()),
        ListStep::Root(Support::Free),
    ];
    let mut room = Room::<4>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    let shape = list.mode_shape(&list.first_frequencies::<1>().unwrap()[0]).unwrap();
    let picture = Picture::of(Drawing::of(&list).unwrap().mode(&shape).unwrap());
    assert_eq!(picture.shown("rest").len(), 2);
    let nodes = [Node::at([2.0, 1.0]), Node::at([2.0, 1.0]).held(Support::Fixed.holds())];
    let spring = Member::<UndampedMember<f64>>::new(0, 1, Spring { stiffness: 1.0 }).along([1.0, 0.0]);
    let network = Network::new(&nodes, std::slice::from_ref(&spring)).unwrap();
    let drawn = Picture::of(Drawing::of(&network).unwrap());
    assert!(drawn.number("width") > 10.0 && drawn.number("height") > 10.0);
}

#[test]
fn sizes_without_a_scale_are_an_error() {
    for length in [1e-306, 1e-320] {
        let nodes = [Node::at([0.0, 0.0]), Node::at([length, 0.0])];
        let spring = Member::<UndampedMember<f64>>::new(0, 1, Spring { stiffness: 1.0 }).along([1.0, 0.0]);
        let Ok(network) = Network::new(&nodes, std::slice::from_ref(&spring)) else {
            continue;
        };
        let drawn = Drawing::of(&network);
        assert!(matches!(drawn, Ok(_) | Err(DrawingError::Size { .. })), "{length}");
    }
    let nodes = [Node::at([-1e308, 0.0]), Node::at([1e308, 0.0])];
    let spring = Member::<UndampedMember<f64>>::new(0, 1, Spring { stiffness: 1.0 }).along([1.0, 0.0]);
    if let Ok(network) = Network::new(&nodes, std::slice::from_ref(&spring)) {
        let error = Drawing::of(&network).unwrap_err();
        assert!(matches!(error, DrawingError::Size { .. }), "{error}");
    }
}

#[test]
fn a_file_that_refuses_is_an_error() {
    let system = crate::frames::ring();
    let error = Drawing::of(&system).unwrap().write("/nowhere/to/be/found.svg").unwrap_err();
    assert!(error.to_string().starts_with("the file cannot be written"), "{error}");
}
