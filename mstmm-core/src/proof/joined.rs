//! How the parts of a model join the front of a count.

use crate::element::{BeamNumbers, DampingNumbers, Exact, LineNumbers, SpinNumbers, TaperedNumbers};
use crate::proof::adding::{
    add_bent, add_counted, add_force, add_inertia, add_line, add_mass, add_member, add_plain_bending, add_spin,
    add_tensor, add_term, general,
};
use crate::proof::ball::Ball;
use crate::proof::front::substitute;
use crate::proof::join::{Failure, Join};
use crate::proof::joining::{Joining, MOST_WAITING, Terms};
use crate::proof::level::Level;
use crate::proof::member::Member;
use crate::proof::row::{Row, is_zero};
use crate::proof::tapered::pieces;
use crate::proof::word::Word;

/// The stiffness that is added to a rigid joint, over the largest one of its displacements. Any number is valid, since the joint never stretches. A
/// whole number would meet springs of the same size and the other sign, and leave a pivot of zero.
const OF_NEIGHBOURS: f64 = 1.37;

impl<N: Level> Join for Joining<'_, N> {
    type Alone = N::Alone;

    #[inline(always)]
    fn stands_at(&mut self, place: usize) {
        self.front.total.place = place;
    }

    fn fail(&mut self, failure: Failure) {
        self.failure = Some(failure);
    }

    #[inline(always)]
    fn has_failed(&self) -> bool {
        self.failure.is_some()
    }

    #[inline(always)]
    fn enter(&mut self) -> usize {
        self.front.enter().unwrap_or_else(|| {
            self.failure = Some(Failure::Full);
            0
        })
    }

    /// Eliminates a variable, now or, where its pivot is small, behind others.
    #[inline(always)]
    fn leave(&mut self, variable: usize) {
        if self.waiting_count == MOST_WAITING {
            self.front.leave(variable);
        } else if !self.front.leave_if_large(variable) {
            self.leaves_behind(variable);
        }
    }

    /// Eliminates those variables that wait and have no small pivot any more.
    fn leave_behind(&mut self) {
        let mut kept = 0;
        for k in 0..self.waiting_count {
            if !self.front.leave_if_large(self.waiting[k].0) {
                self.waiting[kept] = self.waiting[k];
                kept += 1;
            }
        }
        self.waiting_count = kept;
    }

    #[inline(always)]
    fn substitute(&mut self, variable: usize, by: Terms<'_, N>) {
        substitute(&mut self.front, variable, by);
    }

    #[inline(always)]
    fn add_term(&mut self, k: Ball<N::Alone>, row: Terms<'_, N>) {
        if !is_zero(&k) {
            add_term(self, k, row);
        }
    }

    #[inline(always)]
    fn add_damped_term(&mut self, (stiffness, damping): (&Exact, &DampingNumbers), row: Terms<'_, N>) {
        if !self.refuses(damping) {
            self.add_term(Ball::of_pair(*stiffness), row);
        }
    }

    #[inline(always)]
    fn add_mass(&mut self, mass: Exact, row: Terms<'_, N>) {
        if mass != [0.0; 2] {
            add_mass(self, mass, row);
        }
    }

    #[inline(always)]
    fn add_inertia(&mut self, inertia: [Ball<N::Alone>; 3], rows: [Terms<'_, N>; 2]) {
        add_inertia(self, inertia, rows);
    }

    fn add_tensor(&mut self, tensor: [Ball<N::Alone>; 6], rows: [Terms<'_, N>; 3]) {
        add_tensor(self, tensor, rows);
    }

    fn add_spin(&mut self, spin: &SpinNumbers, row: Terms<'_, N>) {
        if !spin.is_none() {
            add_spin(self, spin, row);
        }
    }

    #[inline(always)]
    fn add_line(
        &mut self,
        (numbers, damping): (&LineNumbers, &DampingNumbers),
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 2],
    ) {
        if !self.refuses(damping) {
            add_line(self, numbers, length, rows);
        }
    }

    fn add_bending(
        &mut self,
        (numbers, damping, spin): (&BeamNumbers, &DampingNumbers, &SpinNumbers),
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 4],
    ) {
        if self.refuses(damping) {
            return;
        }
        if numbers.is_plain() && spin.is_none() {
            return add_plain_bending(self, numbers, length, rows);
        }
        let (whole, is_beside_pole) = general(self, (numbers, spin), length);
        if !is_beside_pole {
            return add_bent(self, &whole, &numbers.bending_stiffness, length, rows);
        }
        // Beside a pole the beam is two beams. Not of equal length: every second pole of the whole is one of a half.
        let variables = [self.enter(), self.enter()];
        let middle = variables.map(Row::<N::Alone, 1>::of);
        let part = |share: f64| length * Ball::of(share);
        let [y, theta] = [middle[0].terms(), middle[1].terms()];
        for (share, rows) in [(0.375, [rows[0], rows[1], y, theta]), (0.625, [y, theta, rows[2], rows[3]])] {
            let (piece, _) = general(self, (numbers, spin), part(share));
            add_bent(self, &piece, &numbers.bending_stiffness, part(share), rows);
        }
        variables.into_iter().for_each(|variable| self.leaves_behind(variable));
    }

    /// Adds a tapered beam piece by piece. The last inner end leaves behind the first end of the beam: before that its pivot is a pole where
    /// the beam vibrates between held ends. Its pieces depend on the frequency: in lanes nothing is known of it.
    #[inline(never)]
    fn add_tapered(&mut self, numbers: &TaperedNumbers, length: Ball<N::Alone>, rows: [Terms<'_, N>; 4]) {
        if N::Word::LANES > 1 {
            self.failure = Some(Failure::NotEnclosed);
            return;
        }
        let (mut input, mut inner) = (None::<[Row<N::Alone, 1>; 2]>, None::<[usize; 2]>);
        let found = pieces::<N::Alone>((numbers, length), self.square.lane(0), &mut |piece, is_last| {
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

    fn add_counted(&mut self, stiffness: [Exact; 3], held: f64, rows: [Terms<'_, N>; 2]) {
        add_counted(self, stiffness, held, rows);
    }

    /// The force is one of the negative pivots. A stiffness of any size against what is zero changes nothing and keeps pivots from vanishing.
    fn add_tie(&mut self, gap: Terms<'_, N>) -> usize {
        let size = gap.iter().map(|term| self.front.size(term.variable)).fold(0.0, f64::max);
        let stiffness = if size > 0.0 && size < f64::INFINITY { size * OF_NEIGHBOURS } else { 1.0 };
        self.add_term(Ball::of(stiffness), gap);
        let force = self.enter();
        add_force(self, force, 1.0 / stiffness, gap);
        force
    }
}
