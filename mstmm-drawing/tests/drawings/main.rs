//! Drawings are held to the models that they are of.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]
#![allow(unreachable_pub, dead_code, reason = "examples are programs of their own")]

mod extremes;
mod forces;
mod frames;
mod gallery;
mod labels;
mod loads;
mod modes;
mod pictures;
mod places;
mod reading;
mod rotors;
mod space;
mod space_frames;
mod space_sketch;
mod space_views;
mod supports;
mod trees;
mod widths;

#[path = "../../../examples/double_beam.rs"]
mod double_beam;
#[path = "../../../examples/truss_bridge.rs"]
mod truss_bridge;
#[path = "../../../examples/vehicle.rs"]
mod vehicle;

use pictures::command::portal;
