//! Other ways to the same roots, and what they cost: for measurements, not for users.
//!
//! The rivals are given every advantage: matrices are assembled before the clock starts; the grids of the plain method, the
//! dimensions of Krylov spaces and the contour are the cheapest that find all roots, chosen with the exact roots known. None
//! of them proves that its list is complete. The scan for minima alone has the grids of the paper.

pub mod brent;
pub mod contour;
pub mod elements;
mod error;
pub mod factors;
mod found;
pub mod plain;
mod run;
pub mod runs;
pub mod scenes;
pub mod structure;

pub use error::Error;
pub use found::Found;
pub use run::{ROUNDS, Run};
