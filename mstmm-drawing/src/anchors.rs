//! Collects anchors while a model is put on the paper.

use crate::error::DrawingError;
use crate::vector::Vector;

/// The largest extent of a picture along x, and along y.
const ROOM: Vector = [520.0, 380.0];

/// From metres of the model to the paper: y upwards becomes y downwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    origin: Vector,
    pub(crate) size: f64,
}

impl Scale {
    /// The scale of a model with such places, which are named for errors.
    pub(crate) fn of<'a>(places: impl Iterator<Item = (&'a str, Vector)>) -> Result<Self, DrawingError> {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (name, place) in places {
            for axis in 0..2 {
                let value = place[axis];
                if !value.is_finite() {
                    return Err(DrawingError::NotFinite { name: name.to_owned(), value });
                }
                (low[axis], high[axis]) = (low[axis].min(value), high[axis].max(value));
            }
        }
        if low[0] > high[0] {
            return Err(DrawingError::Empty);
        }
        let extent = [high[0] - low[0], high[1] - low[1]];
        let size = extent[0].max(extent[1]);
        if size == 0.0 {
            return Ok(Scale { origin: low, size: 1.0 });
        }
        let scale = [0, 1].map(|axis| ROOM[axis] / extent[axis]).into_iter().fold(f64::INFINITY, f64::min);
        // a place on the paper has the digits of a number of the model
        let is_known = scale.is_normal() && (low[0].abs().max(low[1].abs()) * scale).is_finite();
        if is_known { Ok(Scale { origin: low, size: scale }) } else { Err(DrawingError::Size { size }) }
    }

    /// Another size of a metre on the paper.
    pub(crate) fn with_size(self, size: f64) -> Scale {
        Scale { size, ..self }
    }

    /// A place of the model on the paper.
    pub(crate) fn place(&self, [x, y]: Vector) -> Vector {
        [(x - self.origin[0]) * self.size, (self.origin[1] - y) * self.size]
    }
}
