//! Universal file dataset 55, data at nodes, in ASCII: mode shapes.

use crate::error::FileError;
use crate::fields::text;
use crate::geometry::Geometry;
use crate::modes::Mode;
use crate::uff_geometry::reals;
use mstmm_core::Complex;
use std::io::Write;

/// The model of a structure.
const STRUCTURAL: u8 = 1;

/// Displacements.
const DISPLACEMENT: u8 = 8;

/// Numbers in a record.
const IN_A_RECORD: usize = 6;

/// Writes modes as datasets 55, one for each: data at the nodes that [`write_uff15`](crate::write_uff15) writes. Datasets written one after the
/// other to a file are one file.
///
/// A natural frequency is a normal mode, analysis type 2: its frequency f in Hz, its modal mass, and no damping. An eigenvalue λ is a complex mode,
/// analysis type 3: λ in 1/s and rad/s, its modal a and its modal b, where `a = 2λm`, `b = -λa`, and m is the modal mass. Vectors of three
/// numbers are translations, those of six translations and rotations; `pyuff` reads complex ones of three alone. All have the six digits for which
/// their columns have room.
///
/// The first identification line is the description, the second one is the name of the mode.
///
/// ```
/// use mstmm_core::search::NaturalFrequency;
/// use mstmm_files::{Geometry, Mode, write_uff15, write_uff55, write_uff82};
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [0.0, 0.0, 8.0]]);
/// let root = NaturalFrequency { omega: 12.5, ..NaturalFrequency::default() };
/// let sway = Mode::from(root).with_vectors([[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [1.0, 0.0, 0.0]]).with_modal_mass(40.0);
/// let mut file = Vec::new(); // or File::create("mast.uff")?
/// write_uff15(&mut file, &mast)?;
/// write_uff82(&mut file, &mast)?;
/// write_uff55(&mut file, "a mast", &mast, [sway])?;
/// let file = String::from_utf8(file)?;
/// assert!(file.contains("\n         2         4         1         1\n  1.98944E+00  4.00000E+01  0.00000E+00  0.00000E+00\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for a geometry as [`write_uff15`](crate::write_uff15) refuses it, no modes, shapes that have not three or six numbers for each
/// point, numbers that are not finite or beyond 1e99, texts that are not printable ASCII of up to 80 characters, and a writer that fails. Nothing
/// is written before all is checked.
///
/// # Source
/// Universal file formats for modal analysis testing, Structural Dynamics Research Laboratory, University of Cincinnati. Modal a and b: R. J.
/// Allemang, *Vibrations: Analytical and Experimental Modal Analysis*, there, too.
pub fn write_uff55<M: Into<Mode>>(
    mut writer: impl Write,
    description: &str,
    geometry: &Geometry,
    modes: impl IntoIterator<Item = M>,
) -> Result<(), FileError> {
    geometry.check()?;
    let mut file = String::new();
    for (row, mode) in modes.into_iter().enumerate() {
        file += &dataset(description, row, &mode.into(), geometry.points.len())?;
    }
    if file.is_empty() {
        return Err(FileError::NoModes);
    }
    Ok(writer.write_all(file.as_bytes())?)
}

/// The dataset of a mode.
fn dataset(description: &str, row: usize, mode: &Mode, points: usize) -> Result<String, FileError> {
    let vectors = mode.vectors(row, points)?;
    let width = vectors.first().map_or(0, |vector| vector.len());
    let is_complex = !mode.is_natural || vectors.iter().copied().flatten().any(|number| number.im != 0.0);
    let mut file = format!("{:>6}\n{:>6}\n", -1, 55);
    for line in [description, &mode.name(row), "", "", ""] {
        file += &format!("{}\n", text(line, 80)?);
    }
    // translations have the number 2, those with rotations 3
    let (analysis, characteristic) = (if mode.is_natural { 2 } else { 3 }, width / 3 + 1);
    let data_type = if is_complex { 5 } else { 2 };
    file +=
        &format!("{STRUCTURAL:>10}{analysis:>10}{characteristic:>10}{DISPLACEMENT:>10}{data_type:>10}{width:>10}\n");
    let parameters = parameters(mode);
    file += &format!("{:>10}{:>10}{:>10}{:>10}\n{}\n", 2, parameters.len(), 1, row + 1, reals(&parameters)?);
    for (node, vector) in vectors.into_iter().enumerate() {
        file += &format!("{:>10}\n", node + 1);
        let both = |number: &Complex<f64>| [number.re, number.im];
        let numbers: Vec<f64> = if is_complex {
            vector.iter().flat_map(both).collect()
        } else {
            vector.iter().map(|number| number.re).collect()
        };
        for record in numbers.chunks(IN_A_RECORD) {
            file += &format!("{}\n", reals(record)?);
        }
    }
    file += &format!("{:>6}\n", -1);
    Ok(file)
}

/// Frequency, modal mass, viscous and hysteretic damping of a normal mode; eigenvalue, modal a and modal b of a complex one.
fn parameters(mode: &Mode) -> Vec<f64> {
    if mode.is_natural {
        return vec![mode.root.hertz(), mode.modal_mass.re, 0.0, 0.0];
    }
    let lambda = mode.root.lambda;
    let a = lambda * mode.modal_mass * 2.0;
    let b = -lambda * a;
    vec![lambda.re, lambda.im, a.re, a.im, b.re, b.im]
}
