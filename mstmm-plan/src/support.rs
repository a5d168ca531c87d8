//! Supports: each is the set of the freedoms that it holds.

use crate::coordinate::Coordinate;
use crate::freedom::Freedoms;
use crate::space::Space;

/// A boundary condition: it holds some freedoms, whose forces are unknown, and leaves the others, whose forces are zero.
///
/// ```
/// use mstmm_plan::{Coordinate, Space, Support};
/// assert!(Support::Pinned.unknowns(Space::Bending).eq([Coordinate::Theta, Coordinate::Q]));
/// assert!(!Support::Pinned.exists_in(Space::Translation));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// All displacements are zero.
    Fixed,
    /// All forces are zero.
    Free,
    /// Displacements and moment are zero; the rotation is free.
    Pinned,
    /// Rotation and shear force are zero; in planar states X, Θ and Qy.
    Guided,
    /// Planar states only: Y, M and Qx are zero.
    Roller,
}

impl Support {
    /// All supports; of those that hold the same in a space the first is the one that there is.
    pub const ALL: [Support; 5] = [Support::Fixed, Support::Free, Support::Pinned, Support::Guided, Support::Roller];

    /// The freedoms that the support holds.
    #[inline]
    pub const fn holds(self) -> Freedoms {
        match self {
            Support::Fixed => Freedoms::PLANE,
            Support::Free => Freedoms::NONE,
            Support::Pinned => Freedoms::X.union(Freedoms::Y),
            Support::Guided => Freedoms::X.union(Freedoms::RZ),
            Support::Roller => Freedoms::Y,
        }
    }

    /// Whether states of a space have this support: none before it in [`ALL`](Self::ALL) holds the same of them.
    #[inline]
    pub const fn exists_in(self, space: Space) -> bool {
        let mut earlier = 0;
        while earlier < self as usize {
            if Support::ALL[earlier].holds().intersection(space).is(self.holds().intersection(space)) {
                return false;
            }
            earlier += 1;
        }
        true
    }

    /// Whether the support leaves an entry of the state unknown: the force of what it holds, the displacement of what it does not.
    #[inline]
    pub const fn leaves(self, entry: Coordinate) -> bool {
        self.holds().contains(entry.freedom()) == entry.is_force()
    }

    /// The entries that are unknown at this support of a state of some space, in the order of the state.
    ///
    /// # Source
    /// Table 1 of the paper.
    #[inline]
    pub fn unknowns(self, space: Space) -> impl Iterator<Item = Coordinate> + Clone {
        let (free, held) = (space.without(self.holds()), space.intersection(self.holds()));
        free.displacements().iter().chain(held.forces()).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Coordinate::{M, Q, Qx, Theta, X, Y};
    use Support::{Fixed, Free, Guided, Pinned, Roller};

    /// Table 1 of the paper: the unknowns of each support that there is.
    const TABLE: [(Space, Support, &[Coordinate]); 13] = [
        (Space::Translation, Fixed, &[Q]),
        (Space::Translation, Free, &[Y]),
        (Space::Rotation, Fixed, &[M]),
        (Space::Rotation, Free, &[Theta]),
        (Space::Bending, Fixed, &[M, Q]),
        (Space::Bending, Pinned, &[Theta, Q]),
        (Space::Bending, Free, &[Y, Theta]),
        (Space::Bending, Guided, &[Y, M]),
        (Space::Planar, Fixed, &[M, Qx, Q]),
        (Space::Planar, Pinned, &[Theta, Qx, Q]),
        (Space::Planar, Free, &[X, Y, Theta]),
        (Space::Planar, Guided, &[Y, M, Qx]),
        (Space::Planar, Roller, &[X, Theta, Q]),
    ];

    /// Oracle: the table of the paper, written out.
    #[test]
    fn unknowns_and_refusals_are_those_of_table_1() {
        for space in [Space::Translation, Space::Rotation, Space::Bending, Space::Planar] {
            for support in Support::ALL {
                let row = TABLE.iter().find(|(of, by, _)| (*of, *by) == (space, support));
                assert_eq!(support.exists_in(space), row.is_some(), "{support:?} of a {space} path");
                if let Some((.., unknowns)) = row {
                    assert!(support.unknowns(space).eq(unknowns.iter().copied()), "{support:?} of a {space} path");
                }
            }
        }
    }

    #[test]
    fn all_supports_stand_in_their_order() {
        for (index, support) in Support::ALL.into_iter().enumerate() {
            assert_eq!(support as usize, index);
        }
    }
}
