//! What modes and loads tell: work on shapes, damping of each mode, sums in frequency.

mod about;
mod axial_forces;
mod base;
mod boxes;
mod damping;
mod dislocations;
mod fields;
mod in_hertz;
mod massless;
mod models;
mod moving_loads;
mod moving_loads_by_quadrature;
#[expect(dead_code, reason = "some of what is random")]
#[path = "../support/random.rs"]
mod numbers;
mod participation;
mod peaks;
mod published;
mod random;
mod random_bounds;
mod random_peaks;
mod random_vibration;
mod ranges;
mod refused_forces;
mod spectra;
mod state_spaces;
mod supports;
mod truncation;
mod undamped;
mod work;
