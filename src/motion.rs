//! Motions: mode shapes, responses, sensitivities.
//!
//! Questions are methods of [`ModalAnalysis`], of plane structures of [`FrameAnalysis`]; points of a model are its labels, such as
//! `Footbridge::conn_2`.

pub use mstmm_core::{
    AxialForceError, BandResponse, Combination, Compliance, Coordinate, CountedResponse, Crossing, Direction,
    Directions, DiscreteStateSpace, Drawn, DrawnBody, DrawnEnd, DrawnMember, DrawnPart, DrawnPoint, DrawnStep,
    DrawnSupport, DrawnTree, EndMotion, EnergyShares, Entry, EntryMotion, ExtendedTree, Extent, ForceHistory,
    FrameAnalysis, HoldOrder, InSpace, Label, MacError, MemberEnd, MemberLabel, MemberState, ModalAnalysis,
    ModalStateSpace, MotionError, MovingLoad, MovingNetwork, NotATrack, Orbit, OscillatorPeak, ParticipationFactor,
    Peak, PeakError, PeakOfMode, PlaneEntry, PlaneFrequency, PlanePoint, PlaneResponse, PlaneShapes, PlaneStates,
    Planned, Point, PowerSpectrum, RandomError, RandomResponse, ResponseRatio, ResponseSpectrum, Root, Sample,
    ShapeList, Skew, SpacePoint, SpectralPeak, SpectrumError, SpectrumTable, State, SystemStates, TrackError, Tree,
    Truncation, TruncationError, Variation, WhirlAnalysis, combined, mac, oscillator_peak,
};
#[cfg(feature = "std")]
pub use mstmm_core::{StateMatrices, record_spectrum};

/// A load on a path: a force or a moment at a point, a load along an element, or the weight of all that moves in Y.
///
/// ```
/// use mstmm::motion::Load;
/// use mstmm::prelude::*;
///
/// system! {
///     /// A cantilever with a mass at its tip.
///     struct Bracket { length: f64, ei: f64, m: f64, mass: f64 }
///     fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> point_mass 2 { mass, inertia: 0.0 } -> free;
/// }
///
/// let bracket = Bracket { length: 2.0, ei: 1e4, m: 3.0, mass: 5.0 }.build()?;
/// let tip = Bracket::point_mass_2.output().deflection();
///
/// // under 1 N/m, q l⁴/(8 EI) at rest and more below the first resonance
/// let loaded = bracket.frequency_response(Bracket::beam_1.uniform_load(), tip)?;
/// assert!((loaded.at(0.0)? - 2.0_f64.powi(4) / 8e4).abs() < 1e-17);
/// assert!(loaded.at(10.0)? > loaded.at(0.0)?);
///
/// // under its own weight, for each m/s² of acceleration towards Y
/// let sag = bracket.frequency_response(Load::self_weight(), tip)?.at(0.0)?;
/// assert!((sag - (3.0 * 16.0 / 8.0 + 5.0 * 8.0 / 3.0) / 1e4).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::Load;

/// The axial forces of members under loads at rest: what they are, and the structure under them, its critical loads, its sway (P-Δ).
///
/// ```
/// use mstmm::prelude::*;
/// use mstmm::search::critical_loads;
///
/// system! {
///     /// A portal whose members bear axial forces.
///     struct Portal {}
///     section steel { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0, axial_force: 0.0 }
///     fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0);
///     conn c <- beam 3 { ..steel } <- pinned at (4.0, 0.0);
/// }
///
/// let portal = Portal {}.build()?;
/// let dead = [(Portal::conn_b.force_y(), -2e5), (Portal::conn_c.force_y(), -2e5), (Portal::beam_2.uniform_load_y(), -1e4)];
/// let forces = portal.axial_forces(&dead)?;
/// assert!((forces.get(Portal::beam_1)? + 219_516.0577).abs() < 1e-3);
///
/// // the portal buckles sideways under twice the loads
/// let factors = critical_loads::<1, _>(0.0..=4.0, |factor| portal.with_axial_forces(&(&forces * factor)))?;
/// assert!((factors[0].factor - 2.07810721832793).abs() < 1e-13);
///
/// // under the loads it sways almost twice as far, and its frequency falls
/// let loaded = portal.settled_under(&dead)?;
/// let sway = |portal: &PortalSystem| portal.frequency_response(Portal::conn_b.force_x(), Portal::conn_b.displacement_x())?.at(0.0);
/// assert!((sway(&loaded)? / sway(&portal)? - 1.9).abs() < 0.05);
/// let [unloaded, under] = [portal.first_frequencies::<1>()?[0].omega, loaded.first_frequencies::<1>()?[0].omega];
/// assert!(under < 0.75 * unloaded);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::AxialForces;

/// A load on a plane model: a force or a moment at a point, a motion of a support, a load along a member, or the weight of the model.
///
/// ```
/// use mstmm::motion::PlaneLoad;
/// use mstmm::prelude::*;
///
/// system! {
///     /// A portal with a machine on its girder.
///     struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64, machine: f64 }
///     fixed at (0.0, 0.0)
///         -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
///         -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
///         <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- conn d at (span, 0.0);
///     conn d <- fixed;
///     conn c -> point_mass 4 { mass: machine };
/// }
///
/// let portal = Portal { height: 3.0, span: 4.0, ea: 1e12, ei: 1e6, m: 20.0, machine: 100.0 }.build()?;
/// let girder = Portal::beam_2;
/// let response = portal.frequency_response(girder.uniform_load_y(), girder.input().moment())?;
///
/// // the moments at rest, for bars that do not stretch: q l²/(6 (2 + h/l)) at the corners, and q l²/8 less in the middle
/// let at_rest = response.states(0.0)?;
/// let corner = 16.0 / (6.0 * (2.0 + 0.75));
/// for (part, moment) in [(0.0, corner), (0.5, corner - 2.0), (1.0, corner)] {
///     assert!((at_rest.along(girder, 4.0 * part)?.moment - moment).abs() < 1e-4);
/// }
///
/// // the foot below the machine carries that, a column and half of the girder
/// let foot = portal.frequency_response(PlaneLoad::self_weight_y(), Portal::conn_d.reaction_y())?;
/// assert!((foot.at(0.0)? + 100.0 + 60.0 + 40.0).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::PlaneLoad;

/// The shape of a mode: states at all ends of elements and inside of beams, nodes, energies.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
///     fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free;
/// }
///
/// let beam = Cantilever { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5 }.build()?;
/// let roots = beam.first_frequencies::<3>()?;
/// let third = beam.mode_shape(&roots[2])?;
/// assert_eq!(third.nodes(Cantilever::beam_1), 2);
/// assert_eq!(third.state(Cantilever::beam_1.input()).y, 0.0);
/// let middle = third.along(Cantilever::beam_1, 0.5)?;
/// assert!(middle.y.abs() < third.state(Cantilever::beam_1.output()).y.abs());
///
/// // of modal mass 1, orthogonal to other modes
/// assert!((third.modal_mass() - 1.0).abs() < 1e-14);
/// assert!(third.product(&beam.mode_shape(&roots[0])?).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::ModeShape;

/// The response to a harmonic load, at rest too.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
///     fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free;
/// }
///
/// let beam = Cantilever { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5 }.build()?;
/// let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::beam_1.output());
/// let deflection = beam.frequency_response(tip.force(), tip.deflection())?;
///
/// // l³/(3 EI) at rest, at ω = 5 rad/s nearer to the first resonance at 7.03 more
/// assert!((deflection.at(0.0)? - 1.0 / 6.0).abs() < 1e-15);
/// assert!(deflection.at(5.0)? > 1.9 / 6.0);
///
/// let moment = beam.frequency_response(tip.force(), clamp.moment())?;
/// let mut values = [0.0; 3];
/// moment.on(&[0.0, 1.0, 2.0], &mut values)?;
/// assert!((values[0] - 1.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::FrequencyResponse;

/// What each field of the model moves a root by.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
///     fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free;
/// }
///
/// let beam = Cantilever { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5 }.build()?;
/// let root = beam.first_frequencies::<1>()?[0];
/// let sensitivity = beam.sensitivity(&root)?;
/// for (field, slope) in sensitivity.iter() {
///     println!("dω/d({field}) = {slope}");
/// }
/// // ω is proportional to l⁻²
/// assert!((sensitivity.get("length").unwrap_or(0.0) + 2.0 * root.omega).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::Sensitivities;

/// The response in time to an impulse, a step or a force history.
///
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
pub use mstmm_core::{ExactResponse, ModalResponse};

/// The shape of a mode of a plane frame: displacements of points, forces in members.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64 }
///     fixed at (0.0, 0.0)
///         -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
///         -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
///         <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (span, 0.0);
/// }
///
/// let portal = Portal { height: 2.0, span: 2.0, ea: 4e8, ei: 1e6, m: 20.0 }.build()?;
/// let first = portal.first_frequencies::<1>()?[0];
/// let shape = portal.mode_shape(&first)?;
///
/// // it sways: both corners go the same way, and the girder has no moment in its middle
/// let [b, c] = [Portal::conn_b, Portal::conn_c].map(|point| shape.value(point.displacement_x()));
/// assert!((b? - c?).abs() < 1e-13);
/// let girder = Portal::beam_2;
/// assert!((shape.value(girder.input().moment())? + shape.value(girder.output().moment())?).abs() < 1e-8);
///
/// // inside of the girder the moment falls along a line, but for its inertia; most of the strain energy is in the columns
/// let quarter = shape.along(girder, 0.5)?.moment / shape.value(girder.input().moment())?;
/// assert!((quarter - 0.5).abs() < 0.1);
/// assert!(2.0 * shape.energy_shares(Portal::beam_1)?.strain > 0.5);
///
/// // its frequency follows the height of the columns, their feet being where they are
/// let sensitivity = portal.sensitivity(&first)?;
/// assert!(sensitivity.get("height").unwrap_or(0.0) < -100.0);
///
/// let response = portal.frequency_response(Portal::conn_b.force_x(), Portal::beam_1.input().moment())?;
/// assert!(response.at(0.0)?.abs() < 1.0 && response.at(0.99 * first.omega)?.abs() > 10.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::PlaneShape;

/// What a plane frame looks like: points, members, bodies and supports, with their names and coordinates.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64 }
///     fixed at (0.0, 0.0)
///         -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
///         -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
///         <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (span, 0.0);
/// }
///
/// let portal = Portal { height: 2.0, span: 3.0, ea: 4e8, ei: 1e6, m: 20.0 }.build()?;
/// let sketch = portal.sketch();
/// let names: Vec<_> = sketch.points().map(|point| point.name.to_string()).collect();
/// assert_eq!(names, ["fixed at beam 1", "conn b", "conn c", "fixed at beam 3"]);
///
/// // its first mode, in which the corners move by half a metre
/// let shape = portal.mode_shape(&portal.first_frequencies::<1>()?[0])?;
/// let scale = 0.5 / shape.value(Portal::conn_b.displacement_x())?;
/// let mut moved = Vec::new();
/// for point in sketch.points() {
///     let [x, y, _] = point.position;
///     let [u, v] = [shape.value(point.label.displacement_x())?, shape.value(point.label.displacement_y())?];
///     moved.push([x + scale * u, y + scale * v]);
/// }
/// assert!(moved[0] == [0.0, 0.0] && (moved[1][0] - 0.5).abs() < 1e-15 && (moved[2][0] - 3.5).abs() < 1e-13);
/// for member in sketch.members() {
///     let [from, to] = member.ends.map(|end| end.point.map(|point| moved[point]));
///     println!("{} {} from {from:?} to {to:?}", member.kind, member.name);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::Sketch;

/// What a built tree is made of, and where its paths join.
///
/// ```
/// use mstmm::motion::DrawnPart;
/// use mstmm::prelude::*;
///
/// system! {
///     /// A cantilever with a spring under its tip.
///     struct Held { length: f64, ei: f64, m: f64, stiffness: f64 }
///     fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> conn tip -> free;
///     conn tip <- spring 2 { stiffness } <- fixed;
/// }
/// # impl Held { fn steel() -> Self { Held { length: 2.0, ei: 1e4, m: 3.0, stiffness: 5e3 } } }
///
/// let held = Held::steel().build()?;
/// let steps: Vec<_> = held.sketch().steps().collect();
/// let names: Vec<_> = steps.iter().map(|step| step.name.to_string()).collect();
/// assert_eq!(names, ["fixed", "beam 1", "fixed", "spring 2", "conn tip", "free"]);
/// assert_eq!(steps[4].inputs, [1, 3]);
/// let DrawnPart::Element { kind, extent } = steps[1].part else { return Err("no element".into()) };
/// assert_eq!((kind, extent.output), ("Beam", [2.0, 0.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::TreeSketch;

/// How much of the mass each mode takes with it along a direction.
///
/// ```
/// use mstmm::prelude::*;
///
/// system! {
///     pub struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
///     fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free;
/// }
///
/// let beam = Cantilever { length: 2.0, bending_stiffness: 8.0, mass_per_length: 1.5 }.build()?;
/// let roots = beam.first_frequencies::<3>()?;
/// let participation = beam.participation::<3, _>(&roots, Direction::y())?;
/// for (mode, root) in roots.iter().enumerate() {
///     let part = 100.0 * participation.cumulative(mode) / participation.total();
///     println!("{:7.3} Hz {:6.3} kg, together {part:4.1} %", root.hertz(), participation.effective_mass(mode));
/// }
/// assert!((participation.effective_mass(0) / 3.0 - 0.6131).abs() < 1e-4);
/// assert!((participation.total() - 3.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub use mstmm_core::Participation;
