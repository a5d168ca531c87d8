//! Building, evaluating and searching allocate nothing, in any of the paper's five topologies.
#![allow(unsafe_code, reason = "a global allocator cannot be written without")]
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::support::models::{self, DampedOscillator, RestrainedBeam, SpringAndMass, TipBody, TwoSpans};
use core::alloc::{GlobalAlloc, Layout};
use core::cell::Cell;
use core::hint::black_box;
use mstmm::element::{ParameterError, SMatrix};
use mstmm::motion::ModalResponse;
use mstmm::number::{Magnitude, Scaled};
use mstmm::prelude::*;
use std::alloc::System;

system! {
    /// Two modes of a rigid body.
    #[derive(Clone, Copy, Debug)]
    pub struct FreeBeam { m: f64 }
    free -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: m } -> free;
}

system! {
    /// A portal with a spring and a damper between its corners.
    #[derive(Clone, Copy, Debug)]
    pub struct Portal { length: f64, c: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a at (0.0, length)
        -> beam 2 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (length, length)
        <- beam 3 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } <- conn foot at (length, 0.0) <- pinned;
    conn a -> spring 4 { stiffness: 1.0, damping: c } -> conn b;
}

system! {
    /// A square without supports.
    #[derive(Clone, Copy, Debug)]
    pub struct Square { length: f64 }
    conn a at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (length, 0.0)
        -> beam 2 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn c at (length, length)
        -> beam 3 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn d at (0.0, length)
        -> beam 4 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
}

/// The system's allocator, counting what the current thread asks of it: other threads belong to the test harness.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

impl Counting {
    fn count() {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
    }
}

// SAFETY: every request goes to `System` unchanged; the counter itself neither allocates nor unwinds.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        Counting::count();
        // SAFETY: the caller's obligations are those of `System`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        Counting::count();
        // SAFETY: as above.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        Counting::count();
        // SAFETY: as above.
        unsafe { System.realloc(block, layout, size) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of allocations, growths included, during `work`.
fn allocations<R>(work: impl FnOnce() -> R) -> usize {
    let before = ALLOCATIONS.get();
    let result = black_box(work());
    let count = ALLOCATIONS.get() - before;
    drop(result);
    count
}

/// Searches over ω, and over λ, on grids just fine enough to refine a few minima.
fn search<D: Into<Magnitude>>(determinant: impl Fn(Complex<f64>) -> D + Copy) {
    let along_axis = fmin1d::<32, _>(|omega| determinant(Complex::new(0.0, omega)), 0.1..=20.0, 60, 1e-6);
    assert!(!black_box(along_axis).unwrap().is_empty());
    let in_plane =
        fmin2d::<32, _>(|re, im| determinant(Complex::new(re, im)), [-2.0..=1.0, 0.1..=20.0], [12, 30], [1e-6, 1e-6]);
    assert!(!black_box(in_plane).unwrap().is_empty());
}

/// Builds, evaluates at a complex λ, and searches.
fn assert_none<S, const N: usize>(build: impl Fn() -> Result<S, ParameterError>)
where
    S: Evaluate<Complex<f64>, Matrix = SMatrix<Complex<f64>, N, N>>,
    S: Spectrum + mstmm::search::System<Parameter = f64> + Characteristic<Complex<f64>>,
{
    assert_eq!(allocations(&build), 0, "build");
    let (system, lambda) = (build().unwrap(), Complex::new(-0.3, 4.0));
    assert_eq!(allocations(|| system.overall_matrix(lambda)), 0, "overall_matrix at λ");
    assert_eq!(allocations(|| system.overall_determinant(lambda)), 0, "overall_determinant at λ");
    assert_eq!(allocations(|| search(|lambda| system.overall_determinant(lambda))), 0, "searches over λ");
    let characteristic = || Characteristic::<Complex<f64>>::characteristic(&system, lambda);
    assert_eq!(allocations(characteristic), 0, "characteristic at λ");
    let region = || Region { re: -2.0..=1.0, im: 0.1..=50.0 };
    assert_eq!(allocations(|| assert!(!system.eigenvalues::<16>(region()).unwrap().is_empty())), 0, "eigenvalues");
    assert_eq!(allocations(|| assert!(system.count_in(region()).unwrap() > 0)), 0, "count_in");
    assert_eq!(allocations(|| assert!(system.first_eigenvalues::<3>().is_ok())), 0, "first_eigenvalues");
}

/// The same at a real ω.
fn assert_none_undamped<S, const N: usize>(build: impl Fn() -> Result<S, ParameterError>)
where
    S: Evaluate<f64, Matrix = SMatrix<f64, N, N>> + Evaluate<Complex<f64>, Matrix = SMatrix<Complex<f64>, N, N>>,
    S: Undamped + mstmm::search::System<Parameter = f64>,
    S: Spectrum + Characteristic<Complex<f64>>,
{
    let system = build().unwrap();
    let determinant = |omega: f64| -> Scaled<f64> { system.overall_determinant(omega) };
    assert_eq!(allocations(|| -> SMatrix<f64, N, N> { system.overall_matrix(4.0) }), 0, "overall_matrix at ω");
    assert_eq!(allocations(|| determinant(4.0)), 0, "overall_determinant at ω");
    assert_eq!(allocations(|| fmin1d::<32, _>(determinant, 0.1..=20.0, 60, 1e-6)), 0, "fmin1d over ω");
    assert_eq!(allocations(|| Characteristic::<f64>::characteristic(&system, 4.0)), 0, "characteristic at ω");
    assert_eq!(allocations(|| assert!(system.count_below(100.0).unwrap() > 0)), 0, "count_below");
    assert_eq!(allocations(|| assert!(system.first_frequencies::<5>().is_ok())), 0, "first_frequencies");
    assert_eq!(allocations(|| assert!(system.natural_frequencies::<32>(0.0..=100.0).is_ok())), 0, "in a range");
    assert_none(build);
}

/// Samples of a response in time.
fn follow<const N: usize, M>(response: &ModalResponse<f64, N, M>) {
    let mut history = response.history(0.1).unwrap();
    let last = (0..10).map(|n| history.next(f64::from(n))).last();
    assert!(last.unwrap().is_finite() && response.to_step(0.3).is_finite() && response.to_impulse(0.3).is_finite());
}

/// Responses in time, undamped with a multiple root and damped, by the counter.
#[test]
fn modal_responses_allocate_nothing() {
    let system = models::light_tip_body().build().unwrap();
    let tip = TipBody::beam_1.output();
    let roots = system.first_frequencies::<4>().unwrap();
    let work = || {
        let response = system.modal_response::<4, _>(&roots, tip.force(), tip.deflection()).unwrap();
        follow(&response);
        follow(&response.with_damping_ratio(0.02).unwrap());
    };
    assert_eq!(allocations(work), 0, "undamped");
    let system = models::damped_oscillator().build().unwrap();
    let point = DampedOscillator::conn_5;
    let roots = system.first_eigenvalues::<4>().unwrap();
    let work = || follow(&system.modal_response::<4, _>(&roots, point.force(), point.deflection()).unwrap());
    assert_eq!(allocations(work), 0, "damped");
    let system = FreeBeam { m: 0.5 }.build().unwrap();
    let roots = system.first_frequencies::<4>().unwrap();
    let end = FreeBeam::beam_1.output();
    let work = || follow(&system.modal_response::<2, _>(&roots, end.force(), end.rotation()).unwrap());
    assert_eq!(allocations(work), 0, "with rigid-body modes");
}

/// Shapes, responses and sensitivities of a system at roots, and all that can be asked of them.
macro_rules! assert_motions_allocate_nothing {
    ($system:expr, $roots:expr, $x:expr, $points:expr, $labels:expr) => {{
        let (system, roots, points) = ($system, $roots, $points);
        let work = || {
            for root in roots.iter() {
                let shape = system.mode_shape(root).unwrap();
                let _ = black_box((shape.modal_mass(), shape.modal_stiffness(), shape.product(&shape)));
                let _ = black_box((shape.energy_shares($labels), shape.along($labels, 0.01)));
                let _ = black_box(shape.clone().with_unit_deflection());
                let _ = black_box(system.mode_shapes::<2, _>(root).unwrap());
                let sensitivities = system.sensitivity(root).unwrap();
                let _ = black_box((sensitivities.get("length"), sensitivities.iter().count()));
            }
            let response = system.frequency_response(points[0].force(), points[1].deflection()).unwrap();
            let _ = black_box(response.at($x).unwrap());
            let mut values = [$x; 2];
            response.on(&[$x, $x + 1.0], &mut values).unwrap();
            let curve = response.curve::<4000, _>(1.0..=3e4, &roots, 1e-2);
            let _ = black_box((values, curve.map(|curve| curve.first().map(|sample| sample.value * $x))));
        };
        assert_eq!(allocations(work), 0);
    }};
}

#[test]
fn motions_allocate_nothing() {
    let system = models::two_spans().build().unwrap();
    let roots = system.first_frequencies::<4>().unwrap();
    let points = [TwoSpans::conn_4, TwoSpans::mass_6.output()];
    assert_motions_allocate_nothing!(&system, &roots, 300.0, points, TwoSpans::beam_1);
    let system = models::damped_oscillator().build().unwrap();
    let roots = system.first_eigenvalues::<4>().unwrap();
    let points = [DampedOscillator::conn_5, DampedOscillator::mass_7.output()];
    assert_motions_allocate_nothing!(&system, &roots, Complex::new(0.0, 300.0), points, DampedOscillator::beam_1);
}

/// Motions of frames, undamped with multiple roots and damped, under loads and motions of supports.
macro_rules! assert_motions_of_frames_allocate_nothing {
    ($system:expr, $roots:expr, $x:expr, $loads:expr, $entry:expr, $label:expr) => {{
        let (system, roots) = ($system, $roots);
        let work = || {
            for root in &roots {
                let shapes = system.mode_shapes::<3, _>(root).unwrap();
                for shape in shapes.iter() {
                    let _ = black_box((shape.modal_mass(), shape.modal_stiffness(), shape.product(shape)));
                    let _ = black_box((shape.energy_shares($label), shape.along($label, 0.01)));
                    let _ = black_box(shape.clone().with_unit_deflection());
                }
                let sensitivities = system.sensitivity(root);
                let _ = black_box(sensitivities.map(|found| (found.get("length"), found.iter().count())));
            }
            for load in $loads {
                let response = system.frequency_response(load, $entry).unwrap();
                let _ = black_box(response.curve::<4000, _>(0.1..=2.0, &roots, 1e-2).map(|curve| curve.len()));
                let _ = black_box(response.at($x).unwrap());
                follow(&system.modal_response::<6, _>(&roots, load, $entry).unwrap());
            }
            let _ = black_box((system.overall_matrix($x), system.overall_determinant($x)));
        };
        assert_eq!(allocations(work), 0);
    }};
}

#[test]
fn motions_of_frames_allocate_nothing() {
    let system = Portal { length: 1.0, c: 0.1 }.build().unwrap();
    let roots = system.first_eigenvalues::<4>().unwrap();
    let (loads, entry) = ([Portal::conn_a.force_x(), Portal::conn_foot.motion_x()], Portal::conn_b.displacement_x());
    let x = Complex::new(-0.1, 3.0);
    assert_motions_of_frames_allocate_nothing!(&system, roots, x, loads, entry, Portal::beam_2);
    let system = Square { length: 1.0 }.build().unwrap();
    let roots = system.first_frequencies::<6>().unwrap();
    let (loads, entry) = ([Square::conn_a.force_x()], Square::conn_c.rotation_z());
    assert_motions_of_frames_allocate_nothing!(&system, roots, 3.0, loads, entry, Square::beam_2);
}

system! {
    /// A cantilever of the plane with a body at its tip and a spring.
    #[derive(Debug)]
    pub struct Lamp { height: f64, mass: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e6, bending_stiffness: 500.0, mass_per_length: 2.0 } -> conn top at (0.0, height)
        -> rigid_body 2 { mass, inertia: 0.1, centre: (0.2, height) };
    conn top -> spring 3 { stiffness: 1e3 } -> pinned at (1.0, 0.0);
}

/// A sketch and the first shape on it.
#[test]
fn a_sketch_allocates_nothing() {
    let lamp = Lamp { height: 3.0, mass: 5.0 }.build().unwrap();
    let root = lamp.first_frequencies::<1>().unwrap()[0];
    let work = || {
        let (sketch, shape) = (lamp.sketch(), lamp.mode_shape(&root).unwrap());
        let moved = |point: mstmm::motion::DrawnPoint<Lamp, f64>| {
            point.position[0] + shape.value(point.label.displacement_x()).unwrap()
        };
        let _ = black_box(sketch.points().map(moved).fold(0.0, f64::max));
        let parts = [sketch.members().count(), sketch.bodies().count(), sketch.supports().count()];
        assert_eq!(parts, [2, 1, 2]);
    };
    assert_eq!(allocations(work), 0);
}

/// The shapes of a double root come from a ring of frequencies around it.
#[test]
fn shapes_of_a_double_root_allocate_nothing() {
    let beam = FreeBeam { m: 0.5 }.build().unwrap();
    let roots = beam.first_frequencies::<2>().unwrap();
    assert_eq!(allocations(|| black_box(beam.mode_shapes::<2, _>(&roots[0]).unwrap()).iter().count()), 0);
}

/// Oracle: three allocations made on purpose, one of each kind.
#[test]
fn the_counter_sees_allocations() {
    assert_eq!(allocations(|| Box::new(black_box(1.0))), 1);
    assert_eq!(allocations(|| vec![0_u8; black_box(100)]), 1);
    let mut growing = Vec::with_capacity(1);
    growing.push(black_box(1));
    assert_eq!(allocations(|| growing.push(2)), 1);
    assert_eq!(allocations(|| black_box(1.0) + 1.0), 0);
}

/// Section 4.1, by the counter.
#[test]
fn beam_with_rigid_body_allocates_nothing() {
    let model = TipBody {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        mass: 1.0,
        inertia: 0.2,
        eccentricity: 0.3,
        depth: 0.5,
    };
    assert_none_undamped(|| model.build());
}

/// Section 4.2, by the counter.
#[test]
fn beam_with_elastic_restraints_allocates_nothing() {
    let model = RestrainedBeam {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        left_stiffness: 100.0,
        left_torsion: 1.0,
        right_stiffness: 100.0,
        right_torsion: 1.0,
    };
    assert_none_undamped(|| model.build());
}

/// Section 4.3, by the counter.
#[test]
fn beam_with_spring_and_lumped_mass_allocates_nothing() {
    let model = SpringAndMass {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        spring_position: 0.3,
        mass_position: 0.4,
        stiffness: 10.0,
        mass: 0.1,
    };
    assert_none_undamped(|| model.build());
}

/// Section 4.4, by the counter.
#[test]
fn beam_with_support_and_elastically_attached_mass_allocates_nothing() {
    let model = TwoSpans {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        support_position: 0.4,
        spring_position: 0.75,
        stiffness: 3.0,
        mass: 0.2,
    };
    assert_none_undamped(|| model.build());
}

/// Section 4.5, by the counter.
#[test]
fn beam_with_damped_oscillator_allocates_nothing() {
    let model = DampedOscillator {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        spring_position: 0.2,
        oscillator_position: 0.6,
        torsion_position: 0.75,
        spring_stiffness: 5.0,
        oscillator_stiffness: 4.0,
        damping: 1.0,
        mass: 0.12,
        torsion_stiffness: 10.0,
    };
    assert_none(|| model.build());
}

/// A refused parameter is reported without allocation as well.
#[test]
fn a_parameter_error_allocates_nothing() {
    let model = SpringAndMass {
        length: 1.0,
        bending_stiffness: 1.0,
        mass_per_length: 1.0,
        spring_position: 0.3,
        mass_position: 0.2,
        stiffness: 10.0,
        mass: 0.1,
    };
    assert_eq!(allocations(|| model.build().unwrap_err()), 0);
}
