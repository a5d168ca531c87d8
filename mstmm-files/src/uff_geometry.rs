//! Universal file datasets 15, nodes, and 82, trace lines.

use crate::error::FileError;
use crate::fields::{exponential, text};
use crate::geometry::Geometry;
use std::io::Write;

/// The most nodes that a trace line may have.
const LONGEST_TRACE: usize = 250;

/// Whole numbers in a record.
const IN_A_RECORD: usize = 8;

/// Writes the points of a geometry as a dataset 15: nodes, numbered from 1 on, in the order of the points. Datasets written one after the other
/// to a file are one file.
///
/// Coordinates have the six digits for which their thirteen columns have room. Coordinate systems and colours are 0.
///
/// ```
/// use mstmm_files::{Geometry, write_uff15};
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 12.5]]);
/// let mut file = Vec::new(); // or File::create("mast.uff")?
/// write_uff15(&mut file, &mast)?;
/// let tip = "         2         0         0         0  0.00000E+00  0.00000E+00  1.25000E+01";
/// assert_eq!(String::from_utf8(file)?.lines().nth(3), Some(tip));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no points, lines to points that are not there, places that are not finite or beyond 1e99, and a writer that fails. Nothing is
/// written before all is checked.
///
/// # Source
/// Universal file formats for modal analysis testing, Structural Dynamics Research Laboratory, University of Cincinnati.
pub fn write_uff15(mut writer: impl Write, geometry: &Geometry) -> Result<(), FileError> {
    geometry.check()?;
    let mut file = format!("{:>6}\n{:>6}\n", -1, 15);
    for (index, place) in geometry.points.iter().enumerate() {
        file += &format!("{:>10}{:>10}{:>10}{:>10}{}\n", index + 1, 0, 0, 0, reals(place)?);
    }
    file += &format!("{:>6}\n", -1);
    Ok(writer.write_all(file.as_bytes())?)
}

/// Writes the lines of a geometry as datasets 82, each line a trace line: its number from 1 on, its name and its nodes, as
/// [`write_uff15`] numbers them.
///
/// A trace line has at most 250 nodes. A longer line is several of them, each from the last node of the one before.
///
/// ```
/// use mstmm_files::{Geometry, write_uff82};
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 12.5]]);
/// let mut file = Vec::new(); // or File::options().append(true).open("mast.uff")?
/// write_uff82(&mut file, &mast)?;
/// assert_eq!(String::from_utf8(file)?.lines().nth(4), Some("         1         2"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no points or lines, lines to points that are not there, names that are not printable ASCII of up to 80 characters, and a
/// writer that fails. Nothing is written before all is checked.
///
/// # Source
/// Universal file formats for modal analysis testing, Structural Dynamics Research Laboratory, University of Cincinnati.
pub fn write_uff82(mut writer: impl Write, geometry: &Geometry) -> Result<(), FileError> {
    geometry.check()?;
    if geometry.lines.is_empty() {
        return Err(FileError::NoLines);
    }
    let (mut file, mut number) = (String::new(), 0);
    for line in &geometry.lines {
        let mut first = 0;
        while first + 1 < line.points.len() {
            let end = line.points.len().min(first + LONGEST_TRACE);
            let nodes = &line.points[first..end];
            number += 1;
            file += &format!("{:>6}\n{:>6}\n{number:>10}{:>10}{:>10}\n", -1, 82, nodes.len(), 0);
            file += &format!("{}\n", text(&line.name, 80)?);
            for record in nodes.chunks(IN_A_RECORD) {
                record.iter().for_each(|point| file += &format!("{:>10}", point + 1));
                file.push('\n');
            }
            file += &format!("{:>6}\n", -1);
            first = end - 1;
        }
    }
    Ok(writer.write_all(file.as_bytes())?)
}

/// `E13.5` for each number.
pub(crate) fn reals(numbers: &[f64]) -> Result<String, FileError> {
    numbers.iter().map(|number| exponential(*number, 13, 5)).collect()
}
