//! Assembly of the overall transfer equation: matrix products per transfer path, geometrical equations at each connection.

use crate::element::{Element, MatrixOf};
use crate::model::StateSpace;
use crate::number::Scalar;
use mstmm_plan::{Scheme, Step, WIDEST};
use nalgebra::SMatrix;

/// `U_all` under construction.
///
/// Each column belongs to one unknown boundary entry. It carries the state that this unknown causes at the current
/// point of its path; an element multiplies it, a connection keeps the displacements of its first input and the
/// forces of all.
#[derive(Debug)]
pub struct Assembly<'a, S, const N: usize> {
    scheme: &'a Scheme<'a>,
    /// State per column, indexed by [`Coordinate`](mstmm_plan::Coordinate).
    states: [[S; WIDEST]; N],
    matrix: SMatrix<S, N, N>,
}

impl<'a, S: Scalar, const N: usize> Assembly<'a, S, N> {
    /// An empty equation.
    #[inline]
    pub fn new(scheme: &'a Scheme<'a>) -> Self {
        Assembly { scheme, states: [[S::zero(); WIDEST]; N], matrix: SMatrix::zeros() }
    }

    /// Starts a path from a tip: each of its unknowns causes a unit state.
    #[inline(always)]
    pub fn tip(&mut self, step: usize) {
        let Step::Tip(support) = self.scheme.steps[step] else { return };
        let place = self.scheme.places[step];
        for (column, unknown) in support.unknowns(place.space).enumerate() {
            self.states[place.first_column + column][unknown as usize] = S::one();
        }
    }

    /// Takes the paths up to `step` through an element with transfer matrix `u`.
    #[inline]
    pub fn element<E: Element>(&mut self, step: usize, u: &MatrixOf<E, S>) {
        let place = self.scheme.places[step];
        for state in &mut self.states[place.first_column..place.first_column + place.columns] {
            E::State::transfer(u, state);
        }
    }

    /// Joins the inputs of a connection: a geometrical equation `-H_1 z_1 + H_k z_k = 0` for each input `k` after the
    /// first, and `z_O = U_1 z_1 + Σ U_k z_k`.
    ///
    /// # Source
    /// Eqs. (20)-(29) of the paper.
    pub fn connection(&mut self, step: usize) {
        let places = self.scheme.places;
        let inputs = self.scheme.inputs(step);
        let Some((&first, others)) = inputs.split_first() else { return };
        let reference = places[first];
        let mut row = places[step].first_row + inputs.iter().map(|&input| places[input].rows).sum::<usize>();
        for &input in others {
            let input = places[input];
            let columns = input.first_column..input.first_column + input.columns;
            for &displacement in input.space.displacements() {
                for column in reference.first_column..reference.first_column + reference.columns {
                    self.matrix[(row, column)] = -self.states[column][displacement as usize];
                }
                for column in columns.clone() {
                    self.matrix[(row, column)] = self.states[column][displacement as usize];
                    self.states[column][displacement as usize] = S::zero();
                }
                row += 1;
            }
        }
        self.leave_behind(step, row);
    }

    /// Ends the entries that the output of a connection has not: their forces are zero, their displacements free.
    fn leave_behind(&mut self, step: usize, mut row: usize) {
        let place = self.scheme.places[step];
        for &coordinate in self.scheme.left_behind(step).coordinates() {
            for column in place.first_column..place.first_column + place.columns {
                if coordinate.is_force() {
                    self.matrix[(row, column)] = self.states[column][coordinate as usize];
                }
                self.states[column][coordinate as usize] = S::zero();
            }
            row += usize::from(coordinate.is_force());
        }
    }

    /// Ends all paths at the root: `z_root` of the tips minus its own unknowns, eq. (30).
    pub fn finish(mut self) -> SMatrix<S, N, N> {
        let Scheme { steps: [.., Step::Root(_, support)], places: [.., place], .. } = self.scheme else {
            return self.matrix;
        };
        let tips = N - place.space.count();
        let mut own_column = tips;
        for (row, &coordinate) in place.space.coordinates().iter().enumerate() {
            for column in 0..tips {
                self.matrix[(row, column)] = self.states[column][coordinate as usize];
            }
            if support.leaves(coordinate) {
                self.matrix[(row, own_column)] = -S::one();
                own_column += 1;
            }
        }
        self.matrix
    }
}
