//! The dynamic stiffness of a model at complex frequencies, in balls: parts are added, no variable is eliminated.

use crate::element::{BeamNumbers, DampingNumbers, Exact, LineNumbers, SpinNumbers, TaperedNumbers};
use crate::proof::ball::Ball;
use crate::proof::disc::bending::bending;
use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::general::Piece;
use crate::proof::disc::line::line;
use crate::proof::disc::member::{Frequency, Member};
use crate::proof::join::{Failure, Join};
use crate::proof::level::Level;
use crate::proof::member::place;
use crate::proof::row::{Row, Term, is_zero};

/// Where a member beside a pole is cut: exact parts of few bits. A pole of both parts is the 128th of the whole.
const CUT: [f64; 2] = [53.0 / 128.0, 75.0 / 128.0];

/// Most pieces of a general beam.
const MOST_PIECES: f64 = 256.0;

/// The matrix of a model.
#[derive(Debug)]
pub(crate) struct Matrix<'m, N> {
    /// The lower triangle, row after row; empty where variables are counted alone.
    pub(crate) entries: &'m mut [ComplexBall<N>],
    /// Whether a place has a variable.
    pub(crate) is_taken: &'m mut [bool],
    /// Number of places that are in use or were.
    pub(crate) width: usize,
    /// The frequencies.
    at: Frequency<N>,
    /// The one frequency by which members are cut: the matrix is analytic, since it is put together in the same way at all others.
    centre: Frequency<N>,
    /// Why nothing is known; none so far.
    pub(crate) failure: Option<Failure>,
}

/// The terms of a row.
type Terms<'r, N> = &'r [Term<<N as Level>::Alone>];

/// Displacement and rotation of a point.
type Point<'r, N> = [Terms<'r, N>; 2];

/// Adds a part of a beam, given its index and its rows.
type AddPart<'f, 'm, N> = dyn FnMut(&mut Matrix<'m, N>, usize, [Terms<'_, N>; 4]) + 'f;

impl<'m, N: Level<Word = f64, Alone = N>> Matrix<'m, N> {
    /// A matrix that nothing has joined.
    pub(crate) fn new(
        entries: &'m mut [ComplexBall<N>],
        is_taken: &'m mut [bool],
        [lambda, centre]: [ComplexBall<N>; 2],
    ) -> Self {
        let [at, centre] = [lambda, centre].map(Frequency::new);
        Matrix { entries, is_taken, width: 0, at, centre, failure: None }
    }

    /// Adds a ball to an entry and to its mirror image.
    fn add(&mut self, row: usize, column: usize, ball: ComplexBall<N>) {
        if let Some(entry) = self.entries.get_mut(place(row, column)) {
            *entry = *entry + ball;
        }
    }

    /// Adds a matrix over rows.
    fn add_all<const F: usize, const E: usize>(&mut self, stiffness: &[ComplexBall<N>; E], rows: &[Terms<'_, N>; F]) {
        for a in 0..F {
            for b in 0..=a {
                for (i, first) in rows[a].iter().enumerate() {
                    let scaled = stiffness[place(a, b)] * first.coefficient;
                    for (j, second) in rows[b].iter().enumerate() {
                        if a == b && j > i {
                            break;
                        }
                        let term = scaled * second.coefficient;
                        // an entry between two rows stands twice in the form
                        let is_double = a != b && first.variable == second.variable;
                        self.add(first.variable, second.variable, if is_double { term.scaled(2.0) } else { term });
                    }
                }
            }
        }
    }

    /// Adds a member whose entries are over a stiffness, and those of rotations over powers of a length.
    fn add_member<const F: usize, const E: usize>(
        &mut self,
        member: &Member<N, E>,
        factor: ComplexBall<N>,
        lever: Option<Ball<N>>,
        rows: &[Terms<'_, N>; F],
    ) {
        if !member.is_known() {
            self.failure = Some(Failure::NotEnclosed);
        }
        let mut stiffness = member.stiffness;
        for a in 0..F {
            for b in 0..=a {
                let entry = &mut stiffness[place(a, b)];
                *entry = *entry * factor;
                for _ in 0..a % 2 + b % 2 {
                    lever.iter().for_each(|lever| *entry = *entry * *lever);
                }
            }
        }
        self.add_all(&stiffness, rows);
    }

    /// Adds the bending of a beam in so many parts, whose ends but the outer ones are variables; `each` adds a part.
    fn in_parts(&mut self, count: usize, rows: [Terms<'_, N>; 4], each: &mut AddPart<'_, 'm, N>) {
        let mut input = None::<[Row<N, 1>; 2]>;
        for part in 0..count {
            let output = (part + 1 < count).then(|| [self.enter(), self.enter()].map(Row::<N, 1>::of));
            let point = |own: &Option<[Row<N, 1>; 2]>, outer: Point<'_, N>, add: &mut dyn FnMut(Point<'_, N>)| match own
            {
                Some([y, theta]) => add([y.terms(), theta.terms()]),
                None => add(outer),
            };
            point(&input, [rows[0], rows[1]], &mut |first| {
                point(&output, [rows[2], rows[3]], &mut |second| {
                    each(self, part, [first[0], first[1], second[0], second[1]]);
                });
            });
            input = output;
        }
    }

    /// Adds a plain beam of a length.
    fn add_plain(&mut self, beam: (&BeamNumbers, &DampingNumbers), length: Ball<N>, rows: [Terms<'_, N>; 4]) {
        let [factor, x] = self.at.of_beam(beam, length);
        self.add_member(&bending(x), factor, Some(length), &rows);
    }
}

impl<N: Level<Word = f64, Alone = N>> Join for Matrix<'_, N> {
    type Alone = N;

    fn stands_at(&mut self, _: usize) {}

    fn fail(&mut self, failure: Failure) {
        self.failure = Some(failure);
    }

    fn has_failed(&self) -> bool {
        self.failure.is_some()
    }

    fn enter(&mut self) -> usize {
        let free = self.is_taken.iter().take(self.width).position(|is_taken| !is_taken);
        let variable = free.unwrap_or(self.width);
        let Some(is_taken) = self.is_taken.get_mut(variable) else {
            self.failure = Some(Failure::Full);
            return 0;
        };
        *is_taken = true;
        self.width = self.width.max(variable + 1);
        for other in 0..self.width {
            if let Some(entry) = self.entries.get_mut(place(variable, other)) {
                *entry = ComplexBall::of(0.0);
            }
        }
        variable
    }

    fn leave(&mut self, _: usize) {}

    fn leave_behind(&mut self) {}

    fn substitute(&mut self, variable: usize, by: &[Term<N>]) {
        self.is_taken[variable] = false;
        if self.entries.is_empty() {
            return;
        }
        let diagonal = self.entries[place(variable, variable)];
        for other in 0..self.width {
            if other == variable || !self.is_taken[other] {
                continue;
            }
            let beside = self.entries[place(other, variable)];
            for term in by {
                let product = beside * term.coefficient;
                self.add(term.variable, other, if term.variable == other { product.scaled(2.0) } else { product });
            }
        }
        self.add_all(&[diagonal], &[by]);
    }

    fn add_term(&mut self, k: Ball<N>, row: &[Term<N>]) {
        if !is_zero(&k) {
            self.add_all(&[ComplexBall::real(k)], &[row]);
        }
    }

    fn add_damped_term(&mut self, (stiffness, damping): (&Exact, &DampingNumbers), row: &[Term<N>]) {
        self.add_all(&[self.at.spring(stiffness, damping)], &[row]);
    }

    fn add_mass(&mut self, mass: Exact, row: &[Term<N>]) {
        if mass != [0.0; 2] {
            self.add_all(&[self.at.square * Ball::of_pair(mass)], &[row]);
        }
    }

    fn add_inertia(&mut self, inertia: [Ball<N>; 3], rows: [&[Term<N>]; 2]) {
        self.add_all(&inertia.map(|inertia| self.at.square * inertia), &rows);
    }

    fn add_tensor(&mut self, tensor: [Ball<N>; 6], rows: [&[Term<N>]; 3]) {
        self.add_all(&tensor.map(|entry| self.at.square * entry), &rows);
    }

    fn add_spin(&mut self, spin: &SpinNumbers, row: &[Term<N>]) {
        if !spin.is_none() {
            self.add_all(&[self.at.moment(spin)], &[row]);
        }
    }

    fn add_line(&mut self, numbers: (&LineNumbers, &DampingNumbers), length: Ball<N>, rows: [&[Term<N>]; 2]) {
        let [_, y] = self.centre.of_line(numbers, length);
        let middle = line(y).is_beside_pole().then(|| Row::<N, 1>::of(self.enter()));
        let mut add = |length: Ball<N>, rows: [Terms<'_, N>; 2]| {
            let [factor, y] = self.at.of_line(numbers, length);
            self.add_member(&line(y), factor, None, &rows);
        };
        match &middle {
            None => add(length, rows),
            Some(middle) => {
                let [first, second] = CUT.map(|part| length * Ball::of(part));
                add(first, [rows[0], middle.terms()]);
                add(second, [middle.terms(), rows[1]]);
            }
        }
    }

    fn add_bending(
        &mut self,
        (numbers, damping, spin): (&BeamNumbers, &DampingNumbers, &SpinNumbers),
        length: Ball<N>,
        rows: [&[Term<N>]; 4],
    ) {
        let beam = (numbers, damping);
        if numbers.bends_alone() && spin.is_none() {
            let [_, x] = self.centre.of_beam(beam, length);
            if !bending(x).is_beside_pole() {
                return self.add_plain(beam, length, rows);
            }
            let parts = CUT.map(|part| length * Ball::of(part));
            return self.in_parts(2, rows, &mut |matrix, part, rows| matrix.add_plain(beam, parts[part], rows));
        }
        let count = Piece::of(&self.centre, (numbers, damping, spin), length).count();
        if count.is_nan() || count >= MOST_PIECES {
            self.failure = Some(Failure::NotEnclosed);
            return;
        }
        let count = count as usize;
        let part = length * Ball::of(count as f64).inverse();
        let piece = Piece::of(&self.at, (numbers, damping, spin), part);
        let member = piece.stiffness();
        self.in_parts(count, rows, &mut |matrix, _, rows| {
            matrix.add_member(&member, piece.factor, Some(part), &rows);
        });
    }

    fn add_tapered(&mut self, _: &TaperedNumbers, _: Ball<N>, _: [&[Term<N>]; 4]) {
        self.failure = Some(Failure::NotEnclosed);
    }

    fn add_counted(&mut self, _: [Exact; 3], _: f64, _: [&[Term<N>]; 2]) {
        self.failure = Some(Failure::NotInNumbers);
    }

    fn add_tie(&mut self, gap: &[Term<N>]) -> usize {
        let force = self.enter();
        for term in gap {
            self.add(force, term.variable, ComplexBall::real(term.coefficient));
        }
        force
    }
}
