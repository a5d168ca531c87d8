//! Two by two cells of a grid: a point and its eight neighbours.

use crate::model::SearchError;
use crate::number::Magnitude;
use crate::search::minima::grid::{Grid, HALVINGS_TO_SHOW_A_ROOT};
use core::cmp::Ordering;

/// A point of a grid with the samples around it, by their offsets -1, 0, 1 along each axis; one that is missing lies
/// outside the rectangle of the search.
#[derive(Clone, Copy)]
pub(super) struct Cells {
    pub(super) centre: [f64; 2],
    /// Length of a cell along each axis.
    pub(super) step: [f64; 2],
    pub(super) own: Magnitude,
    values: [[Option<Magnitude>; 3]; 3],
}

impl Cells {
    /// The cells around a point by the samples at offsets `0..3` each; `None` if the point itself lies outside.
    pub(super) fn new(
        centre: [f64; 2],
        step: [f64; 2],
        sample: impl Fn(usize, usize) -> Option<Magnitude>,
    ) -> Option<Self> {
        let values = core::array::from_fn(|i| core::array::from_fn(|j| sample(i, j)));
        sample(1, 1).map(|own| Cells { centre, step, own, values })
    }

    /// Whether the point is lowest along both axes.
    pub(super) fn is_minimum(&self) -> bool {
        self.lowest() == [true, true]
    }

    /// The least concavity along an axis if the point is lowest along the other: less than 1 where a root hides in the
    /// cells, and the less the nearer it is to the point.
    fn concavity(&self) -> Option<Magnitude> {
        let (lowest, neighbours) = (self.lowest(), self.neighbours());
        let along = |axis: usize| match neighbours[axis] {
            [Some(before), Some(after)] if lowest[1 - axis] => Some(Magnitude::concavity(before, self.own, after)),
            _ => None,
        };
        [along(0), along(1)].into_iter().flatten().min_by(compare)
    }

    /// Whether the point is lowest along one axis and has a convex logarithm along the other.
    fn hides_root(&self) -> bool {
        self.concavity().is_some_and(|concavity| concavity < Magnitude::from(1.0))
    }

    /// Least and largest coordinate along each axis, inside the rectangle.
    pub(super) fn bounds(&self, grids: &[Grid; 2]) -> [[f64; 2]; 2] {
        core::array::from_fn(|axis| {
            let Grid { start, end, .. } = grids[axis];
            [self.centre[axis] - self.step[axis], self.centre[axis] + self.step[axis]].map(|x| x.clamp(start, end))
        })
    }

    /// Halves the cells, going on with those that show a root, until the point is lowest along both axes.
    pub(super) fn find_minimum(
        mut self,
        evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
        grids: &[Grid; 2],
    ) -> Result<Option<Self>, SearchError> {
        for _ in 0..HALVINGS_TO_SHOW_A_ROOT {
            if self.is_minimum() {
                return Ok(Some(self));
            }
            let used_up = |axis: usize| self.centre[axis] + self.step[axis] / 2.0 == self.centre[axis];
            if !self.hides_root() || used_up(0) || used_up(1) {
                break;
            }
            let inner = self.halved(evaluate, grids)?;
            let inner = || inner.iter().flatten().flatten();
            let hidden =
                || inner().filter(|cells| cells.hides_root()).min_by(|a, b| compare(&a.concavity(), &b.concavity()));
            let Some(next) = inner().find(|cells| cells.is_minimum()).or_else(hidden) else { return Ok(None) };
            self = *next;
        }
        Ok(None)
    }

    /// The cells of half the length around the point and around each of the midpoints to its neighbours.
    fn halved(
        &self,
        evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
        grids: &[Grid; 2],
    ) -> Result<[[Option<Self>; 3]; 3], SearchError> {
        let step = self.step.map(|step| step / 2.0);
        let place = |axis: usize, k: usize| {
            let exact = self.centre[axis] + (k as f64 - 2.0) * step[axis];
            let inside = exact.clamp(grids[axis].start, grids[axis].end);
            // the last point of a grid may lie a rounding beyond the end of the range, but no more
            ((exact - inside).abs() <= step[axis] / 4.0).then_some(inside)
        };
        let mut samples = [[None; 5]; 5];
        for (i, row) in samples.iter_mut().enumerate() {
            for (j, sample) in row.iter_mut().enumerate() {
                *sample = match (place(0, i), place(1, j)) {
                    _ if i % 2 == 0 && j % 2 == 0 => self.values[i / 2][j / 2],
                    (Some(x), Some(y)) => Some(evaluate(x, y)?),
                    _ => None,
                };
            }
        }
        let cells = |i: usize, j: usize| {
            let centre = [place(0, i + 1)?, place(1, j + 1)?];
            Cells::new(centre, step, |k, l| samples[i + k][j + l])
        };
        Ok(core::array::from_fn(|i| core::array::from_fn(|j| cells(i, j))))
    }

    /// The neighbours before and after the point along each axis.
    fn neighbours(&self) -> [[Option<Magnitude>; 2]; 2] {
        [[self.values[0][1], self.values[2][1]], [self.values[1][0], self.values[1][2]]]
    }

    /// Whether no neighbour along an axis is lower; a tie belongs to the earlier point, so that it counts once.
    fn lowest(&self) -> [bool; 2] {
        self.neighbours().map(|[before, after]| {
            before.is_none_or(|before| self.own < before) && after.is_none_or(|after| self.own <= after)
        })
    }
}

/// The order of two values, which are numbers: a search ends at the first that is none.
fn compare<V: PartialOrd>(a: &V, b: &V) -> Ordering {
    a.partial_cmp(b).unwrap_or(Ordering::Equal)
}
