//! Shape functions, matrices and eigenvalue solvers against oracles that share no formula with them.

use nalgebra::{Complex, DMatrix, DVector};
use rivals::elements::assembly::{Matrices, assembled};
use rivals::elements::reference::reference;
use rivals::elements::skyline::Skyline;
use rivals::elements::{arnoldi, dense, lanczos};
use rivals::structure::{FIXED, Lumped, Matrix, Span, Structure, free, pinned};

/// Highest degree of the shape functions under test.
const DEGREE: usize = 12;

/// Points and weights of the quadrature of Gauss, from the eigenvalues of its Jacobi matrix (Golub and Welsch).
fn gauss(points: usize) -> Vec<(f64, f64)> {
    let mut jacobi = DMatrix::zeros(points, points);
    for k in 1..points {
        let x = k as f64;
        let entry = x / (4.0 * x * x - 1.0).sqrt();
        (jacobi[(k, k - 1)], jacobi[(k - 1, k)]) = (entry, entry);
    }
    let eigen = jacobi.symmetric_eigen();
    let weights = eigen.eigenvectors.row(0).map(|share| 2.0 * share * share);
    eigen.eigenvalues.iter().copied().zip(weights.iter().copied()).collect()
}

/// Second derivatives: of Hermite's cubics as in textbooks, of bubbles the orthonormal Legendre polynomials.
fn curvature(shape: usize, x: f64) -> f64 {
    match shape {
        0 => 1.5 * x,
        1 => 1.5 * x - 0.5,
        2 => -1.5 * x,
        3 => 1.5 * x + 0.5,
        _ => {
            let n = shape - 2;
            let (mut before, mut value) = (1.0, x);
            for k in 1..n {
                let k = k as f64;
                (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
            }
            value * (n as f64 + 0.5).sqrt()
        }
    }
}

/// Deflections, from start value and slope at ξ = -1 and the twofold integral `∫ (ξ - t) w''(t) dt`.
fn deflection(shape: usize, x: f64, rule: &[(f64, f64)]) -> f64 {
    let half = (x + 1.0) / 2.0;
    let integral: f64 = rule
        .iter()
        .map(|(point, weight)| {
            let t = -1.0 + half * (point + 1.0);
            weight * half * (x - t) * curvature(shape, t)
        })
        .sum();
    let start = if shape == 0 { 1.0 } else { 0.0 };
    let slope = if shape == 1 { 1.0 } else { 0.0 };
    start + slope * (x + 1.0) + integral
}

/// Oracle: quadrature of Gauss with 20 points, exact up to degree 39, over values from recurrences. 20 terms of size 1.
#[test]
fn reference_matrices_are_the_integrals() {
    let rule = gauss(20);
    let integral = |f: &dyn Fn(f64) -> f64| rule.iter().map(|(x, weight)| weight * f(*x)).sum::<f64>();
    let entries = reference(DEGREE);
    for a in 0..=DEGREE {
        for b in 0..=a {
            let entry = entries.iter().find(|entry| entry.pair == [a, b]);
            let (stiffness, mass) = entry.map_or((0.0, 0.0), |entry| (entry.stiffness, entry.mass));
            let expected = integral(&|x| curvature(a, x) * curvature(b, x));
            // values of orthonormal polynomials at the ends: sqrt(n + 1/2) each
            let scale = DEGREE as f64;
            assert!((stiffness - expected).abs() < 20.0 * f64::EPSILON * scale, "{a} {b}: {stiffness}, {expected}");
            let expected = integral(&|x| deflection(a, x, &rule) * deflection(b, x, &rule));
            assert!((mass - expected).abs() < 20.0 * f64::EPSILON * scale, "{a} {b}: {mass}, {expected}");
        }
    }
}

fn span(length: f64, nodes: [[Option<usize>; 2]; 2]) -> Span {
    Span { length, bending_stiffness: 3.0, mass_per_length: 5.0, nodes }
}

/// Oracle: the matrices of every textbook, `EI/l³ [12, 6l, -12, 6l; ..]` and `ml/420 [156, 22l, 54, -13l; ..]`.
#[test]
fn cubics_give_the_textbook_element() {
    let l: f64 = 0.7;
    let structure = Structure { spans: vec![span(l, [free(0), free(2)])], lumped: Vec::new() };
    let matrices = assembled(&structure, 3, &reference(3));
    let (a, b) = (6.0 * l, l * l);
    let stiffness = [12.0, a, -12.0, a, a, 4.0 * b, -a, 2.0 * b, -12.0, -a, 12.0, -a, a, 2.0 * b, -a, 4.0 * b];
    let (c, d) = (22.0 * l, 13.0 * l);
    let mass = [156.0, c, 54.0, -d, c, 4.0 * b, d, -3.0 * b, 54.0, d, 156.0, -c, -d, -3.0 * b, -c, 4.0 * b];
    let expected = [
        DMatrix::from_row_slice(4, 4, &stiffness) * (3.0 / l.powi(3)),
        DMatrix::from_row_slice(4, 4, &mass) * (5.0 * l / 420.0),
    ];
    for (matrix, expected) in [matrices.stiffness.dense(), matrices.mass.dense()].iter().zip(expected) {
        assert!((matrix - &expected).amax() <= 16.0 * f64::EPSILON * expected.amax(), "{matrix}{expected}");
    }
    assert!(matrices.damping.is_none());
}

/// Two beams, a body on the clamped one, an oscillator with spring and dashpot between them.
fn structure() -> Structure {
    let mut lumped = Lumped::body(0, 2.0, 0.5, 0.3).to_vec();
    lumped.push(Lumped::between(Matrix::Stiffness, [0, 3], 11.0));
    lumped.push(Lumped::between(Matrix::Damping, [0, 3], 7.0));
    lumped.push(Lumped::at(Matrix::Mass, 3, 4.0));
    Structure { spans: vec![span(1.0, [FIXED, free(0)]), span(2.0, [free(0), pinned(2)])], lumped }
}

/// Oracle: twice the energies at the motion y, θ of the middle and u of the oscillator, summed up by hand. Unknowns are
/// numbered along the path: y and θ, the oscillator that hangs on them, the rotation of the last end.
#[test]
fn lumped_elements_add_their_energies() {
    let with = assembled(&structure(), 3, &reference(3));
    let without = assembled(&Structure { lumped: Vec::new(), ..structure() }, 3, &reference(3));
    let (y, theta, u) = (0.7, -0.4, 0.2);
    let form = |matrix: &Skyline, motion: &[f64]| {
        let motion = DVector::from_row_slice(motion);
        (motion.transpose() * matrix.dense() * motion)[0]
    };
    let added = |with: &Skyline, without: &Skyline| form(with, &[y, theta, u, 0.0]) - form(without, &[y, theta, 0.0]);
    let (centre, apart) = (y + 0.3 * theta, y - u);
    let mass = 2.0 * centre * centre + 0.5 * theta * theta + 4.0 * u * u;
    let damping = form(with.damping.as_ref().unwrap(), &[y, theta, u, 0.0]);
    // the forms of the beams, up to 100, are subtracted
    let allowed = 16.0 * f64::EPSILON * 100.0;
    assert!((added(&with.mass, &without.mass) - mass).abs() < allowed);
    assert!((added(&with.stiffness, &without.stiffness) - 11.0 * apart * apart).abs() < allowed);
    assert!((damping - 7.0 * apart * apart).abs() < allowed);
}

/// A finite element model with 47 unknowns whose profile is not a band.
fn matrices() -> Matrices {
    assembled(&structure().refined(3), 9, &reference(9))
}

/// Oracle: products with the full matrix, which the shift makes indefinite.
#[test]
fn skyline_factors_solve() {
    let Matrices { stiffness, mass, .. } = matrices();
    let shifted = stiffness.plus(-100.0, &mass);
    let (full, size) = (shifted.dense(), shifted.size());
    let b = DVector::from_fn(size, |k, _| (k as f64).sin());
    let mut product = DVector::zeros(size);
    shifted.times(b.as_slice(), product.as_mut_slice());
    assert!((&product - &full * &b).amax() <= size as f64 * f64::EPSILON * full.amax());
    let factors = shifted.factorised();
    let mut solution = product.clone();
    factors.solve(solution.as_mut_slice());
    let residual = (&full * &solution - &product).amax();
    // without pivoting: growth of a factor of 100 at this shift
    assert!(residual <= 100.0 * size as f64 * f64::EPSILON * full.amax(), "{residual:e}");
}

/// Oracle: all eigenvalues of the full pencil, from another reduction. Relative rounding of ω² is that of the lowest.
#[test]
fn lanczos_finds_the_eigenvalues_nearest_to_a_shift() {
    let matrices = matrices();
    let all = dense::lowest(&matrices, 10);
    assert!(all.is_sorted());
    let allowed = |value: f64| 100.0 * f64::EPSILON * value * value / all[0];
    for (found, expected) in lanczos::nearest(&matrices, 0.0, 5, 20).iter().zip(&all) {
        assert!((found - expected).abs() <= allowed(*expected), "{found}, {expected}");
    }
    let shift = (all[3] + 2.0 * all[4]) / 3.0;
    let mut near = lanczos::nearest(&matrices, shift, 2, 20);
    near.sort_by(f64::total_cmp);
    for (found, expected) in near.iter().zip(&all[3..5]) {
        assert!((found - expected).abs() <= allowed(*expected), "{found}, {expected}");
    }
}

/// Oracle: the companion matrix `[0 I; -M⁻¹K -M⁻¹C]` in full. Its eigenvalues are exact to the size of its largest, which
/// is some 1e4 times that of those sought.
#[test]
fn arnoldi_finds_the_lowest_eigenvalues() {
    let matrices = assembled(&structure(), 6, &reference(6));
    let size = matrices.mass.size();
    let lu = matrices.mass.dense().lu();
    let damping = matrices.damping.as_ref().unwrap().dense();
    let (k, c) = (lu.solve(&matrices.stiffness.dense()).unwrap(), lu.solve(&damping).unwrap());
    let mut companion = DMatrix::zeros(2 * size, 2 * size);
    companion.view_mut((0, size), (size, size)).fill_with_identity();
    companion.view_mut((size, 0), (size, size)).copy_from(&-k);
    companion.view_mut((size, size), (size, size)).copy_from(&-c);
    let mut all: Vec<Complex<f64>> = companion.complex_eigenvalues().iter().copied().filter(|x| x.im > 0.0).collect();
    all.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    let largest = all.last().unwrap().norm();
    let found = arnoldi::lowest(&matrices, 3, 2 * size);
    assert_eq!(found.len(), 3);
    for root in found {
        let nearest = all[..3].iter().map(|other| (other - root).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 2.0 * size as f64 * f64::EPSILON * largest, "{root}: {nearest:e}");
    }
}
