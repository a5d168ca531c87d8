//! Parts join the front: each is a symmetric matrix of balls over rows of variables, and a count with its rows held.

use crate::element::{BeamNumbers, Exact, LineNumbers, TaperedNumbers};
use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, bending};
use crate::proof::front::Front;
use crate::proof::general_bending::general_bending;
use crate::proof::level::Level;
use crate::proof::line::line;
use crate::proof::member::{Member, place};
use crate::proof::number::Number;
use crate::proof::row::{Row, TERMS, Term, is_zero};
use crate::proof::tapered::pieces;
use crate::proof::word::{MOST_LANES, Word, apart};

/// The terms of a row.
pub(crate) type Terms<'r, N> = &'r [Term<<N as Level>::Alone>];

/// Most variables that wait; others leave at once, which is valid in any order.
const MOST_WAITING: usize = 48;

/// A front with what has joined it at a frequency.
#[derive(Debug)]
pub(crate) struct Joining<'m, N: Number> {
    pub(crate) front: Front<'m, N>,
    /// ω², of either sign.
    pub(crate) square: Ball<N>,
    /// The sum of the counts with held ends: of upper bounds in lanes that are bounded from above, of lower ones in the others.
    pub(crate) held: N::Word,
    /// Variables that leave behind others, borders and those with small pivots, each with the node or the step where it would have left.
    waiting: [(usize, usize); MOST_WAITING],
    waiting_count: usize,
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
        Joining { front, square, held, waiting: [(0, 0); MOST_WAITING], waiting_count: 0, failure: None }
    }

    /// Takes a place for a variable.
    #[inline(always)]
    pub(crate) fn enter(&mut self) -> usize {
        self.front.enter().unwrap_or_else(|| {
            self.failure = Some(Failure::Full);
            0
        })
    }

    /// Adds `k row²`.
    #[inline(always)]
    pub(crate) fn add_term(&mut self, k: Ball<N::Alone>, row: Terms<'_, N>) {
        if !is_zero(&k) {
            add_term(self, k, row);
        }
    }

    /// Adds `-ω² m row²`.
    #[inline(always)]
    pub(crate) fn add_mass(&mut self, mass: Exact, row: Terms<'_, N>) {
        if mass != [0.0; 2] {
            add_mass(self, mass, row);
        }
    }

    /// Eliminates a variable, now or, where its pivot is small, behind others.
    #[inline(always)]
    pub(crate) fn leave(&mut self, variable: usize) {
        if self.waiting_count == MOST_WAITING {
            self.front.leave(variable);
        } else if !self.front.leave_if_large(variable) {
            self.leaves_behind(variable);
        }
    }

    /// Lets a variable leave behind those of the end that leaves first: before that its pivot may be a pole.
    #[inline(always)]
    fn leaves_behind(&mut self, variable: usize) {
        if self.waiting_count < MOST_WAITING {
            self.waiting[self.waiting_count] = (variable, self.front.total.place);
            self.waiting_count += 1;
        } else {
            self.front.leave(variable);
        }
    }

    /// Eliminates those variables that wait and have no small pivot any more.
    pub(crate) fn leave_behind(&mut self) {
        let mut kept = 0;
        for k in 0..self.waiting_count {
            if !self.front.leave_if_large(self.waiting[k].0) {
                self.waiting[kept] = self.waiting[k];
                kept += 1;
            }
        }
        self.waiting_count = kept;
    }

    /// Eliminates all variables that wait, largest pivot first.
    pub(crate) fn leave_all(&mut self) {
        self.leave_behind();
        while self.waiting_count > 0 {
            let share = |k: &usize| self.front.share(self.waiting[*k].0);
            let largest = (0..self.waiting_count).max_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0);
            let (variable, place) = self.waiting[largest];
            self.front.total.place = place;
            self.front.leave(variable);
            self.waiting_count -= 1;
            self.waiting.swap(largest, self.waiting_count);
        }
    }

    /// Adds the bending of a beam over the rows of displacement and rotation of both ends.
    pub(crate) fn add_bending(&mut self, numbers: &BeamNumbers, length: Ball<N::Alone>, rows: [Terms<'_, N>; 4]) {
        if numbers.is_plain() {
            return add_plain_bending(self, numbers, length, rows);
        }
        let (whole, is_beside_pole) = general(self, numbers, length);
        if !is_beside_pole {
            return add_bent(self, &whole, &numbers.bending_stiffness, length, rows);
        }
        // Beside a pole the beam is two beams. Not of equal length: every second pole of the whole is one of a half.
        let variables = [self.enter(), self.enter()];
        let middle = variables.map(Row::<N::Alone, 1>::of);
        let part = |share: f64| length * Ball::of(share);
        let [y, theta] = [middle[0].terms(), middle[1].terms()];
        for (share, rows) in [(0.375, [rows[0], rows[1], y, theta]), (0.625, [y, theta, rows[2], rows[3]])] {
            let (piece, _) = general(self, numbers, part(share));
            add_bent(self, &piece, &numbers.bending_stiffness, part(share), rows);
        }
        variables.into_iter().for_each(|variable| self.leaves_behind(variable));
    }

    /// Adds a tapered beam piece by piece. The last inner end leaves behind the first end of the beam: before that its pivot is a pole where
    /// the beam vibrates between held ends. Its pieces depend on the frequency: in lanes nothing is known of it.
    #[inline(never)]
    pub(crate) fn add_tapered(&mut self, numbers: &TaperedNumbers, rows: [Terms<'_, N>; 4]) {
        if N::Word::LANES > 1 {
            self.failure = Some(Failure::NotEnclosed);
            return;
        }
        let (mut input, mut inner) = (None::<[Row<N::Alone, 1>; 2]>, None::<[usize; 2]>);
        let found = pieces::<N::Alone>(numbers, self.square.lane(0), &mut |piece, is_last| {
            let variables = (!is_last).then(|| [self.enter(), self.enter()]);
            let output = variables.map(|variables| variables.map(Row::of));
            let mut ends = rows;
            for (place, end) in [&input, &output].into_iter().enumerate() {
                if let Some([y, theta]) = end {
                    (ends[2 * place], ends[2 * place + 1]) = (y.terms(), theta.terms());
                }
            }
            add_member(self, &Member::of_lanes(&[piece]), &ends, &[Ball::of(1.0); 3], [false; 4]);
            for variable in inner.into_iter().flatten() {
                if is_last { self.leaves_behind(variable) } else { self.leave(variable) }
            }
            (input, inner) = (output, variables);
        });
        if found.is_none() {
            self.failure = Some(Failure::NotEnclosed);
        }
    }

    /// Adds a spring, or another stiffness, between two rows.
    #[inline(never)]
    pub(crate) fn add_spring<const T: usize>(&mut self, stiffness: Exact, [first, second]: [&Row<N::Alone, T>; 2]) {
        let mut elongation = second.widened::<{ TERMS }>();
        elongation.add(first, Ball::of(-1.0));
        self.add_term(Ball::of_pair(stiffness), elongation.terms());
    }
}

apart! {
    /// Adds a matrix over rows, given the sizes of the stiffnesses of these.
    fn add<N: Level, const F: usize, const E: usize>(
        joining: &mut Joining<'_, N>,
        stiffness: &[Ball<N>; E],
        rows: &[Terms<'_, N>; F],
        sizes: [f64; F],
    ) {
        let front = &mut joining.front;
        for (row, size) in rows.iter().zip(sizes) {
            for term in *row {
                let square = term.coefficient.mid.size();
                front.grow(term.variable, size * square * square);
            }
        }
        for a in 0..F {
            for b in 0..=a {
                let entry = stiffness[place(a, b)];
                if is_zero(&entry) {
                    continue;
                }
                for (i, first) in rows[a].iter().enumerate() {
                    let scaled = first.times(entry);
                    for (j, second) in rows[b].iter().enumerate() {
                        if a == b && j > i {
                            break;
                        }
                        let term = second.times(scaled);
                        // an entry between two rows stands twice in the form
                        let is_double = a != b && first.variable == second.variable;
                        let term = if is_double { term.scaled(2.0) } else { term };
                        front.add(first.variable, second.variable, term);
                    }
                }
            }
        }
    }

    /// Adds a member, in the units of its displacements' stiffnesses, with its border.
    fn add_member<N: Level, const F: usize, const E: usize>(
        joining: &mut Joining<'_, N>,
        member: &Member<N, F, E>,
        rows: &[Terms<'_, N>; F],
        factors: &[Ball<N::Alone>; 3],
        is_rotation: [bool; F],
    ) {
        // force per displacement, force per rotation or moment per displacement, moment per rotation
        let [force, mixed, moment] = *factors;
        let factors: [Ball<N>; 3] = [Ball::everywhere(force), Ball::everywhere(mixed), Ball::everywhere(moment)];
        let mut stiffness = member.stiffness;
        let mut sizes = member.sizes;
        for a in 0..F {
            for b in 0..=a {
                let factor = factors[usize::from(is_rotation[a]) + usize::from(is_rotation[b])];
                stiffness[place(a, b)] = stiffness[place(a, b)] * factor;
            }
            sizes[a] *= if is_rotation[a] { moment.mid.size() } else { force.mid.size() };
        }
        add(joining, &stiffness, rows, sizes);
        let upper = joining.front.is_bounded_above();
        joining.held = joining.held + N::Word::select(upper, member.held[1], member.held[0]);
        joining.front.total.multiply(member.minor);
        let Some(border) = &member.border else { return };
        let variable = joining.enter();
        joining.front.grow(variable, sizes[0]);
        joining.front.add(variable, variable, -(border.flexibility * factors[0]));
        for a in 0..F {
            // the displacement of a rotation is its lever: one factor for the force, of which the other half is in σ
            let force = border.forces[a] * factors[usize::from(is_rotation[a])];
            for term in rows[a] {
                joining.front.add(variable, term.variable, term.times(force));
            }
        }
        joining.leaves_behind(variable);
    }

    /// A general beam, lane by lane, and whether one of them is beside a pole.
    fn general<N: Level>(
        joining: &Joining<'_, N>,
        numbers: &BeamNumbers,
        length: Ball<N::Alone>,
    ) -> (Bending<N>, bool) {
        let first = general_bending(numbers, length, joining.square.lane(0));
        let (mut lanes, mut is_beside_pole) = ([first.member; MOST_LANES], first.is_beside_pole);
        for (lane, member) in lanes.iter_mut().enumerate().take(N::Word::LANES).skip(1) {
            let beam = general_bending(numbers, length, joining.square.lane(lane));
            *member = beam.member;
            is_beside_pole |= beam.is_beside_pole;
        }
        (Member::of_lanes(&lanes[..N::Word::LANES]), is_beside_pole)
    }

    /// Adds a stiffness between two rows that nobody has proven, with its count with held ends.
    pub(crate) fn add_counted<N: Level>(
        joining: &mut Joining<'_, N>,
        stiffness: [Exact; 3],
        held: f64,
        rows: [Terms<'_, N>; 2],
    ) {
        let [input, between, output] = stiffness;
        let stiffness = [Ball::<N>::of_pair(input), Ball::of_pair(between), Ball::of_pair(output)];
        let [input, between, output] = [input[0].abs(), between[0].abs(), output[0].abs()];
        add(joining, &stiffness, &rows, [input.max(between), output.max(between)]);
        joining.held = joining.held + N::Word::of(held);
    }

    /// Adds a line over the rows of its ends.
    pub(crate) fn add_line<N: Level>(
        joining: &mut Joining<'_, N>,
        numbers: &LineNumbers,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 2],
    ) {
        let over = length * Ball::of_pair(numbers.stiffness).inverse();
        let inertia = Ball::of_pair(numbers.inertia) * joining.square;
        let loads = if numbers.foundation == [0.0; 2] { inertia } else { inertia - Ball::of_pair(numbers.foundation) };
        let member = line(loads * Ball::everywhere(length * over));
        add_member(joining, &member, &rows, &[over.inverse(); 3], [false; 2]);
    }

    /// Adds the bending of a plain beam.
    fn add_plain_bending<N: Level>(
        joining: &mut Joining<'_, N>,
        numbers: &BeamNumbers,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 4],
    ) {
        let square = length * length;
        let of_mass = Ball::of_pair(numbers.mass_per_length)
            * (square * square * Ball::of_pair(numbers.bending_stiffness).inverse());
        let x = Ball::everywhere(of_mass) * joining.square;
        add_bent(joining, &bending(x), &numbers.bending_stiffness, length, rows);
    }

    /// Adds the bending of a beam, known over `EI/l³`.
    fn add_bent<N: Level>(
        joining: &mut Joining<'_, N>,
        member: &Bending<N>,
        stiffness: &Exact,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 4],
    ) {
        let inverse = length.inverse();
        let moment = Ball::of_pair(*stiffness) * inverse;
        let mixed = moment * inverse;
        add_member(joining, member, &rows, &[mixed * inverse, mixed, moment], [false, true, false, true]);
    }

    /// See [`Joining::add_term`].
    fn add_term<N: Level>(joining: &mut Joining<'_, N>, k: Ball<N::Alone>, row: Terms<'_, N>) {
        add(joining, &[Ball::everywhere(k)], &[row], [k.mid.size()]);
    }

    /// See [`Joining::add_mass`].
    fn add_mass<N: Level>(joining: &mut Joining<'_, N>, mass: Exact, row: Terms<'_, N>) {
        let entry = -(Ball::of_pair(mass) * joining.square);
        add(joining, &[entry], &[row], [entry.mid.size().first()]);
    }

    /// Adds the inertia of a body over rows of displacement and rotation of a point, given its mass, its mass moment and its moment of inertia
    /// about the point.
    pub(crate) fn add_inertia<N: Level>(joining: &mut Joining<'_, N>, inertia: [Ball<N::Alone>; 3], rows: [Terms<'_, N>; 2]) {
        let mut entries = [Ball::of(0.0); 3];
        for (entry, inertia) in entries.iter_mut().zip(inertia) {
            if !is_zero(&inertia) {
                *entry = -(Ball::everywhere(inertia) * joining.square);
            }
        }
        let sizes = [entries[0].mid.size().first(), entries[2].mid.size().first()];
        add(joining, &entries, &rows, sizes);
    }

    /// Adds the force of a rigid joint over the displacements that are equal, given about its flexibility, and takes off its negative pivot.
    pub(crate) fn add_force<N: Level>(
        joining: &mut Joining<'_, N>,
        force: usize,
        flexibility: f64,
        gap: Terms<'_, N>,
    ) {
        joining.front.grow(force, flexibility);
        for term in gap {
            joining.front.add(force, term.variable, Ball::everywhere(term.coefficient));
        }
        joining.held = joining.held + N::Word::of(-1.0);
    }
}
