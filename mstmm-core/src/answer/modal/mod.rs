//! Responses as sums over modes: in time, in frequency, with damping of each mode.

pub(crate) mod damping;
pub(crate) mod discrete;
pub(crate) mod exact;
pub(crate) mod history;
pub(crate) mod in_frequency;
pub(crate) mod moving_mass;
pub(crate) mod of_tree;
pub(crate) mod oscillator;
pub(crate) mod participation;
pub(crate) mod power_spectrum;
pub(crate) mod random_vibration;
pub(crate) mod rates;
pub(crate) mod response;
pub(crate) mod segment;
pub(crate) mod spectrum;
pub(crate) mod state_space;
pub(crate) mod truncation;
pub(crate) mod work;
