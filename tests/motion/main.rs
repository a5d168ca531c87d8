//! Mode shapes, responses to loads and sensitivities.

#[expect(dead_code, reason = "what the other program needs")]
#[path = "../support/complex_beam.rs"]
mod complex_beam;
pub mod curves_end;
mod damped_materials;
mod energy_shares;
pub mod examples;
pub mod frequency_response;
#[path = "../support/hinged_models.rs"]
mod hinged_models;
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
mod sketches;
mod state_equations;
pub mod static_limits;
#[path = "../support/mod.rs"]
pub mod support;
mod tapered_beams;
mod uniform_loads;
mod wave_lines;
