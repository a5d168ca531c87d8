//! Universal file dataset 58, function at nodal degrees of freedom, in ASCII.

use crate::error::FileError;
use crate::fields::{exponential, text};
use crate::function::{Axis, Dof, Function, Quantity};
use mstmm_core::Complex;
use std::f64::consts::TAU;
use std::io::Write;

/// The type of a frequency response function.
const FREQUENCY_RESPONSE: u8 = 4;

/// Complex numbers in double precision.
const COMPLEX_DOUBLE: u8 = 6;

/// Abscissae that stand beside the ordinates.
const UNEVEN: u8 = 0;

/// Writes a response as a dataset 58: complex, in double precision, each sample with its frequency in Hz. Datasets written one after the other
/// to a file are one file.
///
/// `samples` are pairs of ω [rad/s] and the response there, in ascending order. Values have thirteen digits, frequencies the eight for which
/// their thirteen columns have room; what is below 1e-99 is zero.
///
/// ```
/// use mstmm_files::{Direction, Dof, Function, write_uff58};
///
/// let at = |node| Dof { node, direction: Direction::Y };
/// let mut file = Vec::new();
/// write_uff58(&mut file, &Function::receptance("a spring", at(2), at(1)), [(0.0, 0.5), (6.25, 0.25)])?;
/// let file = String::from_utf8(file)?;
/// assert_eq!(file.lines().nth(14), Some("9.9471839E-01  2.500000000000E-01  0.000000000000E+00"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no samples, numbers that are not finite or beyond 1e99, frequencies that are negative or do not grow in the digits of
/// the format, texts that do not fit into their columns, and a writer that fails. Nothing is written before all samples are checked.
///
/// # Source
/// Universal file formats for modal analysis testing, Structural Dynamics Research Laboratory, University of Cincinnati.
pub fn write_uff58<V: Into<Complex<f64>>>(
    mut writer: impl Write,
    function: &Function<'_>,
    samples: impl IntoIterator<Item = (f64, V)>,
) -> Result<(), FileError> {
    let lines = lines(samples)?;
    let mut file = format!("{:>6}\n{:>6}\n{}\n", -1, 58, text(function.description, 80)?);
    // the identification lines that are left: run, date, load case
    for _ in 0..4 {
        file += &format!("{}\n", text("", 80)?);
    }
    file += &format!("{FREQUENCY_RESPONSE:>5}{:>10}{:>5}{:>10}", 0, 0, 0);
    file += &format!("{}{}\n", dof(function.response)?, dof(function.reference)?);
    let zero = exponential(0.0, 13, 5)?;
    file += &format!("{COMPLEX_DOUBLE:>10}{:>10}{UNEVEN:>10}{zero}{zero}{zero}\n", lines.len());
    let frequency = Axis { quantity: Quantity::Frequency, label: "Frequency", unit: "Hz" };
    let none = Axis { quantity: Quantity::Unknown, label: "", unit: "" };
    for axis in [&frequency, &function.ordinate, &function.denominator, &none] {
        let (label, unit) = (text(axis.label, 20)?, text(axis.unit, 20)?);
        file += &format!("{:>10}{:>5}{:>5}{:>5} {label} {unit}\n", axis.quantity.code(), 0, 0, 0);
    }
    lines.iter().for_each(|line| file += line);
    file += &format!("{:>6}\n", -1);
    Ok(writer.write_all(file.as_bytes())?)
}

/// `1X, 10A1, I10, I4`: no entity, a node and a direction.
fn dof(dof: Dof) -> Result<String, FileError> {
    Ok(format!(" {}{:>10}{:>4}", text("", 10)?, dof.node, dof.direction.code()))
}

/// `E13, 2E20.12` for each sample.
fn lines<V: Into<Complex<f64>>>(samples: impl IntoIterator<Item = (f64, V)>) -> Result<Vec<String>, FileError> {
    let (mut lines, mut last) = (Vec::new(), None);
    for (row, (omega, value)) in samples.into_iter().enumerate() {
        let (value, hertz) = (value.into(), omega / TAU);
        if !(omega.is_finite() && value.re.is_finite() && value.im.is_finite()) {
            return Err(FileError::NotFinite { row });
        }
        if omega < 0.0 {
            return Err(FileError::Negative { row, omega });
        }
        let abscissa = exponential(hertz, 13, 7)?;
        let read: f64 = abscissa.trim().parse().map_err(|_| FileError::Columns { value: hertz })?;
        if last.is_some_and(|last| read <= last) {
            return Err(FileError::Order { row, hertz });
        }
        last = Some(read);
        lines.push(format!("{abscissa}{}{}\n", exponential(value.re, 20, 12)?, exponential(value.im, 20, 12)?));
    }
    if lines.is_empty() { Err(FileError::Empty) } else { Ok(lines) }
}
