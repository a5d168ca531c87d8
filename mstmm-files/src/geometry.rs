//! Points, lines through them, and what the points do in a mode.

use crate::error::FileError;
use crate::modes::Mode;
use std::collections::BTreeSet;

/// A line through points, such as a member.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polyline {
    /// What it is called.
    pub name: String,
    /// The indices of its points, from 0 on; two or more.
    pub points: Vec<usize>,
}

/// Points in space and lines through them: what modes are shown on. Models of the plane have the coordinate z = 0.
///
/// ```
/// use mstmm_files::Geometry;
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [0.0, 0.0, 8.0]]);
/// let boom = mast.add_line("boom", [[0.0, 0.0, 8.0], [3.0, 0.0, 8.0]]);
/// assert_eq!((boom, mast.points.len(), mast.lines.len()), (3..5, 5, 2));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// The places of the points \[m\].
    pub points: Vec<[f64; 3]>,
    /// The lines.
    pub lines: Vec<Polyline>,
}

impl Geometry {
    /// Adds points with a line through them. The result is the range of their indices.
    pub fn add_line(
        &mut self,
        name: impl Into<String>,
        places: impl IntoIterator<Item = [f64; 3]>,
    ) -> std::ops::Range<usize> {
        let first = self.points.len();
        self.points.extend(places);
        let points = first..self.points.len();
        self.lines.push(Polyline { name: name.into(), points: points.clone().collect() });
        points
    }

    /// Checks that there are points, that their places are finite, and that lines lead through points that are there.
    pub(crate) fn check(&self) -> Result<(), FileError> {
        if self.points.is_empty() {
            return Err(FileError::NoPoints);
        }
        if let Some(point) = self.points.iter().position(|place| !place.iter().all(|part| part.is_finite())) {
            return Err(FileError::Place { point });
        }
        for (line, Polyline { points, .. }) in self.lines.iter().enumerate() {
            if points.len() < 2 {
                return Err(FileError::ShortLine { line });
            }
            if let Some(&point) = points.iter().find(|point| **point >= self.points.len()) {
                return Err(FileError::NoSuchPoint { line, point, points: self.points.len() });
            }
        }
        Ok(())
    }
}

/// A motion of the points by its name: of a real mode one, of a complex one both of its parts.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    pub(crate) name: String,
    /// The real part of the displacements of each point.
    pub(crate) real: Vec<[f64; 3]>,
    /// Their imaginary part, if there is any.
    pub(crate) imaginary: Option<Vec<[f64; 3]>>,
}

impl Motion {
    /// The arrays of numbers: the name and the displacements of one, or of both parts.
    pub(crate) fn arrays(&self) -> Vec<(String, &[[f64; 3]])> {
        match &self.imaginary {
            None => vec![(self.name.clone(), &self.real)],
            Some(imaginary) => {
                vec![
                    (format!("{}, real part", self.name), &self.real),
                    (format!("{}, imaginary part", self.name), imaginary),
                ]
            }
        }
    }
}

/// The motions of the points of a checked geometry.
pub(crate) fn motions<M: Into<Mode>>(
    geometry: &Geometry,
    modes: impl IntoIterator<Item = M>,
) -> Result<Vec<Motion>, FileError> {
    geometry.check()?;
    let (mut motions, mut names) = (Vec::new(), BTreeSet::new());
    for (row, mode) in modes.into_iter().enumerate() {
        let mode = mode.into();
        let vectors = mode.vectors(row, geometry.points.len())?;
        let part = |of: fn(&mstmm_core::Complex<f64>) -> f64| -> Vec<[f64; 3]> {
            vectors.iter().map(|vector| [of(&vector[0]), of(&vector[1]), of(&vector[2])]).collect()
        };
        let (real, imaginary) = (part(|number| number.re), part(|number| number.im));
        let is_complex = imaginary.iter().flatten().any(|part| *part != 0.0);
        let motion = Motion { name: mode.name(row), real, imaginary: is_complex.then_some(imaginary) };
        for (name, _) in motion.arrays() {
            if name.chars().any(char::is_control) {
                return Err(FileError::Name { name });
            }
            if !names.insert(name.clone()) {
                return Err(FileError::SameName { name });
            }
        }
        motions.push(motion);
    }
    Ok(motions)
}
