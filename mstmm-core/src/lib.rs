//! Numeric runtime of `mstmm`: scalars, state spaces, elements, the overall transfer equation and the searches.
//!
//! This crate is an implementation detail of `mstmm`, which re-exports what users need. It uses neither `std` nor
//! `alloc`; the feature `std` (default) or `libm` only chooses where sine, cosine and exponential come from. The feature `judge`
//! (default) adds the double-double arithmetic that settles doubtful results.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("mstmm needs one of its features `std` (default) or `libm` for sin, cos and exp");

mod assembly;
mod at;
mod beam_functions;
mod bending_links;
mod bending_steps;
mod block;
mod bounds;
mod characteristic;
mod count;
mod determinant;
mod doubt;
mod element;
pub mod elements;
mod error;
mod fields;
mod in_line;
mod join;
mod layout;
mod line_steps;
mod list;
mod motion;
mod partials;
mod scalar;
mod scaled;
pub mod search;
mod state;
mod step_list;
mod subspace;
#[cfg(test)]
mod tolerance;

pub use assembly::Assembly;
pub use at::At;
pub use block::{InBlocks, ManyFrequencies, Straight, Walk, Walker};
pub use bounds::FrequencyBounds;
pub use characteristic::{Characteristic, System};
pub use count::{BeamSigns, Count, Tally, Untallied};
pub use determinant::determinant;
pub use element::{Element, Evaluate, MatrixOf, PlaneStep, TransferMatrix, build, space_of, without_pole};
pub use error::{InvalidParameter, ParameterError, Requirement, SearchError};
pub use fields::{Chain, ChainRule, Fields};
pub use in_line::{coefficients, join, root, step};
pub use join::{held, moderated, narrowed, widened};
pub use layout::{Layout, Scheme, Step};
pub use list::List;
pub use motion::{
    Covector, Ends, EnergyShares, Entry, Field, ForceHistory, FrequencyResponse, Inside, JudgedTree, Label, Load,
    ModalResponse, ModeShape, Motion, MotionError, Motions, Planned, Point, Root, Sample, Sensitivities, ShapeList,
    Tree, TreeInBlocks, Visit, VisitAt, VisitInBlock,
};
pub use nalgebra::SMatrix;
pub use num_complex::Complex;
pub use partials::Partials;
pub use scalar::{
    Branches, ComplexEigenvalue, ComplexFrequency, DoubleDouble, Dual, Frequency, InColumns, JudgeOf, MayDecay,
    Oscillation, Real, RealFrequency, Scalar, WaveFunctions, WaveProducts,
};
pub use scaled::{Magnitude, Scaled};
pub use state::{Bending, Coordinate, Planar, Rotation, Space, State, StateSpace, Support, Translation};
pub use step_list::{
    AnyElement, AnyUndamped, ListElement, ListError, ListPass, ListStep, ListWalk, OPEN_PATHS, StepList,
};
pub use subspace::{Line, Plane, Subspace};
