//! What cannot be drawn, and why.

use mstmm_core::MotionError;
use std::io;

/// A model, or a motion, that cannot be drawn.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// There is no point and no member; of a diagram no frequency or no speed.
    #[error("there is nothing to draw: no point, or no frequency")]
    Empty,
    /// A coordinate or a length is not finite.
    #[error("{name} has the coordinate {value}, which no drawing has")]
    NotFinite {
        /// What the source calls it.
        name: String,
        /// The coordinate or the length.
        value: f64,
    },
    /// The model is so large, or so small, that its scale is no number.
    #[error("a model of the size {size:e} has no scale")]
    Size {
        /// Its largest extent.
        size: f64,
    },
    /// Factors of participation are those of another list of roots.
    #[error("the list has {roots} roots, but the participation is that of {of_shapes}")]
    Roots {
        /// Roots of the list.
        roots: usize,
        /// Roots of the participation.
        of_shapes: usize,
    },
    /// An angle of a view is not finite.
    #[error("a view with the azimuth {azimuth} and the elevation {elevation} has no direction")]
    View {
        /// The azimuth in degrees.
        azimuth: f64,
        /// The elevation in degrees.
        elevation: f64,
    },
    /// The motion is not known.
    #[error("the motion cannot be drawn: {0}")]
    Motion(#[from] MotionError),
    /// The motion is not finite.
    #[error("the motion of {name} is not finite")]
    MotionNotFinite {
        /// What the source calls the member or the point.
        name: String,
    },
    /// No member has such a force.
    #[error("of no member is a {force} drawn")]
    NoForce {
        /// The force.
        force: &'static str,
    },
    /// A load acts on nothing that is drawn, or is no force and no moment.
    #[error(
        "the load has no place in the drawing: it acts on no point, no member and no mass that is drawn, or is no force"
    )]
    NoPlace,
    /// The amount of a load is not finite.
    #[error("the load has the amount {amount}, which no arrow has")]
    LoadNotFinite {
        /// The amount.
        amount: f64,
    },
    /// The file refuses.
    #[error("the file cannot be written: {0}")]
    Io(#[from] io::Error),
}

/// Its text, so that a program whose `main` returns it prints a sentence.
impl std::fmt::Debug for DrawingError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}
