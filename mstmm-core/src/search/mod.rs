//! Searches for natural frequencies and eigenvalues.

mod closed_range;
mod critical_loads;
pub(crate) mod damped;
mod identity;
mod minima;
mod proportional_damping;
mod room;
pub(crate) mod undamped;

pub use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
pub use closed_range::ClosedRange;
pub use critical_loads::{CriticalLoad, CriticalLoads, critical_loads};
pub use damped::eigenvalues::Eigenvalues;
pub use damped::found::{Eigenvalue, EigenvalueList, Region};
pub use minima::fmin1d::{Minimum1d, fmin1d};
pub use minima::fmin2d::{MAX_MOVES, MAX_ROW, Minimum2d, fmin2d};
pub use minima::grid::{MAX_POINTS, Minima};
pub use proportional_damping::ProportionalDamping;
pub use undamped::found::{FrequencyList, NaturalFrequency};
pub use undamped::natural::NaturalFrequencies;
pub use undamped::sweep::{FirstFrequencies, Sweep, SweepError};
