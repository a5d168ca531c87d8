//! The matrix of the unknowns that have not left, and their elimination. No pivot is searched: an unknown waits while its pivot is small.

use crate::number::{Operation, Products, Scalar, Size, with_products};
use crate::structure::chart::MOST_MOTIONS;
use crate::structure::node_unknowns::{MotionUnknown, NodeUnknowns};
use crate::structure::tape::Tape;
use crate::structure::total::Total;
use crate::structure::triangle::{self, place};
use crate::structure::units::Units;

/// Size of a pivot beside the largest term of its entry, below which its unknown waits for others to leave: a pivot loses three digits at most.
/// Pivots vanish where the structure so far has a natural frequency.
const SMALL_PIVOT: f64 = 1e-3;

/// Size of a pivot beside the largest term of its entry, in units of rounding, below which it is rounding alone: each of a few terms adds one unit.
const ROUNDING: f64 = 4.0;

/// Loads that a factor solves for at once.
pub(crate) const LOADS: usize = 2;

/// The loads of a number and of the next one: on all displacements, of the size of their units, and perhaps dislocations. Motions at two frequencies
/// are compared under the same load, so the load has the finest units of charts for both.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LoadEverywhere {
    pub(crate) number: u32,
    pub(crate) dislocates: bool,
    pub(crate) units: Units,
}

/// An unknown that has not left.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unknown<S> {
    pub(super) number: u32,
    pub(super) is_taken: bool,
    /// How many nodes have it as a motion and have not left.
    pub(super) holders: u32,
    /// Whether it leaves as soon as its pivot is large.
    pub(super) waits: bool,
    /// Whether it is a force.
    pub(super) is_force: bool,
    /// Whether what acts everywhere is in its load.
    pub(super) is_loaded: bool,
    /// The largest term of its diagonal entry, or a usual size of these.
    pub(super) size: f64,
    pub(super) loads: [S; LOADS],
}

impl<S: Scalar> Unknown<S> {
    pub(crate) fn none() -> Self {
        let loads = [S::zero(); LOADS];
        Unknown {
            number: 0,
            is_taken: false,
            holders: 0,
            waits: false,
            is_force: false,
            is_loaded: false,
            size: 0.0,
            loads,
        }
    }
}

/// The row of an unknown that has left: its value under each load is that of `values`, less each number times the value of the unknown beside it.
/// A shear adds that to the value that it has.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<S> {
    number: u32,
    first: u32,
    is_shear: bool,
    values: [S; LOADS],
}

impl<S: Scalar> Row<S> {
    /// The shear that adds to the value of an unknown.
    pub(super) fn shear_of(number: u32) -> Self {
        Row { number, is_shear: true, ..Row::none() }
    }

    pub(crate) fn none() -> Self {
        Row { number: 0, first: 0, is_shear: false, values: [S::zero(); LOADS] }
    }
}

/// Subtracts a factor times the entries of a column from a row of the matrix.
struct Subtract<'a, S> {
    row: &'a mut [S],
    factor: S,
    column: &'a [(S, u32)],
}

impl<S: Scalar> Operation for Subtract<'_, S> {
    type Output = ();

    #[inline(always)]
    fn by<P: Products>(self) {
        for (entry, place) in self.column {
            let sum = &mut self.row[*place as usize];
            *sum = sum.less_product::<P>(self.factor, *entry);
        }
    }
}

/// Subtracts a factor times the entries of a column from a row of the matrix.
#[inline(always)]
fn subtract<S: Scalar>(row: &mut [S], factor: S, column: &[(S, u32)]) {
    with_products::<S, _>(Subtract { row, factor, column });
}

/// The elimination of a structure, in memory of the caller's.
#[derive(Debug)]
pub struct Factor<'r, S: Scalar> {
    /// The lower triangle over the slots of unknowns, row after row.
    pub(super) entries: &'r mut [S],
    pub(super) unknowns: &'r mut [Unknown<S>],
    /// Number of slots that are in use or were.
    pub(super) width: usize,
    /// The column of the unknown that leaves: each entry with its row.
    column: &'r mut [(S, u32)],
    rows: Tape<'r, Row<S>>,
    /// The numbers of all rows, each with the unknown beside it.
    numbers: Tape<'r, (S, u32)>,
    /// The values of all unknowns under each load, once all have left.
    values: Tape<'r, [S; LOADS]>,
    pub(super) entered: u32,
    /// The finest units that charts may have.
    pub(crate) units: Units,
    /// The load of all unknowns, if there is one.
    pub(crate) everywhere: Option<LoadEverywhere>,
    /// The node that is taken up, and the first one where a pivot was rounding alone.
    pub(crate) node: u32,
    pub(crate) vanished_at: Option<u32>,
    /// Whether there was no slot for an unknown, though the order of a network has counted them: then nothing is known.
    pub(super) is_full: bool,
    /// The work of each load on its motion.
    pub(crate) works: [S; LOADS],
    /// Δ and the count so far.
    pub(crate) total: Total<S>,
    /// Whether rows are kept for the values of unknowns; else Δ alone is asked for.
    pub(crate) keeps_rows: bool,
}

impl<'r, S: Scalar> Factor<'r, S> {
    /// The factor of a structure that nothing has joined, in memory for the matrix and its unknowns, for one of its columns, for rows, for their
    /// numbers, and for values.
    pub(super) fn new(
        (entries, unknowns): (&'r mut [S], &'r mut [Unknown<S>]),
        column: &'r mut [(S, u32)],
        rows: Tape<'r, Row<S>>,
        numbers: Tape<'r, (S, u32)>,
        values: Tape<'r, [S; LOADS]>,
        keeps_rows: bool,
    ) -> Self {
        Factor {
            entries,
            unknowns,
            width: 0,
            column,
            rows,
            numbers,
            values,
            entered: 0,
            units: Units::FINEST,
            everywhere: None,
            node: 0,
            vanished_at: None,
            is_full: false,
            works: [S::zero(); LOADS],
            total: Total::new(),
            keeps_rows,
        }
    }
}

impl<S: Scalar> Factor<'_, S> {
    /// Takes a slot for an unknown. Where there is none, one that waits leaves.
    pub(super) fn enter(&mut self, is_force: bool) -> (u32, u32) {
        let free = self.unknowns[..self.width].iter().position(|unknown| !unknown.is_taken);
        let slot = match free {
            Some(free) => free,
            None if self.width < self.unknowns.len() => {
                self.width += 1;
                self.width - 1
            }
            None => self.make_room(),
        };
        let number = self.entered;
        self.entered += 1;
        self.unknowns[slot] = Unknown { number, is_taken: true, is_force, ..Unknown::none() };
        for other in 0..self.width {
            self.entries[place(slot, other)] = S::zero();
        }
        (number, slot as u32)
    }

    /// Lets the unknown with the largest pivot of those that wait leave.
    #[cold]
    fn make_room(&mut self) -> usize {
        let waiting = (0..self.width).filter(|slot| self.unknowns[*slot].waits);
        match waiting.max_by(|one, other| self.share(*one).total_cmp(&self.share(*other))) {
            Some(best) => {
                let best = if self.share(best) < SMALL_PIVOT { self.sheared(best) } else { best };
                self.leave(best);
                best
            }
            None => {
                self.is_full = true;
                0
            }
        }
    }

    /// Begins a row. Returns whether there is room for it.
    pub(super) fn begin_row(&mut self, row: Row<S>) -> bool {
        let has_room = self.rows.push(Row { first: self.numbers.get().len() as u32, ..row });
        self.is_full |= !has_room;
        has_room
    }

    /// Adds a number to the row that has begun.
    #[inline]
    pub(super) fn push_number(&mut self, factor: S, beside: u32) {
        let has_room = self.numbers.push((factor, beside));
        self.is_full |= !has_room;
    }

    /// Lets a motion enter.
    pub(super) fn enter_motion(&mut self) -> MotionUnknown {
        let (number, slot) = self.enter(false);
        MotionUnknown { number, slot }
    }

    /// Notes that a node has an unknown as a motion.
    pub(crate) fn hold(&mut self, motion: MotionUnknown) {
        self.unknowns[motion.slot as usize].holders += 1;
    }

    /// Adds to an entry, and thereby to its mirror image.
    #[inline]
    pub(super) fn add(&mut self, row: u32, column: u32, term: S) {
        self.entries[place(row as usize, column as usize)] += term;
        if row == column {
            self.note(row, term.size().first());
        }
    }

    /// Notes a usual size of terms of the diagonal entry of an unknown: its own may vanish.
    pub(super) fn note(&mut self, slot: u32, size: f64) {
        let unknown = &mut self.unknowns[slot as usize];
        unknown.size = unknown.size.max(size);
    }

    /// Lets an unknown wait: all that knows it has joined.
    pub(super) fn wait(&mut self, slot: u32) {
        self.unknowns[slot as usize].waits = true;
    }

    /// Adds a force on an unknown to the first load.
    #[inline]
    pub(super) fn add_load(&mut self, slot: u32, force: S) {
        self.unknowns[slot as usize].loads[0] += force;
    }

    /// The size of a pivot beside the largest term of its entry.
    pub(super) fn share(&self, slot: usize) -> f64 {
        let size = self.entries[place(slot, slot)].size().first();
        if size > 0.0 { size / self.unknowns[slot].size } else { 0.0 }
    }

    /// Lets a node leave. An unknown leaves with the last node that holds it, and so do unknowns that wait; an unknown with a small pivot stays.
    pub(super) fn leave_node(&mut self, node: &NodeUnknowns) {
        for (_, slot) in node.slots() {
            let unknown = &mut self.unknowns[slot as usize];
            // without room for them several unknowns have one slot
            unknown.holders = unknown.holders.saturating_sub(1);
            if unknown.holders == 0 {
                self.wait(slot);
                self.leave_if_large(slot as usize);
            }
        }
        while (0..self.width).any(|slot| self.leave_if_large(slot)) {}
    }

    /// Lets an unknown that waits leave if its pivot is large. Returns whether it has left.
    fn leave_if_large(&mut self, slot: usize) -> bool {
        let is_ready = self.unknowns[slot].waits && self.share(slot) >= SMALL_PIVOT;
        if is_ready {
            self.leave(slot);
        }
        is_ready
    }

    /// Lets all unknowns leave that are left, largest pivot first.
    pub(super) fn leave_all(&mut self) {
        while self.unknowns[..self.width].iter().any(|unknown| unknown.is_taken) {
            self.unknowns[..self.width].iter_mut().for_each(|unknown| unknown.waits = unknown.is_taken);
            self.make_room();
        }
        if self.is_full {
            self.total = Total::unknown();
        }
    }

    /// Eliminates an unknown.
    fn leave(&mut self, slot: usize) {
        self.load_everywhere(slot);
        let Unknown { number, size, loads, .. } = self.unknowns[slot];
        (self.unknowns[slot].is_taken, self.unknowns[slot].waits) = (false, false);
        let mut pivot = self.entries[place(slot, slot)];
        if pivot.size().first() <= ROUNDING * S::EPSILON * size {
            self.vanished_at = self.vanished_at.or(Some(self.node));
            pivot = S::from_f64(S::EPSILON * if size > 0.0 { size } else { 1.0 });
            if size == 0.0 {
                self.total.multiply(S::zero(), 0);
            }
        }
        self.total.pivot(pivot);
        let inverse = S::one() / pivot;
        let is_loaded = loads.map(|load| !load.is_constant_zero());
        let mut row = Row { number, ..Row::none() };
        for load in (0..LOADS).filter(|load| is_loaded[*load]) {
            row.values[load] = loads[load] * inverse;
            self.works[load] += loads[load] * row.values[load];
        }
        if self.keeps_rows && !self.begin_row(row) {
            return;
        }
        let mut count = 0;
        for row in 0..self.width {
            let entry = self.entries[place(row, slot)];
            if !self.unknowns[row].is_taken || entry.is_constant_zero() {
                continue;
            }
            let factor = entry * inverse;
            subtract(&mut self.entries[triangle::row(row)..], factor, &self.column[..count]);
            self.column[count] = (entry, row as u32);
            count += 1;
            let term = factor * entry;
            self.entries[place(row, row)] -= term;
            let unknown = &mut self.unknowns[row];
            unknown.size = unknown.size.max(term.size().first());
            for load in (0..LOADS).filter(|load| is_loaded[*load]) {
                unknown.loads[load] -= factor * loads[load];
            }
            if self.keeps_rows {
                // slots are taken again: what is beside is known by its number
                let beside = unknown.number;
                self.push_number(factor, beside);
            }
        }
    }

    /// Finds the values of all unknowns, the last one first.
    pub(super) fn solve(&mut self) {
        self.leave_all();
        let none = if self.is_full { S::from_f64(f64::NAN) } else { S::zero() };
        self.values.fill([none; LOADS], self.entered as usize);
        if self.is_full {
            return;
        }
        let all = self.values.get_mut();
        let numbers = self.numbers.get();
        let mut end = numbers.len();
        for row in self.rows.get().iter().rev() {
            let first = row.first as usize;
            let mut values = if row.is_shear { all[row.number as usize] } else { row.values };
            for (factor, beside) in &numbers[first..end] {
                for (value, other) in values.iter_mut().zip(all[*beside as usize]) {
                    if !other.is_constant_zero() {
                        *value -= *factor * other;
                    }
                }
            }
            all[row.number as usize] = values;
            end = first;
        }
    }

    /// The value of an unknown under a load.
    #[inline]
    pub(crate) fn value(&self, number: u32, load: usize) -> S {
        // without room for the unknowns there is no value
        self.values.get().get(number as usize).map_or(S::from_f64(f64::NAN), |values| values[load])
    }

    /// The values of the motions of a node under a load.
    pub(crate) fn values_of(&self, node: &NodeUnknowns, load: usize) -> [S; MOST_MOTIONS] {
        let mut values = [S::zero(); MOST_MOTIONS];
        for (value, motion) in values.iter_mut().zip(node.motions) {
            *value = motion.map_or(S::zero(), |motion| self.value(motion.number, load));
        }
        values
    }
}
