//! Plane frames: beams at any angle, loops, rigid bodies with many ports, releases, skew supports, springs along directions.

mod at_rest;
mod buildings;
mod by_minors;
mod checks;
mod choices;
mod counts;
mod damped;
mod damped_members;
mod decision_shares;
mod directed;
mod equivalents;
pub mod examples;
mod families;
mod finite_elements;
mod joints;
mod judgement;
mod large;
mod library;
mod lines;
mod motions;
mod oracle;
mod oracle_against_cases;
mod oracle_as_search;
mod oracle_laws;
mod overall;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/portal.rs"]
pub mod portal;
mod reference_cases;
mod rigid_trees;
mod sketches;
mod stability;
#[path = "../support/stiffness_matrix/mod.rs"]
mod stiffness_matrix;
mod structure;
#[path = "../support/mod.rs"]
pub mod support;
mod through_library;
mod tree_as_network;
mod without_hold;
