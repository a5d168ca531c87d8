//! Parts join the front: each is a symmetric matrix of balls over rows of variables, and a count with its rows held.

use crate::element::{BeamNumbers, Exact, LineNumbers, TaperedNumbers};
use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, bending};
use crate::proof::front::Front;
use crate::proof::functions::Level;
use crate::proof::general_bending::general_bending;
use crate::proof::line::line;
use crate::proof::member::{Member, any, place};
use crate::proof::number::Number;
use crate::proof::row::{Row, is_zero};
use crate::proof::tapered::pieces;
use crate::proof::word::Word;

/// Most members beside a pole that may join before a node leaves.
const MOST_BORDERS: usize = 48;

/// A front with what has joined it at a frequency.
#[derive(Debug)]
pub(crate) struct Joining<'m, N: Number> {
    pub(crate) front: Front<'m, N>,
    /// ω², of either sign.
    pub(crate) square: Ball<N>,
    /// The sum of the counts with held ends: of upper bounds in lanes that are bounded from above, of lower ones in the others.
    pub(crate) held: N::Word,
    /// Variables of borders that have not left yet.
    borders: [usize; MOST_BORDERS],
    border_count: usize,
    /// Why nothing is known; none so far.
    pub(crate) failure: Option<Failure>,
}

/// Why a bound is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The front has no place for another variable.
    Full,
    /// A part is known by its transfer matrix alone.
    NotInNumbers,
    /// A part has no enclosure at this frequency.
    NotEnclosed,
    /// Whether one of the freedoms at a step is held twice is not decided.
    Redundant(usize),
}

impl<'m, N: Level> Joining<'m, N> {
    /// A front that nothing has joined.
    #[inline(always)]
    pub(crate) fn new(front: Front<'m, N>, square: Ball<N>) -> Self {
        let held = N::Word::of(0.0);
        Joining { front, square, held, borders: [0; MOST_BORDERS], border_count: 0, failure: None }
    }

    /// Takes a place for a variable.
    #[inline(always)]
    pub(crate) fn enter(&mut self) -> usize {
        self.front.enter().unwrap_or_else(|| {
            self.failure = Some(Failure::Full);
            0
        })
    }

    /// Puts a combination of other variables in the place of one.
    #[inline(never)]
    pub(crate) fn substitute(&mut self, variable: usize, by: &Row<N>) {
        self.front.substitute(variable, by.terms());
    }

    /// Adds `k row²`.
    #[inline(always)]
    pub(crate) fn add_term(&mut self, k: Ball<N>, row: &Row<N>) {
        if !is_zero(&k) {
            self.add([k], &[*row], [k.mid.size().first()]);
        }
    }

    /// Adds a matrix over rows, given the sizes of the stiffnesses of these.
    #[inline(never)]
    pub(crate) fn add<const F: usize, const E: usize>(
        &mut self,
        stiffness: [Ball<N>; E],
        rows: &[Row<N>; F],
        sizes: [f64; F],
    ) {
        for (row, size) in rows.iter().zip(sizes) {
            for term in row.terms() {
                let square = term.coefficient.mid.size().first();
                self.front.grow(term.variable, size * square * square);
            }
        }
        for a in 0..F {
            for b in 0..=a {
                let entry = stiffness[place(a, b)];
                if is_zero(&entry) {
                    continue;
                }
                for (i, first) in rows[a].terms().iter().enumerate() {
                    let scaled = first.times(entry);
                    for (j, second) in rows[b].terms().iter().enumerate() {
                        if a == b && j > i {
                            break;
                        }
                        let term = second.times(scaled);
                        // an entry between two rows stands twice in the form
                        let is_double = a != b && first.variable == second.variable;
                        let term = if is_double { term.scaled(2.0) } else { term };
                        self.front.add(first.variable, second.variable, term);
                    }
                }
            }
        }
    }

    /// Adds a member, in the units of its displacements' stiffnesses, with its border.
    #[inline(never)]
    fn add_member<const F: usize, const E: usize>(
        &mut self,
        member: &Member<N, F, E>,
        rows: &[Row<N>; F],
        factors: [Ball<N>; 3],
        is_rotation: [bool; F],
    ) {
        // force per displacement, force per rotation or moment per displacement, moment per rotation
        let factor = |a: usize, b: usize| factors[usize::from(is_rotation[a]) + usize::from(is_rotation[b])];
        let mut stiffness = member.stiffness;
        let mut sizes = member.sizes;
        for a in 0..F {
            for b in 0..=a {
                stiffness[place(a, b)] = stiffness[place(a, b)] * factor(a, b);
            }
            sizes[a] *= factor(a, a).mid.size().first();
        }
        self.add(stiffness, rows, sizes);
        let upper = self.front.is_bounded_above();
        self.held = self.held + N::Word::select(upper, member.held[1], member.held[0]);
        self.front.total.multiply(member.minor);
        let Some(border) = member.border else { return };
        let variable = self.enter();
        self.front.grow(variable, sizes[0]);
        self.front.add(variable, variable, -(border.flexibility * factors[0]));
        for a in 0..F {
            // the displacement of a rotation is its lever: one factor for the force, of which the other half is in σ
            let force = border.forces[a] * factors[usize::from(is_rotation[a])];
            for term in rows[a].terms() {
                self.front.add(variable, term.variable, term.times(force));
            }
        }
        self.leaves_behind(variable);
    }

    /// Lets a variable leave behind those of the end that leaves first.
    #[inline(always)]
    fn leaves_behind(&mut self, variable: usize) {
        if self.border_count < MOST_BORDERS {
            self.borders[self.border_count] = variable;
            self.border_count += 1;
        } else {
            self.failure = Some(Failure::Full);
        }
    }

    /// Eliminates the borders of all members, once the variables of their first ends have left: before that their pivots are the poles.
    #[inline(always)]
    pub(crate) fn leave_borders(&mut self) {
        for k in 0..self.border_count {
            self.front.leave(self.borders[k]);
        }
        self.border_count = 0;
    }

    /// Adds a line over the rows of its ends.
    #[inline(never)]
    pub(crate) fn add_line(&mut self, numbers: &LineNumbers, length: Ball<N>, rows: &[Row<N>; 2]) {
        let over = length * Ball::of_pair(numbers.stiffness).inverse();
        let inertia = Ball::of_pair(numbers.inertia) * self.square;
        let loads = if numbers.foundation == [0.0; 2] { inertia } else { inertia - Ball::of_pair(numbers.foundation) };
        let member = line(loads * (length * over));
        let stiffness = over.inverse();
        self.add_member(&member, rows, [stiffness; 3], [false; 2]);
    }

    /// Adds the bending of a beam over the rows of displacement and rotation of both ends.
    #[inline(never)]
    pub(crate) fn add_bending(&mut self, numbers: &BeamNumbers, length: Ball<N>, rows: &[Row<N>; 4]) {
        if numbers.is_plain() {
            return self.add_plain_bending(numbers, length, rows);
        }
        let whole = general_bending(numbers, length, self.square);
        if !any::<N::Word>(whole.is_beside_pole) {
            return self.add_bent(&whole.member, &numbers.bending_stiffness, length, rows);
        }
        // Beside a pole the beam is two beams. Not of equal length: every second pole of the whole is one of a half.
        let variables = [self.enter(), self.enter()];
        let middle = variables.map(Row::of);
        let part = |share: f64| length * Ball::of(share);
        for (share, rows) in
            [(0.375, [rows[0], rows[1], middle[0], middle[1]]), (0.625, [middle[0], middle[1], rows[2], rows[3]])]
        {
            let piece = general_bending(numbers, part(share), self.square);
            self.add_bent(&piece.member, &numbers.bending_stiffness, part(share), &rows);
        }
        variables.into_iter().for_each(|variable| self.leaves_behind(variable));
    }

    /// Adds the bending of a plain beam.
    #[inline(never)]
    fn add_plain_bending(&mut self, numbers: &BeamNumbers, length: Ball<N>, rows: &[Row<N>; 4]) {
        let square = length * length;
        let mass = Ball::of_pair(numbers.mass_per_length) * self.square;
        let x = mass * (square * square * Ball::of_pair(numbers.bending_stiffness).inverse());
        self.add_bent(&bending(x), &numbers.bending_stiffness, length, rows);
    }

    /// Adds the bending of a beam, known over `EI/l³`.
    #[inline(always)]
    fn add_bent(&mut self, member: &Bending<N>, stiffness: &Exact, length: Ball<N>, rows: &[Row<N>; 4]) {
        let inverse = length.inverse();
        let moment = Ball::of_pair(*stiffness) * inverse;
        let mixed = moment * inverse;
        self.add_member(member, rows, [mixed * inverse, mixed, moment], [false, true, false, true]);
    }

    /// Adds a stiffness between two rows that nobody has proven, with its count with held ends.
    #[inline(never)]
    pub(crate) fn add_counted(&mut self, stiffness: [Exact; 3], held: f64, rows: &[Row<N>; 2]) {
        let stiffness: [Ball<N>; 3] = stiffness.map(Ball::of_pair);
        let size = stiffness.map(|entry| entry.mid.size().first());
        self.add(stiffness, rows, [size[0].max(size[1]), size[2].max(size[1])]);
        self.held = self.held + N::Word::of(held);
    }

    /// Adds a tapered beam piece by piece. The last inner end leaves behind the first end of the beam: before that its pivot is a pole where
    /// the beam vibrates between held ends.
    #[inline(never)]
    pub(crate) fn add_tapered(&mut self, numbers: &TaperedNumbers, rows: &[Row<N>; 4]) {
        let (mut input, mut inner) = ([rows[0], rows[1]], None::<[usize; 2]>);
        let found = pieces(numbers, self.square, &mut |piece, is_last| {
            let variables = (!is_last).then(|| [self.enter(), self.enter()]);
            let output = variables.map_or([rows[2], rows[3]], |variables| variables.map(Row::of));
            let one = Ball::of(1.0);
            self.add_member(&piece, &[input[0], input[1], output[0], output[1]], [one; 3], [false; 4]);
            for variable in inner.into_iter().flatten() {
                if is_last { self.leaves_behind(variable) } else { self.front.leave(variable) }
            }
            (input, inner) = (output, variables);
        });
        if found.is_none() {
            self.failure = Some(Failure::NotEnclosed);
        }
    }

    /// Adds a spring, or another stiffness, between two rows.
    #[inline(never)]
    pub(crate) fn add_spring(&mut self, stiffness: Exact, rows: [&Row<N>; 2]) {
        let mut elongation = *rows[1];
        elongation.add(rows[0], Ball::of(-1.0));
        self.add_term(Ball::of_pair(stiffness), &elongation);
    }

    /// Adds the inertia of a body over rows of displacement and rotation of a point, given its mass, its mass moment and its moment of inertia
    /// about the point.
    #[inline(never)]
    pub(crate) fn add_inertia(&mut self, [mass, moment, inertia]: [Ball<N>; 3], rows: &[Row<N>; 2]) {
        let entries = [mass, moment, inertia].map(|entry| if is_zero(&entry) { entry } else { -(entry * self.square) });
        let sizes = [entries[0], entries[2]].map(|entry| entry.mid.size().first());
        self.add(entries, rows, sizes);
    }
}
