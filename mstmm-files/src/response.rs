//! Responses as tables.

use crate::error::FileError;
use crate::fields::number;
use mstmm_core::Complex;
use std::f64::consts::TAU;
use std::io::Write;

/// The columns of a response.
const COLUMNS: [&str; 6] =
    ["frequency_hz", "angular_frequency_rad_per_s", "real", "imaginary", "magnitude", "phase_deg"];

/// Writes a response as CSV, a row per sample, with all digits: the frequency in Hz and in rad/s, the response by its parts, and by its
/// magnitude and its phase in degrees.
///
/// `samples` are pairs of ω [rad/s] and the response there.
///
/// ```
/// let mut file = Vec::new();
/// mstmm_files::write_response(&mut file, [(0.0, 0.5), (6.25, -0.25)])?;
/// let file = String::from_utf8(file)?;
/// assert_eq!(file.lines().nth(2), Some("0.9947183943243458,6.25,-0.25,0.0,0.25,180.0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no samples, numbers that are not finite, and a writer that fails.
pub fn write_response<V: Into<Complex<f64>>>(
    writer: impl Write,
    samples: impl IntoIterator<Item = (f64, V)>,
) -> Result<(), FileError> {
    let mut table = csv::Writer::from_writer(writer);
    table.write_record(COLUMNS)?;
    let mut is_empty = true;
    for (row, (omega, value)) in samples.into_iter().enumerate() {
        let value = value.into();
        let fields = [omega / TAU, omega, value.re, value.im, value.norm(), value.arg().to_degrees()];
        if !fields.iter().all(|field| field.is_finite()) {
            return Err(FileError::NotFinite { row });
        }
        table.write_record(fields.map(number))?;
        is_empty = false;
    }
    if is_empty { Err(FileError::Empty) } else { Ok(table.flush()?) }
}
