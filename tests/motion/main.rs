//! Mode shapes, responses to loads and sensitivities.

pub mod curves_end;
mod energy_shares;
pub mod examples;
pub mod frequency_response;
mod joints;
mod lists;
mod lumped_chains;
pub mod modal_response;
mod mode_shapes;
mod near_resonance;
mod response_oracle;
mod sensitivities;
mod sensitivity_oracle;
pub mod sensitivity_units;
mod state_equations;
pub mod static_limits;
#[path = "../support/mod.rs"]
pub mod support;
mod tapered_beams;
mod uniform_loads;
mod wave_lines;
