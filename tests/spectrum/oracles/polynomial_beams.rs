//! General beams as finite elements of a high degree: deflection and rotation are polynomials, whose energies are exact.
//!
//! Nothing of waves is in it, and nothing of clamped beams: the negative pivots of all polynomials are counted. By the law of inertia a system
//! has at least as many roots as elements have, whatever their degree, and no more where polynomials follow its motions.

use super::chain_matrix::{ChainMatrix, Form, negative_pivots, number, sum};
use super::many_digits::Exact;
use crate::general_chains::chain::{Chain, Link};
use mstmm::elements::GeneralBeam;

/// A displacement or a slope over Legendre's polynomials of `s` in [-1, 1] along a beam.
type Series = Vec<Form>;

/// Degree of the elements beside half the largest wave number times the length: polynomials follow waves from there on, ever faster.
const BEYOND: f64 = 24.0;

/// The displacement with a slope, from that at the input end: `∫ P_n ds = (P_(n+1) - P_(n-1))/(2n + 1)`.
fn integral(start: &Form, slope: &[Form], half: &Exact) -> Series {
    let mut series = vec![Form::new(); slope.len() + 1];
    for (n, form) in slope.iter().enumerate() {
        let part = half / number((2 * n + 1) as f64);
        series[n + 1] = sum(&series[n + 1], &part, form);
        // that of `P_0` is `P_1 + 1`
        let (before, lower) = if n == 0 { (0, part) } else { (n - 1, -part) };
        series[before] = sum(&series[before], &lower, form);
    }
    series[0] = sum(&series[0], &number(1.0), start);
    series
}

/// The mean slope from one end to the other.
fn mean_slope([from, to]: [&Form; 2], half: &Exact) -> Form {
    let inverse = number(0.5) / half;
    sum(&sum(&Form::new(), &inverse, to), &-inverse.clone(), from)
}

/// Deflection, its slope, rotation and its slope over the polynomials.
struct Motion {
    y: Series,
    slope: Series,
    theta: Series,
    curvature: Series,
}

impl Motion {
    /// All motions of so high a degree between the displacements of both ends. With shear the slopes of deflection and rotation are free but
    /// for their means; without shear the curvature is, but for its mean and its moment.
    fn between(
        [[y, theta], [y_out, theta_out]]: [[Form; 2]; 2],
        is_sheared: bool,
        degree: usize,
        half: &Exact,
        matrix: &mut ChainMatrix,
    ) -> Self {
        let mut curvature = vec![Form::new(); degree];
        let mut slope = vec![Form::new(); degree + 1];
        // the highest first, so that each has few neighbours when it is eliminated
        for n in (1..=degree).rev() {
            if is_sheared {
                slope[n] = matrix.freedom();
            }
            if n < degree && (is_sheared || n > 1) {
                curvature[n] = matrix.freedom();
            }
        }
        let mean = mean_slope([&y, &y_out], half);
        curvature[0] = mean_slope([&theta, &theta_out], half);
        if is_sheared {
            slope[0] = mean;
        } else {
            // the mean of Θ is `(Θ + Θ_out)/2 - c₁ half/3`
            let ends = sum(&sum(&theta, &number(1.0), &theta_out), &number(-2.0), &mean);
            curvature[1] = sum(&Form::new(), &(number(1.5) / half), &ends);
        }
        let rotation = integral(&theta, &curvature, half);
        let slope = if is_sheared { slope } else { rotation.clone() };
        Motion { y: integral(&y, &slope, half), slope, theta: rotation, curvature }
    }
}

/// Adds `factor · ∫ f² ds`: the integral of the square of `P_n` is `2/(2n + 1)`.
fn add_square(matrix: &mut ChainMatrix, series: &[Form], factor: &Exact) {
    for (n, form) in series.iter().enumerate() {
        matrix.add(form, form, &(factor * number(2.0) / number((2 * n + 1) as f64)));
    }
}

/// The motions of a beam with their energies less `ω²` times their inertias.
fn element(
    beam: &GeneralBeam<f64>,
    degree: usize,
    square: &Exact,
    matrix: &mut ChainMatrix,
    from: [Form; 2],
    to: Option<[Form; 2]>,
) -> [Form; 2] {
    let to = to.unwrap_or_else(|| [matrix.freedom(), matrix.freedom()]);
    let [length, ei, m, r] =
        [beam.length, beam.bending_stiffness, beam.mass_per_length, beam.rotary_inertia].map(number);
    let half = length * number(0.5);
    let is_sheared = beam.shear_stiffness < f64::INFINITY;
    let Motion { y, slope, theta, curvature } = Motion::between([from, to.clone()], is_sheared, degree, &half, matrix);
    let mut add = |series: &[Form], density: Exact| add_square(matrix, series, &(density * &half));
    add(&curvature, ei);
    add(&slope, number(beam.axial_force) + number(beam.foundation_shear_stiffness));
    add(&y, number(beam.foundation_stiffness) - m * square);
    add(&theta, -(r * square));
    if is_sheared {
        let shear: Series = slope.iter().zip(&theta).map(|(slope, theta)| sum(slope, &number(-1.0), theta)).collect();
        add(&shear, number(beam.shear_stiffness));
    }
    to
}

/// About the largest wave number of a beam times its length, of waves that travel or decay.
fn largest_wave(beam: &GeneralBeam<f64>, square: f64) -> f64 {
    let (ei, f) = (beam.bending_stiffness, 1.0 / beam.shear_stiffness);
    let tension = beam.axial_force + beam.foundation_shear_stiffness;
    let sigma = 1.0 / (1.0 + tension * f);
    let h = (beam.mass_per_length * square).abs() + beam.foundation_stiffness;
    let g = sigma * tension.abs() + beam.rotary_inertia * square.abs();
    (sigma * (h / ei).sqrt() + g / ei + f * sigma * h).sqrt() * beam.length
}

/// The largest wave number of any beam of a chain times its length.
pub(crate) fn longest(chain: &Chain, square: f64) -> f64 {
    let wave = |link: &Link| match link {
        Link::Beam(beam) | Link::Side(_, beam) => largest_wave(beam, square),
        _ => 0.0,
    };
    chain.links.iter().map(wave).fold(0.0, f64::max)
}

/// The number of roots of a chain whose square is below one of either sign, by elements of degrees that follow its waves, and more.
pub(crate) fn roots_of_elements(chain: &Chain, square: &Exact, more: usize) -> Option<u64> {
    let plain = square.to_f64().value();
    negative_pivots(chain, square, |matrix, beam, from, to| {
        let degree = (0.5 * largest_wave(beam, plain) + BEYOND) as usize + more;
        Some(element(beam, degree, square, matrix, from, to))
    })
}
