//! The models of tests/data/answers.json, whose values are those of independent fields with 40 digits.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use core::f64::consts::TAU;
use mstmm::Complex;
use mstmm::elements::Spring;
use mstmm::frame::{Frame, Ground, Line, Member, OfBeam, Plane, Point, PointMass, Section, Structure};
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;
use serde_json::Value;

system! {
    /// A beam with a mass and a spring at its tip.
    #[derive(Clone, Copy)]
    pub(crate) struct Cantilever {}
    fixed -> beam 1 { length: 1.2, bending_stiffness: 180.0, mass_per_length: 2.5 } -> point_mass 2 { mass: 0.8, inertia: 0.0 } -> conn tip -> free;
    fixed -> spring 3 { stiffness: 350.0 } -> conn tip;
}

system! {
    /// A portal frame with a mass at a corner.
    #[derive(Clone, Copy)]
    pub(crate) struct Portal {}
    section steel { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 }
    conn a at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0) -> beam 3 { ..steel }
        -> conn d at (4.0, 0.0);
    fixed -> conn a;
    pinned -> conn d;
    conn b -> point_mass 4 { mass: 100.0 };
}

/// The cantilever between places, with its foot, its tip and its beam: its support moves, and its weight has a bound.
pub(crate) fn cantilever() -> (Structure<Line>, [Point<Line>; 2], Member<OfBeam>) {
    let mut frame = Frame::new();
    let [foot, tip] = [0.0, 1.2].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    let beam = frame.member(foot, tip, Section::new().bending_stiffness(180.0).mass_per_length(2.5));
    frame.member(tip, Ground, Spring { stiffness: 350.0 });
    frame.mass(tip, 0.8);
    (frame.build().unwrap(), [foot, tip], beam)
}

/// Three members at 120°, with a mass in the middle, which is the point.
pub(crate) fn three_spokes() -> (Structure<Plane>, Point<Plane>) {
    let mut frame = Frame::new();
    let middle = frame.point([0.0, 0.0]);
    let spoke = Section::new().axial_stiffness(3e7).bending_stiffness(2e5).mass_per_length(12.0);
    for third in 0..3 {
        let (sin, cos) = (f64::from(third) * TAU / 3.0 + 0.4).sin_cos();
        let end = frame.point([2.0 * cos, 2.0 * sin]);
        frame.hold(end, Support::Fixed);
        frame.member(middle, end, spoke);
    }
    frame.body([middle], PointMass { mass: 40.0, inertia: 0.9 });
    (frame.build().unwrap(), middle)
}

/// A mass that moves along x on a spring, with the foot of the spring and the mass.
pub(crate) fn oscillator(stiffness: f64, mass: f64) -> (Frame<Plane>, [Point<Plane>; 2]) {
    let mut frame = Frame::new();
    let points @ [foot, moved] = [[0.0, 0.0], [1.0, 0.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(foot.along([1.0, 0.0]), moved.along([1.0, 0.0]), Spring { stiffness });
    frame.mass(moved, mass);
    frame.hold(moved, Freedoms::Y);
    (frame, points)
}

/// A part of the file.
pub(crate) fn reference(part: &str) -> Value {
    let file: Value = serde_json::from_str(include_str!("../data/answers.json")).unwrap();
    file[part].clone()
}

/// A number of the file, which stands there as text.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_str().map_or_else(|| value.as_f64().unwrap(), |text| text.parse().unwrap())
}

#[track_caller]
pub(crate) fn assert_close(found: impl Into<Complex<f64>>, expected: impl Into<Complex<f64>>, tolerance: f64) {
    let (found, expected) = (found.into(), expected.into());
    let error = (found - expected).norm() / expected.norm();
    assert!(error <= tolerance, "{found} instead of {expected}: {error:e}");
}
