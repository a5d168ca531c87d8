//! Finite elements: Hermite's cubics refined in number, or hierarchic shape functions refined in degree.

pub mod arnoldi;
pub mod assembly;
pub mod dense;
pub mod lanczos;
pub mod reference;
pub mod skyline;
pub mod solver;
