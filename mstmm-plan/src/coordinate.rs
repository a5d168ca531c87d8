//! Entries of the state vector: each freedom has a displacement and the force that does work on it.

use crate::freedom::Freedoms;

/// An entry of the state vector of planar motion, in the order of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum Coordinate {
    /// Longitudinal displacement X \[m\]
    X = 0,
    /// Deflection Y \[m\]
    Y = 1,
    /// Rotation Θ \[rad\]
    Theta = 2,
    /// Bending moment M [N m]
    M = 3,
    /// Axial force Qx \[N\]
    Qx = 4,
    /// Shear force Q, in planar states Qy \[N\]
    Q = 5,
}

use Coordinate::{M, Q, Qx, Theta, X, Y};

/// What is known of an entry: its symbol, its freedom, the entry of that freedom that does work on it.
struct Row(&'static str, Freedoms, Coordinate);

/// The state vector, a row per entry: displacements first, forces second.
const STATE: [Row; 6] = [
    Row("X", Freedoms::X, Qx),
    Row("Y", Freedoms::Y, Q),
    Row("Θ", Freedoms::RZ, M),
    Row("M", Freedoms::RZ, Theta),
    Row("Qx", Freedoms::X, X),
    Row("Q", Freedoms::Y, Y),
];

impl Coordinate {
    /// All entries, in the order of the state vector.
    pub const ALL: [Coordinate; 6] = [X, Y, Theta, M, Qx, Q];

    /// The freedom that the entry displaces, or works on.
    #[inline]
    pub const fn freedom(self) -> Freedoms {
        STATE[self as usize].1
    }

    /// The entry that does work on this one: the force of a displacement, the displacement of a force.
    #[inline]
    pub const fn dual(self) -> Coordinate {
        STATE[self as usize].2
    }

    /// Whether the entry is a force or a moment.
    #[inline]
    pub const fn is_force(self) -> bool {
        self as usize >= STATE.len() / 2
    }

    /// How the entry is written in a state of some space.
    pub const fn symbol(self, space: Freedoms) -> &'static str {
        match self {
            Q if space.contains(Freedoms::X) => "Qy",
            _ => STATE[self as usize].0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_freedom_has_one_displacement_and_its_force() {
        for (index, entry) in Coordinate::ALL.into_iter().enumerate() {
            assert_eq!(entry as usize, index);
            assert_eq!(entry.dual().dual(), entry);
            assert_eq!(entry.dual().freedom(), entry.freedom());
            assert_ne!(entry.dual().is_force(), entry.is_force());
            assert_eq!(entry.freedom().count(), 1);
        }
    }
}
