//! Stiff beams are wide: widths are as the fourth roots of bending stiffnesses, at rest and in motion, of paths, frames and frames in space.

use crate::reading::{Picture, Shown};
use mstmm::frame::{Frame, Section};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;

/// The usual width of a beam, as the style sheet has it, and half of the last digit of a width.
const USUAL: f64 = 3.6;
const DIGIT: f64 = 0.0051;

system! {
    /// A shaft whose second half is stiffer.
    struct Stepped { thin: f64, thick: f64 }
    fixed -> beam 1 { length: 0.5, bending_stiffness: thin, mass_per_length: 3.0 }
          -> beam 2 { length: 0.5, bending_stiffness: thick, mass_per_length: 3.0, rotary_inertia: 1e-3 } -> free;
}

system! {
    /// A column and a girder, and a damped brace.
    struct Bent { column: f64, girder: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 4e8, bending_stiffness: column, mass_per_length: 20.0 } -> conn b at (0.0, 3.0)
        -> beam 2 { axial_stiffness: 4e8, bending_stiffness: girder, mass_per_length: 20.0 } -> conn tip at (2.0, 3.0)
        -> beam 3 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> pinned at (0.0, 1.0);
}

/// The width of a beam: of all its lines but halos the same.
fn width(all: &[Shown], name: &str) -> f64 {
    let lines = all.iter().filter(|shown| shown.name == name).flat_map(|shown| shown.classes.iter().zip(&shown.widths));
    let mut widths = lines.filter(|(class, _)| *class == "beam").map(|(_, width)| width.unwrap_or(USUAL));
    let first = widths.next().unwrap();
    assert!(widths.all(|width| width == first), "{name}");
    first
}

#[test]
fn beams_alike_have_the_usual_width() {
    let picture = Picture::of(Drawing::of(&Stepped { thin: 2e4, thick: 2e4 }.build().unwrap()).unwrap());
    let shown = picture.shown("model");
    assert_eq!(["beam 1", "beam 2"].map(|name| width(&shown, name)), [USUAL; 2]);
    assert!(shown.iter().all(|part| part.widths.iter().all(Option::is_none)));
}

#[test]
fn widths_are_as_the_fourth_roots_of_stiffnesses() {
    let system = Stepped { thin: 1e4, thick: 16e4 }.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let picture = Picture::of(Drawing::of(&system).unwrap().mode(&shape).unwrap());
    for class in ["rest", "still", "moving"] {
        let shown = picture.shown(class);
        let [thin, thick] = ["beam 1", "beam 2"].map(|name| width(&shown, name));
        assert!((thick / thin - 2.0).abs() < 2.0 * DIGIT && thick > USUAL, "{thin} {thick}");
    }
}

#[test]
fn members_of_frames_have_widths() {
    let frame = Bent { column: 81e6, girder: 1e6 }.build().unwrap();
    let stiffnesses: Vec<f64> =
        FrameAnalysis::sketch(&frame).members().map(|member| member.bending_stiffness).collect();
    assert_eq!(stiffnesses, [81e6, 1e6, 1e6]);
    let shown = Picture::of(Drawing::of(&frame).unwrap()).shown("model");
    let [column, girder, brace] = ["beam 1", "beam 2", "beam 3"].map(|name| width(&shown, name));
    assert!((column / girder - 3.0).abs() < 4.0 * DIGIT && girder == brace, "{column} {girder}");
    // a hair beside a wall is still seen
    let frame = Bent { column: 1e12, girder: 1.0 }.build().unwrap();
    let shown = Picture::of(Drawing::of(&frame).unwrap()).shown("model");
    let [column, girder] = ["beam 1", "beam 2"].map(|name| width(&shown, name));
    assert!(girder == 0.5 * USUAL && column < 2.0 * USUAL + DIGIT, "{column} {girder}");
}

/// In space by the stiffer of both planes, with paper around each piece that is wider.
#[test]
fn members_in_space_have_widths() {
    let section = |y: f64, z: f64| {
        let steel = Section::new().axial_stiffness(4e8).torsional_stiffness(4e5).bending_stiffness_y(y);
        steel.bending_stiffness_z(z).mass_per_length(20.0).polar_inertia_per_length(0.06)
    };
    let mut frame = Frame::new();
    let [foot, head, tip] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 1.0, 3.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, head, section(16e6, 16e6));
    frame.member(head, tip, section(1e6, 0.5e6));
    let crane = frame.build().unwrap();
    let shown = Picture::of(Drawing::of(&crane).unwrap()).shown("model");
    let [column, arm] = ["member 0", "member 1"].map(|name| width(&shown, name));
    assert!((column / arm - 2.0).abs() < 2.0 * DIGIT, "{column} {arm}");
    for part in shown.iter().filter(|part| part.name == "member 0") {
        let halos = part.classes.iter().zip(&part.widths).filter(|(class, _)| class.starts_with("halo"));
        halos.for_each(|(_, halo)| assert!(halo.unwrap() > column + 4.0));
    }
}
