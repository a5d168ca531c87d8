//! Numeric runtime of `mstmm`: scalars, state spaces, elements, the overall transfer equation and the searches.
//!
//! This crate is an implementation detail of `mstmm`, which re-exports what users need. Without
//! the feature `std` (default) it uses neither `std` nor `alloc`, and `libm` has sine, cosine and exponential. With it large structures stand on the
//! heap, and there are frames that the program describes. The feature `proof`
//! (default) adds the extended precision, double-double, in which doubtful results are computed again.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(any(test, feature = "std"))]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("mstmm needs one of its features `std` (default) or `libm` for sin, cos and exp");

mod answer;
mod element;
pub mod elements;
#[cfg(feature = "std")]
pub mod frame;
mod model;
mod number;
mod pass;
mod proof;
pub mod search;
pub mod sections;
mod structure;
mod subspace;

pub use answer::compliance::Compliance;
pub use answer::energy_shares::EnergyShares;
#[cfg(feature = "std")]
pub use answer::frame_sensitivity::FrameSensitivities;
pub use answer::frequency_response::FrequencyResponse;
pub use answer::mac::{MacError, mac};
pub use answer::many_frequencies::ManyFrequencies;
pub use answer::modal::discrete::{DiscreteStateSpace, HoldOrder};
pub use answer::modal::exact::ExactResponse;
pub use answer::modal::history::{EntryMotion, ForceHistory};
#[cfg(feature = "std")]
pub use answer::modal::oscillator::record_spectrum;
pub use answer::modal::oscillator::{OscillatorPeak, oscillator_peak};
pub use answer::modal::participation::{Participation, ParticipationFactor};
pub use answer::modal::power_spectrum::PowerSpectrum;
pub use answer::modal::random_vibration::RandomResponse;
pub use answer::modal::response::ModalResponse;
pub use answer::modal::spectrum::{
    Combination, Directions, PeakOfMode, ResponseSpectrum, SpectralPeak, SpectrumTable, combined,
};
pub use answer::modal::state_space::ModalStateSpace;
#[cfg(feature = "std")]
pub use answer::modal::state_space::StateMatrices;
pub use answer::modal::truncation::{Truncation, Variation};
pub use answer::mode_shape::{ModeShape, ShapeList};
pub use answer::moving_load::crossing::Crossing;
pub use answer::moving_load::load::MovingLoad;
pub use answer::network::axial_forces::AxialForces;
pub use answer::network::geometry::geometry_slopes;
pub use answer::network::inside::MemberState;
pub use answer::network::questions::FrameAnalysis;
pub use answer::network::response::PlaneResponse;
pub use answer::network::sensitivity::PlaneChain;
pub use answer::network::shape::{PlaneShape, PlaneShapes};
pub use answer::network::sketch::Sketch;
pub use answer::network::states::PlaneStates;
pub use answer::orbit::{Orbit, WhirlAnalysis};
pub use answer::peak::of_proportional::CountedResponse;
pub use answer::peak::of_response::BandResponse;
pub use answer::peak::ratio::ResponseRatio;
pub use answer::peak::result::Peak;
pub use answer::questions::ModalAnalysis;
pub use answer::response_curve::Sample;
pub use answer::root::Root;
pub use answer::sensitivity::Sensitivities;
pub use answer::states::SystemStates;
pub use answer::tree_sketch::TreeSketch;
pub use element::back_transfer::BackTransfer;
pub use element::carries_load::CarriesLoad;
pub use element::charted::{Charted, MemberChart, MemberElement, MemberVisit, brought, has_chart, one_motion};
pub use element::deflection::Deflection;
pub use element::energies::{Energies, Inside};
pub use element::listed::{ListElement, ListMoving, ListStepping, MOST_PARAMETERS};
pub use element::member_gradient::{ByName, MemberGradient, MemberSlopes};
pub use element::member_motion::{Forms, MemberEnds, MemberMotion, VisitMember};
pub use element::member_numbers::{MemberNumbers, OwnPart};
pub use element::member_transfer::{MemberMatrix, MemberTransfer, PartState, member_transfer};
pub use element::moving::{CoefficientsOf, Moving};
pub use element::spins::Spins;
pub use element::traits::{Element, MatrixOf, PlaneStep, TransferMatrix, build, space_of, without_pole};
pub use element::visit::{Visit, VisitStep};
pub use elements::any_member::{AnyMember, BuiltAnyMember, BuiltUndampedMember, Section, UndampedMember};
pub use elements::damped_joint::DampedJoint;
pub use elements::joint::Joint;
pub use elements::shared::bending_chart::BendingWaves;
pub use elements::shared::chart_scalar::ChartScalar;
pub use elements::shared::longitudinal_chart::LongitudinalWaves;
pub use elements::{AnyElement, AnyUndamped};
pub use model::axial_force_error::AxialForceError;
pub use model::chain_rule::{Chain, ChainRule, Fields, NamedFields};
pub use model::direction::Direction;
pub use model::end_motion::EndMotion;
pub use model::ends::Ends;
pub use model::error::{InvalidParameter, ParameterError, Requirement};
pub use model::estimates::FrequencyEstimates;
pub use model::extent::Extent;
pub use model::label::{Entry, Label, Load, Point};
pub use model::load_error::LoadError;
pub use model::member_plane::Skew;
pub use model::motion_error::MotionError;
pub use model::peak_error::PeakError;
pub use model::plane_label::{Handle, Hold, MemberEnd, MemberLabel, PlaneEntry, PlaneLoad, PlanePoint, Tied};
pub use model::random_error::RandomError;
pub use model::search_error::{SearchError, Spot};
pub use model::space_point::{InSpace, SpacePoint};
pub use model::spectrum_error::SpectrumError;
pub use model::speed_error::SpeedError;
pub use model::state::{Bending, Planar, Rotation, State, StateSpace, Translation};
pub use model::tolerance_error::ToleranceError;
pub use model::track_error::{NotATrack, TrackError};
pub use model::truncation_error::TruncationError;
pub use model::turns::hertz;
pub use mstmm_plan::{
    Coordinate, Freedoms, Layout, NetworkOrder, OrderRoom, PathNode, Place, Scheme, Space, Step, Support, refuse_if,
};
pub use nalgebra::SMatrix;
pub use num_complex::Complex;
pub use number::double_double::DoubleDouble;
pub use number::dual::Dual;
pub use number::even_waves::EvenWaves;
pub use number::fixed_list::List;
pub use number::frequency::{
    ComplexEigenvalue, ComplexFrequency, ExtendedOf, Frequency, MayDecay, Oscillation, Parameter, Real, RealFrequency,
};
pub use number::frequency_powers::FrequencyPowers;
#[doc(hidden)]
pub use number::interval::Interval;
pub use number::packed::InLanes;
pub use number::partials::Partials;
#[doc(hidden)]
pub use number::products::Products;
pub use number::scalar::{LONGEST_IN_LANES, Scalar, Single};
pub use number::scaled::{Magnitude, Scaled};
pub use number::truth::{Size, Truth};
pub use number::value::Value;
pub use number::wave_functions::{WaveFunctions, WaveProducts};
pub use pass::at_once::InBlocks;
pub use pass::characteristic::{Characteristic, System};
pub use pass::drawn_tree::{DrawnPart, DrawnStep, DrawnTree};
#[doc(hidden)]
pub use pass::formulas::Enclosing;
pub use pass::formulas::Formulas;
pub use pass::inlining::{coefficients, join, root, step};
pub use pass::model::{Build, Model, Numbered};
#[cfg(feature = "std")]
pub use pass::network::Vectors;
pub use pass::network::{
    Arrays, Axis, Drawn, DrawnBody, DrawnEnd, DrawnMember, DrawnPoint, DrawnSupport, End, InNetwork, Member, Memory,
    Motions, MovingNetwork, Network, NetworkError, NetworkSketch, Node, OverallNetwork, OwnMembers, PerMember, PerNode,
    Placed, PlacedCharts, PlacedMotions, PlacedNode, PlacedTransfers, Placement, PlaneFrequency, Prestressed, Seat,
    Skeleton, SketchedBody, SketchedDirection, SketchedEnd, SketchedMember, SketchedNode, SketchedPlane, SketchedPoint,
    SketchedSkew, SketchedSupport, SketchedUp, StiffnessModel, build_member, network_pass, overall_determinant,
    overall_matrix, visit_network,
};
pub use pass::overall::assembly::Assembly;
pub use pass::overall::determinant::determinant;
pub use pass::overall::evaluate::Evaluate;
pub use pass::own::own_part;
pub use pass::planned_list::{InList, ListParameter, PerParameter, PlannedList, Room};
pub use pass::side_by_side::Lanewise;
pub use pass::step_list::{ListError, ListStep, OPEN_PATHS, StepList};
pub use pass::tree::{ExtendedTree, Planned, Tree};
pub use proof::visit::{Visitor, visit_steps};
pub use search::rotor::{Rotor, Spinning, Whirl};
pub use structure::chart::{Chart, JoinedEnd, MOST_ENTRIES, MOST_FREEDOMS, MOST_VARIABLES};
pub use structure::factor::Factor;
pub use structure::member::{MemberLoad, MemberStiffness};
pub use structure::memory::StructureScalar;
pub use structure::node_unknowns::{MotionUnknown, NodeUnknowns};
pub use subspace::connecting::Connecting;
pub use subspace::count::{Held, NoCount, RootCounter, WittrickWilliams};
pub use subspace::minors::covector::Covector;
pub use subspace::minors::line::Line;
pub use subspace::minors::plane::Plane;
pub use subspace::minors::subspace::Subspace;
