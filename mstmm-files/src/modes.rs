//! Modes as tables.

use crate::error::FileError;
use crate::fields::number;
use mstmm_core::Complex;
use mstmm_core::search::{Eigenvalue, NaturalFrequency};
use std::io::Write;

/// The columns of a root.
const COLUMNS: [&str; 7] =
    ["mode", "frequency_hz", "damping_ratio", "real_1_per_s", "imaginary_rad_per_s", "error_rad_per_s", "multiplicity"];

/// A mode: its root, natural frequency or eigenvalue, and its shape at points.
///
/// A shape has one number for each column of a table, [`with_shape`](Mode::with_shape), or three or six for each point of a
/// [`Geometry`](crate::Geometry), [`with_vectors`](Mode::with_vectors).
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    pub(crate) root: Eigenvalue,
    /// Whether the root is a natural frequency, and no eigenvalue.
    pub(crate) is_natural: bool,
    shape: Vec<Complex<f64>>,
    pub(crate) modal_mass: Complex<f64>,
    name: Option<String>,
}

/// A natural frequency is the eigenvalue `iω`; its error is the farther end of its interval.
impl From<NaturalFrequency> for Mode {
    fn from(root: NaturalFrequency) -> Self {
        let error = (root.upper - root.omega).max(root.omega - root.lower);
        let lambda = Complex::new(0.0, root.omega);
        let root = Eigenvalue { lambda, error, multiplicity: root.multiplicity, ..Eigenvalue::default() };
        Mode { is_natural: true, ..Mode::from(root) }
    }
}

impl From<Eigenvalue> for Mode {
    fn from(root: Eigenvalue) -> Self {
        Mode { root, is_natural: false, shape: Vec::new(), modal_mass: Complex::new(1.0, 0.0), name: None }
    }
}

impl Mode {
    /// The mode with its shape at points, real or complex.
    #[must_use]
    pub fn with_shape<V: Into<Complex<f64>>>(self, shape: impl IntoIterator<Item = V>) -> Self {
        Mode { shape: shape.into_iter().map(Into::into).collect(), ..self }
    }

    /// The mode with a vector for each point, real or complex: displacements along x, y and z \[m\], or these and the rotations about x, y
    /// and z \[rad\].
    #[must_use]
    pub fn with_vectors<const N: usize, V: Into<Complex<f64>>>(
        self,
        vectors: impl IntoIterator<Item = [V; N]>,
    ) -> Self {
        self.with_shape(vectors.into_iter().flatten())
    }

    /// The mode with the modal mass of its shape, `φᵀ M φ [+ φᵀ C φ/(2λ)]`: 1, unless the shape was scaled.
    #[must_use]
    pub fn with_modal_mass(self, modal_mass: impl Into<Complex<f64>>) -> Self {
        Mode { modal_mass: modal_mass.into(), ..self }
    }

    /// The mode with a name of its own in files of shapes, where it is `mode 1 (12.3 Hz)` else.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Mode { name: Some(name.into()), ..self }
    }

    /// What the mode is called, given its place among all.
    pub(crate) fn name(&self, row: usize) -> String {
        self.name.clone().unwrap_or_else(|| format!("mode {} ({} Hz)", row + 1, five_digits(self.root.hertz())))
    }

    /// The vectors of so many points, each of three numbers or of six.
    ///
    /// # Errors
    /// [`FileError::Vectors`] for another number of values, [`FileError::NotFinite`].
    pub(crate) fn vectors(&self, row: usize, points: usize) -> Result<Vec<&[Complex<f64>]>, FileError> {
        let values = self.shape.len();
        let width = [3, 6].into_iter().find(|width| width * points == values);
        let width = width.ok_or(FileError::Vectors { row, values, points })?;
        let is_finite = |number: &Complex<f64>| number.re.is_finite() && number.im.is_finite();
        if ![self.root.lambda, self.modal_mass].iter().chain(&self.shape).all(is_finite) {
            return Err(FileError::NotFinite { row });
        }
        Ok(self.shape.chunks(width).collect())
    }
}

/// A number that is not negative with five digits, without zeros at its end.
fn five_digits(number: f64) -> String {
    let before = if number > 0.0 { number.log10().floor() } else { 0.0 };
    let decimals = (4.0 - before).clamp(0.0, 12.0) as usize;
    let text = format!("{number:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Writes modes as CSV, a row per mode, with all digits: its number from 1 on, the frequency in Hz, the damping ratio, both parts of its
/// eigenvalue, the radius of its certificate, its multiplicity, and both parts of its shape at each of the points.
///
/// ```
/// use mstmm_files::{Mode, write_modes};
/// use mstmm_core::search::NaturalFrequency;
///
/// let root = NaturalFrequency { omega: 2.0, lower: 1.75, upper: 2.25, multiplicity: 1, ..NaturalFrequency::default() };
/// let mut file = Vec::new();
/// write_modes(&mut file, &["tip"], [Mode::from(root).with_shape([0.5])])?;
/// let file = String::from_utf8(file)?;
/// assert!(file.starts_with("mode,frequency_hz,"));
/// assert_eq!(file.lines().nth(1), Some("1,0.3183098861837907,0.0,0.0,2.0,0.25,1,0.5,0.0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError::Shape`] for a shape with another number of values than there are points, [`FileError::NotFinite`] for numbers that are not
/// finite, and a writer that fails. A system may have no modes.
pub fn write_modes<M: Into<Mode>>(
    writer: impl Write,
    points: &[&str],
    modes: impl IntoIterator<Item = M>,
) -> Result<(), FileError> {
    let mut table = csv::Writer::from_writer(writer);
    let of_points = points.iter().flat_map(|point| [format!("{point}_real"), format!("{point}_imaginary")]);
    table.write_record(COLUMNS.iter().map(|column| (*column).to_owned()).chain(of_points))?;
    for (row, mode) in modes.into_iter().enumerate() {
        let Mode { root, shape, .. } = mode.into();
        if shape.len() != points.len() {
            return Err(FileError::Shape { row, values: shape.len(), points: points.len() });
        }
        let numbers = [root.hertz(), root.damping_ratio(), root.lambda.re, root.lambda.im, root.error];
        let shape = || shape.iter().flat_map(|value| [value.re, value.im]);
        if !numbers.into_iter().chain(shape()).all(f64::is_finite) {
            return Err(FileError::NotFinite { row });
        }
        let texts = |numbers: &[f64]| numbers.iter().copied().map(number).collect::<Vec<_>>();
        let shape: Vec<f64> = shape().collect();
        let fields = [vec![(row + 1).to_string()], texts(&numbers), vec![root.multiplicity.to_string()], texts(&shape)];
        table.write_record(fields.concat())?;
    }
    Ok(table.flush()?)
}
