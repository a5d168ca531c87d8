//! All that the page shows.

use crate::data::counts::{Counts, counts};
use crate::data::digits::{self, Digits, OverStiffness};
use crate::data::frames::{Frames, frames};
use crate::data::landscapes::{Landscapes, landscapes};
use crate::data::shapes::{Shapes, System, of_portal, shapes, systems};
use crate::data::storeys::over_storeys;
use crate::data::tables::{Table, tables};
use crate::error::ReportError;
use crate::growth::{ELEMENTS, OverElements, OverRoots, over_elements, over_roots};
use rivals::Run;

/// How much is measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Samples along a line or an edge of |Δ|.
    pub samples: usize,
    /// Mode numbers at which digits are counted.
    pub modes: Vec<u32>,
    /// Exponents of ten of the stiffnesses at which digits are counted.
    pub stiffness: Vec<i32>,
    /// Numbers of elements.
    pub elements: Vec<usize>,
    /// Numbers of storeys.
    pub storeys: Vec<usize>,
    /// The largest mode number at which times are taken.
    pub roots: usize,
    /// Whether other programs are run where they are there; else recorded figures are shown.
    pub programs: bool,
}

/// Numbers of storeys in the report.
const STOREYS: [usize; 6] = [1, 2, 3, 5, 10, 20];

impl Extent {
    /// What the report shows.
    pub fn full() -> Self {
        let (modes, stiffness) = (digits::mode_numbers(), (-15..=15).collect());
        Extent {
            samples: 141,
            modes,
            stiffness,
            elements: ELEMENTS.to_vec(),
            storeys: STOREYS.to_vec(),
            roots: 1000,
            programs: true,
        }
    }
}

/// What was measured.
#[derive(Debug)]
pub struct Measurements {
    pub(crate) runs: Vec<Run>,
    pub(crate) tables: Vec<Table>,
    pub(crate) counts: Counts,
    pub(crate) landscapes: Landscapes,
    pub(crate) systems: Vec<System>,
    pub(crate) shapes: Vec<Shapes>,
    pub(crate) portal: Shapes,
    pub(crate) digits_of_modes: Vec<Digits>,
    pub(crate) digits_of_stiffness: OverStiffness,
    pub(crate) elements: OverElements,
    pub(crate) roots: OverRoots,
    pub(crate) storeys: OverElements,
    pub(crate) frames: Frames,
}

impl Measurements {
    /// Number of steps that [`take`](Measurements::take) tells of.
    pub const STEPS: u64 = 9;

    /// Measures all that the runs do not tell, and says what is next before each step.
    ///
    /// # Errors
    /// [`ReportError`] where an example cannot be solved.
    pub fn take(runs: Vec<Run>, extent: &Extent, mut next: impl FnMut(&'static str)) -> Result<Self, ReportError> {
        next("tables of the paper");
        let tables = tables()?;
        next("counts");
        let counts = counts(extent.samples)?;
        next("landscapes");
        let landscapes = landscapes(extent.samples)?;
        next("drawings");
        let (systems, shapes, portal) = (systems()?, shapes()?, of_portal()?);
        next("digits");
        let digits_of_modes = digits::over_modes(&extent.modes)?;
        let digits_of_stiffness = digits::over_stiffness(&extent.stiffness)?;
        next("cost of elements");
        let elements = over_elements(&extent.elements)?;
        next("cost of roots");
        let roots = over_roots(extent.roots)?;
        next("storeys");
        let storeys = over_storeys(&extent.storeys)?;
        next("frames by other programs");
        let frames = frames(extent.programs)?;
        Ok(Measurements {
            runs,
            tables,
            counts,
            landscapes,
            systems,
            shapes,
            portal,
            digits_of_modes,
            digits_of_stiffness,
            elements,
            roots,
            storeys,
            frames,
        })
    }
}
