//! Shape functions of a beam element on `-1 <= ξ <= 1`: the cubics of Hermite, and bubbles of any higher degree.
//!
//! Deflections and curvatures are kept as coefficients of Legendre polynomials, whose products integrate to `2/(2n + 1)`:
//! matrices follow without quadrature, and what is zero in them is exactly zero. The bubble of degree k is the twofold
//! integral of the orthonormal polynomial of degree k - 2: bending stiffness couples no bubble with anything, mass only those
//! whose degrees differ by 0, 2 or 4, and nodes with the first four.
//!
//! # Source
//! Integrated Legendre polynomials of the hierarchic finite elements of Szabó and Babuška (1991), integrated once more.

/// A series of Legendre polynomials: degrees and coefficients.
type Series = Vec<(usize, f64)>;

/// A shape function over ξ.
#[derive(Clone, Debug)]
struct Shape {
    deflection: Series,
    curvature: Series,
}

/// Integral of the product of two series over -1 <= ξ <= 1.
fn product(a: &Series, b: &Series) -> f64 {
    let pairs = a.iter().flat_map(|x| b.iter().filter(|y| y.0 == x.0).map(move |y| (x, y)));
    pairs.map(|(x, y)| x.1 * y.1 * 2.0 / (2 * x.0 + 1) as f64).sum()
}

/// Deflection and slope 1 at the first end, then at the second; slopes over ξ.
fn cubics() -> [Shape; 4] {
    let shape = |[p0, p1, p2, p3]: [f64; 4], curvature: [f64; 2]| Shape {
        deflection: vec![(0, p0), (1, p1), (2, p2), (3, p3)],
        curvature: vec![(0, curvature[0]), (1, curvature[1])],
    };
    let sixth = 1.0 / 6.0;
    [
        shape([0.5, -0.6, 0.0, 0.1], [0.0, 1.5]),
        shape([sixth, -0.1, -sixth, 0.1], [-0.5, 1.5]),
        shape([0.5, 0.6, 0.0, -0.1], [0.0, -1.5]),
        shape([-sixth, -0.1, sixth, 0.1], [0.5, 1.5]),
    ]
}

/// The bubble of a degree from 4 on, zero with its slope at both ends, from `(2n + 1) P_n = (P_{n+1} - P_{n-1})'`.
fn bubble(degree: usize) -> Shape {
    let n = degree - 2;
    let x = n as f64;
    let norm = ((2.0 * x + 1.0) / 2.0).sqrt();
    let (up, down) = (norm / ((2.0 * x + 1.0) * (2.0 * x + 3.0)), norm / ((2.0 * x + 1.0) * (2.0 * x - 1.0)));
    Shape { deflection: vec![(n + 2, up), (n, -up - down), (n - 2, down)], curvature: vec![(n, norm)] }
}

/// An entry of the reference matrices that is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Numbers of the two shape functions; 0 to 3 are nodal, 4 and more of that degree.
    pub pair: [usize; 2],
    /// Integral of the product of their second derivatives.
    pub stiffness: f64,
    /// Integral of their product.
    pub mass: f64,
}

/// Lower triangles of the reference matrices for all shape functions up to a degree, 3 or more.
pub fn reference(degree: usize) -> Vec<Entry> {
    let shapes: Vec<Shape> = cubics().into_iter().chain((4..=degree).map(bubble)).collect();
    let mut entries = Vec::new();
    for (row, a) in shapes.iter().enumerate() {
        for (column, b) in shapes.iter().enumerate().take(row + 1) {
            let entry = Entry {
                pair: [row, column],
                stiffness: product(&a.curvature, &b.curvature),
                mass: product(&a.deflection, &b.deflection),
            };
            if entry.stiffness != 0.0 || entry.mass != 0.0 {
                entries.push(entry);
            }
        }
    }
    entries
}
