//! A structure as finite elements: cubic deflections, linear elongations, and constraints solved by singular vectors.
//!
//! Its frequencies are upper bounds of the exact ones, each of that with the same number.

use crate::structure::{Element, End, Structure};
use nalgebra::{Cholesky, DMatrix, Matrix4, SymmetricEigen};

/// Elements in a member.
pub(crate) const ELEMENTS: usize = 4;

/// Part of the largest singular value below which one is zero.
const RANK: f64 = 1e-10;

/// A row of factors of all displacements.
type Row = Vec<(usize, f64)>;

/// Displacements `[x, y, rz]` of nodes and of points of members, global ones, with indices from `3 · point` on.
pub(crate) struct FiniteElements {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    constraints: Vec<Row>,
}

impl FiniteElements {
    pub(crate) fn of(structure: &Structure) -> Self {
        let beams = structure.members.iter().filter(|member| matches!(member.element, Element::Beam(_)));
        let size = 3 * (structure.nodes.len() + (ELEMENTS + 1) * beams.count());
        let zero = DMatrix::zeros(size, size);
        let mut model = FiniteElements { stiffness: zero.clone(), mass: zero, constraints: Vec::new() };
        for index in 0..structure.nodes.len() {
            model.node(structure, index);
        }
        let mut first = structure.nodes.len();
        for member in &structure.members {
            match member.element {
                Element::Beam(section) => {
                    let [from, to] = member.ends.map(|end| structure.position(&end));
                    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
                    let length = dx.hypot(dy);
                    let axis = [dx / length, dy / length];
                    for (end, point) in member.ends.iter().zip([first, first + ELEMENTS]) {
                        model.tie(structure, end, point, axis);
                    }
                    let parameters = [
                        length / ELEMENTS as f64,
                        section.axial_stiffness,
                        section.bending_stiffness,
                        section.mass_per_length,
                    ];
                    (first..first + ELEMENTS).for_each(|point| model.element(point, axis, parameters));
                    first += ELEMENTS + 1;
                }
                Element::Spring { stiffness } => {
                    let [from, to] = member.ends.map(|end| structure.position(&end));
                    let [x, y] = member.along.unwrap_or([to[0] - from[0], to[1] - from[1]]);
                    let unit = [x / x.hypot(y), y / x.hypot(y)];
                    let [away, row] = member.ends.map(|end| along(structure, &end, unit));
                    let row: Row = row.into_iter().chain(away.into_iter().map(|(i, f)| (i, -f))).collect();
                    add(&mut model.stiffness, &row, stiffness);
                }
                Element::TorsionSpring { stiffness } => {
                    let [from, to] = member.ends.map(|end| 3 * end.node + 2);
                    add(&mut model.stiffness, &[(to, 1.0), (from, -1.0)], stiffness);
                }
                _ => unreachable!("a joint or a dashpot"),
            }
        }
        model
    }

    fn node(&mut self, structure: &Structure, index: usize) {
        let node = structure.nodes[index];
        for (held, freedom) in [(node.held.x, 0), (node.held.y, 1), (node.held.rz, 2)] {
            if held {
                self.constraints.push(vec![(3 * index + freedom, 1.0)]);
            }
        }
        if let Some([x, y]) = node.along {
            self.constraints.push(vec![(3 * index, -y), (3 * index + 1, x)]);
        }
        let centre = End::from(index).at(node.centre);
        for axis in [[1.0, 0.0], [0.0, 1.0]] {
            add(&mut self.mass, &along(structure, &centre, axis), node.mass);
        }
        self.mass[(3 * index + 2, 3 * index + 2)] += node.inertia;
    }

    /// Ties the end point of a member to its node, but for what is released.
    fn tie(&mut self, structure: &Structure, end: &End, point: usize, [c, s]: [f64; 2]) {
        for (released, axis) in [(end.released.x, [c, s]), (end.released.y, [-s, c])] {
            if !released {
                let own = [(3 * point, -axis[0]), (3 * point + 1, -axis[1])];
                self.constraints.push(along(structure, end, axis).into_iter().chain(own).collect());
            }
        }
        if !end.released.rz {
            self.constraints.push(vec![(3 * end.node + 2, 1.0), (3 * point + 2, -1.0)]);
        }
    }

    fn element(&mut self, point: usize, [c, s]: [f64; 2], [l, ea, ei, m]: [f64; 4]) {
        let local = |point: usize| -> [Row; 3] {
            let [x, y, rz] = [3 * point, 3 * point + 1, 3 * point + 2];
            [vec![(x, c), (y, s)], vec![(x, -s), (y, c)], vec![(rz, l)]]
        };
        let ([u, v, turn], [u_out, v_out, turn_out]) = (local(point), local(point + 1));
        let difference: Row = u_out.iter().copied().chain(u.iter().map(|&(i, f)| (i, -f))).collect();
        add(&mut self.stiffness, &difference, ea / l);
        let sum: Row = u_out.iter().chain(&u).copied().collect();
        // m l/6 [[2, 1], [1, 2]]
        add(&mut self.mass, &sum, m * l / 6.0);
        add(&mut self.mass, &u, m * l / 6.0);
        add(&mut self.mass, &u_out, m * l / 6.0);
        #[rustfmt::skip]
        let bending = Matrix4::new(
            12.0, 6.0, -12.0, 6.0,
            6.0, 4.0, -6.0, 2.0,
            -12.0, -6.0, 12.0, -6.0,
            6.0, 2.0, -6.0, 4.0,
        ) * (ei / (l * l * l));
        #[rustfmt::skip]
        let inertia = Matrix4::new(
            156.0, 22.0, 54.0, -13.0,
            22.0, 4.0, 13.0, -3.0,
            54.0, 13.0, 156.0, -22.0,
            -13.0, -3.0, -22.0, 4.0,
        ) * (m * l / 420.0);
        let rows = [v, turn, v_out, turn_out];
        for (i, a) in rows.iter().enumerate() {
            for (j, b) in rows.iter().enumerate() {
                add_product(&mut self.stiffness, a, b, bending[(i, j)]);
                add_product(&mut self.mass, a, b, inertia[(i, j)]);
            }
        }
    }

    /// All frequencies in ascending order; `None` where a motion has neither stiffness nor mass.
    pub(crate) fn frequencies(&self) -> Option<Vec<f64>> {
        let size = self.mass.nrows();
        let mut rows = DMatrix::<f64>::zeros(size, size);
        for (index, row) in self.constraints.iter().enumerate() {
            row.iter().for_each(|&(column, factor)| rows[(index, column)] += factor);
        }
        let constrained = SymmetricEigen::new(rows.transpose() * rows);
        let largest = constrained.eigenvalues.max();
        let free: Vec<usize> = (0..size).filter(|&i| constrained.eigenvalues[i] < RANK * largest).collect();
        let basis = constrained.eigenvectors.select_columns(&free);
        let [stiffness, mass] = [&self.stiffness, &self.mass].map(|matrix| basis.transpose() * matrix * &basis);
        // `1/(ω² + shift)` are eigenvalues of a definite problem
        let shift = 1e-2;
        let lower = Cholesky::new(stiffness + &mass * shift)?.l();
        let half = lower.solve_lower_triangular(&mass)?;
        let inverse = SymmetricEigen::new(lower.solve_lower_triangular(&half.transpose())?);
        let mut squares: Vec<f64> =
            inverse.eigenvalues.iter().filter(|mu| **mu > 1e-13).map(|mu| (1.0 / mu - shift).max(0.0)).collect();
        squares.sort_by(f64::total_cmp);
        Some(squares.into_iter().map(f64::sqrt).collect())
    }
}

/// The displacement along a direction of the point where an end is.
fn along(structure: &Structure, end: &End, [x, y]: [f64; 2]) -> Row {
    let (place, node) = (structure.position(end), structure.nodes[end.node].position);
    let lever = (place[0] - node[0]) * y - (place[1] - node[1]) * x;
    vec![(3 * end.node, x), (3 * end.node + 1, y), (3 * end.node + 2, lever)]
}

fn add(matrix: &mut DMatrix<f64>, row: &[(usize, f64)], factor: f64) {
    add_product(matrix, row, row, factor);
}

fn add_product(matrix: &mut DMatrix<f64>, a: &[(usize, f64)], b: &[(usize, f64)], factor: f64) {
    for &(i, a) in a {
        for &(j, b) in b {
            matrix[(i, j)] += factor * a * b;
        }
    }
}
