//! Fronts of displacements alone, eliminated without a choice of pivots.

use crate::number::{Scalar, Size};
use crate::pass::network::stiffness::in_front::InFront;
use crate::pass::network::stiffness::total::StiffnessTotal;
use crate::pass::network::stiffness::waves::Bending;

/// Number of pivots whose roundings add up to one more error of a row: rows know their errors, but not how those of different rows depend on
/// each other. Up to that error rounding may decide the sign of a pivot.
const PIVOTS_PER_ERROR: usize = 6;

/// The displacements of a node, or the forces of a rigid joint, in a front.
#[derive(Clone, Copy, Debug)]
pub(super) struct Group {
    /// The node, or beyond these a member.
    pub(super) node: usize,
    pub(super) first: usize,
    pub(super) count: usize,
}

/// A front that waits: where its groups, variables and entries begin.
#[derive(Clone, Copy, Debug, Default)]
struct Waiting {
    group: usize,
    variable: usize,
    entry: usize,
}

/// Memory for fronts of up to `W` displacements at once.
pub(super) struct StiffnessRoom<S: Scalar, const W: usize> {
    triangles: [[S; W]; W],
    errors: [[S::Size; W]; 2],
    groups: [Group; W],
    waiting: [Waiting; W],
    row: [S; W],
    places: [usize; W],
}

impl<S: Scalar, const W: usize> StiffnessRoom<S, W> {
    /// Memory without fronts.
    #[inline(always)]
    pub(super) fn new() -> Self {
        StiffnessRoom {
            triangles: [[S::zero(); W]; W],
            errors: [[S::Size::of(0.0); W]; 2],
            groups: [Group { node: 0, first: 0, count: 0 }; W],
            waiting: [Waiting::default(); W],
            row: [S::zero(); W],
            places: [0; W],
        }
    }

    /// Fronts in this memory, given whether rounding is watched.
    #[inline(always)]
    pub(super) fn fronts(&mut self, watches: bool) -> StiffnessFronts<'_, S> {
        let (waiting_entries, entries) = self.triangles.as_flattened_mut().split_at_mut(row(W - 1));
        let [waiting_errors, errors] = &mut self.errors;
        StiffnessFronts {
            entries,
            errors,
            waiting_entries,
            waiting_errors,
            groups: &mut self.groups,
            waiting: &mut self.waiting,
            row: &mut self.row,
            places: &mut self.places,
            depth: 0,
            first_group: 0,
            group_count: 0,
            count: 0,
            watches,
            pivots: 0,
            total: StiffnessTotal::new(),
        }
    }
}

/// Where a row of a lower triangle begins.
#[inline(always)]
const fn row(row: usize) -> usize {
    row * (row + 1) / 2
}

/// Where an entry of a lower triangle stands, or its mirror image.
#[inline(always)]
const fn place(one: usize, other: usize) -> usize {
    if other <= one { row(one) + other } else { row(other) + one }
}

/// Fronts at work.
pub(super) struct StiffnessFronts<'r, S: Scalar> {
    /// The front at work: what stays first, then what is eliminated.
    entries: &'r mut [S],
    errors: &'r mut [S::Size],
    waiting_entries: &'r mut [S],
    waiting_errors: &'r mut [S::Size],
    /// Those of waiting fronts, then those of the front at work.
    groups: &'r mut [Group],
    waiting: &'r mut [Waiting],
    row: &'r mut [S],
    places: &'r mut [usize],
    /// The number of waiting fronts.
    depth: usize,
    /// Where the groups of the front at work begin, and how many they are.
    first_group: usize,
    group_count: usize,
    /// The number of its variables.
    count: usize,
    /// Whether errors are carried along.
    watches: bool,
    /// The number of pivots so far.
    pivots: usize,
    pub(super) total: StiffnessTotal<S>,
}

impl<S: Scalar> StiffnessFronts<'_, S> {
    /// Begins a front that takes up the last ones, without the group that it will eliminate. None where memory ends.
    #[inline(always)]
    pub(super) fn begin(&mut self, taken_up: usize, own: usize) -> Option<()> {
        let end = self.waiting[self.depth].group;
        let from = self.depth.checked_sub(taken_up)?;
        (self.first_group, self.group_count, self.count) = (end, 0, 0);
        let mut k = self.waiting[from].group;
        while k < end {
            let Group { node, count, .. } = self.groups[k];
            if node != own {
                self.include(node, count)?;
            }
            k += 1;
        }
        Some(())
    }

    /// Includes the variables of a node, if they are not in the front yet.
    #[inline(always)]
    pub(super) fn include(&mut self, node: usize, count: usize) -> Option<()> {
        if self.place_of(node).is_none() {
            *self.groups.get_mut(self.first_group + self.group_count)? = Group { node, first: self.count, count };
            self.group_count += 1;
            self.count += count;
        }
        Some(())
    }

    /// Where the variables of a node begin, and how many they are.
    #[inline(always)]
    pub(super) fn place_of(&self, node: usize) -> Option<[usize; 2]> {
        let mut k = self.first_group;
        while k < self.first_group + self.group_count {
            let Group { node: own, first, count } = self.groups[k];
            if own == node {
                return Some([first, count]);
            }
            k += 1;
        }
        None
    }

    /// Fills the front with those that it takes up.
    #[inline(always)]
    pub(super) fn fill(&mut self, taken_up: usize) -> Option<()> {
        if self.count >= self.errors.len() {
            return None;
        }
        self.entries[..row(self.count)].fill(S::zero());
        self.errors[..self.count].fill(S::Size::of(0.0));
        let mut front = self.depth - taken_up;
        while front < self.depth {
            self.take_up(front);
            front += 1;
        }
        self.depth -= taken_up;
        Some(())
    }

    /// Adds a waiting front.
    #[inline(always)]
    fn take_up(&mut self, front: usize) {
        let (begin, end) = (self.waiting[front], self.waiting[front + 1]);
        let mut count = 0;
        for k in begin.group..end.group {
            let [first, variables] = self.place_of(self.groups[k].node).unwrap_or([0; 2]);
            for variable in 0..variables {
                self.places[count] = first + variable;
                count += 1;
            }
        }
        let mut at = begin.entry;
        for k in 0..count {
            let own = self.places[k];
            let error = self.waiting_errors[begin.variable + k];
            self.errors[own] = self.errors[own] + error;
            for l in 0..=k {
                self.entries[place(own, self.places[l])] += self.waiting_entries[at];
                at += 1;
            }
        }
    }

    /// Adds a number times a body's mass matrix over motions, given its lower triangle.
    #[inline(always)]
    pub(super) fn add_body(&mut self, [first, count]: [usize; 2], masses: &[f64; 6], lambda_squared: S) {
        for k in 0..count {
            for l in 0..=k {
                let term = lambda_squared.scaled(masses[row(k) + l]);
                self.entries[row(first + k) + first + l] += term;
                if k == l {
                    self.note(first + k, term.size());
                }
            }
        }
    }

    /// Adds forces that tie a freedom of both ends, at a place.
    #[inline(always)]
    pub(super) fn add_tie(&mut self, at: usize, freedom: usize, member: InFront<'_>) {
        for end in 0..2 {
            let Some([first, count]) = member.ends[end] else { continue };
            for (k, part) in member.row(end, freedom)[..count].iter().enumerate() {
                self.entries[place(at, first + k)] += S::from_f64(if end == 0 { -part } else { *part });
            }
        }
    }

    /// Adds a stiffness between the displacements of both ends in a freedom: of each end, and across.
    #[inline(always)]
    pub(super) fn add_line(&mut self, [own, across]: [S; 2], freedom: usize, member: InFront<'_>) {
        for end in 0..2 {
            let Some(place) = member.ends[end] else { continue };
            let parts = member.row(end, freedom);
            self.add_own(own, place, &parts);
            // the terms of both are as large, also where those of one cancel
            self.note_own(own.size().or_larger(across.size()), place, &parts);
        }
        let [Some(place), Some(other)] = member.ends else { return };
        self.add_across(across, [place, other], [&member.row(0, freedom), &member.row(1, freedom)]);
    }

    /// Adds a stiffness of a displacement, given what that is of the motions of its node.
    #[inline(always)]
    pub(super) fn add_own(&mut self, own: S, [first, count]: [usize; 2], parts: &[f64; 3]) {
        for (k, part) in parts[..count].iter().enumerate() {
            if *part == 0.0 {
                continue;
            }
            let term = own.scaled(*part);
            let start = row(first + k) + first;
            for (entry, part) in self.entries[start..=start + k].iter_mut().zip(parts) {
                *entry += term.scaled(*part);
            }
        }
    }

    /// Adds a stiffness between two displacements, given what these are of the motions of their nodes.
    #[inline(always)]
    pub(super) fn add_across(&mut self, across: S, places: [[usize; 2]; 2], rows: [&[f64; 3]; 2]) {
        let [[first, count], [other_first, other_count]] = places;
        for (k, part) in rows[0][..count].iter().enumerate() {
            if *part == 0.0 {
                continue;
            }
            let term = across.scaled(*part);
            for (l, part) in rows[1][..other_count].iter().enumerate() {
                self.add([first + k, other_first + l], term.scaled(*part));
            }
        }
    }

    /// Notes the size of the terms that a stiffness of a displacement is made of.
    #[inline(always)]
    pub(super) fn note_own(&mut self, size: S::Size, [first, count]: [usize; 2], parts: &[f64; 3]) {
        if self.watches {
            for (k, part) in parts[..count].iter().enumerate() {
                self.note(first + k, size * S::Size::of(part * part));
            }
        }
    }

    /// Adds an entry and its mirror image, which on the diagonal is the same place.
    #[inline(always)]
    fn add(&mut self, [one, other]: [usize; 2], term: S) {
        let place = place(one, other);
        self.entries[place] += term;
        if one == other {
            self.entries[place] += term;
        }
    }

    /// Notes the size of a term on the diagonal: what terms are rounded by adds up.
    #[inline(always)]
    fn note(&mut self, place: usize, size: S::Size) {
        if self.watches {
            self.errors[place] = self.errors[place] + size;
        }
    }

    /// Adds the stiffness of bending: that of deflections, which is one of a line, and what rotations have.
    #[inline(always)]
    pub(super) fn add_bending(&mut self, bending: &Bending<S>, member: InFront<'_>) {
        let [yy, yt, tt, yy_across, yt_across, tt_across] = bending.stiffness;
        self.add_line([yy, yy_across], 1, member);
        for end in 0..2 {
            let (Some(rotation), Some([first, count])) = (member.rotation(end), member.ends[end]) else { continue };
            let yt = if end == 0 { yt } else { -yt };
            for l in 0..count {
                self.add([rotation, first + l], yt.scaled(member.member.rows[end][1][l]));
            }
            self.entries[place(rotation, rotation)] += tt;
            self.note(rotation, tt.size().or_larger(tt_across.size()));
            // with deflections at the other end
            if let Some([first, count]) = member.ends[1 - end] {
                let across = if end == 0 { -yt_across } else { yt_across };
                for l in 0..count {
                    self.add([rotation, first + l], across.scaled(member.member.rows[1 - end][1][l]));
                }
            }
        }
        if let (Some(one), Some(other)) = (member.rotation(0), member.rotation(1)) {
            self.add([one, other], tt_across);
        }
    }

    /// Eliminates the last variables, and lets what is left wait.
    #[inline(always)]
    pub(super) fn eliminate(&mut self, leaving: usize) -> Option<()> {
        for _ in 0..leaving {
            self.pivot_on_last();
        }
        let begin = self.waiting[self.depth];
        if self.count == 0 {
            return Some(());
        }
        // the groups that stay, without the last one, which has left
        for k in 0..self.group_count - 1 {
            self.groups[begin.group + k] = self.groups[self.first_group + k];
        }
        let (entries, count) = (row(self.count), self.count);
        let end = Waiting {
            group: begin.group + self.group_count - 1,
            variable: begin.variable + count,
            entry: begin.entry + entries,
        };
        if end.variable >= self.waiting_errors.len() || self.depth + 1 >= self.waiting.len() {
            return None;
        }
        self.waiting_entries[begin.entry..end.entry].copy_from_slice(&self.entries[..entries]);
        self.waiting_errors[begin.variable..end.variable].copy_from_slice(&self.errors[..count]);
        self.depth += 1;
        self.waiting[self.depth] = end;
        Some(())
    }

    /// Pivots on the last variable.
    #[inline(always)]
    fn pivot_on_last(&mut self) {
        let last = self.count - 1;
        let (rest, own) = self.entries.split_at_mut(row(last));
        let (factors, pivot) = (&own[..last], own[last]);
        let (solved, inverse) = (&mut self.row[..last], S::one() / pivot);
        let mut rest = rest;
        for k in 0..last {
            let factor = factors[k];
            solved[k] = factor * inverse;
            let (entries, others) = rest.split_at_mut(k + 1);
            rest = others;
            for (entry, solved) in entries.iter_mut().zip(&solved[..=k]) {
                *entry -= factor * *solved;
            }
        }
        let error = self.errors[last];
        if self.watches {
            for ((own_error, solved), factor) in self.errors.iter_mut().zip(&self.row[..last]).zip(factors) {
                *own_error = inherited(*own_error, [solved.size(), factor.size()], error);
            }
        }
        self.take(pivot, error);
        self.count = last;
    }

    /// Includes a pivot, with the error of its row, in Δ and the count.
    #[inline(always)]
    pub(super) fn take(&mut self, pivot: S, error: S::Size) {
        if self.watches {
            self.pivots += 1;
            let errors = self.pivots.div_ceil(PIVOTS_PER_ERROR) as f64;
            let limit = error * S::Size::of(errors * S::EPSILON);
            self.total.is_doubtful = self.total.is_doubtful | !limit.is_below(pivot.size());
        }
        self.total.multiply(pivot, 0);
        self.total.below = self.total.below + S::Size::one_if(pivot.is_negative());
    }
}

/// The error of a row, in units of rounding, after a pivot on another one: its own and what it inherits of that, given the sizes of its entry
/// there over the pivot and of that entry.
#[inline(always)]
pub(super) fn inherited<E: Size>(own: E, [solved, factor]: [E; 2], pivot: E) -> E {
    own + solved * (solved * pivot + factor)
}
