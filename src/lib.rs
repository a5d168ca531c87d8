//! Exact vibrations of linear systems of beams, rigid bodies, springs, dampers and masses.
#![no_std]
#![forbid(unsafe_code)]

pub use mstmm_core::{
    AnyElement, AnyUndamped, Assembly, At, BeamSigns, Bending, Characteristic, Complex, ComplexEigenvalue,
    ComplexFrequency, Coordinate, Count, Covector, DoubleDouble, Dual, Element, Ends, EnergyShares, Entry, Evaluate,
    Field, Frequency, FrequencyBounds, FrequencyResponse, Inside, InvalidParameter, Label, Layout, Line, ListElement,
    ListError, ListPass, ListStep, Load, Magnitude, MatrixOf, MayDecay, ModeShape, Motion, MotionError, Motions,
    Oscillation, ParameterError, Planar, Plane, PlaneStep, Planned, Point, Real, RealFrequency, Requirement, Root,
    Rotation, SMatrix, Sample, Scalar, Scaled, SearchError, Sensitivities, ShapeList, Space, StateSpace, StepList,
    Subspace, Support, System, Tally, TransferMatrix, Translation, Tree, Untallied, Visit, VisitAt, WaveFunctions,
    WaveProducts, determinant, elements, search,
};

/// All that a model needs: `use mstmm::prelude::*;`.
pub mod prelude {
    pub use crate::search::{Eigenvalue, Eigenvalues, NaturalFrequencies, NaturalFrequency, Region, Undamped};
    pub use crate::search::{fmin1d, fmin2d};
    pub use crate::{Characteristic, Complex, Evaluate, Motions, system};
}

/// What emitted code uses; not for use by hand.
#[doc(hidden)]
pub mod __private {
    pub use mstmm_core::*;
    pub use mstmm_macros::expand_system;
}

/// Declares a model: a struct of parameters and a sketch of the system.
#[doc = include_str!("../docs/grammar.md")]
#[macro_export]
macro_rules! system {
    ($($model:tt)*) => {
        $crate::__private::expand_system! { ($crate) $($model)* }
    };
}

/// The README's model is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
