//! Numbers: real, complex, dual, double-double and without branches; nothing here knows mechanics.

pub(crate) mod branch_free;
pub(crate) mod columns;
pub(crate) mod complex;
pub(crate) mod double_double;
pub(crate) mod doubt;
pub(crate) mod dual;
pub(crate) mod exponent;
pub(crate) mod exponentials;
pub(crate) mod fixed_list;
pub(crate) mod floats;
pub(crate) mod frequency;
pub(crate) mod frequency_powers;
pub(crate) mod kernel;
pub(crate) mod oscillation;
pub(crate) mod partials;
pub(crate) mod scalar;
pub(crate) mod scaled;
#[cfg(test)]
pub(crate) mod tolerance;
pub(crate) mod wave_functions;
pub(crate) mod waves;
