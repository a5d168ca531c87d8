#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod error;
mod fields;
mod function;
mod geometry;
mod gltf;
mod member_lines;
mod modes;
mod response;
mod state_space;
mod uff55;
mod uff58;
mod uff_geometry;
mod vtp;

pub use error::FileError;
pub use function::{Axis, Direction, Dof, Function, Quantity};
pub use geometry::{Geometry, Polyline};
pub use gltf::write_gltf;
pub use member_lines::MemberLines;
pub use modes::{Mode, write_modes};
pub use response::write_response;
pub use state_space::{Format, write_state_space};
pub use uff_geometry::{write_uff15, write_uff82};
pub use uff55::write_uff55;
pub use uff58::write_uff58;
pub use vtp::write_vtp;
