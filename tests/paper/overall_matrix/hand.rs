//! The overall matrix by hand: the transfer matrices as the paper prints them, whole block rows, then the columns of
//! the boundary zeros struck out. Slow and obvious; shares nothing with the library.

use mstmm::Complex;
use nalgebra::DMatrix;

pub(crate) type C = Complex<f64>;
pub(crate) type Matrix = DMatrix<C>;

/// A matrix from real rows.
fn real<const ROWS: usize, const COLUMNS: usize>(rows: [[f64; COLUMNS]; ROWS]) -> Matrix {
    Matrix::from_fn(ROWS, COLUMNS, |i, j| C::from(rows[i][j]))
}

/// A square matrix from complex rows.
fn complex<const N: usize>(rows: [[C; N]; N]) -> Matrix {
    Matrix::from_fn(N, N, |i, j| rows[i][j])
}

/// Eq. (3).
pub(crate) fn spring(k: f64) -> Matrix {
    real([[1.0, -1.0 / k], [0.0, 1.0]])
}

/// Eq. (4).
pub(crate) fn torsion_spring(k: f64) -> Matrix {
    real([[1.0, 1.0 / k], [0.0, 1.0]])
}

/// Eq. (5).
pub(crate) fn mass(m: f64, lambda: C) -> Matrix {
    complex([[C::ONE, C::ZERO], [-lambda * lambda * m, C::ONE]])
}

/// Eq. (16) with b2 = c2 = 0.
pub(crate) fn body(m: f64, j: f64, b1: f64, c1: f64, lambda: C) -> Matrix {
    let (o, i) = (C::ZERO, C::ONE);
    let ml2 = lambda * lambda * m;
    complex([
        [i, C::from(b1), o, o],
        [o, i, o, o],
        [-ml2 * (b1 - c1), lambda * lambda * (j - m * b1 * c1), i, C::from(b1)],
        [-ml2, -ml2 * c1, o, i],
    ])
}

/// Eq. (19).
pub(crate) fn beam(l: f64, ei: f64, m: f64, lambda: C) -> Matrix {
    let b = (-lambda * lambda * m / ei).sqrt().sqrt();
    let z = b * l;
    let (ch, sh, cos, sin) = (z.cosh(), z.sinh(), z.cos(), z.sin());
    let (s, t, u, v) = ((ch + cos) / 2.0, (sh + sin) / 2.0, (ch - cos) / 2.0, (sh - sin) / 2.0);
    let (b2, b3) = (b * b, b * b * b);
    complex([
        [s, t / b, u / (b2 * ei), v / (b3 * ei)],
        [b * v, s, t / (b * ei), u / (b2 * ei)],
        [b2 * u * ei, b * v * ei, s, t / b],
        [b3 * t * ei, b2 * u * ei, b * v, s],
    ])
}

/// Eq. (32).
pub(crate) fn hinge(ky: f64, kt: f64) -> Matrix {
    real([[1.0, 0.0, 0.0, -1.0 / ky], [0.0, 1.0, 1.0 / kt, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
}

/// `K + Cλ`.
pub(crate) fn dynamic_stiffness(k: f64, c: f64, lambda: C) -> C {
    lambda * c + k
}

/// Eq. (39).
pub(crate) fn spring_damper(k: f64, c: f64, lambda: C) -> Matrix {
    complex([[C::ONE, -dynamic_stiffness(k, c, lambda).inv()], [C::ZERO, C::ONE]])
}

/// The matrices of a connection of two inputs, `z_O = U_I1 z_I1 + U_I2 z_I2` and `H_I1 z_I1 = H_I2 z_I2`.
pub(crate) struct Connection {
    pub(crate) u1: Matrix,
    pub(crate) u2: Matrix,
    pub(crate) h1: Matrix,
    pub(crate) h2: Matrix,
}

/// Eqs. (21) and (23): bending and bending.
pub(crate) fn consistent() -> Connection {
    let h = real([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
    let u2 = real([[0.0; 4], [0.0; 4], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]);
    Connection { u1: Matrix::identity(4, 4), u2, h1: h.clone(), h2: h }
}

/// Eqs. (25) and (26): bending and translation.
pub(crate) fn translational() -> Connection {
    let u2 = real([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 1.0]]);
    Connection { u1: Matrix::identity(4, 4), u2, h1: real([[1.0, 0.0, 0.0, 0.0]]), h2: real([[1.0, 0.0]]) }
}

/// Eqs. (28) and (29): bending and rotation.
pub(crate) fn torsional() -> Connection {
    let u2 = real([[0.0, 0.0], [0.0, 0.0], [0.0, 1.0], [0.0, 0.0]]);
    Connection { u1: Matrix::identity(4, 4), u2, h1: real([[0.0, 1.0, 0.0, 0.0]]), h2: real([[1.0, 0.0]]) }
}

/// `O` with `rows` rows and `columns` columns.
pub(crate) fn zeros(rows: usize, columns: usize) -> Matrix {
    Matrix::zeros(rows, columns)
}

/// `-I` of the root.
pub(crate) fn minus_identity() -> Matrix {
    -Matrix::identity(4, 4)
}

/// A boundary with the positions of its unknown entries: Table 1 of the paper.
#[derive(Clone, Copy)]
pub(crate) struct Boundary {
    entries: usize,
    unknown: [bool; 4],
}

/// `[Y, Θ, M, Q]` with Y = Θ = 0.
pub(crate) const FIXED: Boundary = Boundary { entries: 4, unknown: [false, false, true, true] };
/// `[Y, Θ, M, Q]` with Y = M = 0.
pub(crate) const PINNED: Boundary = Boundary { entries: 4, unknown: [false, true, false, true] };
/// `[Y, Θ, M, Q]` with M = Q = 0.
pub(crate) const FREE: Boundary = Boundary { entries: 4, unknown: [true, true, false, false] };
/// `[Y, Q]` with Y = 0, or `[Θ, M]` with Θ = 0.
pub(crate) const FIXED_LINE: Boundary = Boundary { entries: 2, unknown: [false, true, false, false] };
/// `[Y, Q]` with Q = 0.
pub(crate) const FREE_LINE: Boundary = Boundary { entries: 2, unknown: [true, false, false, false] };

/// `U_all` from its block rows, columns of zero boundary entries removed.
pub(crate) fn reduced<const B: usize>(block_rows: &[[Matrix; B]], boundaries: [Boundary; B]) -> Matrix {
    let height = block_rows.iter().map(|row| row[0].nrows()).sum();
    let width = boundaries.iter().map(|boundary| boundary.entries).sum();
    let mut full = Matrix::zeros(height, width);
    let mut top = 0;
    for row in block_rows {
        let mut left = 0;
        for block in row {
            full.view_mut((top, left), block.shape()).copy_from(block);
            left += block.ncols();
        }
        top += row[0].nrows();
    }
    let unknown = boundaries.iter().flat_map(|boundary| &boundary.unknown[..boundary.entries]);
    let columns: Vec<usize> = unknown.enumerate().filter(|(_, unknown)| **unknown).map(|(column, _)| column).collect();
    full.select_columns(&columns)
}
