//! A mast in space with a closed form, a spring beside it, and its modes on lines.

use mstmm::frame::{Frame, Section, Space, Structure};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_files::{MemberLines, Mode};

pub(crate) const HEIGHT: f64 = 8.0;
pub(crate) const MASS_PER_LENGTH: f64 = 20.0;
pub(crate) const STIFFNESS: f64 = 7e5;

/// The first wave number of a cantilever times its length.
pub(crate) const WAVE: f64 = 1.875_104_068_711_961;

/// A mast along z that is softest along y, with a spring without force from its tip to a point that is held.
pub(crate) fn mast() -> Structure<Space> {
    let mut frame = Frame::new();
    let [foot, tip, beside] = [[0.0, 0.0, 0.0], [0.0, 0.0, HEIGHT], [3.0, 0.0, HEIGHT]].map(|place| frame.point(place));
    let steel = Section::new()
        .axial_stiffness(4e8)
        .torsional_stiffness(4e5)
        .bending_stiffness_y(2e6)
        .bending_stiffness_z(STIFFNESS)
        .mass_per_length(MASS_PER_LENGTH)
        .polar_inertia_per_length(0.06);
    frame.member(foot, tip, steel.up([1.0, 0.0, 0.0]));
    // along x, across the first mode
    frame.member(tip, beside, mstmm::elements::Spring { stiffness: 1e3 });
    frame.hold(foot, Support::Fixed);
    frame.hold(beside, Support::Pinned);
    frame.build().unwrap()
}

/// The lines of the mast and its first modes on them.
pub(crate) fn modes(count: usize) -> (MemberLines<mstmm::frame::InFrame>, Vec<Mode>) {
    let mast = mast();
    let lines = MemberLines::of(&mast, 20);
    let roots = mast.frequencies(count).unwrap();
    let shapes = roots.iter().map(|root| lines.motions(&mast.mode_shape(root).unwrap()).unwrap());
    let modes = shapes.zip(&roots).map(|(shape, root)| Mode::from(*root).with_vectors(shape)).collect();
    (lines, modes)
}

/// The first shape across the mast, of unit modal mass, at a height.
pub(crate) fn first_shape(height: f64) -> f64 {
    let x = WAVE * height / HEIGHT;
    let ratio = (WAVE.sinh() - WAVE.sin()) / (WAVE.cosh() + WAVE.cos());
    (x.cosh() - x.cos() - ratio * (x.sinh() - x.sin())) / (MASS_PER_LENGTH * HEIGHT).sqrt()
}

/// The first natural frequency in hertz.
pub(crate) fn first_hertz() -> f64 {
    (WAVE / HEIGHT).powi(2) * (STIFFNESS / MASS_PER_LENGTH).sqrt() / std::f64::consts::TAU
}
