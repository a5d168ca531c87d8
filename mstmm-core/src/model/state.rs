//! State vectors and the types of their spaces.
//!
//! The sign convention is that of Fig. 1 of the paper: an output state is used as the next input state without any
//! change of sign.

use crate::number::{Scalar, Single};
use mstmm_plan::WIDEST;
use nalgebra::SMatrix;

use mstmm_plan::{Coordinate, Space};

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

impl<S: Single> State<S> {
    /// Returns the size of the largest entry, whatever its unit.
    pub(crate) fn size(&self) -> f64 {
        self.y.size().max(self.theta.size()).max(self.m.size()).max(self.q.size())
    }
}

impl<S: Scalar> State<S> {
    /// Maps each entry by one function.
    pub(crate) fn map<R>(self, f: impl Fn(S) -> R) -> State<R> {
        State { y: f(self.y), theta: f(self.theta), m: f(self.m), q: f(self.q) }
    }

    /// Turns the x-axis round: slope and shear force change their signs.
    pub(crate) fn backwards(self) -> Self {
        State { theta: -self.theta, q: -self.q, ..self }
    }

    /// Adds another state times a factor.
    pub(crate) fn plus(self, other: State<S>, factor: S) -> Self {
        State {
            y: self.y + other.y * factor,
            theta: self.theta + other.theta * factor,
            m: self.m + other.m * factor,
            q: self.q + other.q * factor,
        }
    }

    /// Returns an entry; X and Qx belong to planar states, and are zero here.
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
                let coordinates = const { Self::SPACE.coordinates() };
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
