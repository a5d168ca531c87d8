//! What the documents show of the report.

use crate::error::ReportError;
use crate::measurements::Measurements;
use crate::plots::{digits, error_time};

/// Names of the pictures, in the order of [`pictures`].
pub const PICTURES: [&str; 2] = ["error_time.svg", "digits.svg"];
/// Scenes of the first picture: an example of the paper, and a mode that shows who keeps digits.
const SCENES: [&str; 2] = ["4.4", "mode 100"];
/// The document with the table, from the root of the repository.
pub const DOCUMENT: &str = "docs/speed.md";
/// Comments between which the table stands.
const MARKERS: [&str; 2] = ["<!-- factors -->\n", "<!-- end of factors -->"];

/// The pictures, each as the text of a file.
///
/// # Errors
/// [`ReportError::Drawing`].
pub fn pictures(measurements: &Measurements) -> Result<[String; 2], ReportError> {
    let Measurements { runs, digits_of_modes, digits_of_stiffness, .. } = measurements;
    Ok([error_time::file(runs, SCENES)?, digits::file(digits_of_modes, digits_of_stiffness)?])
}

/// The document with another table between its markers.
///
/// # Errors
/// [`ReportError::NoMarker`].
pub fn with_table(document: &str, table: &str) -> Result<String, ReportError> {
    let [start, end] = MARKERS;
    let (before, rest) = document.split_once(start).ok_or(ReportError::NoMarker(start))?;
    let (_, after) = rest.split_once(end).ok_or(ReportError::NoMarker(end))?;
    Ok(format!("{before}{start}\n{table}\n{end}{after}"))
}
