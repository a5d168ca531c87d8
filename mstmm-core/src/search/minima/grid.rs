//! Grids over intervals, and the lists of minima that searches on them return.

use crate::model::SearchError;
use crate::number::List;
use core::ops::{Deref, RangeInclusive};

/// The minima that a search found, and the number of evaluations it took; dereferences to a slice of minima.
#[derive(Clone, Copy, Debug)]
pub struct Minima<M, const CAP: usize> {
    pub(super) minima: List<M, CAP>,
    pub(super) evaluations: usize,
}

impl<M, const CAP: usize> Minima<M, CAP> {
    /// Number of evaluations of the function.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }
}

impl<M, const CAP: usize> Deref for Minima<M, CAP> {
    type Target = [M];

    fn deref(&self) -> &[M] {
        &self.minima
    }
}

impl<'a, M, const CAP: usize> IntoIterator for &'a Minima<M, CAP> {
    type Item = &'a M;
    type IntoIter = core::slice::Iter<'a, M>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// Largest number of grid points in one direction: beyond it a search would not end within hours.
pub const MAX_POINTS: usize = i32::MAX as usize;

/// Halvings after which a root that a slope hides must show as a minimum: enough for a function that grows by `e^500`
/// along a cell, and few where rounding noise only looks like one.
pub(super) const HALVINGS_TO_SHOW_A_ROOT: u32 = 10;

/// A grid of equal cells over an interval, ends included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) points: usize,
    pub(super) tolerance: f64,
}

impl Grid {
    /// A grid over a finite range that runs upwards, with 3 to `limit` points and a positive tolerance.
    pub(super) fn new(
        range: &RangeInclusive<f64>,
        points: usize,
        limit: usize,
        tolerance: f64,
    ) -> Result<Self, SearchError> {
        let (start, end) = (*range.start(), *range.end());
        if !(start < end && (end - start).is_finite()) {
            return Err(SearchError::Range { start, end });
        }
        if !(3..=limit).contains(&points) {
            return Err(SearchError::Grid { points, limit });
        }
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(SearchError::Tolerance { tolerance });
        }
        Ok(Grid { start, end, points, tolerance })
    }

    /// The `index`-th point; the last one is exactly the end.
    pub(super) fn point(&self, index: usize) -> f64 {
        if index + 1 == self.points {
            return self.end;
        }
        self.start + (self.end - self.start) * (index as f64 / (self.points - 1) as f64)
    }

    /// Width of a cell.
    pub(super) fn step(&self) -> f64 {
        (self.end - self.start) / (self.points - 1) as f64
    }
}
