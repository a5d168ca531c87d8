//! A drawing: a model, and what is drawn over it.

use crate::diagram::{Diagram, Force, diagrams};
use crate::error::DrawingError;
use crate::figure::Figure;
use crate::motion::{Motion, forces};
use crate::shape::{Number, Shape};
use crate::sketched::Sketched;
use crate::sketched::private::Figured;
use std::fmt;
use std::path::Path;

/// The largest displacement on the paper, as a part of the size of the model, and within what bounds.
const REACH: f64 = 0.11;
const LEAST_REACH: f64 = 22.0;
const MOST_REACH: f64 = 56.0;

/// A drawing of a model `M`, which prints as SVG.
pub struct Drawing<M> {
    pub(crate) figure: Figure<M>,
    /// A motion, and its unit on the paper with the phase at which the largest displacement is seen.
    pub(crate) motion: Option<(Motion, Number)>,
    /// A force with its diagrams, and its unit on the paper.
    pub(crate) force: Option<(Force, Vec<Diagram>, f64)>,
}

impl<M> fmt::Debug for Drawing<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Drawing").field("parts", &self.figure.parts.len()).finish_non_exhaustive()
    }
}

impl<M> Drawing<M> {
    /// The drawing of a built system: of a frame where its points are, of a tree of paths along its bending paths.
    ///
    /// # Errors
    /// [`DrawingError::Empty`] for a model without points, [`DrawingError::NotFinite`] and [`DrawingError::Size`] for one that no scale
    /// puts on the paper.
    pub fn of<Y, Kind>(system: &Y) -> Result<Self, DrawingError>
    where
        Y: Sketched<Kind> + Figured<Kind, Model = M>,
    {
        Ok(Drawing { figure: system.figure()?, motion: None, force: None })
    }

    /// The drawing with a motion over it: a mode shape, or of a frame the states of a response. Where the reader's settings allow, it moves.
    ///
    /// # Errors
    /// [`DrawingError::Motion`] where the motion is not known, [`DrawingError::MotionNotFinite`] where it is not finite.
    pub fn mode(mut self, shape: &impl Shape<M>) -> Result<Self, DrawingError> {
        let motion = Motion::of(&self.figure, shape)?;
        let places = || self.figure.anchors.iter().map(|anchor| anchor.at);
        let extent = |axis: usize| {
            let ends = places().map(|place| place[axis]);
            ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min)
        };
        let height = (REACH * extent(0).max(extent(1))).clamp(LEAST_REACH, MOST_REACH);
        let (largest, phase) = motion.largest();
        let reach = Some(height / largest).filter(|reach| reach.is_finite()).unwrap_or(0.0);
        self.motion = Some((motion, Number::from_polar(reach, -phase)));
        Ok(self)
    }

    /// The drawing with an internal force of all beams over it, of a mode shape or the states of a response: of a complex motion its real part.
    ///
    /// # Errors
    /// As [`mode`](Drawing::mode); [`DrawingError::NoForce`] where no member has such a force, or all are zero.
    pub fn forces(mut self, shape: &impl Shape<M>, force: Force) -> Result<Self, DrawingError> {
        let values = forces(&self.figure, shape, force)?;
        let (diagrams, scale) =
            diagrams(&self.figure, force, &values).ok_or(DrawingError::NoForce { force: force.name() })?;
        self.force = Some((force, diagrams, scale));
        Ok(self)
    }

    /// Writes the drawing to a file.
    ///
    /// # Errors
    /// [`DrawingError::Io`] where the file refuses.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), DrawingError> {
        Ok(std::fs::write(path, self.to_string())?)
    }
}
