//! State vectors, their spaces, and supports: which entries exist, in which order, and which are zero.
//!
//! The sign convention is that of Fig. 1 of the paper: an output state is used as the next input state without any
//! change of sign.

use crate::number::scalar::Scalar;
use nalgebra::SMatrix;

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

/// A state vector of planar bending; of a translation or rotation path half of the entries are zero.
///
/// With x along the arrows of the sketch, signs are those of a beam at rest: `Θ = Y'`, `M = EI Θ'`, `Q = M'`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State<S> {
    /// Deflection Y \[m\]
    pub y: S,
    /// Rotation Θ \[rad\]
    pub theta: S,
    /// Bending moment M [N m]
    pub m: S,
    /// Shear force Q \[N\]
    pub q: S,
}

impl<S: Scalar> State<S> {
    /// Each entry through one function.
    pub(crate) fn map<R>(self, f: impl Fn(S) -> R) -> State<R> {
        State { y: f(self.y), theta: f(self.theta), m: f(self.m), q: f(self.q) }
    }

    /// Seen against the x-axis: slope and shear force change their signs.
    pub(crate) fn backwards(self) -> Self {
        State { theta: -self.theta, q: -self.q, ..self }
    }

    /// Size of the largest entry, of whatever unit.
    pub(crate) fn size(&self) -> f64 {
        self.y.size().max(self.theta.size()).max(self.m.size()).max(self.q.size())
    }

    /// The state plus another times a factor.
    pub(crate) fn plus(self, other: State<S>, factor: S) -> Self {
        State {
            y: self.y + other.y * factor,
            theta: self.theta + other.theta * factor,
            m: self.m + other.m * factor,
            q: self.q + other.q * factor,
        }
    }

    /// An entry; X and Qx are those of planar states, and zero here.
    pub(crate) fn entry(&self, coordinate: Coordinate) -> S {
        match coordinate {
            Coordinate::Y => self.y,
            Coordinate::Theta => self.theta,
            Coordinate::M => self.m,
            Coordinate::Q => self.q,
            Coordinate::X | Coordinate::Qx => S::zero(),
        }
    }
}

/// The space of a state vector: displacements first, forces second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// `[Y, Q]`
    Translation,
    /// `[Θ, M]`
    Rotation,
    /// `[Y, Θ, M, Q]`
    Bending,
    /// `[X, Y, Θ, M, Qx, Qy]`
    Planar,
}

impl Space {
    /// The entries of a state of this space, in order.
    #[inline]
    pub const fn coordinates(self) -> &'static [Coordinate] {
        match self {
            Space::Translation => &[Y, Q],
            Space::Rotation => &[Theta, M],
            Space::Bending => &[Y, Theta, M, Q],
            Space::Planar => &[X, Y, Theta, M, Qx, Q],
        }
    }

    /// Number of entries `n_s`.
    #[inline]
    pub const fn size(self) -> usize {
        self.coordinates().len()
    }

    /// The displacements of this space.
    #[inline]
    pub const fn displacements(self) -> &'static [Coordinate] {
        self.coordinates().split_at(self.size() / 2).0
    }

    /// The smallest space that holds the states of both; `None` where they cannot meet at a connection.
    #[inline]
    pub const fn join(self, other: Space) -> Option<Space> {
        match (self, other) {
            (Space::Planar, Space::Planar) => Some(Space::Planar),
            (Space::Planar, _) | (_, Space::Planar) => None,
            (Space::Translation, Space::Translation) => Some(Space::Translation),
            (Space::Rotation, Space::Rotation) => Some(Space::Rotation),
            _ => Some(Space::Bending),
        }
    }

    /// Whether two spaces are the same; `==` is not available in constants.
    #[inline]
    pub const fn is(self, other: Space) -> bool {
        self as usize == other as usize
    }
}

/// A state space as a type: gives the shape of the transfer matrices of its elements.
pub trait StateSpace {
    /// The space as a value.
    const SPACE: Space;
    /// A square matrix over states of this space.
    type Matrix<S: Scalar>;

    /// Takes a state through a transfer matrix; the state is indexed by [`Coordinate`].
    #[doc(hidden)]
    fn transfer<S: Scalar>(matrix: &Self::Matrix<S>, state: &mut [S; WIDEST]);
}

/// Number of entries of the widest state.
pub(crate) const WIDEST: usize = Space::Planar.size();

/// Declares the marker type of a space.
macro_rules! state_space {
    ($(#[$doc:meta])* $name:ident, $size:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        impl StateSpace for $name {
            const SPACE: Space = Space::$name;
            type Matrix<S: Scalar> = SMatrix<S, $size, $size>;

            #[inline]
            fn transfer<S: Scalar>(matrix: &Self::Matrix<S>, state: &mut [S; WIDEST]) {
                let coordinates = Self::SPACE.coordinates();
                let input: [S; $size] = core::array::from_fn(|k| state[coordinates[k] as usize]);
                for (row, &coordinate) in coordinates.iter().enumerate() {
                    let mut sum = S::zero();
                    for (column, &entry) in input.iter().enumerate() {
                        sum += matrix[(row, column)] * entry;
                    }
                    state[coordinate as usize] = sum;
                }
            }
        }
    };
}

state_space!(
    /// States `[Y, Q]`: deflection and shear force.
    Translation, 2
);
state_space!(
    /// States `[Θ, M]`: rotation and moment.
    Rotation, 2
);
state_space!(
    /// States `[Y, Θ, M, Q]`: planar bending.
    Bending, 4
);
state_space!(
    /// States `[X, Y, Θ, M, Qx, Qy]`: planar motion with bending and longitudinal vibration.
    Planar, 6
);

/// A boundary condition: which half of a state is zero (Table 1 of the paper).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// All displacements are zero.
    Fixed,
    /// Displacements and moment are zero; the rotation is free.
    Pinned,
    /// All forces are zero.
    Free,
    /// Rotation and shear force are zero; in planar states X, Θ and Qy.
    Guided,
    /// Planar states only: Y, M and Qx are zero.
    Roller,
}

impl Support {
    /// Whether a displacement is zero at this support of a state of some space.
    pub(crate) const fn fixes(self, displacement: Coordinate, space: Space) -> bool {
        let Some(unknowns) = self.unknowns(space) else { return false };
        let mut k = 0;
        while k < unknowns.len() {
            if unknowns[k] as usize == displacement as usize {
                return false;
            }
            k += 1;
        }
        true
    }

    /// The entries that are unknown at this support, in the order of the state; `None` where states of that space
    /// have no such support.
    ///
    /// # Source
    /// Table 1 of the paper.
    #[inline]
    pub const fn unknowns(self, space: Space) -> Option<&'static [Coordinate]> {
        Some(match (space, self) {
            (Space::Translation, Support::Fixed) => &[Q],
            (Space::Translation, Support::Free) => &[Y],
            (Space::Rotation, Support::Fixed) => &[M],
            (Space::Rotation, Support::Free) => &[Theta],
            (Space::Bending, Support::Fixed) => &[M, Q],
            (Space::Bending, Support::Pinned) => &[Theta, Q],
            (Space::Bending, Support::Free) => &[Y, Theta],
            (Space::Bending, Support::Guided) => &[Y, M],
            (Space::Planar, Support::Fixed) => &[M, Qx, Q],
            (Space::Planar, Support::Pinned) => &[Theta, Qx, Q],
            (Space::Planar, Support::Free) => &[X, Y, Theta],
            (Space::Planar, Support::Guided) => &[Y, M, Qx],
            (Space::Planar, Support::Roller) => &[X, Theta, Q],
            (Space::Translation | Space::Rotation, _) | (Space::Bending, Support::Roller) => return None,
        })
    }
}
