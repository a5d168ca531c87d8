//! Searches for natural frequencies and eigenvalues.

mod critical_loads;
pub(crate) mod damped;
mod identity;
mod minima;
mod proportional_damping;
pub(crate) mod undamped;

pub use critical_loads::{AtRest, CriticalLoad, CriticalLoads, critical_loads};
pub use damped::eigenvalues::{Eigenvalues, Spectrum};
pub use damped::found::{Eigenvalue, EigenvalueList, Region};
pub use minima::fmin1d::{Minimum1d, fmin1d};
pub use minima::fmin2d::{MAX_MOVES, MAX_ROW, Minimum2d, fmin2d};
pub use minima::grid::{MAX_POINTS, Minima};
pub use proportional_damping::ProportionalDamping;
pub use undamped::found::{FrequencyList, NaturalFrequency};
pub use undamped::natural::NaturalFrequencies;
pub use undamped::searched::Undamped;
pub use undamped::sweep::{FirstFrequencies, Sweep, SweepError};
