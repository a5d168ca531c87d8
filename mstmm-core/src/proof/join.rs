//! What the parts of a model join, row by row: the front of a count, or the matrix of a disc.

use crate::element::{BeamNumbers, DampingNumbers, Exact, LineNumbers, SpinNumbers, TaperedNumbers};
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::row::{Row, Term};

/// What parts join.
pub(crate) trait Join: Sized {
    /// The numbers of rows.
    type Alone: Level<Word = f64, Alone = Self::Alone>;

    /// The node or the step whose variables leave next.
    fn stands_at(&mut self, place: usize);
    /// Nothing is known from here on.
    fn fail(&mut self, failure: Failure);
    /// Whether nothing is known.
    fn has_failed(&self) -> bool;

    /// Takes a place for a variable.
    fn enter(&mut self) -> usize;
    /// No part knows a variable any more.
    fn leave(&mut self, variable: usize);
    /// Variables that wait behind others may leave.
    fn leave_behind(&mut self);
    /// Puts a combination of other variables in the place of one, which no part knows any more.
    fn substitute(&mut self, variable: usize, by: &[Term<Self::Alone>]);

    /// Adds `k row²`.
    fn add_term(&mut self, k: Ball<Self::Alone>, row: &[Term<Self::Alone>]);
    /// Adds a spring between the two rows whose difference is given, with its damping.
    fn add_damped_term(&mut self, spring: (&Exact, &DampingNumbers), row: &[Term<Self::Alone>]);
    /// Adds `λ² m row²`.
    fn add_mass(&mut self, mass: Exact, row: &[Term<Self::Alone>]);
    /// Adds the inertia of a body over rows of displacement and rotation of a point, given its mass, its mass moment and its moment of inertia
    /// about the point.
    fn add_inertia(&mut self, inertia: [Ball<Self::Alone>; 3], rows: [&[Term<Self::Alone>]; 2]);
    /// Adds the inertia of a body over the rows of its three rotations, given the lower triangle of its tensor.
    fn add_tensor(&mut self, tensor: [Ball<Self::Alone>; 6], rows: [&[Term<Self::Alone>]; 3]);
    /// Adds the gyroscopic moment of what spins over the row of its rotation.
    fn add_spin(&mut self, spin: &SpinNumbers, row: &[Term<Self::Alone>]);
    /// Adds a line over the rows of its ends.
    fn add_line(
        &mut self,
        line: (&LineNumbers, &DampingNumbers),
        length: Ball<Self::Alone>,
        rows: [&[Term<Self::Alone>]; 2],
    );
    /// Adds the bending of a beam over the rows of displacement and rotation of both ends.
    fn add_bending(
        &mut self,
        beam: (&BeamNumbers, &DampingNumbers, &SpinNumbers),
        length: Ball<Self::Alone>,
        rows: [&[Term<Self::Alone>]; 4],
    );
    /// Adds a tapered beam.
    fn add_tapered(&mut self, numbers: &TaperedNumbers, length: Ball<Self::Alone>, rows: [&[Term<Self::Alone>]; 4]);
    /// Adds a stiffness between two rows that nobody has proven, with its count with held ends.
    fn add_counted(&mut self, stiffness: [Exact; 3], held: f64, rows: [&[Term<Self::Alone>]; 2]);
    /// Adds the force of a rigid joint over the displacements that are equal. Returns its variable.
    fn add_tie(&mut self, gap: &[Term<Self::Alone>]) -> usize;

    /// Adds a spring, or another stiffness, between two rows.
    #[inline(never)]
    fn add_spring<const T: usize, const TWO: usize>(
        &mut self,
        spring: (&Exact, &DampingNumbers),
        [first, second]: [&Row<Self::Alone, T>; 2],
    ) {
        let mut elongation = second.widened::<TWO>();
        elongation.add(first, Ball::of(-1.0));
        self.add_damped_term(spring, elongation.terms());
    }
}

/// Why nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// There is no place for another variable.
    Full,
    /// A part is known by its transfer matrix alone.
    NotInNumbers,
    /// A part has no enclosure at this frequency.
    NotEnclosed,
    /// Whether one of the freedoms at a step is held twice is not decided.
    Redundant(usize),
}
