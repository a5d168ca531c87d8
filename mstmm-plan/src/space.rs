//! Spaces of state vectors: a space is the set of displacements that its states tell.

use crate::coordinate::Coordinate;
use crate::freedom::Freedoms;
use core::fmt;

/// The space of a state vector: the set of its displacements. Their forces are the other half of the state.
///
/// ```
/// use mstmm_plan::{Coordinate, Freedoms, Space};
/// assert_eq!(Space::Bending, Freedoms::Y.union(Freedoms::RZ));
/// assert_eq!(Space::Bending.coordinates(), [Coordinate::Y, Coordinate::Theta, Coordinate::M, Coordinate::Q]);
/// assert_eq!(Space::Translation.join(Space::Rotation), Some(Space::Bending));
/// assert_eq!(Space::Planar.join(Space::Bending), None);
/// ```
pub type Space = Freedoms;

/// Number of entries of the widest state.
pub const WIDEST: usize = Space::PLANE.size();

/// Number of spaces, that of no freedom included.
const SPACES: usize = Space::PLANE.index() + 1;

/// The entries of the states of every space, and room behind them.
const ENTRIES: &[[Coordinate; WIDEST]; SPACES] = &{
    let mut entries = [Coordinate::ALL; SPACES];
    let mut space = 0;
    while space < SPACES {
        let (mut entry, mut size) = (0, 0);
        while entry < WIDEST {
            if Freedoms::at(space).contains(Coordinate::ALL[entry].freedom()) {
                entries[space][size] = Coordinate::ALL[entry];
                size += 1;
            }
            entry += 1;
        }
        space += 1;
    }
    entries
};

/// The entries of the states of every space.
const STATES: &[&[Coordinate]; SPACES] = &{
    let mut states: [&[Coordinate]; SPACES] = [&[]; SPACES];
    let mut space = 0;
    while space < SPACES {
        states[space] = ENTRIES[space].split_at(Freedoms::at(space).size()).0;
        space += 1;
    }
    states
};

// named like the types of the core that mark them
#[allow(non_upper_case_globals)]
impl Freedoms {
    /// States `[Y, Q]`
    pub const Translation: Space = Freedoms::Y;
    /// States `[Θ, M]`
    pub const Rotation: Space = Freedoms::RZ;
    /// States `[Y, Θ, M, Q]`
    pub const Bending: Space = Freedoms::Y.union(Freedoms::RZ);
    /// States `[X, Y, Θ, M, Qx, Qy]`
    pub const Planar: Space = Freedoms::PLANE;
}

impl Freedoms {
    /// Number of entries `n_s` of a state.
    #[inline]
    pub const fn size(self) -> usize {
        2 * self.count()
    }

    /// The entries of a state, in order: displacements first, forces second.
    #[inline]
    pub const fn coordinates(self) -> &'static [Coordinate] {
        STATES[self.intersection(Freedoms::PLANE).index()]
    }

    /// The displacements of a state.
    #[inline]
    pub const fn displacements(self) -> &'static [Coordinate] {
        self.halves().0
    }

    /// The forces of a state.
    #[inline]
    pub const fn forces(self) -> &'static [Coordinate] {
        self.halves().1
    }

    #[inline]
    const fn halves(self) -> (&'static [Coordinate], &'static [Coordinate]) {
        let entries = self.coordinates();
        entries.split_at(entries.len() / 2)
    }

    /// The smallest space that holds the states of both; `None` where they cannot meet at a connection, as planar states and
    /// others, or where one of them is not known.
    #[inline]
    pub const fn join(self, other: Space) -> Option<Space> {
        let is_known = !self.is_empty() && !other.is_empty();
        let is_planar = self.contains(Freedoms::X);
        if is_known && is_planar == other.contains(Freedoms::X) { Some(self.union(other)) } else { None }
    }
}

/// The names of all freedoms, in their order.
const NAMES: [&str; 6] = ["x", "y", "rz", "z", "rx", "ry"];

/// The name of a space, such as `bending`; of other sets their displacements, such as `X, Θ`, and of sets in space their freedoms, such as `z, rx`.
impl fmt::Display for Freedoms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Space::Translation => f.write_str("translation"),
            Space::Rotation => f.write_str("rotation"),
            Space::Bending => f.write_str("bending"),
            Space::Planar => f.write_str("planar"),
            spatial if !Freedoms::PLANE.contains(spatial) => {
                let own = Freedoms::EACH.into_iter().zip(NAMES).filter(|(freedom, _)| spatial.contains(*freedom));
                own.enumerate()
                    .try_for_each(|(index, (_, name))| write!(f, "{}{name}", if index > 0 { ", " } else { "" }))
            }
            other => other.displacements().iter().enumerate().try_for_each(|(index, displacement)| {
                write!(f, "{}{}", if index > 0 { ", " } else { "" }, displacement.symbol(other))
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Coordinate::{M, Q, Qx, Theta, X, Y};

    /// The states of the paper.
    #[test]
    fn states_are_displacements_and_then_forces() {
        assert_eq!(Space::Translation.coordinates(), [Y, Q]);
        assert_eq!(Space::Rotation.coordinates(), [Theta, M]);
        assert_eq!(Space::Bending.coordinates(), [Y, Theta, M, Q]);
        assert_eq!(Space::Planar.coordinates(), [X, Y, Theta, M, Qx, Q]);
        assert_eq!(Space::Planar.displacements(), [X, Y, Theta]);
        assert_eq!(Space::Planar.forces(), [M, Qx, Q]);
        assert_eq!(Space::NONE.coordinates(), []);
    }

    #[test]
    fn paths_meet_in_the_union_of_their_states() {
        let narrow = [Space::Translation, Space::Rotation, Space::Bending];
        for a in narrow {
            for b in narrow {
                let joined = if a == b { a } else { Space::Bending };
                assert_eq!(a.join(b), Some(joined));
            }
            assert_eq!(a.join(Space::Planar), None);
            assert_eq!(Space::Planar.join(a), None);
            assert_eq!(Space::NONE.join(a), None);
        }
        assert_eq!(Space::Planar.join(Space::Planar), Some(Space::Planar));
    }
}
