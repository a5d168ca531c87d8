//! Answers about the motion of a system at its roots and under loads.

pub(crate) mod at_rest;
pub(crate) mod dominant_entry;
pub(crate) mod energies;
pub(crate) mod energy_shares;
pub(crate) mod facts;
#[cfg(feature = "std")]
pub(crate) mod frame_rotor;
#[cfg(feature = "std")]
pub(crate) mod frame_sensitivity;
pub(crate) mod frequency_response;
pub(crate) mod interior;
pub(crate) mod mac;
pub(crate) mod many_frequencies;
pub(crate) mod misfit;
pub(crate) mod modal;
pub(crate) mod mode_shape;
pub(crate) mod network;
pub(crate) mod orbit;
pub(crate) mod questions;
pub(crate) mod repeated_root;
pub(crate) mod response_curve;
pub(crate) mod root;
pub(crate) mod sensitivity;
pub(crate) mod spread_load;
pub(crate) mod states;
pub(crate) mod tree_sketch;
