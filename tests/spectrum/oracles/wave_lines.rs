//! Trees of strings, springs and masses, that share no formula with the library: their exact dynamic stiffness, and finite elements of a high
//! degree, both counted by Sylvester's law in double-double arithmetic.

use mstmm::number::{DoubleDouble, Parameter, Scalar};

/// A link between two points.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Link {
    Spring(f64),
    /// Length, stiffness H, mass per length, stiffness of the foundation.
    Line([f64; 4]),
}

/// Points with masses, numbered from 1, and links between them; point 0 is the ground.
#[derive(Clone, Debug, Default)]
pub(crate) struct Web {
    pub(crate) masses: Vec<f64>,
    pub(crate) links: Vec<([usize; 2], Link)>,
}

type Matrix = Vec<Vec<DoubleDouble>>;

fn number(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

/// Number of negative pivots.
fn negative_pivots(mut matrix: Matrix) -> u64 {
    let mut negative = 0;
    while let Some(last) = matrix.pop() {
        let n = matrix.len();
        negative += u64::from(last[n].is_negative());
        let inverse = number(1.0) / last[n];
        for row in 0..n {
            let factor = last[row] * inverse;
            if factor.vanishes() {
                continue;
            }
            for column in 0..=row {
                let product = factor * last[column];
                matrix[row][column] -= product;
            }
        }
    }
    negative
}

impl Web {
    /// Lower triangle of zeros with the masses on its diagonal, for so many functions beside the points.
    fn masses(&self, square: DoubleDouble, functions: usize) -> Matrix {
        let points = self.masses.len();
        let mut matrix: Matrix = (0..points + functions).map(|row| vec![number(0.0); row + 1]).collect();
        for (point, mass) in self.masses.iter().enumerate() {
            matrix[point][point] = -(square * number(*mass));
        }
        matrix
    }

    /// Adds a symmetric 2×2 matrix of a link.
    fn add(matrix: &mut Matrix, ends: [usize; 2], [own, mixed]: [DoubleDouble; 2]) {
        for end in ends.into_iter().filter(|end| *end > 0) {
            matrix[end - 1][end - 1] += own;
        }
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        if low > 0 {
            matrix[high - 1][low - 1] += mixed;
        }
    }

    /// Number of frequencies below ω by the dynamic stiffness of each link, and half waves between points at rest.
    pub(crate) fn count_below(&self, omega: DoubleDouble) -> u64 {
        let square = omega * omega;
        let (mut matrix, mut held) = (self.masses(square, 0), 0);
        for (ends, link) in &self.links {
            let stiffness = match *link {
                Link::Spring(k) => [number(k), -number(k)],
                Link::Line([length, h, m, k]) => {
                    let [length, h] = [length, h].map(number);
                    let wave = (square * number(m) - number(k)) / h;
                    let rate = wave.abs().sqrt();
                    let phase = rate * length;
                    let is_travelling = !wave.is_negative();
                    if is_travelling {
                        // π in two words; the whole number below, which rounding to a double may pass
                        let waves = phase / DoubleDouble::from_sum(core::f64::consts::PI, 1.224_646_799_147_353_2e-16);
                        let whole = waves.to_f64().floor();
                        held += if waves < number(whole) { whole - 1.0 } else { whole } as u64;
                    }
                    // far beyond the range of a hyperbolic sine nothing comes through
                    let (sin, cos) = match phase.to_f64() {
                        _ if is_travelling => phase.sin_cos(),
                        long if long > 500.0 => (number(1e200), number(1e200)),
                        _ => phase.sinh_cosh(),
                    };
                    [rate * h * cos / sin, -(rate * h / sin)]
                }
            };
            Self::add(&mut matrix, *ends, stiffness);
        }
        held + negative_pivots(matrix)
    }

    /// The largest phase or decay along a line, up to which polynomials have to follow.
    pub(crate) fn longest(&self, omega: f64) -> f64 {
        let phase = |(_, link): &([usize; 2], Link)| match *link {
            Link::Spring(_) => 0.0,
            Link::Line([length, h, m, k]) => length * ((omega * omega * m - k) / h).abs().sqrt(),
        };
        self.links.iter().map(phase).fold(0.0, f64::max)
    }

    /// Number of frequencies below ω of elements with polynomials up to a degree on each line: `N₀, N₁ = (1 ∓ x)/2` and
    /// `(P_j - P_{j-2})/√(4j - 2)`, whose derivatives are orthogonal.
    pub(crate) fn count_of_elements(&self, omega: f64, degree: usize) -> u64 {
        let square = number(omega) * number(omega);
        let lines = self.links.iter().filter(|(_, link)| matches!(link, Link::Line(_))).count();
        let points = self.masses.len();
        let mut matrix = self.masses(square, lines * (degree - 1));
        let mut first = points;
        for (ends, link) in &self.links {
            match *link {
                Link::Spring(k) => Self::add(&mut matrix, *ends, [number(k), -number(k)]),
                Link::Line(line) => {
                    let places: Vec<Option<usize>> = ends
                        .iter()
                        .map(|end| end.checked_sub(1))
                        .chain((0..degree - 1).map(|inner| Some(first + inner)))
                        .collect();
                    add_element(&mut matrix, &places, line, square);
                    first += degree - 1;
                }
            }
        }
        negative_pivots(matrix)
    }
}

/// Coefficients of a shape function over Legendre's polynomials.
fn shape(index: usize) -> Vec<(usize, DoubleDouble)> {
    let half = number(0.5);
    match index {
        0 => vec![(0, half), (1, -half)],
        1 => vec![(0, half), (1, half)],
        j => {
            let factor = number(1.0) / number((4 * j - 2) as f64).sqrt();
            vec![(j - 2, -factor), (j, factor)]
        }
    }
}

/// Adds `K - ω²M` of a line; shape functions without a place vanish.
fn add_element(matrix: &mut Matrix, places: &[Option<usize>], line: [f64; 4], square: DoubleDouble) {
    let [length, h, m, k] = line.map(number);
    let density = (k - square * m) * length * number(0.5);
    let strain = h * number(2.0) / length;
    for (one, row) in places.iter().enumerate() {
        for (other, column) in places.iter().enumerate() {
            let (Some(row), Some(column)) = (row, column) else { continue };
            if column > row || (row == column && one != other) {
                continue;
            }
            let mut entry = match (one, other) {
                (0 | 1, 0 | 1) => strain * number(if one == other { 0.5 } else { -0.5 }),
                _ if one == other => strain,
                _ => number(0.0),
            };
            for (p, a) in shape(one) {
                for (_, b) in shape(other).into_iter().filter(|(q, _)| *q == p) {
                    entry += density * a * b * number(2.0) / number((2 * p + 1) as f64);
                }
            }
            matrix[*row][*column] += entry;
        }
    }
}
