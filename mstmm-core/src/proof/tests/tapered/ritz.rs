//! Ritz's method in 500 bits: polynomials of high degree in elements of their own, with bubbles that are eliminated.

use crate::elements::TaperedBeam;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::vec::Vec;

pub(super) type Exact = FBig<HalfEven, 2>;

/// A number in 500 bits.
pub(super) fn big(number: f64) -> Exact {
    Exact::try_from(number).unwrap().with_precision(500).value()
}

/// A polynomial times another.
fn times(first: &[Exact], second: &[Exact]) -> Vec<Exact> {
    let mut product = std::vec![big(0.0); first.len() + second.len() - 1];
    for (i, a) in first.iter().enumerate() {
        for (j, b) in second.iter().enumerate() {
            product[i + j] = &product[i + j] + a * b;
        }
    }
    product
}

/// The value of a polynomial.
fn value(polynomial: &[Exact], at: &Exact) -> Exact {
    polynomial.iter().rev().fold(big(0.0), |sum, term| sum * at + term)
}

/// A polynomial of x in `s`, where `x = start + s width`.
fn shifted(polynomial: &[Exact], start: &Exact, width: &Exact) -> Vec<Exact> {
    let line = [start.clone(), width.clone()];
    let one: Vec<Exact> = std::vec![big(1.0)];
    let mut power = one;
    let mut sum = std::vec![big(0.0); polynomial.len()];
    for term in polynomial {
        for (entry, of_power) in sum.iter_mut().zip(&power) {
            *entry = &*entry + term * of_power;
        }
        power = times(&power, &line);
    }
    sum
}

/// `EI`, `N - r ω²` and `m (ω² + Ω² sin² ψ) - k` as polynomials of x, from the definitions of the parameters.
pub(super) fn energy(beam: TaperedBeam<f64>, square: &Exact) -> [Vec<Exact>; 3] {
    let length = big(beam.length);
    let even = |taper: f64| [big(1.0), -big(taper) / &length];
    let (b, h) = (even(beam.width_taper), even(beam.height_taper));
    let area = times(&b, &h);
    let shape = times(&area, &times(&h, &h));
    let scaled = |polynomial: &[Exact], factor: &Exact| polynomial.iter().map(|term| term * factor).collect::<Vec<_>>();
    let speed_squared = big(beam.rotation_speed) * big(beam.rotation_speed);
    let mut term = big(beam.setting_angle);
    let mut sin = big(0.0);
    for k in 1..200 {
        sin = &sin + &term;
        term = -(term * big(beam.setting_angle) * big(beam.setting_angle)) / big(f64::from(2 * k * (2 * k + 1)));
    }
    // N' = -p - Ω² m (R + x)
    let pull = times(&scaled(&area, &(big(beam.mass_per_length) * &speed_squared)), &[big(beam.hub_radius), big(1.0)]);
    let mut force = std::vec![big(0.0)];
    force.extend(pull.iter().enumerate().map(|(k, term)| -(term / big(k as f64 + 1.0))));
    force[1] = &force[1] - big(beam.axial_load);
    force[0] = big(beam.axial_force) - value(&force, &length);
    let rotary = scaled(&shape, &(-big(beam.rotary_inertia) * square));
    force = force.iter().zip(&rotary).map(|(force, rotary)| force + rotary).collect();
    let of_mass = (square + speed_squared * &sin * &sin) * big(beam.mass_per_length);
    let mut load = scaled(&area, &of_mass);
    load[0] = &load[0] - big(beam.foundation_stiffness);
    [scaled(&shape, &big(beam.bending_stiffness)), force, load]
}

/// Eliminates the last variables of a symmetric matrix; returns the number of negative pivots.
pub(super) fn eliminated(matrix: &mut Vec<Vec<Exact>>, left: usize) -> usize {
    let mut negative = 0;
    while matrix.len() > left {
        let own = matrix.pop().unwrap();
        let pivot = own[matrix.len()].clone();
        negative += usize::from(pivot < big(0.0));
        for row in 0..matrix.len() {
            let factor = &own[row] / &pivot;
            for column in 0..=row {
                matrix[row][column] = &matrix[row][column] - &factor * &own[column];
            }
        }
    }
    negative
}

/// The lower triangle and the clamped count of a beam in elements of a degree, none longer than its share.
pub(super) fn ritz(beam: TaperedBeam<f64>, square: &Exact, degree: usize, share: f64) -> (Vec<Exact>, usize) {
    let profile = energy(beam, square);
    let (mut start, mut negative) = (0.0, 0);
    let mut whole: Option<Vec<Vec<Exact>>> = None;
    while start < 1.0 {
        // width and height at the start are halved or doubled at most
        let reach = |taper: f64| if taper == 0.0 { 1.0 } else { 0.5 * (1.0 - taper * start) / taper.abs() };
        let mut width = share.min(reach(beam.width_taper)).min(reach(beam.height_taper));
        // a number of few digits: sums are exact
        width = f64::from_bits(width.to_bits() & !((1 << 50) - 1));
        if start + width > 1.0 - 0.1 * width {
            width = 1.0 - start;
        }
        let (mut matrix, inside) = element(&profile, beam.length, start, width, degree);
        negative += inside;
        if let Some(before) = whole {
            // y1 θ1 y3 θ3 y2 θ2
            let zero = || big(0.0);
            let mut all: Vec<Vec<Exact>> = (0..6).map(|_| (0..6).map(|_| zero()).collect()).collect();
            for (parts, places) in [(&before, [0, 1, 4, 5]), (&matrix, [4, 5, 2, 3])] {
                for row in 0..4 {
                    for column in 0..4 {
                        let entry = &parts[row.max(column)][row.min(column)];
                        let place = &mut all[places[row]][places[column]];
                        *place = &*place + entry;
                    }
                }
            }
            negative += eliminated(&mut all, 4);
            matrix = all;
        }
        whole = Some(matrix);
        start += width;
    }
    let whole = whole.unwrap();
    ((0..4).flat_map(|row| whole[row][..=row].to_vec()).collect(), negative)
}

/// An element over `y1, θ1, y2, θ2`, its bubbles `s^k (s - s²)²` eliminated, and their negative pivots.
pub(super) fn element(
    profile: &[Vec<Exact>; 3],
    length: f64,
    start: f64,
    width: f64,
    degree: usize,
) -> (Vec<Vec<Exact>>, usize) {
    let delta = big(length) * big(width);
    let from = big(length) * big(start);
    let [bending, force, load] = profile.each_ref().map(|polynomial| {
        let local = shifted(polynomial, &from, &delta);
        let moment =
            |t: usize| local.iter().enumerate().fold(big(0.0), |sum, (k, term)| sum + term / big((t + k + 1) as f64));
        (0..2 * degree + 1).map(moment).collect::<Vec<_>>()
    });
    let cube = &delta * &delta * &delta;
    let of_powers = |i: usize, j: usize| {
        let number = |n: usize| big(n as f64);
        let mut sum = -(&load[i + j] * &delta);
        if i > 0 && j > 0 {
            sum += number(i * j) * &force[i + j - 2] / &delta;
        }
        if i > 1 && j > 1 {
            sum += number(i * (i - 1) * j * (j - 1)) * &bending[i + j - 4] / &cube;
        }
        sum
    };
    let powers: Vec<Vec<Exact>> = (0..=degree).map(|i| (0..=degree).map(|j| of_powers(i, j)).collect()).collect();
    let number = |factor: f64| big(factor);
    let mut shapes = std::vec![
        std::vec![(0, number(1.0)), (2, number(-3.0)), (3, number(2.0))],
        std::vec![(1, delta.clone()), (2, number(-2.0) * &delta), (3, delta.clone())],
        std::vec![(2, number(3.0)), (3, number(-2.0))],
        std::vec![(2, -delta.clone()), (3, delta.clone())],
    ];
    shapes.extend((2..degree - 1).map(|k| std::vec![(k, number(1.0)), (k + 1, number(-2.0)), (k + 2, number(1.0))]));
    let mut matrix: Vec<Vec<Exact>> = Vec::new();
    for (row, first) in shapes.iter().enumerate() {
        let entry = |second: &Vec<(usize, Exact)>| {
            first
                .iter()
                .fold(big(0.0), |sum, (i, a)| second.iter().fold(sum, |sum, (j, b)| sum + a * b * &powers[*i][*j]))
        };
        matrix.push(shapes[..=row].iter().map(entry).collect());
    }
    let negative = eliminated(&mut matrix, 4);
    (matrix, negative)
}
