//! Members and fronts that wait for the elimination of a node, one upon the other.

use crate::number::{Scalar, Size};
use crate::subspace::front::chart::Chart;
use crate::subspace::front::matrix::{Front, Variable};
use crate::subspace::front::total::Total;
use core::ops::Range;
use mstmm_plan::Freedoms;

/// A stack of objects, each a symmetric matrix over some variables; `W` is the largest number of variables of all.
#[derive(Clone, Debug)]
pub(crate) struct Objects<S: Scalar, const W: usize> {
    /// The matrices, one below the other, each from the first column on.
    pub(super) entries: [[S; W]; W],
    pub(crate) variables: [Variable; W],
    /// Error of each row in units of rounding.
    pub(super) errors: [f64; W],
    /// The first variable of each object.
    starts: [usize; W],
    objects: usize,
    count: usize,
}

impl<S: Scalar, const W: usize> Objects<S, W> {
    pub(crate) fn new() -> Self {
        Objects {
            entries: [[S::zero(); W]; W],
            variables: [Variable::NONE; W],
            errors: [0.0; W],
            starts: [0; W],
            objects: 0,
            count: 0,
        }
    }

    /// The number of objects.
    pub(crate) fn len(&self) -> usize {
        self.objects
    }

    /// The variables of an object.
    pub(crate) fn range(&self, object: usize) -> Range<usize> {
        let end = if object + 1 < self.objects { self.starts[object + 1] } else { self.count };
        self.starts[object]..end
    }

    /// The variables of the last objects, from one on.
    pub(crate) fn last(&self, from: usize) -> Range<usize> {
        if from < self.objects { self.starts[from]..self.count } else { self.count..self.count }
    }

    /// The object of a variable.
    pub(super) fn object_of(&self, place: usize) -> usize {
        (0..self.objects).rev().find(|object| self.starts[*object] <= place).unwrap_or(0)
    }

    /// Opens an object. Returns its first variable.
    fn open(&mut self) -> usize {
        self.starts[self.objects] = self.count;
        self.objects += 1;
        self.count
    }

    /// Adds a member by its chart, with labels from one on.
    pub(crate) fn push_chart(&mut self, chart: &Chart<S>, label: usize, total: &mut Total<S>) {
        let first = self.open();
        for end in 0..2 {
            for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
                if chart.freedoms.contains(kind) {
                    let variable = chart.variable(self.count - first, end, freedom);
                    self.variables[self.count] = Variable { label: label + variable.label, ..variable };
                    self.count += 1;
                }
            }
        }
        for (row, entries) in self.entries[first..self.count].iter_mut().zip(&chart.entries) {
            for (place, entry) in row.iter_mut().zip(entries) {
                *place = *entry;
            }
        }
        if total.carries_errors {
            for (error, entries) in self.errors[first..self.count].iter_mut().zip(&chart.entries) {
                *error = entries.iter().fold(0.0, |largest, entry| entry.size().first().max(largest));
            }
        }
        total.multiply(chart.product.mantissa(), chart.product.exponent());
        total.below = total.below + chart.below;
    }

    /// Removes the last objects.
    pub(crate) fn drop_last(&mut self, objects: usize) {
        self.objects -= objects;
        self.count = if objects == 0 { self.count } else { self.starts[self.objects] };
    }

    /// Adds what is left of a front, in units that are `2^shift` times as large.
    pub(crate) fn push_front(&mut self, front: &Front<S, W>, shift: i32) {
        let first = self.open();
        self.count = first + front.boundary().len();
        self.put_back(first, front, shift);
    }

    /// Puts the boundary of a front in the place of an object that begins with a variable.
    pub(super) fn put_back(&mut self, first: usize, front: &Front<S, W>, shift: i32) {
        let boundary = front.boundary();
        let sign = |variable: &Variable| if variable.is_force { -shift } else { shift };
        for (k, variable) in front.variables[boundary.clone()].iter().enumerate() {
            self.variables[first + k] = Variable { unit: variable.unit + shift, ..*variable };
            self.errors[first + k] = front.errors[boundary.start + k].times_power_of_two(2 * sign(variable));
            let entries = &front.entries[boundary.start + k][boundary.clone()];
            for ((place, entry), other) in
                self.entries[first + k].iter_mut().zip(entries).zip(&front.variables[boundary.clone()])
            {
                *place = entry.times_power_of_two(sign(variable) + sign(other));
            }
        }
    }
}
