//! Recursive scanning for the minima of |Δ| on an interval.

use super::{Grid, Minima};
use crate::error::SearchError;
use crate::list::List;
use crate::scaled::Magnitude;
use core::ops::RangeInclusive;

/// A local minimum on an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Minimum1d {
    /// Where it is.
    pub x: f64,
    /// The modulus of the function there.
    pub residual: Magnitude,
    /// Whether it is an end of the interval: the function may fall further beyond it, so it need not be a root.
    pub at_end: bool,
}

/// The local minima of `|function|` on `range`, by the paper's recursive scanning.
///
/// The function is evaluated at `points` equally spaced points; each local minimum, the ends of the interval
/// included, has its two neighbouring cells scanned again in four cells until they are shorter than `tolerance`.
///
/// For a Δ(ω) without poles of an undamped system each interior minimum is a root. Roots closer than two cells are
/// lost without notice, and multiplicity is not seen.
///
/// # Errors
/// [`SearchError`] for a range that is empty, reversed or not finite, fewer than 3 points, a tolerance that is not
/// positive, a function value that is not a number, or more than `CAP` minima.
///
/// # Source
/// fMin1D of the paper's reference [23], as section 4.1 uses it.
///
/// ```
/// let minima = mstmm_core::search::fmin1d::<4, _>(|x: f64| x.sin(), 1.0..=7.0, 20, 1e-9)?;
/// assert_eq!(minima.len(), 2);
/// assert!((minima[0].x - core::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), mstmm_core::SearchError>(())
/// ```
pub fn fmin1d<const CAP: usize, V: Into<Magnitude>>(
    mut function: impl FnMut(f64) -> V,
    range: RangeInclusive<f64>,
    points: usize,
    tolerance: f64,
) -> Result<Minima<Minimum1d, CAP>, SearchError> {
    let grid = Grid::new(&range, points, usize::MAX, tolerance)?;
    let mut evaluations = 0;
    let mut evaluate = |x: f64| {
        evaluations += 1;
        Sample::new(x, function(x).into())
    };
    let mut minima = List::new();
    let mut previous = None;
    let mut current = evaluate(grid.point(0))?;
    for index in 1..=points {
        let next = if index < points { Some(evaluate(grid.point(index))?) } else { None };
        // a tie belongs to the earlier point, so that a root midway between two points is found once
        let falls = previous.is_none_or(|previous: Sample| current.value < previous.value);
        let rises = next.is_none_or(|next| current.value <= next.value);
        if falls && rises {
            let minimum = refine(&mut evaluate, previous, current, next, tolerance)?;
            minima.push(minimum).map_err(|_| SearchError::Capacity { capacity: CAP })?;
        }
        let Some(next) = next else { break };
        (previous, current) = (Some(current), next);
    }
    Ok(Minima { minima, evaluations })
}

/// A point and the modulus there.
#[derive(Clone, Copy)]
struct Sample {
    x: f64,
    value: Magnitude,
}

impl Sample {
    fn new(x: f64, value: Magnitude) -> Result<Self, SearchError> {
        if value.is_nan() { Err(SearchError::NotANumber { x, y: 0.0 }) } else { Ok(Sample { x, value }) }
    }
}

/// Halves the cells on both sides of a minimum until they are shorter than the tolerance together, or until no number
/// is left between them. A missing neighbour is an end of the interval.
fn refine(
    evaluate: &mut impl FnMut(f64) -> Result<Sample, SearchError>,
    mut before: Option<Sample>,
    mut middle: Sample,
    mut after: Option<Sample>,
    tolerance: f64,
) -> Result<Minimum1d, SearchError> {
    loop {
        let (start, end) = (before.unwrap_or(middle).x, after.unwrap_or(middle).x);
        if end - start <= tolerance {
            break;
        }
        let mut between = |outer: Option<Sample>| match outer {
            Some(outer) => {
                let x = middle.x + (outer.x - middle.x) / 2.0;
                if x == middle.x || x == outer.x { Ok(None) } else { evaluate(x).map(Some) }
            }
            None => Ok(None),
        };
        let (lower, upper) = (between(before)?, between(after)?);
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

    #[test]
    fn three_roots_to_a_millionth_take_the_evaluations_of_the_reference() {
        let found = fmin1d::<8, _>(|x: f64| (x - 200.0) * (x - 777.0) * (x - 1500.0), 1.0..=2000.0, 100, 1e-6).unwrap();
        assert_eq!(found.len(), 3);
        assert!(found.evaluations() <= 100 + 3 * 2 * 26, "{}", found.evaluations());
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
        let full = fmin1d::<1, _>(|x: f64| x.sin(), 1.0..=7.0, 20, 0.1).unwrap_err();
        assert_eq!(full, SearchError::Capacity { capacity: 1 });
    }
}
