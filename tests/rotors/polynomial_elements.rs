//! Rotors as finite elements of a high degree in 32 digits: deflection and rotation are polynomials, whose energies and gyroscopic forms are exact.
//!
//! Nothing of waves is in it, and nothing of clamped beams. With the stiffness positive the negative pivots of `K - ω²M + ωΩG` over all polynomials are
//! the roots below ω, at most as many as the rotor has, and as many where polynomials follow its motions.

use mstmm::number::{DoubleDouble, Scalar};

/// A part of a shaft between two stations.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member {
    pub(crate) ends: [usize; 2],
    pub(crate) length: f64,
    pub(crate) bending_stiffness: f64,
    pub(crate) mass: f64,
    /// Infinite without shear.
    pub(crate) shear_stiffness: f64,
    pub(crate) rotary_inertia: f64,
    pub(crate) polar_inertia: f64,
    pub(crate) speed: f64,
}

/// A disc at a station.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub(crate) station: usize,
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    pub(crate) polar_inertia: f64,
    pub(crate) speed: f64,
}

/// A rotor of stations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shafts {
    pub(crate) stations: usize,
    pub(crate) members: Vec<Member>,
    pub(crate) discs: Vec<Disc>,
    /// Springs of a deflection against the ground or that of another station.
    pub(crate) springs: Vec<(usize, Option<usize>, f64)>,
    /// Springs of a rotation against the ground.
    pub(crate) torsion_springs: Vec<(usize, f64)>,
    /// Deflections, 2s, and rotations, 2s + 1, that are held.
    pub(crate) held: Vec<usize>,
}

type Number = DoubleDouble;

/// What a coefficient is of the unknowns.
type Form = Vec<(usize, Number)>;

/// Degree of the elements beside half the largest wave number times the length: polynomials follow waves from there on, ever faster.
const BEYOND: f64 = 24.0;

fn number(value: f64) -> Number {
    Number::from_f64(value)
}

fn sum(one: &Form, factor: Number, other: &Form) -> Form {
    let mut sum = one.clone();
    for (unknown, part) in other {
        match sum.iter_mut().find(|(known, _)| known == unknown) {
            Some((_, own)) => *own += factor * *part,
            None => sum.push((*unknown, factor * *part)),
        }
    }
    sum
}

/// The integral of a series over Legendre's polynomials from the input end on: `∫ P_n ds = (P_(n+1) - P_(n-1))/(2n + 1)`.
fn integral(start: &Form, slope: &[Form], half: Number) -> Vec<Form> {
    let mut series = vec![Form::new(); slope.len() + 1];
    for (n, form) in slope.iter().enumerate() {
        let part = half / number((2 * n + 1) as f64);
        series[n + 1] = sum(&series[n + 1], part, form);
        // that of P_0 is P_1 + 1
        let (before, lower) = if n == 0 { (0, part) } else { (n - 1, -part) };
        series[before] = sum(&series[before], lower, form);
    }
    series[0] = sum(&series[0], number(1.0), start);
    series
}

/// A symmetric matrix, row by row.
struct Matrix(Vec<Vec<Number>>);

impl Matrix {
    fn new(size: usize) -> Self {
        Matrix(vec![vec![number(0.0); size]; size])
    }

    /// Adds `factor · Σ 2/(2n + 1) f_n f_nᵀ`, the integral of a square.
    fn add_square(&mut self, series: &[Form], factor: Number) {
        for (n, form) in series.iter().enumerate() {
            let weight = factor * number(2.0) / number((2 * n + 1) as f64);
            for (row, a) in form {
                for (column, b) in form {
                    self.0[*row][*column] += weight * *a * *b;
                }
            }
        }
    }

    /// Eliminates all unknowns from one on, the last first; the number of negative pivots.
    fn eliminate_down_to(&mut self, first: usize) -> u64 {
        let mut negative = 0;
        while self.0.len() > first {
            let row = self.0.pop().unwrap_or_default();
            let last = self.0.len();
            let pivot = row[last];
            negative += u64::from(pivot < number(0.0));
            for (other, factor) in self.0.iter_mut().zip(&row) {
                other.pop();
                if *factor != number(0.0) {
                    let share = *factor / pivot;
                    for (entry, part) in other.iter_mut().zip(&row) {
                        *entry -= share * *part;
                    }
                }
            }
        }
        negative
    }
}

/// A product of two numbers, exactly.
fn times(a: f64, b: f64) -> Number {
    DoubleDouble::from_product(a, b)
}

impl Member {
    /// About the largest wave number times the length.
    fn largest_wave(&self, omega: f64) -> f64 {
        let square = omega * omega;
        let h = self.mass * square;
        let g = self.rotary_inertia * square + (self.polar_inertia * self.speed * omega).abs();
        ((h / self.bending_stiffness).sqrt() + g / self.bending_stiffness + h / self.shear_stiffness).sqrt()
            * self.length
    }

    /// The dynamic stiffness over `y, θ` of both ends, and the negative pivots of all that is inside.
    fn condensed(&self, omega: f64, more: usize) -> (Matrix, u64) {
        let degree = (0.5 * self.largest_wave(omega) + BEYOND) as usize + more;
        let half = number(self.length) * number(0.5);
        let is_sheared = self.shear_stiffness < f64::INFINITY;
        let mut unknowns = 4;
        let mut free = || {
            unknowns += 1;
            vec![(unknowns - 1, number(1.0))]
        };
        let ends: [Form; 4] = [0, 1, 2, 3].map(|end| vec![(end, number(1.0))]);
        let mean = |from: &Form, to: &Form| {
            let inverse = number(0.5) / half;
            sum(&sum(&Form::new(), inverse, to), -inverse, from)
        };
        let (mut curvature, mut slope) = (vec![Form::new(); degree], vec![Form::new(); degree + 1]);
        curvature[0] = mean(&ends[1], &ends[3]);
        for n in 1..=degree {
            if is_sheared {
                slope[n] = free();
            }
            if n < degree && (is_sheared || n > 1) {
                curvature[n] = free();
            }
        }
        if is_sheared {
            slope[0] = mean(&ends[0], &ends[2]);
        } else {
            // the mean of Θ is (Θ + Θ_out)/2 - c₁ half/3
            let moved = sum(&sum(&ends[1], number(1.0), &ends[3]), number(-2.0), &mean(&ends[0], &ends[2]));
            curvature[1] = sum(&Form::new(), number(1.5) / half, &moved);
        }
        let theta = integral(&ends[1], &curvature, half);
        let slope = if is_sheared { slope } else { theta.clone() };
        let y = integral(&ends[0], &slope, half);
        let mut matrix = Matrix::new(unknowns);
        let square = times(omega, omega);
        let gyroscopic = times(self.polar_inertia, self.speed) * number(omega);
        matrix.add_square(&curvature, number(self.bending_stiffness) * half);
        matrix.add_square(&y, -(number(self.mass) * square * half));
        matrix.add_square(&theta, (gyroscopic - number(self.rotary_inertia) * square) * half);
        if is_sheared {
            let longer = theta.iter().chain(std::iter::repeat(&ends[0]));
            let shear: Vec<Form> = slope
                .iter()
                .zip(longer)
                .enumerate()
                .map(|(n, (slope, theta))| if n < degree + 1 { sum(slope, number(-1.0), theta) } else { slope.clone() })
                .collect();
            matrix.add_square(&shear, number(self.shear_stiffness) * half);
        }
        let negative = matrix.eliminate_down_to(4);
        (matrix, negative)
    }
}

impl Shafts {
    /// The number of roots of forward whirl below ω, or of backward whirl with all speeds negated.
    pub(crate) fn count_below(&self, omega: f64, more: usize) -> u64 {
        let mut matrix = Matrix::new(2 * self.stations);
        let (mut negative, square) = (0, times(omega, omega));
        for member in &self.members {
            let (part, inside) = member.condensed(omega, more);
            negative += inside;
            let place = |k: usize| 2 * member.ends[k / 2] + k % 2;
            for (row, entries) in part.0.iter().enumerate() {
                for (column, entry) in entries.iter().enumerate() {
                    matrix.0[place(row)][place(column)] += *entry;
                }
            }
        }
        for disc in &self.discs {
            let [y, theta] = [2 * disc.station, 2 * disc.station + 1];
            matrix.0[y][y] -= number(disc.mass) * square;
            matrix.0[theta][theta] +=
                times(disc.polar_inertia, disc.speed) * number(omega) - number(disc.inertia) * square;
        }
        for (station, other, stiffness) in &self.springs {
            let (a, k) = (2 * station, number(*stiffness));
            matrix.0[a][a] += k;
            if let Some(b) = other.map(|other| 2 * other) {
                matrix.0[b][b] += k;
                matrix.0[a][b] -= k;
                matrix.0[b][a] -= k;
            }
        }
        for (station, stiffness) in &self.torsion_springs {
            matrix.0[2 * station + 1][2 * station + 1] += number(*stiffness);
        }
        let free: Vec<usize> = (0..2 * self.stations).filter(|unknown| !self.held.contains(unknown)).collect();
        let rows = free.iter().map(|row| free.iter().map(|column| matrix.0[*row][*column]).collect()).collect();
        negative + Matrix(rows).eliminate_down_to(0)
    }

    /// The same rotor with all speeds negated.
    pub(crate) fn turned_round(&self) -> Self {
        let mut other = self.clone();
        other.members.iter_mut().for_each(|member| member.speed = -member.speed);
        other.discs.iter_mut().for_each(|disc| disc.speed = -disc.speed);
        other
    }
}
