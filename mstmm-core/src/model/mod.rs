//! What a model is, with numbers: states, labels, parameters with their errors, estimates of frequencies.

pub(crate) mod chain_rule;
pub(crate) mod ends;
pub(crate) mod error;
pub(crate) mod estimates;
pub(crate) mod label;
pub(crate) mod scaled_state;
pub(crate) mod state;
