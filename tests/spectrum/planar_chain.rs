//! Planar scenes: rigid bodies against their mass and stiffness matrices, planar beams against closed forms.

use crate::support::roots::{assert_same_roots, bisect, zeros};
use core::f64::consts::{FRAC_PI_2, PI};
use mstmm::prelude::*;
use nalgebra::{Cholesky, SMatrix, SVector};

/// The accuracy demanded of every frequency, relative.
const TOLERANCE: f64 = 1e-10;

system! {
    /// Three bodies on three hinges, the last one free; `_a`, `_b`, `_c` from the fixed end on.
    #[derive(Clone, Copy, Debug)]
    struct Chain {
        kx_a: f64, ky_a: f64, kt_a: f64, kx_b: f64, ky_b: f64, kt_b: f64, kx_c: f64, ky_c: f64, kt_c: f64,
        m_a: f64, j_a: f64, bx_a: f64, by_a: f64, cx_a: f64, cy_a: f64,
        m_b: f64, j_b: f64, bx_b: f64, by_b: f64, cx_b: f64, cy_b: f64,
        m_c: f64, j_c: f64, bx_c: f64, by_c: f64, cx_c: f64, cy_c: f64,
    }

    fixed -> hinge 1 { stiffness_x: kx_a, stiffness_y: ky_a, stiffness_rz: kt_a }
          -> body 2 { mass: m_a, inertia_about_input: j_a, output_x: bx_a, output_y: by_a, centre_x: cx_a, centre_y: cy_a }
          -> hinge 3 { stiffness_x: kx_b, stiffness_y: ky_b, stiffness_rz: kt_b }
          -> body 4 { mass: m_b, inertia_about_input: j_b, output_x: bx_b, output_y: by_b, centre_x: cx_b, centre_y: cy_b }
          -> hinge 5 { stiffness_x: kx_c, stiffness_y: ky_c, stiffness_rz: kt_c }
          -> body 6 { mass: m_c, inertia_about_input: j_c, output_x: bx_c, output_y: by_c, centre_x: cx_c, centre_y: cy_c }
          -> free;
}

/// A body as mechanics needs it: `centre` and `output` from the input point, inertia about the input point.
#[derive(Clone, Copy)]
struct RigidBody {
    mass: f64,
    inertia: f64,
    output: [f64; 2],
    centre: [f64; 2],
}

/// A hinge in front of a body: stiffnesses along x, along y and about z.
type Stiffnesses = [f64; 3];

/// Coordinates: X, Y of the input point and the rotation, of each of three bodies.
const FREEDOMS: usize = 9;
type Matrix = SMatrix<f64, FREEDOMS, FREEDOMS>;
type Row = SVector<f64, FREEDOMS>;

/// Displacement along x and along y of the point of `body` at `arm` from its input point, linearised:
/// `X - arm_y Θ` and `Y + arm_x Θ`.
fn displacement(body: usize, arm: [f64; 2]) -> [Row; 2] {
    let (mut x, mut y) = (Row::zeros(), Row::zeros());
    x[3 * body] = 1.0;
    x[3 * body + 2] = -arm[1];
    y[3 * body + 1] = 1.0;
    y[3 * body + 2] = arm[0];
    [x, y]
}

fn rotation(body: usize) -> Row {
    let mut row = Row::zeros();
    row[3 * body + 2] = 1.0;
    row
}

/// Natural frequencies by Lagrange's equations, `T = ½ q̇ᵀ M q̇` and `V = ½ qᵀ K q`, as the eigenvalues of L⁻¹ K L⁻ᵀ with
/// M = L Lᵀ; `None` if M is not positive definite.
fn lagrange(bodies: [RigidBody; 3], hinges: [Stiffnesses; 3]) -> Option<Vec<f64>> {
    let (mut mass, mut stiffness) = (Matrix::zeros(), Matrix::zeros());
    for (k, (body, hinge)) in bodies.iter().zip(hinges).enumerate() {
        let [cx, cy] = body.centre;
        let about_centre = body.inertia - body.mass * (cx * cx + cy * cy);
        for velocity in displacement(k, body.centre) {
            mass += velocity * velocity.transpose() * body.mass;
        }
        mass += rotation(k) * rotation(k).transpose() * about_centre;
        let ([x, y], theta) = (displacement(k, [0.0, 0.0]), rotation(k));
        let stretches = match k.checked_sub(1) {
            None => [x, y, theta],
            Some(before) => {
                let [output_x, output_y] = displacement(before, bodies[before].output);
                [x - output_x, y - output_y, theta - rotation(before)]
            }
        };
        for (stretch, k) in stretches.iter().zip(hinge) {
            stiffness += stretch * stretch.transpose() * k;
        }
    }
    let l = Cholesky::new(mass)?.l();
    let half = l.solve_lower_triangular(&stiffness)?;
    let symmetric = l.solve_lower_triangular(&half.transpose())?;
    let mut frequencies: Vec<f64> = symmetric.symmetric_eigenvalues().iter().map(|square| square.sqrt()).collect();
    frequencies.sort_by(f64::total_cmp);
    Some(frequencies)
}

/// Mass centres and output points off every axis.
const BODIES: [RigidBody; 3] = [
    RigidBody { mass: 2.0, inertia: 1.1, output: [0.8, 0.3], centre: [0.5, -0.2] },
    RigidBody { mass: 1.3, inertia: 0.6, output: [0.6, -0.5], centre: [-0.2, 0.4] },
    RigidBody { mass: 0.7, inertia: 0.3, output: [-0.4, 0.9], centre: [0.3, 0.35] },
];
const HINGES: [Stiffnesses; 3] = [[90.0, 40.0, 15.0], [60.0, 120.0, 9.0], [35.0, 70.0, 4.0]];

fn chain() -> Chain {
    let [a, b, c] = BODIES;
    let [[kx_a, ky_a, kt_a], [kx_b, ky_b, kt_b], [kx_c, ky_c, kt_c]] = HINGES;
    let ([bx_a, by_a], [bx_b, by_b], [bx_c, by_c]) = (a.output, b.output, c.output);
    let ([cx_a, cy_a], [cx_b, cy_b], [cx_c, cy_c]) = (a.centre, b.centre, c.centre);
    let (m_a, m_b, m_c, j_a, j_b, j_c) = (a.mass, b.mass, c.mass, a.inertia, b.inertia, c.inertia);
    Chain {
        kx_a,
        ky_a,
        kt_a,
        kx_b,
        ky_b,
        kt_b,
        kx_c,
        ky_c,
        kt_c,
        m_a,
        j_a,
        bx_a,
        by_a,
        cx_a,
        cy_a,
        m_b,
        j_b,
        bx_b,
        by_b,
        cx_b,
        cy_b,
        m_c,
        j_c,
        bx_c,
        by_c,
        cx_c,
        cy_c,
    }
}

/// Oracle: the generalised eigenvalue problem of the mass and stiffness matrices from rigid-body kinematics.
#[test]
fn three_bodies_on_hinges_have_the_frequencies_of_lagranges_equations() {
    let expected = lagrange(BODIES, HINGES).unwrap();
    assert_eq!((ChainSystem::N, expected.len()), (6, FREEDOMS));
    let system = chain().build().unwrap();
    let found = zeros(|omega| system.overall_determinant(omega), 0.0..=60.0, 600);
    assert_same_roots(&found, &expected, TOLERANCE);
}

/// One planar beam between two supports, cut in two so that no entry of its transfer matrix meets a zero only.
macro_rules! planar_beam_between {
    ($model:ident: $tip:ident -> $root:ident) => {
        system! {
            #[derive(Clone, Copy, Debug)]
            struct $model { length: f64, ea: f64, ei: f64, m: f64 }

            $tip -> beam 1 {
                length: 0.3 * length, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m,
            } -> beam 2 {
                length: 0.7 * length, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m,
            } -> $root
        }
    };
}
planar_beam_between!(Cantilever: fixed -> free);
planar_beam_between!(PinnedRoller: pinned -> roller);
planar_beam_between!(RollerGuided: roller -> guided);
planar_beam_between!(GuidedPinned: guided -> pinned);

/// Length, EA, EI and mass per length; chosen so that bending and longitudinal frequencies alternate.
const SECTION: [f64; 4] = [1.3, 900.0, 2.7, 0.4];

/// Natural frequencies below `limit` of bending `β l = z_k` and of longitudinal vibration `ζ = ζ_k`, k = 1, 2, ….
fn closed_form(bending: impl Fn(f64) -> f64, longitudinal: impl Fn(f64) -> f64, limit: f64) -> Vec<f64> {
    let [l, ea, ei, m] = SECTION;
    let orders = || (1..=20).map(f64::from);
    let bending = orders().map(|k| (bending(k) / l).powi(2) * (ei / m).sqrt());
    let longitudinal = orders().map(|k| longitudinal(k) / l * (ea / m).sqrt());
    let mut all: Vec<f64> = bending.chain(longitudinal).filter(|omega| *omega < limit).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// Upper end of the searches: four bending modes, below those at which det U_all loses its digits.
const LIMIT: f64 = 300.0;

/// Checks a beam against closed forms, given as the k-th root of each kind of vibration.
macro_rules! assert_frequencies {
    ($model:ident, bending: $bending:expr, longitudinal: $longitudinal:expr) => {{
        let [length, ea, ei, m] = SECTION;
        let system = $model { length, ea, ei, m }.build().unwrap();
        // det U_all of a scene without rigid-body motion is even in ω and has no zero at rest
        let found = zeros(|omega| system.overall_determinant(omega), 0.0..=LIMIT, 2000);
        assert_same_roots(&found, &closed_form($bending, $longitudinal, LIMIT), TOLERANCE);
    }};
}

/// `k π`: a wave with equal ends.
fn whole(k: f64) -> f64 {
    k * PI
}

/// `(2k-1) π/2`: a wave with a node at one end and none at the other.
fn odd(k: f64) -> f64 {
    (2.0 * k - 1.0) * FRAC_PI_2
}

/// The k-th root of `cos z cosh z = -1`: one in each interval of length π.
fn cantilever(k: f64) -> f64 {
    bisect(|z| z.cos() + 1.0 / z.cosh(), (k - 1.0) * PI, k * PI)
}

/// Closed form: bending `cos z cosh z = -1`, longitudinal `cos ζ = 0`.
#[test]
fn a_planar_cantilever_bends_and_stretches() {
    assert_frequencies!(Cantilever, bending: cantilever, longitudinal: odd);
}

/// Closed form: bending `sin z = 0`, longitudinal held at one end, `cos ζ = 0`.
#[test]
fn a_pinned_beam_on_a_roller_slides_along_it() {
    assert_frequencies!(PinnedRoller, bending: whole, longitudinal: odd);
}

/// Closed form: bending `cos z = 0` (half of a beam on rollers), longitudinal held at one end, `cos ζ = 0`.
#[test]
fn a_guided_end_is_the_middle_of_a_beam_twice_as_long() {
    assert_frequencies!(RollerGuided, bending: odd, longitudinal: odd);
}

/// Closed form: bending `cos z = 0`, longitudinal held at both ends, `sin ζ = 0`.
#[test]
fn guided_and_pinned_ends_both_hold_the_beam_lengthwise() {
    assert_frequencies!(GuidedPinned, bending: odd, longitudinal: whole);
}
