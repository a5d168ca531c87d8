//! Searches for natural frequencies and eigenvalues.

mod by_factor;
mod campbell;
mod closed_range;
mod critical_loads;
mod critical_ranges;
mod critical_speeds;
pub(crate) mod damped;
mod identity;
mod minima;
mod proportional_damping;
mod room;
pub(crate) mod rotor;
mod stability_threshold;
pub(crate) mod undamped;

pub use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
pub use campbell::{AtSpeed, campbell};
pub use closed_range::ClosedRange;
pub use critical_loads::{CriticalLoad, CriticalLoads, critical_loads};
pub use critical_ranges::{CriticalLoadRange, CriticalSpeedRange, critical_speed_ranges};
pub use critical_speeds::{CriticalSpeed, CriticalSpeeds, critical_speeds};
pub use damped::eigenvalues::Eigenvalues;
pub use damped::found::{Eigenvalue, EigenvalueList, Region};
pub use minima::fmin1d::{Minimum1d, fmin1d};
pub use minima::fmin2d::{MAX_MOVES, MAX_ROW, Minimum2d, fmin2d};
pub use minima::grid::{MAX_POINTS, Minima};
pub use proportional_damping::ProportionalDamping;
pub use stability_threshold::{Threshold, stability_threshold};
pub use undamped::field_box::{Between, FieldBox};
pub use undamped::found::{FrequencyList, NaturalFrequency};
pub use undamped::natural::NaturalFrequencies;
pub use undamped::sweep::{FirstFrequencies, Sweep, SweepError};
pub use undamped::tolerance_box::{FrequencyRange, ToleranceBox};
