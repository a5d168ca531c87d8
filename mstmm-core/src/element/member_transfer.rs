//! Transfer matrices of members: those of elements, in the order and with the signs of plane structures.

use crate::element::charted::{MemberElement, along_member};
use crate::element::traits::{Element, TransferMatrix, space_of};
use crate::model::StateSpace;
use crate::number::{Scalar, Single};
use mstmm_plan::{Coordinate, Freedoms, WIDEST};

/// The state of a member, or of a part of one, at an end: displacements along and across it \[m\] and rotation \[rad\], and the forces \[N\] and the
/// moment [N m] that what lies upstream exerts on what follows.
#[derive(Clone, Copy, Debug)]
pub struct PartState<S> {
    pub(crate) displacements: [S; 3],
    pub(crate) forces: [S; 3],
}

/// The transfer matrix of a member, in its axes, and the factor that removes its poles.
#[derive(Clone, Copy, Debug)]
pub struct MemberTransfer<S> {
    /// Over displacements, then forces, along x, y and about z.
    matrix: [[S; WIDEST]; WIDEST],
    pub(crate) denominator: Option<S>,
}

impl<S: Scalar> MemberTransfer<S> {
    /// A member that is not known.
    pub(crate) fn none() -> Self {
        MemberTransfer { matrix: [[S::zero(); WIDEST]; WIDEST], denominator: None }
    }

    /// The member with its ends exchanged. It is reciprocal: its inverse is made of the transposes of its blocks.
    pub(crate) fn reversed(self) -> Self {
        let half = WIDEST / 2;
        let turned = |k: usize| (k + half) % WIDEST;
        let matrix =
            core::array::from_fn(|row| core::array::from_fn(|column| self.matrix[turned(column)][turned(row)]));
        MemberTransfer { matrix, ..self }
    }

    /// The state behind the member.
    pub(crate) fn of(&self, state: PartState<S>) -> PartState<S> {
        let PartState { displacements, forces } = state;
        let entry = |row: usize| {
            let states = displacements.iter().chain(&forces);
            self.matrix[row].iter().zip(states).fold(S::zero(), |sum, (entry, state)| sum + *entry * *state)
        };
        PartState { displacements: [0, 1, 2].map(entry), forces: [3, 4, 5].map(entry) }
    }
}

/// The transfer matrix of an element as a member.
pub fn member_transfer<E: TransferMatrix<S>, S: Single>(built: &E::Built, x: S) -> MemberTransfer<S> {
    let transfer = E::transfer_matrix(built, x);
    let mut matrix = [[S::zero(); WIDEST]; WIDEST];
    for &from in space_of::<E>().coordinates() {
        let mut state = [S::zero(); WIDEST];
        state[from as usize] = sign(from);
        E::State::transfer(&transfer, &mut state);
        for &to in space_of::<E>().coordinates() {
            matrix[place::<E>(to)][place::<E>(from)] = sign::<S>(to) * state[to as usize];
        }
    }
    MemberTransfer { matrix, denominator: E::denominator(built, x) }
}

/// Where an entry of an element's state stands in that of a member.
fn place<E: Element>(coordinate: Coordinate) -> usize {
    let is_single = space_of::<E>().count() == 1;
    let freedom = if is_single { along_member::<E>() } else { coordinate.freedom() };
    let place = Freedoms::SINGLE.iter().take_while(|single| !single.is(freedom)).count();
    if coordinate.is_force() { place + WIDEST / 2 } else { place }
}

/// The sign of an entry: M turns against Θ at an input end.
fn sign<S: Scalar>(coordinate: Coordinate) -> S {
    if matches!(coordinate, Coordinate::M) { -S::one() } else { S::one() }
}

/// A member whose transfer matrix is known at a frequency of type `S`.
pub trait MemberMatrix<S: Scalar>: MemberElement {
    /// Its transfer matrix.
    fn transfer(built: &Self::Built, x: S) -> MemberTransfer<S>;
}
