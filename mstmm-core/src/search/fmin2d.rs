//! Recursive scanning for the minima of |Δ| on a rectangle.

use super::{Grid, Minima};
use crate::error::SearchError;
use crate::list::List;
use crate::scaled::Magnitude;
use core::ops::RangeInclusive;

/// Largest number of grid points in the second direction: three rows of samples are kept on the stack.
pub const MAX_ROW: usize = 256;

/// A local minimum on a rectangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Minimum2d {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
    /// The modulus of the function there.
    pub residual: Magnitude,
    /// Whether it lies on an edge of the rectangle: the function may fall further beyond it, so it need not be a root.
    pub at_edge: bool,
}

/// The local minima of `|function|` on a rectangle, by the paper's recursive scanning.
///
/// The function is evaluated on a grid of `points[0]` by `points[1]` points; a point becomes a candidate where it
/// is lowest along one axis and lowest along the other, too, or convex in its logarithm: there a steep slope hides a root
/// from the grid (log|Δ| is harmonic, so away from roots it is not convex along both axes). Around a candidate the grid is
/// halved again and again, moving to the lowest of 9 points each time, until its cells are shorter than `tolerances`. Candidates that end within a tolerance of each other are one root.
///
/// For a pole-free Δ(λ) each interior minimum is a root (minimum-modulus principle). Roots closer than two cells are
/// lost without notice, and multiplicity is not seen.
///
/// # Errors
/// [`SearchError`] for a range that is empty, reversed or not finite, fewer than 3 points in a direction (or more than
/// [`MAX_ROW`] in the second), a tolerance that is not positive, a function value that is not a number, or more than
/// `CAP` minima.
///
/// # Source
/// fMin2D of the paper's reference 23, as section 4.5 uses it; the search for hidden roots is an addition.
///
/// ```
/// use mstmm_core::search::fmin2d;
/// use num_complex::Complex;
/// let square = |x, y| Complex::<f64>::new(x, y).powu(2) + 1.0; // roots ±i
/// let minima = fmin2d::<4, _>(square, [-1.0..=1.5, 0.0..=2.0], [10, 10], [1e-9, 1e-9])?;
/// assert_eq!(minima.len(), 1);
/// assert!(minima[0].x.abs() < 1e-8 && (minima[0].y - 1.0).abs() < 1e-8);
/// # Ok::<(), mstmm_core::SearchError>(())
/// ```
pub fn fmin2d<const CAP: usize, V: Into<Magnitude>>(
    mut function: impl FnMut(f64, f64) -> V,
    ranges: [RangeInclusive<f64>; 2],
    points: [usize; 2],
    tolerances: [f64; 2],
) -> Result<Minima<Minimum2d, CAP>, SearchError> {
    let grids = [
        Grid::new(&ranges[0], points[0], usize::MAX, tolerances[0])?,
        Grid::new(&ranges[1], points[1], MAX_ROW, tolerances[1])?,
    ];
    let mut evaluations = 0;
    let mut evaluate = |x: f64, y: f64| {
        evaluations += 1;
        let value = function(x, y).into();
        if value.is_nan() { Err(SearchError::NotANumber { x, y }) } else { Ok(value) }
    };
    let mut minima = List::<Minimum2d, CAP>::new();
    let mut rows = [[Magnitude::default(); MAX_ROW]; 3];
    for ahead in 0..=points[0] {
        if ahead < points[0] {
            for (k, place) in rows[ahead % 3][..points[1]].iter_mut().enumerate() {
                *place = evaluate(grids[0].point(ahead), grids[1].point(k))?;
            }
        }
        let Some(row) = ahead.checked_sub(1) else { continue };
        for column in 0..points[1] {
            let start = [grids[0].point(row), grids[1].point(column)];
            // a root within a cell is what makes this point a candidate
            let known = |minimum: &Minimum2d| {
                (minimum.x - start[0]).abs() <= grids[0].step() && (minimum.y - start[1]).abs() <= grids[1].step()
            };
            if minima.iter().any(known) || !is_candidate(&rows, [row, column], points) {
                continue;
            }
            if let Some(minimum) = refine(&mut evaluate, &grids, start, rows[row % 3][column], &minima)? {
                minima.push(minimum).map_err(|_| SearchError::Capacity { capacity: CAP })?;
            }
        }
    }
    Ok(Minima { minima, evaluations })
}

/// Whether a grid point is lowest along one axis and has a convex logarithm along the other.
fn is_candidate(rows: &[[Magnitude; MAX_ROW]; 3], [row, column]: [usize; 2], points: [usize; 2]) -> bool {
    let own = rows[row % 3][column];
    let neighbours = [
        (
            row.checked_sub(1).map(|row| rows[row % 3][column]),
            (row + 1 < points[0]).then(|| rows[(row + 1) % 3][column]),
        ),
        (column.checked_sub(1).map(|k| rows[row % 3][k]), (column + 1 < points[1]).then(|| rows[row % 3][column + 1])),
    ];
    // a tie belongs to the earlier point, so that it counts once
    let lowest = neighbours
        .map(|(before, after)| before.is_none_or(|before| own < before) && after.is_none_or(|after| own <= after));
    let convex = neighbours.map(|(before, after)| match (before, after) {
        (Some(before), Some(after)) => Magnitude::is_log_convex(before, own, after),
        _ => false,
    });
    (lowest[0] && (lowest[1] || convex[1])) || (lowest[1] && convex[0])
}

/// Halvings after which a search that has come to the cells of a known minimum is taken to end there, too.
const HALVINGS_TO_TELL_ROOTS_APART: u32 = 4;

/// Halves the cells around the lowest point so far, moving along with it, until they are shorter than the tolerances
/// or no number is left between two points. `None` where that leads to a minimum that is known already.
fn refine(
    evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
    grids: &[Grid; 2],
    mut centre: [f64; 2],
    mut value: Magnitude,
    known: &[Minimum2d],
) -> Result<Option<Minimum2d>, SearchError> {
    let mut step = [grids[0].step(), grids[1].step()];
    let mut halvings = 0;
    loop {
        let before = step;
        for axis in 0..2 {
            if step[axis] > grids[axis].tolerance && centre[axis] + step[axis] / 2.0 != centre[axis] {
                step[axis] /= 2.0;
            }
        }
        if step == before {
            break;
        }
        // every move lowers the value on a finite grid, so this ends
        while let Some((lower, lower_value)) = lowest_neighbour(evaluate, grids, centre, step, value)? {
            (centre, value) = (lower, lower_value);
        }
        halvings += 1;
        // each of two searches for one root stops within a cell of it
        let here =
            |old: &Minimum2d| (old.x - centre[0]).abs() <= 2.0 * step[0] && (old.y - centre[1]).abs() <= 2.0 * step[1];
        if halvings >= HALVINGS_TO_TELL_ROOTS_APART && known.iter().any(here) {
            return Ok(None);
        }
    }
    let on_edge = |axis: usize| centre[axis] == grids[axis].start || centre[axis] == grids[axis].end;
    Ok(Some(Minimum2d { x: centre[0], y: centre[1], residual: value, at_edge: on_edge(0) || on_edge(1) }))
}

/// The lowest of the 8 neighbours at a given step inside the rectangle, if it is lower than the centre.
fn lowest_neighbour(
    evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
    grids: &[Grid; 2],
    centre: [f64; 2],
    step: [f64; 2],
    value: Magnitude,
) -> Result<Option<([f64; 2], Magnitude)>, SearchError> {
    let mut lowest = None;
    let mut bound = value;
    for sign in [[-1, -1], [-1, 0], [-1, 1], [0, -1], [0, 1], [1, -1], [1, 0], [1, 1]] {
        let point: [f64; 2] = core::array::from_fn(|axis| {
            let moved = centre[axis] + f64::from(sign[axis]) * step[axis];
            moved.clamp(grids[axis].start, grids[axis].end)
        });
        if point == centre {
            continue;
        }
        let candidate = evaluate(point[0], point[1])?;
        if candidate < bound {
            (lowest, bound) = (Some((point, candidate)), candidate);
        }
    }
    Ok(lowest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex;
    use proptest::prelude::*;

    type C = Complex<f64>;

    proptest! {
        #[test]
        fn finds_each_of_two_separated_roots(ax in -4.0..0.0f64, bx in 2.0..4.0f64, ay in -4.0..4.0f64, by in -4.0..4.0f64) {
            let (a, b) = (C::new(ax, ay), C::new(bx, by));
            let f = |x, y| { let z = C::new(x, y); (z - a) * (z - b) };
            let found = fmin2d::<8, _>(f, [-5.0..=5.0, -5.0..=5.0], [21, 23], [1e-8, 1e-8]).unwrap();
            prop_assert_eq!(found.len(), 2);
            for root in [a, b] {
                prop_assert!(found.iter().any(|m| (C::new(m.x, m.y) - root).norm() < 4e-8));
            }
        }
    }

    #[test]
    fn a_root_that_a_steep_slope_hides_from_the_grid_is_found() {
        let root = C::new(4.6, 4.5);
        let f = |x: f64, y: f64| (C::new(x, y) - root) * (1.2 * x).exp();
        let modulus = |i: i32, j: i32| f(f64::from(i), f64::from(j)).norm();
        let lower_neighbour =
            |i, j| [-1, 0, 1].iter().any(|di| [-1, 0, 1].iter().any(|dj| modulus(i + di, j + dj) < modulus(i, j)));
        assert!((1..10).all(|i| (1..10).all(|j| lower_neighbour(i, j))), "the grid shows the root");
        let found = fmin2d::<8, _>(f, [0.0..=10.0, 0.0..=10.0], [11, 11], [1e-8, 1e-8]).unwrap();
        assert!(found.iter().any(|m| !m.at_edge && (C::new(m.x, m.y) - root).norm() < 4e-8), "{found:?}");
    }

    #[test]
    fn a_root_amid_four_equal_points_is_found_once() {
        let f = |x: f64, y: f64| C::new(x - 0.5, y - 0.5);
        let found = fmin2d::<8, _>(f, [0.0..=4.0, 0.0..=4.0], [5, 5], [1e-6, 1e-6]).unwrap();
        assert_eq!((found.len(), found[0].at_edge), (1, false));
        assert!((found[0].x - 0.5).abs() < 1e-6 && (found[0].y - 0.5).abs() < 1e-6);
    }

    #[test]
    fn a_root_on_an_edge_and_a_function_that_falls_beyond_one_are_marked() {
        let f = |x: f64, y: f64| C::new(x + 1.0, y - 2.0);
        let found = fmin2d::<8, _>(f, [0.0..=4.0, 0.0..=4.0], [5, 5], [1e-6, 1e-6]).unwrap();
        assert_eq!((found.len(), found[0].x, found[0].at_edge), (1, 0.0, true));
    }

    #[test]
    fn bad_input_is_an_error_with_its_numbers() {
        let run = |ranges, points, tolerances| {
            fmin2d::<1, _>(|x: f64, y: f64| C::new(x, y), ranges, points, tolerances).unwrap_err()
        };
        let unit = 0.0..=1.0;
        let reversed = 1.0..=0.0;
        assert!(matches!(
            run([unit.clone(), reversed], [5, 5], [0.1, 0.1]),
            SearchError::Range { start: 1.0, end: 0.0 }
        ));
        let unit = || [unit.clone(), unit.clone()];
        assert!(matches!(run(unit(), [2, 5], [0.1, 0.1]), SearchError::Grid { points: 2, .. }));
        assert!(matches!(run(unit(), [5, 257], [0.1, 0.1]), SearchError::Grid { points: 257, limit: MAX_ROW }));
        assert!(matches!(run(unit(), [5, 5], [0.1, -0.1]), SearchError::Tolerance { .. }));
        let nan = fmin2d::<1, _>(|_, y| if y > 0.6 { f64::NAN } else { y }, unit(), [3, 3], [0.1, 0.1]).unwrap_err();
        assert_eq!(nan, SearchError::NotANumber { x: 0.0, y: 1.0 });
        let two = fmin2d::<1, _>(|x: f64, y: f64| C::new((x - 0.2) * (x - 0.8), y - 0.5), unit(), [11, 11], [0.1, 0.1]);
        assert_eq!(two.unwrap_err(), SearchError::Capacity { capacity: 1 });
    }
}
