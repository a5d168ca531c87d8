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
    scheme: Scheme<'a>,
    /// State per column, indexed by [`Coordinate`](mstmm_plan::Coordinate).
    states: [[S; WIDEST]; N],
    matrix: SMatrix<S, N, N>,
}

impl<'a, S: Scalar, const N: usize> Assembly<'a, S, N> {
    /// An empty equation in which every tip has its unit states.
    pub fn new(scheme: Scheme<'a>) -> Self {
        let mut states = [[S::zero(); WIDEST]; N];
        for (step, place) in scheme.steps.iter().zip(scheme.places) {
            let Step::Tip(support) = step else { continue };
            for (column, unknown) in support.unknowns(place.space).enumerate() {
                states[place.first_column + column][unknown as usize] = S::one();
            }
        }
        Assembly { scheme, states, matrix: SMatrix::zeros() }
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
        let Scheme { places, .. } = self.scheme;
        let Some((&first, others)) = self.scheme.inputs(step).split_first() else { return };
        let reference = places[first];
        let connection = places[step];
        let geometrical_rows: usize = others.iter().map(|&input| places[input].space.count()).sum();
        let left_behind = self.scheme.left_behind(step).count();
        let mut row = connection.first_row + connection.rows - geometrical_rows - left_behind;
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
        let own_column = N - place.space.count();
        for (row, &coordinate) in place.space.coordinates().iter().enumerate() {
            for column in 0..own_column {
                self.matrix[(row, column)] = self.states[column][coordinate as usize];
            }
            for (k, unknown) in support.unknowns(place.space).enumerate() {
                if unknown == coordinate {
                    self.matrix[(row, own_column + k)] = -S::one();
                }
            }
        }
        self.matrix
    }
}
