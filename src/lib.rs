//! Exact vibrations of linear systems of beams, rigid bodies, springs, dampers and masses.
#![no_std]
#![forbid(unsafe_code)]

pub use mstmm_core::{
    AnyElement, AnyUndamped, Assembly, At, BeamSigns, Bending, Characteristic, Complex, ComplexEigenvalue,
    ComplexFrequency, Coordinate, Count, Covector, DoubleDouble, Dual, Element, Ends, EnergyShares, Entry, Evaluate,
    Field, ForceHistory, Frequency, FrequencyBounds, FrequencyResponse, Inside, InvalidParameter, Label, Layout, Line,
    ListElement, ListError, ListPass, ListStep, Load, Magnitude, MatrixOf, MayDecay, ModeShape, Motion, MotionError,
    Motions, Oscillation, ParameterError, Planar, Plane, PlaneStep, Planned, Point, Real, RealFrequency, Requirement,
    Root, Rotation, SMatrix, Sample, Scalar, Scaled, SearchError, Sensitivities, ShapeList, Space, State, StateSpace,
    StepList, Subspace, Support, System, Tally, TransferMatrix, Translation, Tree, Untallied, Visit, VisitAt,
    WaveFunctions, WaveProducts, determinant, elements, search,
};

/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
///     fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free;
/// }
///
/// let beam = Cantilever { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5 }.build()?;
/// let tip = Cantilever::beam_1.output();
/// let roots = beam.first_frequencies::<6>()?;
/// let response = beam.modal_response::<6, _>(&roots, tip.force(), tip.deflection())?;
///
/// // all but 3e-4 of l³/(3 EI), the deflection under a resting load; a sudden one reaches up to twice as far
/// assert!((response.static_value()? * 6.0 - 1.0).abs() < 3e-4);
/// assert!(response.to_step(0.45) > 1.9 / 6.0);
///
/// // half a sine, as samples of a measurement would come, with 1 % of the critical damping in every mode
/// let mut history = response.with_damping_ratio(0.01)?.history(1e-3)?;
/// let deflections: Vec<f64> = (0..=200).map(|n| history.next((f64::from(n) * 1e-3 * 5.0).sin())).collect();
/// assert_eq!(deflections[0], 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::ModalResponse;

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
