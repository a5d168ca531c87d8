//! What each call needs of the stack, on threads that have no more than its documentation says.
//!
//! A thread that needs more ends the whole program. Sizes are those of release builds and, for builds without optimisation, of
//! debug builds.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use mstmm::prelude::*;
use std::thread::Builder;

system! {
    /// Three equal arms and an offset body: their double roots are judged.
    struct Star { l: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
    fixed -> beam 2 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
    fixed -> beam 3 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a
          -> body 4 { mass: 0.3, inertia_about_input: 0.2, output_x: 0.3, centre_x: 0.1 } -> free;
}

system! {
    /// Beams with a damped oscillator.
    struct Absorber { c: f64 }
    pinned -> beam 1 { length: 0.4, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2 -> beam 3 { length: 0.6, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
    conn 2 <- spring 4 { stiffness: 4.0, damping: c } <- mass 5 { mass: 0.12 } <- free;
}

system! {
    /// Critically damped for c = 4: its double eigenvalue is judged.
    struct Oscillator { c: f64 }
    fixed -> spring 1 { stiffness: 4.0, damping: c } -> mass 2 { mass: 1.0 } -> free;
}

system! {
    /// A portal with a damper between its corners.
    struct Portal { l: f64, c: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a at (0.0, l)
        -> beam 2 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (l, l)
        <- beam 3 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } <- pinned at (l, 0.0);
    conn a -> damper 4 { damping: c } -> conn b;
}

system! {
    /// A square on four spokes, whose double roots are judged.
    struct Square { l: f64 }
    conn m at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a at (l, 0.0);
    conn m -> beam 2 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (0.0, l);
    conn m -> beam 3 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn d at (-l, 0.0);
    conn m -> beam 4 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn e at (0.0, -l);
    conn a -> beam 5 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b;
    conn b -> beam 6 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn d;
    conn d -> beam 7 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn e;
    conn e -> beam 8 { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a;
}

/// Runs a call on a thread of so many kB.
fn on_a_stack_of([release, debug]: [usize; 2], call: fn()) {
    let size = if cfg!(debug_assertions) { debug } else { release };
    Builder::new().stack_size(size * 1024).spawn(call).unwrap().join().unwrap();
}

fn star() -> StarSystem {
    Star { l: 1.0 }.build().unwrap()
}

fn absorber() -> AbsorberSystem {
    Absorber { c: 1.0 }.build().unwrap()
}

const REAL: [usize; 2] = [128, 384];
const COMPLEX: [usize; 2] = [192, 768];
const GRID: [usize; 2] = [256, 512];
const FRAMES: [usize; 2] = [256, 768];

#[test]
fn counts() {
    on_a_stack_of(REAL, || assert_eq!(star().count_below(1e-3), Ok(0)));
    on_a_stack_of(REAL, || {
        let root = star().first_frequencies::<1>().unwrap()[0];
        assert!(star().count_below(root.omega).is_ok());
    });
}

#[test]
fn blocks() {
    on_a_stack_of(GRID, || {
        let mut counts = [Ok(0); 64];
        star().counts_below(&[3.0; 64], &mut counts).unwrap();
    });
    on_a_stack_of(GRID, || {
        let mut values = [mstmm::number::Scaled::new(Complex::new(0.0, 0.0), 0); 64];
        absorber().characteristics(&[Complex::new(-1.0, 3.0); 64], &mut values).unwrap();
    });
}

#[test]
fn searches_of_undamped_systems() {
    on_a_stack_of(REAL, || assert!(star().first_frequencies::<8>().unwrap().iter().any(|root| root.multiplicity > 1)));
    on_a_stack_of(REAL, || assert!(star().natural_frequencies::<32>(0.0..=300.0).is_ok()));
}

/// Seven frequencies each of models in step, and of models that do not keep it.
#[test]
fn sweeps() {
    on_a_stack_of(GRID, || {
        let models = (0..20).map(|k| Star { l: 1.0 + f64::from(k) });
        assert!(models.first_frequencies::<7>().all(|roots| roots.is_ok()));
    });
}

#[test]
fn searches_of_damped_systems() {
    on_a_stack_of(COMPLEX, || assert!(absorber().first_eigenvalues::<4>().is_ok()));
    on_a_stack_of(COMPLEX, || assert!(absorber().count_in(Region { re: -5.0..=0.0, im: 1.0..=99.0 }).is_ok()));
    on_a_stack_of(COMPLEX, || {
        let oscillator = Oscillator { c: 4.0 }.build().unwrap();
        let roots = oscillator.eigenvalues::<4>(Region { re: -50.0..=1.0, im: -50.0..=50.0 }).unwrap();
        assert_eq!((roots.len(), roots[0].multiplicity), (1, 2));
    });
}

#[test]
fn searches_of_frames() {
    on_a_stack_of(REAL, || {
        let roots = Square { l: 1.0 }.build().unwrap().first_frequencies::<12>().unwrap();
        assert!(roots.iter().any(|root| root.multiplicity > 1));
    });
    on_a_stack_of(COMPLEX, || {
        assert!(Portal { l: 1.0, c: 0.5 }.build().unwrap().first_eigenvalues::<4>().is_ok());
    });
}

#[test]
fn motions_of_frames() {
    on_a_stack_of(FRAMES, || {
        let square = Square { l: 1.0 }.build().unwrap();
        for root in &square.first_frequencies::<6>().unwrap() {
            assert!(square.mode_shapes::<3, _>(root).is_ok());
            assert!(root.multiplicity > 1 || root.omega == 0.0 || square.sensitivity(root).is_ok());
        }
        let response = square.frequency_response(Square::conn_a.force_x(), Square::conn_b.displacement_y()).unwrap();
        assert!(response.at(1.3).is_ok());
        assert!(response.curve::<64, f64>(0.1..=1.0, &square.first_frequencies::<4>().unwrap(), 1e-2).is_ok());
    });
    on_a_stack_of(FRAMES, || {
        let portal = Portal { l: 1.0, c: 0.5 }.build().unwrap();
        let roots = portal.first_eigenvalues::<2>().unwrap();
        assert!(portal.mode_shape(&roots[0]).is_ok() && portal.sensitivity(&roots[0]).is_ok());
        let (load, entry) = (Portal::conn_a.force_x(), Portal::conn_a.displacement_x());
        assert!(portal.modal_response::<4, _>(&roots, load, entry).is_ok());
        assert!(portal.overall_determinant(roots[0].lambda).mantissa().norm() >= 0.0);
    });
}

#[test]
fn motions() {
    on_a_stack_of(COMPLEX, || {
        for root in &star().first_frequencies::<6>().unwrap() {
            assert!(star().mode_shapes::<4, _>(root).is_ok());
        }
    });
    on_a_stack_of(COMPLEX, || {
        let roots = absorber().first_eigenvalues::<2>().unwrap();
        assert!(absorber().mode_shape(&roots[0]).is_ok() && absorber().sensitivity(&roots[0]).is_ok());
        let point = Absorber::conn_2;
        assert!(absorber().modal_response::<4, _>(&roots, point.force(), point.deflection()).is_ok());
    });
}

#[test]
fn responses() {
    on_a_stack_of(REAL, || {
        let tip = Star::body_4.output();
        assert!(star().frequency_response(tip.force(), tip.deflection()).unwrap().at(0.0).is_ok());
    });
    on_a_stack_of(GRID, || {
        let (system, point) = (absorber(), Absorber::conn_2);
        let response = system.frequency_response(point.force(), point.deflection()).unwrap();
        let mut values = [Complex::new(0.0, 0.0); 64];
        response.on(&[Complex::new(0.0, 2.0); 64], &mut values).unwrap();
    });
    // beside what others need four times the list of 256 samples of 24 bytes
    on_a_stack_of(GRID, || {
        let (system, tip) = (star(), Star::body_4.output());
        let roots = system.first_frequencies::<2>().unwrap();
        let response = system.frequency_response(tip.force(), tip.deflection()).unwrap();
        assert!(!response.curve::<256, _>(0.1..=2.0, &roots, 0.1).unwrap().is_empty());
    });
}
