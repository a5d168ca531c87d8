//! Numeric runtime of `mstmm`: scalars, state spaces, elements, the overall transfer equation and the searches.
//!
//! This crate is an implementation detail of `mstmm`, which re-exports what users need. It uses neither `std` nor
//! `alloc`; the feature `std` (default) or `libm` only chooses where sine, cosine and exponential come from.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("mstmm needs one of its features `std` (default) or `libm` for sin, cos and exp");

mod assembly;
mod beam_functions;
mod determinant;
mod element;
pub mod elements;
mod error;
mod layout;
mod list;
mod scalar;
mod scaled;
pub mod search;
mod state;
#[cfg(test)]
mod tolerance;

pub use assembly::Assembly;
pub use determinant::determinant;
pub use element::{Element, Evaluate, MatrixOf, TransferMatrix, space_of, validate, without_pole};
pub use error::{InvalidParameter, ParameterError, Requirement, SearchError};
pub use layout::{Layout, Step};
pub use list::List;
pub use nalgebra::SMatrix;
pub use num_complex::Complex;
pub use scalar::{ComplexFrequency, Frequency, Real, Scalar};
pub use scaled::{Magnitude, Scaled};
pub use state::{Bending, Coordinate, Planar, Rotation, Space, StateSpace, Support, Translation};
