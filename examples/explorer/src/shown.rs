//! All that the page shows of a model.

use crate::problem::Problem;
use crate::table::Table;
use core::fmt::{self, Write};
use mstmm::prelude::*;

/// Tables of what the page shows, whose columns [`Shown::tables`] names.
#[derive(Debug, Default)]
pub struct Shown {
    /// Parts of the drawing.
    pub parts: Table<64>,
    /// Points of the drawing at rest [m].
    pub points: Table<400>,
    /// Displacements of the points [m], mode after mode, as complex numbers: real parts at one time, imaginary ones a quarter of a
    /// period earlier.
    pub shapes: Table<4800>,
    /// Natural frequencies with the intervals that hold them [rad/s].
    pub frequencies: Table<64>,
    /// Eigenvalues with the radii of the discs that hold them [1/s].
    pub eigenvalues: Table<64>,
    /// The part of the complex plane in which eigenvalues were looked for, and the part that is pictured [1/s]; empty without dampers.
    pub plane: Table<8>,
    /// The response at frequencies [rad/s].
    pub response: Table<6144>,
    /// The response of the same system without what the sliders are about.
    pub bare: Table<6144>,
    /// The poles of the first response near its frequencies [1/s]. A pole of multiplicity m stands m times.
    pub poles: Table<32>,
    /// The poles of the response without the sliders' parts [1/s].
    pub bare_poles: Table<32>,
}

/// A table's name, its columns, and the table.
type Named<'a> = (&'static str, &'static [&'static str], &'a dyn Numbers);

/// What is asked of tables of any size.
pub trait Numbers {
    /// Forgets all rows.
    fn clear(&self);
    /// Where the first number is, and how many there are.
    fn place(&self) -> (*const f64, usize);
    /// The numbers, row after row.
    fn each(&self, see: &mut dyn FnMut(f64));
}

impl<const CAP: usize> Numbers for Table<CAP> {
    fn clear(&self) {
        Table::clear(self);
    }

    fn place(&self) -> (*const f64, usize) {
        (self.start(), self.length())
    }

    fn each(&self, see: &mut dyn FnMut(f64)) {
        self.numbers().for_each(see);
    }
}

impl Shown {
    /// Nothing yet.
    pub const fn new() -> Self {
        Shown {
            parts: Table::new(),
            points: Table::new(),
            shapes: Table::new(),
            frequencies: Table::new(),
            eigenvalues: Table::new(),
            plane: Table::new(),
            response: Table::new(),
            bare: Table::new(),
            poles: Table::new(),
            bare_poles: Table::new(),
        }
    }

    /// All tables.
    pub fn tables(&self) -> [Named<'_>; 10] {
        let response: &[&str] = &["omega", "re", "im"];
        [
            ("parts", &["kind", "first", "count"], &self.parts),
            ("points", &["x", "y"], &self.points),
            ("shapes", &["xRe", "xIm", "yRe", "yIm"], &self.shapes),
            ("frequencies", &["omega", "lower", "upper", "multiplicity"], &self.frequencies),
            ("eigenvalues", &["re", "im", "error", "multiplicity", "ratio"], &self.eigenvalues),
            ("plane", &["reMin", "reMax", "imMin", "imMax"], &self.plane),
            ("response", response, &self.response),
            ("bare", response, &self.bare),
            ("poles", &["re", "im"], &self.poles),
            ("barePoles", &["re", "im"], &self.bare_poles),
        ]
    }

    /// Forgets all.
    pub fn clear(&self) {
        self.tables().iter().for_each(|(_, _, table)| table.clear());
    }

    /// Takes natural frequencies.
    ///
    /// # Errors
    /// [`Problem::Full`] for too many.
    pub fn take_frequencies(&self, found: &[NaturalFrequency]) -> Result<(), Problem> {
        found
            .iter()
            .try_for_each(|root| self.frequencies.push(&[root.omega, root.lower, root.upper, root.multiplicity as f64]))
    }

    /// Takes eigenvalues.
    ///
    /// # Errors
    /// [`Problem::Full`] for too many.
    pub fn take_eigenvalues(&self, found: &[Eigenvalue]) -> Result<(), Problem> {
        found.iter().try_for_each(|root| {
            let Complex { re, im } = root.lambda;
            self.eigenvalues.push(&[re, im, root.error, root.multiplicity as f64, root.damping_ratio()])
        })
    }

    /// Takes the poles of a response into a table of them.
    ///
    /// # Errors
    /// [`Problem::Full`] for too many.
    pub fn take_poles(table: &Table<32>, found: impl IntoIterator<Item = (Complex<f64>, u64)>) -> Result<(), Problem> {
        let often = found.into_iter().flat_map(|(pole, multiplicity)| (0..multiplicity).map(move |_| pole));
        often.map(|pole| [pole.re, pole.im]).try_for_each(|row| table.push(&row))
    }

    /// Takes a part of the complex plane.
    ///
    /// # Errors
    /// [`Problem::Full`] for too many.
    pub fn take_region(&self, Region { re, im }: &Region) -> Result<(), Problem> {
        self.plane.push(&[*re.start(), *re.end(), *im.start(), *im.end()])
    }

    /// Writes names and columns of the tables as JSON.
    pub(crate) fn describe(&self, out: &mut dyn Write) -> fmt::Result {
        for (k, (name, columns, _)) in self.tables().iter().enumerate() {
            let comma = if k == 0 { "" } else { "," };
            write!(out, r#"{comma}{{"name":"{name}","columns":{columns:?}}}"#)?;
        }
        Ok(())
    }
}
