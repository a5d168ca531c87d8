//! Chains with general beams as symmetric matrices of many digits, whose negative pivots are counted: all but the beams.

use super::many_digits::{Exact, exact};
use crate::general_chains::chain::{Chain, Link};
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;
use std::collections::BTreeMap;

/// Bits of a number.
const BITS: usize = 384;

/// A displacement as a sum of degrees of freedom.
pub(crate) type Form = Vec<(usize, Exact)>;

/// Rows of the upper half of a symmetric matrix.
#[derive(Default)]
pub(crate) struct ChainMatrix {
    rows: Vec<BTreeMap<usize, Exact>>,
}

impl ChainMatrix {
    /// A new degree of freedom.
    pub(crate) fn freedom(&mut self) -> Form {
        self.rows.push(BTreeMap::new());
        vec![(self.rows.len() - 1, number(1.0))]
    }

    /// Adds `factor` times the product of two forms to the upper half.
    pub(crate) fn add(&mut self, first: &Form, second: &Form, factor: &Exact) {
        for (i, a) in first {
            for (j, b) in second {
                if i <= j {
                    *self.rows[*i].entry(*j).or_insert_with(|| number(0.0)) += a * b * factor;
                }
            }
        }
    }

    /// The number of negative pivots; none where one vanishes.
    fn negative_pivots(mut self) -> Option<u64> {
        let mut negative = 0;
        for k in 0..self.rows.len() {
            let mut row = core::mem::take(&mut self.rows[k]);
            let pivot = row.remove(&k)?;
            if pivot == number(0.0) {
                return None;
            }
            negative += u64::from(pivot < number(0.0));
            for (i, a) in &row {
                let factor = a / &pivot;
                for (j, b) in row.range(i..) {
                    *self.rows[*i].entry(*j).or_insert_with(|| number(0.0)) -= &factor * b;
                }
            }
        }
        Some(negative)
    }
}

pub(crate) fn number(value: f64) -> Exact {
    exact(value, BITS)
}

/// `first + factor · second`.
pub(crate) fn sum(first: &Form, factor: &Exact, second: &Form) -> Form {
    let mut sum = first.clone();
    for (index, entry) in second {
        let term = entry * factor;
        match sum.iter_mut().find(|(other, _)| other == index) {
            Some((_, entry)) => *entry += term,
            None => sum.push((*index, term)),
        }
    }
    sum
}

/// The deflection and the rotation that a support leaves.
fn left_by(support: Support, matrix: &mut ChainMatrix) -> [Form; 2] {
    let y = if matches!(support, Support::Fixed | Support::Pinned) { Form::new() } else { matrix.freedom() };
    let theta = if matches!(support, Support::Fixed | Support::Guided) { Form::new() } else { matrix.freedom() };
    [y, theta]
}

/// The number of negative pivots of a chain at the square of a frequency, of either sign. Beams go from the displacements of one end to those
/// of the other, new ones where none are given; none where a beam cannot.
pub(crate) fn negative_pivots(
    chain: &Chain,
    square: &Exact,
    mut through: impl FnMut(&mut ChainMatrix, &GeneralBeam<f64>, [Form; 2], Option<[Form; 2]>) -> Option<[Form; 2]>,
) -> Option<u64> {
    let mut matrix = ChainMatrix::default();
    let [mut y, mut theta] = left_by(chain.tip, &mut matrix);
    let last = chain.links.len() - 1;
    for (index, link) in chain.links.iter().enumerate() {
        let inertia = |mass: f64| -(number(mass) * square);
        match *link {
            Link::Beam(ref beam) => {
                let end = (index == last).then(|| left_by(chain.root, &mut matrix));
                [y, theta] = through(&mut matrix, beam, [y, theta], end)?;
            }
            Link::Side(support, ref beam) => {
                let foot = left_by(support, &mut matrix);
                through(&mut matrix, beam, foot, Some([y.clone(), theta.clone()]))?;
            }
            Link::Mass { mass, inertia: own } => {
                matrix.add(&y, &y, &inertia(mass));
                matrix.add(&theta, &theta, &inertia(own));
            }
            Link::Body { mass, central, centre_x, output_x } => {
                let centre = sum(&y, &number(centre_x), &theta);
                matrix.add(&centre, &centre, &inertia(mass));
                matrix.add(&theta, &theta, &inertia(central));
                y = sum(&y, &number(output_x), &theta);
            }
            Link::Spring(stiffness) => matrix.add(&y, &y, &number(stiffness)),
            Link::TorsionSpring(stiffness) => matrix.add(&theta, &theta, &number(stiffness)),
            Link::RotationalHinge(stiffness) => {
                let next = matrix.freedom();
                let turned = sum(&theta, &number(-1.0), &next);
                matrix.add(&turned, &turned, &number(stiffness));
                theta = next;
            }
            Link::ShearHinge(stiffness) => {
                let next = matrix.freedom();
                let moved = sum(&y, &number(-1.0), &next);
                matrix.add(&moved, &moved, &number(stiffness));
                y = next;
            }
            Link::Lever(output_x) => y = sum(&y, &number(output_x), &theta),
        }
    }
    matrix.negative_pivots()
}
