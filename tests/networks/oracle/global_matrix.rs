//! The global matrix of a structure at a frequency, and the count.

use super::{double, monotony};
use crate::stiffness_matrix::beam_matrix::BeamMatrix;
use crate::stiffness_matrix::{Assembled, Form, pivots, sparse};
use mstmm::number::{DoubleDouble, Parameter};

/// Rows up to which the largest of all entries is the next pivot.
const SMALL: usize = 60;

/// Rows from which on only those of short rows are.
const LARGE: usize = 700;

/// A symmetric matrix of displacements, and of forces where a stiffness would be too large.
///
/// With a force the form of an elongation is a row, and minus the flexibility stands on the diagonal. The force has one
/// negative eigenvalue of its own where the flexibility is positive.
pub(super) struct GlobalMatrix {
    sum: Assembled<DoubleDouble>,
    /// Whether all springs, and what is static in short members, have forces.
    pub(super) with_forces: bool,
    /// Number of the members' frequencies with held ends, less the negative eigenvalues that belong to forces.
    pub(super) held: i64,
}

fn unknown(index: usize) -> Form {
    vec![(index, double(1.0))]
}

/// `a + factor · b`, term by term: what cancels is left to the matrix, which knows the sizes of its terms.
pub(super) fn sum(a: &Form, factor: DoubleDouble, b: &Form) -> Form {
    a.iter().copied().chain(b.iter().map(|&(index, entry)| (index, factor * entry))).collect()
}

impl GlobalMatrix {
    pub(super) fn new(unknowns: usize, with_forces: bool) -> Self {
        GlobalMatrix { sum: Assembled::zero(unknowns), with_forces, held: 0 }
    }

    /// One more row and column.
    fn unknown(&mut self) -> Form {
        let size = self.sum.entries.len();
        for row in &mut self.sum.entries {
            row.push(double(0.0));
        }
        for row in &mut self.sum.sizes {
            row.push(0.0);
        }
        self.sum.entries.push(vec![double(0.0); size + 1]);
        self.sum.sizes.push(vec![0.0; size + 1]);
        unknown(size)
    }

    /// Adds a stiffness whose rounding is so many times that of one operation.
    pub(super) fn stiffness(&mut self, form: &Form, stiffness: DoubleDouble, rounding: f64) {
        self.sum.add(form, form, stiffness, rounding * stiffness.to_f64().abs());
    }

    /// Adds the flexibility of a spring with the form of its elongation: the force is an unknown.
    pub(super) fn flexibility(&mut self, form: &Form, flexibility: DoubleDouble, rounding: f64) {
        let force = self.unknown();
        self.sum.add(&force, form, double(1.0), 1.0);
        self.sum.add(form, &force, double(1.0), 1.0);
        self.stiffness(&force, -flexibility, rounding);
    }

    pub(super) fn spring(&mut self, form: &Form, stiffness: DoubleDouble) {
        if self.with_forces || stiffness.to_f64().is_infinite() {
            let flexibility = if stiffness.to_f64().is_infinite() { double(0.0) } else { double(1.0) / stiffness };
            self.flexibility(form, flexibility, 1.0);
            self.held -= 1;
        } else {
            self.stiffness(form, stiffness, 1.0);
        }
    }

    pub(super) fn mass(&mut self, form: &Form, mass: DoubleDouble, omega: DoubleDouble) {
        self.stiffness(form, -(omega * omega * mass), 1.0);
    }

    /// Adds the bending of a member, in two halves where it nearly vibrates with held ends; `None` out of range.
    pub(super) fn bending(
        &mut self,
        ends: &[Form; 4],
        parameters: [DoubleDouble; 3],
        omega: DoubleDouble,
    ) -> Option<()> {
        let matrix = BeamMatrix::of(parameters, omega);
        if !matrix.is_near_a_pole() {
            return self.piece(ends, parameters, &matrix);
        }
        let [length, stiffness, mass] = parameters;
        let half = [length * double(0.5), stiffness, mass];
        let matrix = BeamMatrix::of(half, omega);
        let middle = [self.unknown(), self.unknown()];
        let [y, theta, y_out, theta_out] = ends.clone();
        let [y_middle, theta_middle] = middle.clone();
        self.piece(&[y, theta, y_middle, theta_middle], half, &matrix)?;
        let [y_middle, theta_middle] = middle;
        self.piece(&[y_middle, theta_middle, y_out, theta_out], half, &matrix)
    }

    fn piece(
        &mut self,
        ends: &[Form; 4],
        parameters: [DoubleDouble; 3],
        matrix: &BeamMatrix<DoubleDouble>,
    ) -> Option<()> {
        for (i, a) in ends.iter().enumerate() {
            for (j, b) in ends.iter().enumerate() {
                self.sum.add(a, b, matrix.entries[i][j], matrix.size(i, j));
            }
        }
        if let Some(at_rest) = &matrix.bending {
            self.at_rest(ends, parameters, at_rest);
        }
        self.held += i64::try_from(matrix.held_frequencies_below()?).ok()?;
        Some(())
    }

    /// Adds the static bending: stiffness or flexibility of the output end off a rigid continuation of the input.
    fn at_rest(
        &mut self,
        [y, theta, y_out, theta_out]: &[Form; 4],
        [l, ei, _]: [DoubleDouble; 3],
        stiffness: &[[DoubleDouble; 2]; 2],
    ) {
        let minus = double(-1.0);
        let deflection = sum(&sum(y_out, minus, y), -l, theta);
        let bending = [deflection, sum(theta_out, minus, theta)];
        if !self.with_forces {
            return self.block(&bending, stiffness);
        }
        let forces = [self.unknown(), self.unknown()];
        for (force, form) in forces.iter().zip(&bending) {
            self.sum.add(force, form, double(1.0), 1.0);
            self.sum.add(form, force, double(1.0), 1.0);
        }
        let mixed = -(l * l / (ei * double(2.0)));
        self.block(&forces, &[[-(l * l * l / (ei * double(3.0))), mixed], [mixed, -(l / ei)]]);
        self.held -= 2;
    }

    fn block(&mut self, forms: &[Form; 2], entries: &[[DoubleDouble; 2]; 2]) {
        for (a, row) in forms.iter().zip(entries) {
            for (b, entry) in forms.iter().zip(row) {
                self.sum.add(a, b, *entry, entry.to_f64().abs());
            }
        }
    }

    /// The count of Wittrick and Williams. It leaves out unknowns that no element refers to.
    pub(super) fn count(mut self) -> Option<u64> {
        let is_used = |row: &Vec<f64>| row.iter().any(|&size| size != 0.0);
        let used: Vec<bool> = self.sum.sizes.iter().map(is_used).collect();
        keep(&mut self.sum.entries, &used);
        keep(&mut self.sum.sizes, &used);
        let size = self.sum.entries.len();
        if size >= LARGE && self.with_forces {
            return None;
        }
        let sparsely = (size > SMALL).then(|| sparse::negative(&self.sum)).flatten();
        let fully = || pivots::negative(&self.sum).or_else(|| monotony::negative(&self.sum));
        let negative = sparsely.or_else(|| if size < LARGE { fully() } else { sparse::agreed(&self.sum) })?;
        u64::try_from(self.held + i64::try_from(negative).ok()?).ok()
    }
}

pub(super) fn keep<V>(matrix: &mut Vec<Vec<V>>, is_kept: &[bool]) {
    let by_index = |row: &mut Vec<V>| {
        let mut kept = is_kept.iter();
        row.retain(|_| kept.next() == Some(&true));
    };
    matrix.iter_mut().for_each(by_index);
    let mut kept = is_kept.iter();
    matrix.retain(|_| kept.next() == Some(&true));
}
