//! The drawing of a model: its parts, and how their points move.

use crate::problem::Problem;
use crate::shown::Shown;
use mstmm::Complex;

/// What a part of a drawing is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A line through points.
    Beam,
    /// A mass at a point.
    Mass,
    /// A spring between two points.
    Spring,
    /// A dashpot between two points.
    Dashpot,
    /// A support that holds the place of a point.
    Pinned,
    /// A support that holds a point.
    Fixed,
}

/// Names of the kinds, in their order.
pub const KINDS: [&str; 6] = ["beam", "mass", "spring", "dashpot", "pinned", "fixed"];

/// Pieces in which beams are drawn.
const PIECES: u32 = 12;

/// Places along a beam at which it is drawn, from its input end on [m].
pub(crate) fn stations(length: f64) -> impl Iterator<Item = f64> {
    (0..=PIECES).map(move |k| if k == PIECES { length } else { length * f64::from(k) / f64::from(PIECES) })
}

impl Shown {
    /// Draws a part with points of its own.
    pub(crate) fn draw(&self, kind: Kind, points: impl IntoIterator<Item = [f64; 2]>) -> Result<(), Problem> {
        let first = self.points.length() / 2;
        points.into_iter().try_for_each(|point| self.points.push(&point))?;
        let count = self.points.length() / 2 - first;
        self.parts.push(&[f64::from(kind as u8), first as f64, count as f64])
    }

    /// Moves the next point in a mode.
    pub(crate) fn moved(&self, x: Complex<f64>, y: Complex<f64>) -> Result<(), Problem> {
        self.shapes.push(&[x.re, x.im, y.re, y.im])
    }

    /// Leaves all points at rest in a mode that has no shape of its own, as where two eigenvalues meet.
    pub(crate) fn rests(&self) -> Result<(), Problem> {
        let points = self.points.length() / 2;
        (0..points).try_for_each(|_| self.moved(Complex::default(), Complex::default()))
    }
}
