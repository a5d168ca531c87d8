//! Recursive scanning for the minima of |Δ| on an interval.

use crate::model::SearchError;
use crate::number::{List, Magnitude};
use crate::search::closed_range::ClosedRange;
use crate::search::minima::grid::{Grid, HALVINGS_TO_SHOW_A_ROOT, MAX_POINTS, Minima};

/// A local minimum on an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Minimum1d {
    /// The coordinate of the minimum.
    pub x: f64,
    /// The modulus of the function there.
    pub residual: Magnitude,
    /// Whether it is an end of the interval: the function may fall further beyond it, so it need not be a root.
    pub at_end: bool,
}

/// The local minima of `|function|` on `range`, in ascending order, by the paper's recursive scanning.
///
/// The function is evaluated at `points` equally spaced points; each local minimum, the ends of the interval
/// included, has its two neighbouring cells scanned again in four cells until they are shorter than `tolerance`.
/// Where the samples rise or fall past a root, so that no point of the grid is lower than both its neighbours, the
/// root shows as a convex logarithm (log|Δ| is concave between roots), and those cells are scanned again as well.
///
/// # Limits
/// For a Δ(ω) without poles of an undamped system each interior minimum is a root, as far as rounding lets it be seen.
/// A tolerance below the rounding noise of the function finds minima of the noise, and these can be exact zeros: a
/// residual of 0 certifies nothing, least of all beyond a βl of about 33, where the noise of the double-precision
/// determinant of a beam comes up to the determinant itself.
///
/// Roots closer than two cells can be lost without notice, and multiplicity is not seen. So can a root within 15 % of
/// a cell's length from an end of the range, if the function falls or rises past it. Of two minima within twice the
/// tolerance of each other the second is dropped, as two scans of one root end that close together; one at an end of
/// the interval gives way to one that is not.
///
/// # Errors
/// [`SearchError`] for a range that is empty, reversed or not of finite length, fewer than 3 points or more than
/// [`MAX_POINTS`], a tolerance that is not positive, a function value that is not a number, a function that is zero at
/// all points of the grid, or more than `CAP` minima.
///
/// # Source
/// fMin1D of the paper's reference 23, as section 4.1 uses it; the search for hidden roots is an addition.
///
/// ```
/// let minima = mstmm_core::search::fmin1d::<4, _>(|x: f64| x.sin(), 2.0..=7.0, 20, 1e-9)?;
/// assert_eq!(minima.len(), 2);
/// assert!((minima[0].x - core::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), mstmm_core::SearchError>(())
/// ```
pub fn fmin1d<const CAP: usize, V: Into<Magnitude>>(
    mut function: impl FnMut(f64) -> V,
    range: impl ClosedRange<f64>,
    points: usize,
    tolerance: f64,
) -> Result<Minima<Minimum1d, CAP>, SearchError> {
    let grid = Grid::new(&range.closed(), points, MAX_POINTS, tolerance)?;
    let mut evaluations = 0;
    let mut evaluate = |x: f64| {
        evaluations += 1;
        let value = function(x).into();
        if value.is_nan() { Err(SearchError::NotANumber { x, y: 0.0 }) } else { Ok(Sample { x, value }) }
    };
    let mut minima = List::new();
    let mut all_zero = true;
    // four samples in a row: the third is examined first, so that a search for a root hidden around the second knows the
    // minima on both sides
    let mut window = [None; 4];
    for index in 0..points + 2 {
        window.rotate_left(1);
        window[3] = if index < points { Some(evaluate(grid.point(index))?) } else { None };
        all_zero &= window[3].is_none_or(|sample| sample.value.is_zero());
        if let Some(triple) = Triple::of(&window, 2).filter(Triple::is_minimum) {
            keep(&mut minima, refine(&mut evaluate, triple, tolerance)?, tolerance)?;
        }
        let Some(triple) = Triple::of(&window, 1) else { continue };
        if minima.iter().any(|known: &Minimum1d| !known.at_end && triple.spans(known.x)) {
            continue;
        }
        let Some(triple) = triple.between_samples(&mut evaluate)? else { continue };
        if let Some(minimum) = find_hidden(&mut evaluate, triple, tolerance)? {
            keep(&mut minima, minimum, tolerance)?;
        }
    }
    if all_zero {
        return Err(SearchError::Zero { points, at: None });
    }
    minima.as_mut_slice().sort_unstable_by(|a, b| a.x.total_cmp(&b.x));
    Ok(Minima { minima, evaluations })
}

/// A point and the modulus there.
#[derive(Clone, Copy)]
struct Sample {
    x: f64,
    value: Magnitude,
}

/// Three samples in a row; a missing neighbour is an end of the interval.
#[derive(Clone, Copy)]
struct Triple {
    before: Option<Sample>,
    middle: Sample,
    after: Option<Sample>,
}

impl Triple {
    /// The triple around position `k` of samples in a row.
    fn of(samples: &[Option<Sample>], k: usize) -> Option<Self> {
        samples[k].map(|middle| Triple { before: samples[k - 1], middle, after: samples[k + 1] })
    }

    /// Whether no neighbour is lower; a tie belongs to the earlier point, so that it counts once.
    fn is_minimum(&self) -> bool {
        self.before.is_none_or(|before| self.middle.value < before.value)
            && self.after.is_none_or(|after| self.middle.value <= after.value)
    }

    /// Whether there is a root between the samples although the middle is no minimum.
    fn hides_root(&self) -> bool {
        match (self.before, self.after) {
            (Some(before), Some(after)) => Magnitude::is_log_convex(before.value, self.middle.value, after.value),
            _ => false,
        }
    }

    /// Coordinates of the first and the last sample.
    fn range(&self) -> [f64; 2] {
        [self.before.unwrap_or(self.middle).x, self.after.unwrap_or(self.middle).x]
    }

    /// Length of the two cells.
    fn width(&self) -> f64 {
        let [start, end] = self.range();
        end - start
    }

    /// Whether a point lies in the two cells.
    fn spans(&self, x: f64) -> bool {
        let [start, end] = self.range();
        start <= x && x <= end
    }

    /// A triple without a missing neighbour: at an end of the interval that of the one cell and its middle.
    fn between_samples(
        self,
        evaluate: &mut impl FnMut(f64) -> Result<Sample, SearchError>,
    ) -> Result<Option<Self>, SearchError> {
        let (before, after) = (self.before.unwrap_or(self.middle), self.after.unwrap_or(self.middle));
        let at_end = self.before.is_none() || self.after.is_none();
        let middle = if at_end { between(evaluate, before, Some(after))? } else { Some(self.middle) };
        Ok(middle.map(|middle| Triple { before: Some(before), middle, after: Some(after) }))
    }
}

/// A sample midway between the middle and one of its neighbours, if there is a number between them.
fn between(
    evaluate: &mut impl FnMut(f64) -> Result<Sample, SearchError>,
    middle: Sample,
    outer: Option<Sample>,
) -> Result<Option<Sample>, SearchError> {
    let Some(outer) = outer else { return Ok(None) };
    let x = middle.x + (outer.x - middle.x) / 2.0;
    if x == middle.x || x == outer.x { Ok(None) } else { evaluate(x).map(Some) }
}

/// Halves the cells of a triple with a convex logarithm until one of the new points is a minimum, if any is.
fn find_hidden(
    evaluate: &mut impl FnMut(f64) -> Result<Sample, SearchError>,
    mut triple: Triple,
    tolerance: f64,
) -> Result<Option<Minimum1d>, SearchError> {
    for _ in 0..HALVINGS_TO_SHOW_A_ROOT {
        if triple.is_minimum() {
            return refine(evaluate, triple, tolerance).map(Some);
        }
        if !triple.hides_root() {
            break;
        }
        let lower = between(evaluate, triple.middle, triple.before)?;
        let upper = between(evaluate, triple.middle, triple.after)?;
        if lower.is_none() || upper.is_none() {
            // no number is left between two samples: a triple without one of them would pass for an end of the interval
            break;
        }
        let samples = [triple.before, lower, Some(triple.middle), upper, triple.after];
        let inner = || [1, 2, 3].into_iter().filter_map(|k| Triple::of(&samples, k));
        let Some(next) = inner().find(Triple::is_minimum).or_else(|| inner().find(Triple::hides_root)) else { break };
        triple = next;
    }
    Ok(None)
}

/// Adds a minimum unless it was found from a neighbouring point, too.
fn keep<const CAP: usize>(
    minima: &mut List<Minimum1d, CAP>,
    new: Minimum1d,
    tolerance: f64,
) -> Result<(), SearchError> {
    // each of the two stopped within one tolerance of the same root
    if let Some(old) = minima.as_mut_slice().iter_mut().find(|old| (old.x - new.x).abs() <= 2.0 * tolerance) {
        if old.at_end && !new.at_end {
            *old = new;
        }
        return Ok(());
    }
    minima.push(new).map_err(|_| SearchError::Capacity { capacity: CAP })
}

/// Halves the cells on both sides of a minimum until they are shorter than the tolerance together, or until no number
/// is left between them.
fn refine(
    evaluate: &mut impl FnMut(f64) -> Result<Sample, SearchError>,
    Triple { mut before, mut middle, mut after }: Triple,
    tolerance: f64,
) -> Result<Minimum1d, SearchError> {
    loop {
        if (Triple { before, middle, after }).width() <= tolerance {
            break;
        }
        let (lower, upper) = (between(evaluate, middle, before)?, between(evaluate, middle, after)?);
        if lower.is_none() && upper.is_none() {
            break;
        }
        let lowest = |sample: Option<Sample>, other: Option<Sample>| {
            sample.filter(|s| s.value < middle.value && other.is_none_or(|o| s.value <= o.value))
        };
        if let Some(lower) = lowest(lower, upper) {
            (middle, after) = (lower, Some(middle));
        } else if let Some(upper) = lowest(upper, lower) {
            (before, middle) = (Some(middle), upper);
        } else {
            (before, after) = (lower.or(before), upper.or(after));
        }
    }
    Ok(Minimum1d { x: middle.x, residual: middle.value, at_end: before.is_none() || after.is_none() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::ops::RangeInclusive;
    use proptest::prelude::*;

    fn search(f: impl FnMut(f64) -> f64, range: RangeInclusive<f64>) -> Minima<Minimum1d, 8> {
        fmin1d::<8, _>(f, range, 11, 1e-9).unwrap()
    }

    proptest! {
        #[test]
        fn finds_each_of_two_separated_roots(a in 0.0..4.0f64, gap in 2.5..6.0f64) {
            let found = search(|x| (x - a) * (x - a - gap), 0.0..=10.0);
            let interior: std::vec::Vec<f64> = found.iter().map(|m| m.x).collect();
            prop_assert_eq!(interior.len(), 2);
            prop_assert!((interior[0] - a).abs() <= 1e-9 && (interior[1] - a - gap).abs() <= 1e-9);
        }
    }

    #[test]
    fn a_root_in_the_first_or_last_cell_is_interior() {
        let found = search(|x| x - 0.2, 0.0..=10.0);
        assert_eq!((found.len(), found[0].at_end), (1, false));
        let found = search(|x| x - 9.9, 0.0..=10.0);
        assert_eq!((found.len(), found[0].at_end), (1, false));
    }

    #[test]
    fn the_end_of_a_monotone_function_is_marked() {
        let found = search(|x| x + 1.0, 0.0..=10.0);
        assert_eq!((found.len(), found[0].x, found[0].at_end), (1, 0.0, true));
        let found = search(|x| 11.0 - x, 0.0..=10.0);
        assert_eq!((found.len(), found[0].x, found[0].at_end), (1, 10.0, true));
    }

    #[test]
    fn a_tie_between_two_points_is_found_once() {
        for root in [0.5, 4.5, 9.5] {
            let found = search(|x| x - root, 0.0..=10.0);
            assert_eq!((found.len(), found[0].x), (1, root));
        }
    }

    #[test]
    fn a_tolerance_below_rounding_still_ends() {
        let found = fmin1d::<8, _>(|x: f64| x * x - 2.0, 1.0..=2.0, 3, 1e-300).unwrap();
        // |x² - 2| is the same at the two numbers next to the root
        assert!((found[0].x - 2f64.sqrt()).abs() <= f64::EPSILON);
    }

    /// The samples 0.97, 7.4, 10.4, 47 of section 4.1 rise past a root: here a steep factor does the same.
    #[test]
    fn a_root_that_the_samples_rise_or_fall_past_is_found() {
        for (slope, root) in [(1.0_f64, 4.6), (-1.0, 5.4)] {
            let f = |x: f64| (x - root) * (slope * x).exp();
            let grid: std::vec::Vec<f64> = (0..=10).map(|k| f(f64::from(k)).abs()).collect();
            let minimum = (1..10).any(|k| grid[k] < grid[k - 1] && grid[k] <= grid[k + 1]);
            assert!(!minimum, "the grid shows the root: {grid:?}");
            let found = search(f, 0.0..=10.0);
            assert!(found.iter().any(|m| !m.at_end && (m.x - root).abs() <= 1e-9), "{found:?}");
        }
    }

    /// The sample next to a root that the samples rise past is an end minimum, or belongs to another root.
    #[test]
    fn a_root_beside_another_minimum_is_found() {
        let assert_finds = |f: &dyn Fn(f64) -> f64, range: RangeInclusive<f64>, points, roots: &[f64]| {
            let found = fmin1d::<16, _>(f, range, points, 1e-7).unwrap();
            let interior: std::vec::Vec<f64> = found.iter().filter(|m| !m.at_end).map(|m| m.x).collect();
            assert!(interior.is_sorted(), "{interior:?}");
            for root in roots {
                assert!(interior.iter().any(|x| (x - root).abs() <= 1e-7), "{root} is not in {interior:?}");
            }
            assert_eq!(interior.len(), roots.len(), "{interior:?}");
        };
        assert_finds(&|x| (x - 0.9) * (5.0 * x).exp(), 0.0..=10.0, 11, &[0.9]);
        assert_finds(&|x| (x - 9.1) * (-5.0 * x).exp(), 0.0..=10.0, 11, &[9.1]);
        assert_finds(&|x| (x - 0.4) * (-5.0 * x).exp(), 0.0..=10.0, 11, &[0.4]);
        assert_finds(&|x| (x - 9.6) * (5.0 * x).exp(), 0.0..=10.0, 11, &[9.6]);
        assert_finds(&|x| (x - 1.08197) * (x - 3.13197) * (3.0 * x).exp(), 0.0..=10.0, 11, &[1.08197, 3.13197]);
        assert_finds(&|x| (x - 6.87) * (x - 8.92) * (-3.0 * x).exp(), 0.0..=10.0, 11, &[6.87, 8.92]);
        // a cantilever, Δ = 1 + cos βl cosh βl; the range starts beyond its first root
        let cantilever = |omega: f64| 1.0 + omega.sqrt().cos() * omega.sqrt().cosh();
        let beta_l = [4.694_091_132_974_175_f64, 7.854_757_438_237_613, 10.995_540_734_875_467, 14.137_168_391_046_47];
        assert_finds(&cantilever, 8.0..=210.0, 13, &beta_l.map(|x| x * x));
    }

    #[test]
    fn a_root_takes_the_place_of_an_end_within_the_tolerance() {
        for (root, tolerance) in [(0.4, 0.3), (0.9, 0.5), (0.9, 1.0)] {
            let found = fmin1d::<8, _>(|x: f64| (x - root) * (5.0 * x).exp(), 0.0..=10.0, 11, tolerance).unwrap();
            assert_eq!((found.len(), found[0].at_end), (1, false));
            assert!((found[0].x - root).abs() <= tolerance);
        }
    }

    #[test]
    fn a_function_without_minimum_has_ends_only_whatever_the_tolerance() {
        for tolerance in [1e-6, 1e-300] {
            let found = fmin1d::<8, _>(|x: f64| x.exp(), 0.0..=1.0, 11, tolerance).unwrap();
            assert_eq!((found.len(), found[0].x, found[0].at_end), (1, 0.0, true));
            let found = fmin1d::<8, _>(|_| 3.0, 0.0..=1.0, 101, tolerance).unwrap();
            assert_eq!((found.len(), found[0].x, found[0].at_end), (1, 0.0, true));
        }
        let found = fmin1d::<8, _>(|_| 3.0, 0.0..=1.0, 101, 1e-6).unwrap();
        // the grid, the cells at its ends, and the halvings of the first from 0.01 to 1e-6
        assert!(found.evaluations() <= 101 + 2 + 14, "{}", found.evaluations());
    }

    #[test]
    fn three_roots_to_a_millionth_take_the_evaluations_of_the_reference() {
        let found = fmin1d::<8, _>(|x: f64| (x - 200.0) * (x - 777.0) * (x - 1500.0), 1.0..=2000.0, 100, 1e-6).unwrap();
        assert_eq!(found.len(), 3);
        // and a look into the first and the last cell
        assert!(found.evaluations() <= 100 + 3 * 2 * 26 + 2, "{}", found.evaluations());
    }

    #[test]
    fn bad_input_is_an_error_with_its_numbers() {
        let run = |range, points, tolerance| fmin1d::<1, _>(|x: f64| x, range, points, tolerance).unwrap_err();
        assert_eq!(run(2.0..=1.0, 9, 0.1), SearchError::Range { start: 2.0, end: 1.0 });
        assert_eq!(run(1.0..=1.0, 9, 0.1), SearchError::Range { start: 1.0, end: 1.0 });
        assert!(matches!(run(f64::NAN..=1.0, 9, 0.1), SearchError::Range { .. }));
        assert!(matches!(run(0.0..=f64::INFINITY, 9, 0.1), SearchError::Range { .. }));
        assert!(matches!(run(0.0..=1.0, 2, 0.1), SearchError::Grid { points: 2, .. }));
        for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(run(0.0..=1.0, 9, tolerance), SearchError::Tolerance { .. }));
        }
        let nan = fmin1d::<1, _>(|x: f64| if x > 0.6 { f64::NAN } else { x }, 0.0..=1.0, 5, 0.1).unwrap_err();
        assert_eq!(nan, SearchError::NotANumber { x: 0.75, y: 0.0 });
        assert_eq!(run(-1e308..=1e308, 9, 0.1), SearchError::Range { start: -1e308, end: 1e308 });
        assert_eq!(run(0.0..=1.0, usize::MAX, 0.1), SearchError::Grid { points: usize::MAX, limit: MAX_POINTS });
        let zero = fmin1d::<1, _>(|_| 0.0, 0.0..=1.0, 9, 0.1).unwrap_err();
        assert_eq!(zero, SearchError::Zero { points: 9, at: None });
        let full = fmin1d::<1, _>(|x: f64| x.sin(), 1.0..=7.0, 20, 0.1).unwrap_err();
        assert_eq!(full, SearchError::Capacity { capacity: 1 });
    }
}
