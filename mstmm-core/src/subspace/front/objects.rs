//! Members and fronts that wait for the elimination of a node, one upon the other.

use crate::number::{Scalar, Size, power_of_two};
use crate::subspace::front::chart::{Chart, JoinedEnd, MOST_FREEDOMS, MOST_VARIABLES};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::total::Total;
use crate::subspace::front::triangle::row;
use crate::subspace::front::variable::Variable;
use core::ops::Range;
use mstmm_plan::Freedoms;

/// Where an object begins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    variable: usize,
    entry: usize,
}

impl Start {
    /// Where the first one begins.
    pub(super) const FIRST: Start = Start { variable: 0, entry: 0 };
}

/// A stack of objects, each a symmetric matrix over some variables, in memory of the caller's.
#[derive(Debug)]
pub(crate) struct Objects<'r, S> {
    /// The lower triangles, one behind the other.
    pub(super) entries: &'r mut [S],
    pub(super) variables: &'r mut [Variable],
    /// What the displacement of each variable is of the motions of its node.
    pub(super) rows: &'r mut [[S; MOST_FREEDOMS]],
    /// Error of each row in units of rounding.
    pub(super) errors: &'r mut [f64],
    /// Where each object begins, and the next one would.
    pub(super) starts: &'r mut [Start],
    pub(super) count: usize,
}

impl<S: Scalar> Objects<'_, S> {
    /// The variables of an object.
    #[inline]
    pub(super) fn range(&self, object: usize) -> Range<usize> {
        self.starts[object].variable..self.starts[object + 1].variable
    }

    /// The variables of the last objects, from one on.
    #[inline]
    pub(super) fn last(&self, from: usize) -> Range<usize> {
        self.starts[from].variable..self.starts[self.count].variable
    }

    /// The entries of an object.
    #[inline]
    pub(super) fn triangle(&self, object: usize) -> &[S] {
        &self.entries[self.starts[object].entry..self.starts[object + 1].entry]
    }

    /// Adds an object of so many variables. Returns its first variable and its first entry.
    #[inline]
    fn open(&mut self, variables: usize) -> Start {
        let start = self.starts[self.count];
        self.count += 1;
        self.starts[self.count] = Start { variable: start.variable + variables, entry: start.entry + row(variables) };
        start
    }

    /// Adds a member by its chart, without displacements that vanish. Returns the number of objects that were added: one without variables is
    /// none.
    pub(super) fn push_chart(&mut self, chart: &Chart<S>, ends: &[JoinedEnd<S>; 2], total: &mut Total<S>) -> usize {
        let start = self.starts[self.count];
        // the places in the chart of the variables that stay
        let mut kept = [0; MOST_VARIABLES];
        let (mut place, mut count) = (0, 0);
        for end in ends {
            for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
                if !chart.freedoms.contains(kind) {
                    continue;
                }
                if end.keeps(chart.is_force(place), kind) {
                    let (is_rotation, next) = (freedom + 1 == MOST_FREEDOMS, start.variable + count);
                    self.variables[next] = Variable {
                        node: end.node as u32,
                        measure: chart.measure,
                        unit: chart.units.of(is_rotation),
                        is_force: chart.is_force(place),
                        is_rotation,
                        is_released: end.released.contains(kind),
                    };
                    self.rows[next] = end.rows[freedom];
                    kept[count] = place;
                    count += 1;
                }
                place += 1;
            }
        }
        total.multiply(chart.product.mantissa(), chart.product.exponent());
        total.below = total.below + chart.below;
        if count == 0 {
            return 0;
        }
        let kept = &kept[..count];
        self.open(count);
        let entries = &mut self.entries[start.entry..start.entry + row(count)];
        if count == place {
            entries.copy_from_slice(&chart.entries[..row(count)]);
        } else {
            entries.fill(S::zero());
            for (k, one) in kept.iter().enumerate() {
                let from = &chart.entries[row(*one)..=row(*one) + one];
                for (other, entry) in kept[..=k].iter().zip(&mut entries[row(k)..]) {
                    *entry = from[*other];
                }
            }
        }
        if total.carries_errors {
            for (one, error) in kept.iter().zip(&mut self.errors[start.variable..]) {
                let sizes = kept.iter().map(|other| chart.entry(*one, *other).size().first());
                *error = sizes.fold(0.0, f64::max);
            }
        }
        1
    }

    /// Replaces the last objects, from one on, by what is left of their front, if anything is, in units that are `2^shift` times as large.
    pub(super) fn replace_last(&mut self, from: usize, node: u32, front: &Front<'_, S>, shift: i32) {
        let places = self.last(from);
        self.count = from;
        if front.boundary == 0 {
            return;
        }
        let Start { variable, entry } = self.open(front.boundary);
        // those elsewhere are the boundary, in their order
        let mut next = variable;
        for place in places {
            if self.variables[place].node != node {
                self.rows[next] = self.rows[place];
                next += 1;
            }
        }
        self.copy(self.count - 1, front);
        if shift == 0 {
            return;
        }
        let powers = [power_of_two(shift), power_of_two(-shift)];
        for one in variable..next {
            let own = powers[usize::from(self.variables[one].is_force)];
            self.errors[one] *= own * own;
            self.variables[one].unit += shift;
            let entries = &mut self.entries[entry + row(one - variable)..];
            for (entry, other) in entries.iter_mut().zip(&self.variables[variable..=one]) {
                *entry = entry.scaled(own * powers[usize::from(other.is_force)]);
            }
        }
    }

    /// Copies the boundary of a front to an object of as many variables.
    pub(super) fn copy(&mut self, object: usize, front: &Front<'_, S>) {
        let (places, entry) = (self.range(object), self.starts[object].entry);
        let count = places.len();
        self.variables[places.clone()].copy_from_slice(&front.variables[..count]);
        self.errors[places].copy_from_slice(&front.errors[..count]);
        self.entries[entry..entry + row(count)].copy_from_slice(&front.entries[..row(count)]);
    }
}
