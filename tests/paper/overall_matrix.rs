//! The overall matrix of the paper's five topologies against an assembly by hand from the equations of the paper,
//! and of a tree with connections upstream of connections against its stiffness matrix.

mod hand;

use crate::models::{
    DampedOscillator, DampedOscillatorSystem, RestrainedBeam, RestrainedBeamSystem, SpringAndMass, SpringAndMassSystem,
    TipBody, TipBodySystem, TwoSpans, TwoSpansSystem,
};
use crate::support::roots::{assert_same_roots, zeros as zeros_of};
use hand::{
    C, FIXED, FIXED_LINE, FREE, FREE_LINE, Matrix, PINNED, beam, body, consistent, dynamic_stiffness, hinge, mass,
    minus_identity, reduced, spring, spring_damper, torsion_spring, torsional, translational, zeros,
};
use mstmm::element::SMatrix;
use mstmm::number::Scaled;
use mstmm::search::Evaluate;
use nalgebra::{Matrix6, Vector6};
use proptest::prelude::*;

/// The accuracy demanded of each entry, relative to the largest.
const TOLERANCE: f64 = 1e-12;

/// Fixed seed and modest number of cases: the same parameters in every run.
fn config() -> ProptestConfig {
    ProptestConfig {
        cases: 128,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2017),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

fn assert_same_matrix<const N: usize>(actual: SMatrix<C, N, N>, expected: &Matrix) {
    assert_eq!((N, N), expected.shape(), "size of the overall matrix");
    let largest = expected.iter().map(|entry| entry.norm()).fold(0.0, f64::max);
    for i in 0..N {
        for j in 0..N {
            let error = (actual[(i, j)] - expected[(i, j)]).norm();
            let entries = (actual[(i, j)], expected[(i, j)]);
            assert!(error <= TOLERANCE * largest, "entry ({i}, {j}) is {} instead of {}", entries.0, entries.1);
        }
    }
}

/// Compares with nalgebra's determinant of the matrix by hand times `factor`.
fn assert_same_determinant(actual: Scaled<C>, expected: &Matrix, factor: C) {
    let value = expected.determinant() * factor;
    let error = (actual.value() - value).norm();
    // elimination with N² roundings an entry on either side, relative to Hadamard's bound of the determinant
    let hadamard: f64 = expected.row_iter().map(|row| row.norm()).product();
    let bound = 2.0 * (expected.nrows().pow(2) as f64) * f64::EPSILON * hadamard * factor.norm();
    assert!(error <= bound, "determinant {} instead of {value}", actual.value());
}

/// Checks an undamped system at a real ω and at λ = iω.
fn check_undamped<System, const N: usize>(system: &System, omega: f64, by_hand: impl Fn(C) -> Matrix)
where
    System: Evaluate<f64, Matrix = SMatrix<f64, N, N>> + Evaluate<C, Matrix = SMatrix<C, N, N>>,
{
    let lambda = C::new(0.0, omega);
    let expected = by_hand(lambda);
    assert_same_matrix(system.overall_matrix(omega).map(C::from), &expected);
    assert_same_matrix(system.overall_matrix(lambda), &expected);
    let determinant = system.overall_determinant(omega);
    assert_same_determinant(Scaled::new(C::from(determinant.value()), 0), &expected, C::ONE);
    assert_same_determinant(system.overall_determinant(lambda), &expected, C::ONE);
}

/// Eq. (30).
fn tip_body(p: &TipBody, lambda: C) -> Matrix {
    let u1 = beam(p.length, p.bending_stiffness, p.mass_per_length, lambda);
    let u2 = body(p.mass, p.inertia + p.mass * p.eccentricity * p.eccentricity, p.depth, p.eccentricity, lambda);
    reduced(&[[u2 * u1, minus_identity()]], [FIXED, FREE])
}

/// Eqs. (33)-(35).
fn restrained_beam(p: &RestrainedBeam, lambda: C) -> Matrix {
    let (u1, u5) = (hinge(p.left_stiffness, p.left_torsion), hinge(p.right_stiffness, p.right_torsion));
    let u3 = beam(p.length, p.bending_stiffness, p.mass_per_length, lambda);
    let (c2, c4) = (consistent(), consistent());
    let t1 = &c4.u1 * &u3 * &c2.u1;
    let t2 = &c4.u1 * &u3 * &c2.u2 * &u1;
    let t3 = &c4.u2 * &u5;
    let (g1, g2) = (-&c2.h1, &c2.h2 * &u1);
    let g3 = -&c4.h1 * &u3 * &c2.u1;
    let g4 = -&c4.h1 * &u3 * &c2.u2 * &u1;
    let g5 = &c4.h2 * &u5;
    let rows = [[t1, t2, t3, minus_identity()], [g1, g2, zeros(2, 4), zeros(2, 4)], [g3, g4, g5, zeros(2, 4)]];
    reduced(&rows, [FREE, FIXED, FIXED, FREE])
}

/// Eq. (36).
fn spring_and_mass(p: &SpringAndMass, lambda: C) -> Matrix {
    let span = |length| beam(length, p.bending_stiffness, p.mass_per_length, lambda);
    let (u1, u4, u7) =
        (span(p.spring_position), span(p.mass_position - p.spring_position), span(p.length - p.mass_position));
    let (u3, u6) = (spring(p.stiffness), mass(p.mass, lambda));
    let (c2, c5) = (translational(), translational());
    let t1 = &u7 * &c5.u1 * &u4 * &c2.u1 * &u1;
    let t2 = &u7 * &c5.u1 * &u4 * &c2.u2 * &u3;
    let t3 = &u7 * &c5.u2 * &u6;
    let (g1, g2) = (-&c2.h1 * &u1, &c2.h2 * &u3);
    let g3 = -&c5.h1 * &u4 * &c2.u1 * &u1;
    let g4 = -&c5.h1 * &u4 * &c2.u2 * &u3;
    let g5 = &c5.h2 * &u6;
    let rows = [[t1, t2, t3, minus_identity()], [g1, g2, zeros(1, 2), zeros(1, 4)], [g3, g4, g5, zeros(1, 4)]];
    reduced(&rows, [PINNED, FIXED_LINE, FREE_LINE, PINNED])
}

/// Eqs. (37) and (38).
fn two_spans(p: &TwoSpans, lambda: C) -> Matrix {
    let span = |length| beam(length, p.bending_stiffness, p.mass_per_length, lambda);
    let (u1, u3, u7) =
        (span(p.support_position), span(p.spring_position - p.support_position), span(p.length - p.spring_position));
    let (u5, u6) = (spring(p.stiffness), mass(p.mass, lambda));
    let (c2, c4) = (consistent(), translational());
    let t1 = &u7 * &c4.u1 * &u3 * &c2.u1 * &u1;
    let t2 = &u7 * &c4.u1 * &u3 * &c2.u2;
    let t3 = &u7 * &c4.u2 * &u5 * &u6;
    let (g1, g2) = (-&c2.h1 * &u1, c2.h2.clone());
    let g3 = -&c4.h1 * &u3 * &c2.u1 * &u1;
    let g4 = -&c4.h1 * &u3 * &c2.u2;
    let g5 = &c4.h2 * &u5 * &u6;
    let rows = [[t1, t2, t3, minus_identity()], [g1, g2, zeros(2, 2), zeros(2, 4)], [g3, g4, g5, zeros(1, 4)]];
    reduced(&rows, [PINNED, PINNED, FREE_LINE, PINNED])
}

/// Eq. (40).
fn damped_oscillator(p: &DampedOscillator, lambda: C) -> Matrix {
    let span = |length| beam(length, p.bending_stiffness, p.mass_per_length, lambda);
    let (u1, u4) = (span(p.spring_position), span(p.oscillator_position - p.spring_position));
    let (u8, u11) = (span(p.torsion_position - p.oscillator_position), span(p.length - p.torsion_position));
    let (u3, u10) = (spring(p.spring_stiffness), torsion_spring(p.torsion_stiffness));
    let (u6, u7) = (spring_damper(p.oscillator_stiffness, p.damping, lambda), mass(p.mass, lambda));
    let (c2, c5, c9) = (translational(), translational(), torsional());
    let to_5 = [&u4 * &c2.u1 * &u1, &u4 * &c2.u2 * &u3];
    let to_9 = [&u8 * &c5.u1 * &to_5[0], &u8 * &c5.u1 * &to_5[1], &u8 * &c5.u2 * &u6 * &u7];
    let [t1, t2, t3] = to_9.each_ref().map(|path| &u11 * &c9.u1 * path);
    let [g91, g92, g93] = to_9.map(|path| -&c9.h1 * path);
    let [g51, g52] = to_5.map(|path| -&c5.h1 * path);
    let rows = [
        [t1, t2, t3, &u11 * &c9.u2 * &u10, minus_identity()],
        [-&c2.h1 * &u1, &c2.h2 * &u3, zeros(1, 2), zeros(1, 2), zeros(1, 4)],
        [g51, g52, &c5.h2 * &u6 * &u7, zeros(1, 2), zeros(1, 4)],
        [g91, g92, g93, &c9.h2 * &u10, zeros(1, 4)],
    ];
    reduced(&rows, [PINNED, FIXED_LINE, FREE_LINE, FIXED_LINE, PINNED])
}

/// The widths that the paper states.
#[test]
fn sizes_are_those_of_the_paper() {
    let sizes = [
        TipBodySystem::N,
        RestrainedBeamSystem::N,
        SpringAndMassSystem::N,
        TwoSpansSystem::N,
        DampedOscillatorSystem::N,
    ];
    assert_eq!(sizes, [4, 8, 6, 7, 7]);
}

// Parameters of order one and beams of a few wavelengths at most: entries of one matrix are then of like size, and its
// determinant is not lost in rounding, so that an error in the smallest entry still shows.
proptest! {
    #![proptest_config(config())]

    /// Section 4.1 against eq. (30).
    #[test]
    fn beam_with_rigid_body(p in proptest::array::uniform7(0.5..2.0f64), omega in 0.2..8.0f64) {
        let [length, bending_stiffness, mass_per_length, mass, inertia, e, d] = p;
        let (eccentricity, depth) = (e - 1.0, d - 1.0);
        let model = TipBody { length, bending_stiffness, mass_per_length, mass, inertia, eccentricity, depth };
        check_undamped(&model.build().unwrap(), omega, |lambda| tip_body(&model, lambda));
    }

    /// Section 4.2 against eqs. (33)-(35).
    #[test]
    fn beam_with_elastic_restraints(p in proptest::array::uniform7(0.5..2.0f64), omega in 0.2..8.0f64) {
        let [length, bending_stiffness, mass_per_length, left_stiffness, left_torsion, right_stiffness, right_torsion] = p;
        let model = RestrainedBeam {
            length, bending_stiffness, mass_per_length, left_stiffness, left_torsion, right_stiffness, right_torsion,
        };
        check_undamped(&model.build().unwrap(), omega, |lambda| restrained_beam(&model, lambda));
    }

    /// Section 4.3 against eq. (36).
    #[test]
    fn beam_with_spring_and_lumped_mass(p in proptest::array::uniform7(0.5..2.0f64), omega in 0.2..8.0f64) {
        let [a, b, c, bending_stiffness, mass_per_length, stiffness, mass] = p;
        let model = SpringAndMass {
            length: 0.4 * (a + b + c), spring_position: 0.4 * a, mass_position: 0.4 * (a + b),
            bending_stiffness, mass_per_length, stiffness, mass,
        };
        check_undamped(&model.build().unwrap(), omega, |lambda| spring_and_mass(&model, lambda));
    }

    /// Section 4.4 against eqs. (37) and (38).
    #[test]
    fn beam_with_support_and_elastically_attached_mass(
        p in proptest::array::uniform7(0.5..2.0f64), omega in 0.2..8.0f64,
    ) {
        let [a, b, c, bending_stiffness, mass_per_length, stiffness, mass] = p;
        let model = TwoSpans {
            length: 0.4 * (a + b + c), support_position: 0.4 * a, spring_position: 0.4 * (a + b),
            bending_stiffness, mass_per_length, stiffness, mass,
        };
        check_undamped(&model.build().unwrap(), omega, |lambda| two_spans(&model, lambda));
    }

    /// Section 4.5 against eq. (40), at complex λ; the determinant times K + Cλ.
    #[test]
    fn beam_with_damped_oscillator(
        p in proptest::array::uniform8(0.5..2.0f64), re in -4.0..4.0f64, im in -8.0..8.0f64,
    ) {
        let [length, bending_stiffness, mass_per_length, spring_stiffness, oscillator_stiffness, damping,
            torsion_stiffness, mass] = p;
        let model = DampedOscillator {
            length: 1.2 * length, bending_stiffness, mass_per_length,
            spring_position: 0.24 * length, oscillator_position: 0.72 * length, torsion_position: 0.9 * length,
            spring_stiffness, oscillator_stiffness, damping, mass, torsion_stiffness,
        };
        let lambda = C::new(re, im);
        let (system, expected) = (model.build().unwrap(), damped_oscillator(&model, lambda));
        assert_same_matrix(system.overall_matrix(lambda), &expected);
        let kappa = dynamic_stiffness(oscillator_stiffness, damping, lambda);
        assert_same_determinant(system.overall_determinant(lambda), &expected, kappa);
    }
}

mstmm::system! {
    /// Springs and masses: a translation, a bending and a rotation path, each with an inner point, meet at `conn 3`
    /// with a fourth that is fixed. Every stiffness and every inertia is a different multiple of `unit`.
    #[derive(Clone, Copy, Debug)]
    struct Tree { unit: f64 }

    conn 1 -> mass 13 { mass: 0.7 * unit } -> spring 14 { stiffness: 5.0 * unit } -> conn 3;
    fixed -> spring 11 { stiffness: 2.0 * unit } -> conn 1;
    free -> mass 12 { mass: 0.4 * unit } -> conn 1;

    fixed -> torsion_spring 21 { stiffness: 3.0 * unit } -> conn 2;
    fixed -> spring 22 { stiffness: 7.0 * unit } -> conn 2;
    free -> point_mass 23 { mass: 0.9 * unit, inertia: 0.3 * unit } -> conn 2
         -> hinge 24 { stiffness_y: 11.0 * unit, stiffness_rz: 13.0 * unit } -> conn 3;

    fixed -> torsion_spring 31 { stiffness: 17.0 * unit } -> inertia 32 { inertia: 0.5 * unit }
          -> torsion_spring 33 { stiffness: 19.0 * unit } -> conn 3;

    fixed -> hinge 41 { stiffness_y: 23.0 * unit, stiffness_rz: 29.0 * unit } -> conn 3;
    conn 3 -> point_mass 42 { mass: 1.1 * unit, inertia: 0.6 * unit } -> free;
}

/// Oracle: the eigenvalues of `M^(-1/2) K M^(-1/2)` with the coordinates Y₁, Y₂, Θ₂, Θ of the inertia, Y₃, Θ₃; `K` sums
/// over the springs their stiffness times the square of their stretch.
#[test]
fn a_tree_with_connections_upstream_of_connections() {
    let masses = Vector6::new(0.7 + 0.4, 0.9, 0.3, 0.5, 1.1, 0.6);
    let [y1, y2, theta2, theta, y3, theta3]: [Vector6<f64>; 6] =
        core::array::from_fn(|k| Vector6::from_fn(|row, _| if row == k { 1.0 } else { 0.0 }));
    let springs = [
        (2.0, y1),
        (5.0, y3 - y1),
        (3.0, theta2),
        (7.0, y2),
        (11.0, y3 - y2),
        (13.0, theta3 - theta2),
        (17.0, theta),
        (19.0, theta3 - theta),
        (23.0, y3),
        (29.0, theta3),
    ];
    let stiffness: Matrix6<f64> = springs.iter().map(|(k, stretch)| stretch * stretch.transpose() * *k).sum();
    let scale = Matrix6::from_diagonal(&masses.map(|mass: f64| 1.0 / mass.sqrt()));
    let mut expected: Vec<f64> =
        (scale * stiffness * scale).symmetric_eigenvalues().iter().map(|square| square.sqrt()).collect();
    expected.sort_by(f64::total_cmp);

    let system = Tree { unit: 1.5 }.build().unwrap();
    assert_eq!(TreeSystem::N, 11);
    let found = zeros_of(|omega| system.overall_determinant(omega), 0.0..=20.0, 400);
    assert_same_roots(&found, &expected, TOLERANCE);
}
