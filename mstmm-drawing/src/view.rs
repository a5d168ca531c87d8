//! From where a structure in space is seen.

use crate::error::DrawingError;
use crate::vector::Vector;
use crate::vector3::{Vector3, cross, dot3};
use std::ops::{Add, Mul};

/// From where a structure in space is seen: from so far away that parallel lines stay parallel, with z upwards on the paper.
///
/// A model of the plane is seen from before it, whatever the view.
///
/// ```
/// use mstmm::frame::{Frame, Section};
/// use mstmm::network::Support;
/// use mstmm_drawing::{Drawing, View};
///
/// let steel = Section::new().axial_stiffness(4e8).torsional_stiffness(4e5).bending_stiffness(2e6);
/// let steel = steel.mass_per_length(20.0).polar_inertia_per_length(0.06);
/// let mut frame = Frame::new();
/// let [foot, head, tip] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 1.0, 3.0]].map(|place| frame.point(place));
/// frame.hold(foot, Support::Fixed);
/// frame.member(foot, head, steel);
/// frame.member(head, tip, steel);
/// let crane = frame.build()?;
///
/// let from_above = Drawing::of(&crane)?.view(View::plan())?.to_string();
/// let from_the_side = Drawing::of(&crane)?.view(View::of(20.0, 15.0))?.to_string();
/// assert!(from_above.starts_with("<svg") && from_above != from_the_side);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    azimuth: f64,
    elevation: f64,
}

impl View {
    /// The view from a direction, in degrees: the azimuth from x towards y, the elevation above the plane of x and y.
    ///
    /// At an elevation of 90° or -90° one looks along z, and the azimuth says what is upwards on the paper: what is farthest, or nearest, below it.
    pub const fn of(azimuth: f64, elevation: f64) -> Self {
        View { azimuth, elevation }
    }

    /// The view in which all three axes are equally long: x to the right and nearer, y to the right and farther, z upwards.
    pub const fn isometric() -> Self {
        View::of(-45.0, 35.264_389_682_754_654)
    }

    /// From above: x to the right, y upwards.
    pub const fn plan() -> Self {
        View::of(-90.0, 90.0)
    }

    /// From the front, along y: x to the right, z upwards.
    pub const fn front() -> Self {
        View::of(-90.0, 0.0)
    }

    /// From the right side, against x: y to the right, z upwards.
    pub const fn side() -> Self {
        View::of(0.0, 0.0)
    }

    /// Azimuth and elevation in degrees.
    pub(crate) fn angles(self) -> Vector {
        [self.azimuth, self.elevation]
    }

    /// The axes of the paper.
    ///
    /// # Errors
    /// [`DrawingError::View`] where an angle is not finite.
    pub(crate) fn sight(self) -> Result<Sight, DrawingError> {
        let View { azimuth, elevation } = self;
        if !(azimuth.is_finite() && elevation.is_finite()) {
            return Err(DrawingError::View { azimuth, elevation });
        }
        let ([cos, sin], [level, rise]) = (turn(azimuth), turn(elevation));
        let towards = [level * cos, level * sin, rise];
        let right = [-sin, cos, 0.0];
        Ok(Sight { right, up: cross(towards, right), towards })
    }
}

impl Default for View {
    fn default() -> Self {
        View::isometric()
    }
}

/// Cosine and sine of an angle in degrees; exact for right angles.
fn turn(degrees: f64) -> Vector {
    let turned = degrees.rem_euclid(360.0);
    match [0.0, 90.0, 180.0, 270.0].iter().position(|right| *right == turned) {
        Some(quarter) => [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][quarter],
        None => [turned.to_radians().cos(), turned.to_radians().sin()],
    }
}

/// The axes of the paper in space, of length 1: to the right, upwards, towards the reader.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sight {
    pub(crate) right: Vector3,
    pub(crate) up: Vector3,
    pub(crate) towards: Vector3,
}

impl Sight {
    /// How models of the plane are seen.
    pub(crate) const PLANE: Sight = Sight { right: [1.0, 0.0, 0.0], up: [0.0, 1.0, 0.0], towards: [0.0, 0.0, 1.0] };

    /// What is seen of a vector: to the right and upwards.
    pub(crate) fn seen<T: Copy + Mul<f64, Output = T> + Add<Output = T>>(&self, vector: [T; 3]) -> [T; 2] {
        [self.right, self.up].map(|axis| vector[0] * axis[0] + vector[1] * axis[1] + vector[2] * axis[2])
    }

    /// A way on the paper, whose y is downwards.
    pub(crate) fn way(&self, vector: Vector3) -> Vector {
        let [x, y] = self.seen(vector);
        [x, -y]
    }

    /// How far towards the reader a vector leads.
    pub(crate) fn depth(&self, vector: Vector3) -> f64 {
        dot3(self.towards, vector)
    }
}
