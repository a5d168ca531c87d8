//! Recursive scanning for the minima of |Δ| on a rectangle.

use crate::model::SearchError;
use crate::number::{List, Magnitude};
use crate::search::minima::cells::Cells;
use crate::search::minima::grid::{Grid, MAX_POINTS, Minima};
use core::ops::RangeInclusive;

/// Largest number of grid points in the second direction: three rows of samples are kept on the stack.
pub const MAX_ROW: usize = 256;

/// Largest number of moves of a search with cells of one size.
pub const MAX_MOVES: usize = 1000;

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
/// is lowest along both axes. Around it the grid is halved again and again, moving to the lowest of 9 points each time,
/// until its cells are shorter than `tolerances`. Where a steep slope hides a root from the grid, a point is lowest along
/// one axis only, but convex in its logarithm along the other (log|Δ| is harmonic, so away from roots it is not convex
/// along both axes). There the four cells around the point are halved until one of the new points is lowest along both,
/// and the search does not leave the cells around that one. Minima that end within two cells of each other are one root.
///
/// # Limits
/// For a pole-free Δ(λ) each interior minimum is a root (minimum-modulus principle), as far as rounding lets it be seen: a
/// residual of 0 certifies nothing where it is smaller than the rounding noise. Roots closer than two cells, or than twice
/// the tolerances, are lost without notice, and multiplicity is not seen. Lost without notice is also a root past which
/// the samples slope along both axes, so that no point next to it is lowest along any; a finer grid shows it.
///
/// # Errors
/// [`SearchError`] for a range that is empty, reversed or not of finite length, fewer than 3 points in a direction or
/// more than [`MAX_POINTS`] in the first or [`MAX_ROW`] in the second, a tolerance that is not positive, a function value
/// that is not a number, a function that is zero at all points of the grid, a search that still moves after
/// [`MAX_MOVES`] moves with cells of one size (functions that are not analytic can have valleys that long), or more
/// than `CAP` minima.
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
        Grid::new(&ranges[0], points[0], MAX_POINTS, tolerances[0])?,
        Grid::new(&ranges[1], points[1], MAX_ROW, tolerances[1])?,
    ];
    let step = [grids[0].step(), grids[1].step()];
    let mut evaluations = 0;
    let mut evaluate = |x: f64, y: f64| {
        evaluations += 1;
        let value = function(x, y).into();
        if value.is_nan() { Err(SearchError::NotANumber { x, y }) } else { Ok(value) }
    };
    let mut minima = List::<Minimum2d, CAP>::new();
    let mut all_zero = true;
    let mut rows = [[None; MAX_ROW]; 3];
    for ahead in 0..=points[0] {
        rows.rotate_left(1);
        rows[2] = [None; MAX_ROW];
        for (k, place) in rows[2][..points[1]].iter_mut().enumerate().filter(|_| ahead < points[0]) {
            let value = evaluate(grids[0].point(ahead), grids[1].point(k))?;
            all_zero &= value.is_zero();
            *place = Some(value);
        }
        let Some(row) = ahead.checked_sub(1) else { continue };
        for column in 0..points[1] {
            let centre = [grids[0].point(row), grids[1].point(column)];
            let sample = |i: usize, j: usize| *rows[i].get((column + j).checked_sub(1)?)?;
            let Some(cells) = Cells::new(centre, step, sample) else { continue };
            if let Some(minimum) = search_around(cells, &mut evaluate, &grids, &minima)? {
                minima.push(minimum).map_err(|_| SearchError::Capacity { capacity: CAP })?;
            }
        }
    }
    if all_zero {
        return Err(SearchError::Zero { points: points[0].saturating_mul(points[1]), at: None });
    }
    Ok(Minima { minima, evaluations })
}

/// The minimum to which a point of the grid leads, if it is not known yet.
fn search_around(
    cells: Cells,
    evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
    grids: &[Grid; 2],
    known: &[Minimum2d],
) -> Result<Option<Minimum2d>, SearchError> {
    // a root within a cell is what makes a point a candidate
    let near = |x: f64, axis: usize| (x - cells.centre[axis]).abs() <= cells.step[axis];
    if known.iter().any(|old| !old.at_edge && near(old.x, 0) && near(old.y, 1)) {
        return Ok(None);
    }
    if cells.is_minimum() {
        return refine(cells, grids.map(|grid| [grid.start, grid.end]), evaluate, grids, known);
    }
    match cells.find_minimum(evaluate, grids)? {
        Some(inner) => refine(inner, inner.bounds(grids), evaluate, grids, known),
        None => Ok(None),
    }
}

/// Halvings after which a search within the cells of a known minimum is assumed to end there, too.
const HALVINGS_TO_TELL_ROOTS_APART: u32 = 4;

/// Halves the cells around the lowest point so far, moving along with it inside `bounds`, until they are shorter than
/// the tolerances or no number is left between two points. `None` where that leads to a minimum that is known already,
/// or to bounds inside the rectangle, beyond which the function falls further.
fn refine(
    Cells { mut centre, mut step, own: mut value, .. }: Cells,
    bounds: [[f64; 2]; 2],
    evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
    grids: &[Grid; 2],
    known: &[Minimum2d],
) -> Result<Option<Minimum2d>, SearchError> {
    let on_edge = |[x, y]: [[f64; 2]; 2], centre: [f64; 2]| x.contains(&centre[0]) || y.contains(&centre[1]);
    let edges = grids.map(|grid| [grid.start, grid.end]);
    // each of two searches for one root stops within a cell of it; a minimum on an edge need not be a root
    let is_known = |centre: [f64; 2], step: [f64; 2]| {
        let near = |x: f64, axis: usize| (x - centre[axis]).abs() <= 2.0 * step[axis];
        known.iter().any(|old| near(old.x, 0) && near(old.y, 1) && (!old.at_edge || on_edge(edges, centre)))
    };
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
        let mut moves = 0;
        while let Some((lower, lower_value)) = lowest_neighbour(evaluate, bounds, centre, step, value)? {
            (centre, value) = (lower, lower_value);
            moves += 1;
            if moves == MAX_MOVES {
                return Err(SearchError::StillMoving { x: centre[0], y: centre[1], moves });
            }
        }
        halvings += 1;
        if halvings >= HALVINGS_TO_TELL_ROOTS_APART && is_known(centre, step) {
            return Ok(None);
        }
    }
    let at_edge = on_edge(edges, centre);
    if is_known(centre, step) || (on_edge(bounds, centre) && !at_edge) {
        return Ok(None);
    }
    Ok(Some(Minimum2d { x: centre[0], y: centre[1], residual: value, at_edge }))
}

/// The lowest of the 8 neighbours at a given step inside the bounds, if it is lower than the centre.
fn lowest_neighbour(
    evaluate: &mut impl FnMut(f64, f64) -> Result<Magnitude, SearchError>,
    bounds: [[f64; 2]; 2],
    centre: [f64; 2],
    step: [f64; 2],
    value: Magnitude,
) -> Result<Option<([f64; 2], Magnitude)>, SearchError> {
    let mut lowest = None;
    let mut bound = value;
    for sign in [[-1, -1], [-1, 0], [-1, 1], [0, -1], [0, 1], [1, -1], [1, 0], [1, 1]] {
        let point: [f64; 2] = core::array::from_fn(|axis| {
            let moved = centre[axis] + f64::from(sign[axis]) * step[axis];
            moved.clamp(bounds[axis][0], bounds[axis][1])
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

    /// The one root of `(z - root) e^{slope z}` off the edges of a grid of cells of length 1.
    fn assert_finds_the_root_beside(slope: C, root: C) {
        let f = |x, y| (C::new(x, y) - root) * (C::new(x, y) * slope).exp();
        let found = fmin2d::<8, _>(f, [0.0..=10.0, 0.0..=10.0], [11, 11], [1e-6, 1e-6]).unwrap();
        let interior: std::vec::Vec<_> = found.iter().filter(|m| !m.at_edge).collect();
        assert_eq!(interior.len(), 1, "{found:?}");
        assert!((C::new(interior[0].x, interior[0].y) - root).norm() < 2e-6, "{found:?}");
    }

    proptest! {
        /// The slope leads to an edge, past the root that made a point a candidate.
        #[test]
        fn a_slope_along_an_axis_does_not_lead_away_from_a_root(re in 1.0..9.0f64, im in 1.0..9.0f64, slope in -4.0..4.0f64) {
            assert_finds_the_root_beside(C::new(slope, 0.0), C::new(re, im));
            assert_finds_the_root_beside(C::new(0.0, slope), C::new(re, im));
        }
    }

    #[test]
    fn a_root_beside_the_slope_to_a_corner_is_found() {
        assert_finds_the_root_beside(C::new(-2.8, 0.0), C::new(1.378, 1.1316));
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
    fn a_function_that_is_constant_along_an_axis_has_one_minimum() {
        for along in [[1.0, 0.0], [0.0, 1.0]] {
            for shift in [0.5, 1.0, -2.4] {
                let f = |x: f64, y: f64| along[0] * x + along[1] * y + shift;
                let found = fmin2d::<2, _>(f, [0.0..=4.0, 0.0..=4.0], [5, 5], [1e-6, 1e-6]).unwrap();
                assert_eq!((found.len(), found[0].at_edge), (1, true));
            }
        }
    }

    #[test]
    fn a_tolerance_as_coarse_as_the_grid_gives_a_root_once() {
        for tolerance in [0.13, 0.3, 0.6, 1.0, 2.0] {
            for (x, y, slope) in [(1.5, 1.5, 1.2), (1.4, 2.6, 1.2), (1.3, 1.3, 1.2), (2.0, 2.1, 0.5)] {
                let f = |re: f64, im: f64| C::new(re - x, im - y) * (slope * re).exp();
                let found = fmin2d::<8, _>(f, [0.0..=6.0, 0.0..=6.0], [7, 7], [tolerance; 2]).unwrap();
                let interior: std::vec::Vec<_> = found.iter().filter(|m| !m.at_edge).collect();
                assert_eq!(interior.len(), 1, "{found:?}");
                let Minimum2d { x: re, y: im, .. } = interior[0];
                assert!((re - x).abs() <= tolerance && (im - y).abs() <= tolerance, "{found:?}");
            }
        }
    }

    #[test]
    fn a_valley_without_end_is_an_error_with_its_place() {
        let f = |x: f64, y: f64| C::new(1e4 * (y - x * x), 1.0 - x);
        let error = fmin2d::<8, _>(f, [-2.0..=2.0, -1.0..=3.0], [11, 11], [1e-9, 1e-9]).unwrap_err();
        assert!(matches!(error, SearchError::StillMoving { moves: MAX_MOVES, .. }), "{error}");
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
        assert!(matches!(
            fmin2d::<1, _>(|_, _| 1.0, unit(), [usize::MAX, 5], [0.1, 0.1]).unwrap_err(),
            SearchError::Grid { points: usize::MAX, limit: MAX_POINTS }
        ));
        let zero = fmin2d::<1, _>(|_, _| 0.0, unit(), [3, 4], [0.1, 0.1]).unwrap_err();
        assert_eq!(zero, SearchError::Zero { points: 12, at: None });
        let two = fmin2d::<1, _>(|x: f64, y: f64| C::new((x - 0.2) * (x - 0.8), y - 0.5), unit(), [11, 11], [0.1, 0.1]);
        assert_eq!(two.unwrap_err(), SearchError::Capacity { capacity: 1 });
    }
}
