//! Exact vibrations of linear systems of beams, rigid bodies, springs, dampers and masses.
//!
//! A model is a sketch in [`system!`](crate::system), on whose page is the language; a built system answers questions.
//!
//! ```
//! use mstmm::prelude::*;
//!
//! system! {
//!     /// A beam between two supports, with a mass on a spring at its middle.
//!     pub struct Footbridge { span: f64, bending_stiffness: f64, mass_per_length: f64, absorber: f64, stiffness: f64 }
//!
//!     pinned -> beam 1 { length: span / 2.0, bending_stiffness, mass_per_length } -> conn 2
//!            -> beam 3 { length: span / 2.0, bending_stiffness, mass_per_length } -> pinned;
//!     conn 2 <- spring 4 { stiffness } <- mass 5 { mass: absorber } <- free;
//! }
//!
//! let bridge = Footbridge {
//!     span: 40.0,
//!     bending_stiffness: 2e10,
//!     mass_per_length: 4000.0,
//!     absorber: 800.0,
//!     stiffness: 1.5e5,
//! };
//! let bridge = bridge.build()?;
//! let roots = bridge.first_frequencies::<3>()?;
//! let hertz = roots[0].hertz();
//! assert!(1.9 < hertz && hertz < 2.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | question | method |
//! |---|---|
//! | all natural frequencies of a range, the first n; how many are below ω | [`natural_frequencies`], [`first_frequencies`], [`count_below`] |
//! | whether it is statically stable: how many of its motions grow | [`unstable_modes`] |
//! | all eigenvalues of a region, the first n; how many are in it | [`eigenvalues`], [`first_eigenvalues`], [`count_in`] |
//! | the same in vectors, where numbers are known when the program runs | [`frequencies`], [`frequencies_in`], [`eigenvalues_in`] |
//! | the shape of a mode: states anywhere, nodes, energies | [`mode_shape`], [`mode_shapes`] |
//! | the response to a harmonic load, at rest too, on grids and curves | [`frequency_response`] |
//! | the response in time to an impulse, a step, a history of forces or of the ground, with rates | [`modal_response`] |
//! | how much of the mass each mode takes with it | [`participation`](motion::ModalAnalysis::participation) |
//! | the peak by the response spectrum of an earthquake; that of a record | [`spectral_peak`](motion::ModalResponse::spectral_peak), [`oscillator_peak`](motion::oscillator_peak) |
//! | the root mean square under a load of a power spectrum | [`random`](motion::ModalResponse::random) |
//! | the largest response over a whole band, between two bounds | [`peak`](motion::FrequencyResponse::peak), [`over`](motion::FrequencyResponse::over) |
//! | an entry under loads that move along members; influence lines | [`moving_load`](motion::FrameAnalysis::moving_load) |
//! | a bound for what a list of modes leaves out | [`truncation`](motion::ModalAnalysis::truncation) |
//! | how a root moves with each field of the model | [`sensitivity`] |
//! | the exact ranges of all frequencies over a box of tolerances | [`ToleranceBox`](search::ToleranceBox), of fields [`between`](search::Between::between) |
//! | the first n natural frequencies of many models | [`Sweep::first_frequencies`](search::Sweep::first_frequencies) |
//! | Δ and counts at many frequencies at once | [`characteristics`], [`counts_below`] |
//! | the overall transfer matrix of the paper and its determinant | [`overall_matrix`], [`overall_determinant`] |
//! | a frame of the plane with closed loops, sketched by the places of its points | [`system!`](crate::system#models-with-locations) |
//! | a tree whose size is known when the program runs; such a frame | [`list`]; [`network`] |
//! | a rotor: both whirls, critical speeds, unbalance | [`Rotor::whirl`](search::Rotor::whirl), [`critical_speeds`](search::critical_speeds), [`campbell`](search::campbell), [`unbalance`](motion::WhirlAnalysis::unbalance) |
//! | a picture of a model, of its modes and internal forces | the package `mstmm-drawing` |
//! | what stands where in a frame, and in which path of a tree | [`sketch`], [`sketch` of trees](motion::ModalAnalysis::sketch) |
//! | an element of one's own | [`element`] |
//! | area, moments, torsion and shear of a cross section | [`sections`] |
//! | how far a shape agrees with a measured one | [`mac`](motion::mac) |
//! | responses and modes as files for other programs | the package `mstmm-files` |
//!
//! [`natural_frequencies`]: search::NaturalFrequencies::natural_frequencies
//! [`first_frequencies`]: search::NaturalFrequencies::first_frequencies
//! [`count_below`]: search::NaturalFrequencies::count_below
//! [`frequencies`]: search::NaturalFrequencies::frequencies
//! [`frequencies_in`]: search::NaturalFrequencies::frequencies_in
//! [`eigenvalues_in`]: search::Eigenvalues::eigenvalues_in
//! [`unstable_modes`]: search::NaturalFrequencies::unstable_modes
//! [`eigenvalues`]: search::Eigenvalues::eigenvalues
//! [`first_eigenvalues`]: search::Eigenvalues::first_eigenvalues
//! [`count_in`]: search::Eigenvalues::count_in
//! [`mode_shape`]: motion::ModalAnalysis::mode_shape
//! [`mode_shapes`]: motion::ModalAnalysis::mode_shapes
//! [`frequency_response`]: motion::ModalAnalysis::frequency_response
//! [`modal_response`]: motion::ModalAnalysis::modal_response
//! [`sensitivity`]: motion::ModalAnalysis::sensitivity
//! [`characteristics`]: search::ManyFrequencies::characteristics
//! [`counts_below`]: search::ManyFrequencies::counts_below
//! [`sketch`]: motion::FrameAnalysis::sketch
//! [`overall_matrix`]: search::Evaluate::overall_matrix
//! [`overall_determinant`]: search::Evaluate::overall_determinant
#![no_std]
#![forbid(unsafe_code)]

pub mod motion;

pub use mstmm_core::{Complex, hertz};

/// [language]: macro@crate::system
/// [loads]: crate::motion::FrameAnalysis::axial_forces
#[doc = include_str!("../docs/elements.md")]
pub use mstmm_core::elements;
/// Sections in a model, with the sensitivity to a diameter:
///
/// ```
/// use mstmm::prelude::*;
/// use mstmm::sections;
///
/// system! {
///     struct Mast { height: f64, outer: f64, inner: f64 }
///
///     let (area, i_y, ..) = sections::tube(outer, inner);
///     fixed -> beam 1 { length: height, bending_stiffness: 2.1e11 * i_y, mass_per_length: 7850.0 * area } -> free;
/// }
///
/// let mast = Mast { height: 10.0, outer: 0.5, inner: 0.4 }.build()?;
/// let root = mast.first_frequencies::<1>()?[0];
/// let slope = mast.sensitivity(&root)?.get("outer").ok_or("no such field")?;
/// // ω is proportional to sqrt(outer² + inner²)
/// assert!((slope / root.omega - 0.5 / 0.41).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
pub use mstmm_core::sections;

/// Roots, counts and determinants: the searches, their results, and the functions that they search.
pub mod search {
    /// ```
    /// use mstmm::prelude::*;
    ///
    /// system! {
    ///     struct Cantilever { ei: f64, m: f64 }
    ///     fixed -> beam 1 { length: 1.0, bending_stiffness: ei, mass_per_length: m } -> free;
    /// }
    ///
    /// let (low, high) = (Cantilever { ei: 95.0, m: 0.98 }, Cantilever { ei: 105.0, m: 1.02 });
    /// let lot = Cantilever::between(&low, &high)?;
    /// let range = lot.first_frequencies::<1>()?[0];
    /// assert!((range.lowest.omega / 3.516015 - (95.0_f64 / 1.02).sqrt()).abs() < 1e-5);
    /// assert!((range.highest.omega / 3.516015 - (105.0_f64 / 0.98).sqrt()).abs() < 1e-5);
    /// assert!(lot.is_attained()?);
    /// # Ok::<(), mstmm::search::ToleranceError>(())
    /// ```
    ///
    /// A formula that compares fields has no box:
    ///
    /// ```compile_fail,E0080
    /// use mstmm::prelude::*;
    ///
    /// system! {
    ///     struct Cantilever { ei: f64, m: f64 }
    ///     let stiffer = if ei > 100.0 { 2.0 * ei } else { ei };
    ///     fixed -> beam 1 { length: 1.0, bending_stiffness: stiffer, mass_per_length: m } -> free;
    /// }
    ///
    /// let (low, high) = (Cantilever { ei: 95.0, m: 0.98 }, Cantilever { ei: 105.0, m: 1.02 });
    /// let lot = Cantilever::between(&low, &high);
    /// ```
    ///
    pub use mstmm_core::search::Between;
    /// ```
    /// use mstmm::prelude::*;
    ///
    /// system! {
    ///     pub struct Cantilever { length: f64 }
    ///     fixed -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
    /// }
    ///
    /// let models = (1..=100).map(|k| Cantilever { length: f64::from(k) });
    /// for (k, roots) in (1..).zip(models.first_frequencies::<3>()) {
    ///     let first = roots?[0].omega;
    ///     assert!((first * f64::from(k * k) - 3.516015).abs() < 1e-6);
    /// }
    /// # Ok::<(), mstmm::search::SweepError>(())
    /// ```
    ///
    pub use mstmm_core::search::Sweep;
    /// ```
    /// use mstmm::prelude::*;
    /// use mstmm::search::critical_loads;
    ///
    /// system! {
    ///     struct Column { length: f64, ei: f64, force: f64 }
    ///     fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: 1.0, axial_force: -force } -> free;
    /// }
    ///
    /// // Euler's first case: (n - ½)² π² EI/l²
    /// let loads = critical_loads::<2, _>(0.0..=100.0, |force| Column { length: 2.0, ei: 8.0, force }.build())?;
    /// for (n, load) in (1..).zip(loads.iter()) {
    ///     let exact = 2.0 * ((f64::from(n) - 0.5) * std::f64::consts::PI).powi(2);
    ///     assert!((load.factor / exact - 1.0).abs() < 2e-15 && load.lower <= exact && exact <= load.upper);
    /// }
    /// # Ok::<(), mstmm::search::LoadError>(())
    /// ```
    ///
    pub use mstmm_core::search::critical_loads;
    pub use mstmm_core::search::*;
    pub use mstmm_core::{
        Build, Characteristic, Evaluate, Formulas, InBlocks, Lanewise, LoadError, ManyFrequencies, Model, Numbered,
        Rotor, SearchError, SpeedError, Spinning, Spot, System, ToleranceError, Whirl,
    };
}

/// What an element is, how it transfers subspaces and states, and its energies: for elements of one's own.
///
/// A struct of parameters that implements [`Element`](element::Element) and [`TransferMatrix`](element::TransferMatrix) takes part
/// in the overall matrix; with [`PlaneStep`](element::PlaneStep) in searches; with [`BackTransfer`](element::BackTransfer) and
/// [`Energies`](element::Energies) in mode shapes, responses and sensitivities.
///
/// Between points with places an element of one motion takes part in searches with its chart, [`Charted`](element::Charted), in mode shapes and
/// responses with [`MemberMotion`](element::MemberMotion), in sensitivities with [`MemberGradient`](element::MemberGradient).
pub mod element {
    pub use mstmm_core::{
        BackTransfer, Bending, CarriesLoad, Chart, Charted, Connecting, Coordinate, Covector, Deflection, Element,
        EndMotion, Ends, Energies, Extent, Forms, Freedoms, FrequencyEstimates, FrequencyPowers, Held, Inside,
        InvalidParameter, Line, MatrixOf, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, NoCount,
        ParameterError, Planar, Plane, PlaneStep, Requirement, RootCounter, Rotation, SMatrix, Space, State,
        StateSpace, Subspace, Support, TransferMatrix, Translation, WittrickWilliams,
    };
}

/// Numbers: what parameters and frequencies are made of.
pub mod number {
    pub use mstmm_core::{
        Complex, ComplexEigenvalue, ComplexFrequency, DoubleDouble, Dual, EvenWaves, Frequency, InLanes, Magnitude,
        MayDecay, Oscillation, Parameter, Partials, Real, RealFrequency, Scalar, Scaled, Single, Size, Truth, Value,
        WaveFunctions,
    };
}

#[doc = include_str!("../docs/lists.md")]
pub mod list {
    pub use mstmm_core::{
        AnyElement, AnyUndamped, InList, ListElement, ListError, ListMoving, ListParameter, ListStep, ListStepping,
        OPEN_PATHS, ParameterError, PlannedList, Room, StepList, Support,
    };
}

/// [emitted]: crate::system#what-is-emitted
/// [own]: crate::element
#[doc = include_str!("../docs/networks.md")]
pub mod network {
    #[cfg(feature = "std")]
    pub use mstmm_core::Vectors;
    pub use mstmm_core::{
        AnyMember, Arrays, Chart, Charted, End, Freedoms, InNetwork, Joint, Member, MemberChart, MemberElement,
        MemberMatrix, MemberTransfer, Memory, Network, NetworkError, Node, OverallNetwork, Section, Support,
        UndampedMember,
    };
}

/// Structures whose size and topology the program decides: points and members, added one after the other.
#[cfg(feature = "std")]
pub mod frame {
    pub use mstmm_core::FrameSensitivities;
    pub use mstmm_core::frame::*;
}

/// All that a model needs: `use mstmm::prelude::*;`.
pub mod prelude {
    pub use crate::motion::{Direction, FrameAnalysis, Load, ModalAnalysis, PlaneLoad, WhirlAnalysis};
    pub use crate::search::{
        Between, Characteristic, Eigenvalue, Eigenvalues, Evaluate, ManyFrequencies, NaturalFrequencies,
        NaturalFrequency, Region, Spectrum, Sweep, ToleranceBox, Undamped, Whirl, fmin1d, fmin2d,
    };
    pub use crate::{Complex, hertz, system};
}

/// What emitted code uses; not for use by hand.
#[doc(hidden)]
pub mod __private {
    pub use mstmm_core::*;
    pub use mstmm_macros::expand_system;
}

/// Declares a model: a struct of parameters and a sketch of the system.
///
/// [reference]: #the-language-of-system-reference
/// [sketches]: #sketches-step-by-step
/// [no-sensitivity]: #7-fields-without-a-derivative
/// [sections-example]: #4-sections-what-members-share
/// [sketch-example]: #8-read-the-model-back
/// [space-example]: #6-in-space
/// [signs]: #supports
/// [frames]: #models-with-locations
/// [bodies]: #points-and-places
/// [space]: #three-coordinates
/// [signs-in-space]: crate::motion::MemberState
/// [repeated]: mod@crate::list
/// [from_file]: crate::frame::Frame
/// [elements]: mod@crate::elements
/// [wrong]: mod@crate::elements#when-euler-bernoulli-is-wrong
/// [own]: mod@crate::element
/// [rotors]: crate::search::Rotor
#[doc = include_str!("../docs/sketches.md")]
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
