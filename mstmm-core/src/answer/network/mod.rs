//! Answers about the motion of plane structures.

mod about;
pub(crate) mod axial_forces;
mod carried;
pub(crate) mod energies;
pub(crate) mod geometry;
pub(crate) mod inside;
mod moving_mass;
pub(crate) mod of_frame;
pub(crate) mod own_load;
pub(crate) mod questions;
pub(crate) mod response;
pub(crate) mod sensitivity;
pub(crate) mod shape;
pub(crate) mod sketch;
pub(crate) mod spread_load;
pub(crate) mod states;
mod track;
mod under_load;
mod work;
