//! The methods of a scene that evaluate its transfer matrices, with the type of the system hidden.

use super::{ELLIPSE, LINE, Scene, fewest_points};
use crate::contour::Beyn;
use crate::found::Found;
use crate::plain;
use crate::structure::Structure;
use core::ops::RangeInclusive;
use mstmm::element::SMatrix;
use mstmm::prelude::*;
use mstmm::search::System;

/// Room for the minima of a scan, ends and edges of its range included.
const MINIMA: usize = 32;

/// The first frequencies, certified; none where the search fails.
pub(super) fn first<Y: Undamped + System<Parameter = f64>, const N: usize>(system: &Y) -> Found {
    system.first_frequencies::<N>().map_or(Found::new(0), |list| of_list(&list, list.evaluations()))
}

/// All frequencies of a range, certified.
pub(super) fn in_range<Y: Undamped + System<Parameter = f64>>(system: &Y, range: RangeInclusive<f64>) -> Found {
    system.natural_frequencies::<2>(range).map_or(Found::new(0), |list| of_list(&list, list.evaluations()))
}

/// Each frequency as often as it is there.
fn of_list(list: &[NaturalFrequency], evaluations: usize) -> Found {
    let each = list.iter().flat_map(|root| (0..root.multiplicity).map(|_| root.omega));
    Found::of_frequencies(each, evaluations)
}

/// The paper's scan for minima on a line.
fn scan_line(system: &impl Evaluate<f64>, range: &RangeInclusive<f64>, points: usize, tolerance: f64) -> Found {
    let function = |omega| system.overall_determinant(omega);
    let minima = fmin1d::<MINIMA, _>(function, range.clone(), points, tolerance * range.end());
    minima.map_or(Found::new(0), |minima| {
        let interior = minima.iter().filter(|minimum| !minimum.at_end).map(|minimum| minimum.x);
        Found::of_frequencies(interior, minima.evaluations())
    })
}

/// The paper's scan for minima on its rectangle and grid.
fn scan_rectangle(system: &impl Evaluate<Complex<f64>>, tolerance: f64) -> Found {
    let function = |omega, delta: f64| system.overall_determinant(Complex::new(-delta, omega));
    let ranges = [-10.0..=12_000.0, -5.0..=300.0];
    let minima = fmin2d::<MINIMA, _>(function, ranges, [40, 20], [tolerance * 12_000.0; 2]);
    minima.map_or(Found::new(0), |minima| {
        let mut found = Found::new(minima.evaluations());
        let interior = minima.iter().filter(|minimum| !minimum.at_edge);
        interior.for_each(|minimum| found.push(Complex::new(-minimum.y, minimum.x)));
        found.sorted()
    })
}

/// A scene of an undamped system.
pub(super) fn undamped<Y>(
    name: &'static str,
    system: Y,
    certified: impl Fn(&Y) -> Found + 'static,
    exact: Vec<f64>,
    range: RangeInclusive<f64>,
    points: usize,
    structure: Structure,
) -> Scene
where
    Y: Evaluate<f64> + Undamped + System<Parameter = f64> + Clone + 'static,
{
    let separating = fewest_points(&exact, &range);
    let (plain_system, scan_system, scan_range) = (system.clone(), system.clone(), range.clone());
    Scene {
        name,
        exact: exact.into_iter().map(|omega| Complex::new(0.0, omega)).collect(),
        structure,
        shift: 0.0,
        has_close_roots: false,
        certified: Box::new(move || certified(&system)),
        plain: Box::new(move |tolerance| plain::line(&plain_system, &range, separating, tolerance)),
        scan: Box::new(move |tolerance| scan_line(&scan_system, &scan_range, points, tolerance)),
        contour: None,
    }
}

/// A scene of a damped system, with the paper's rectangle.
pub(super) fn damped<Y>(name: &'static str, system: Y, exact: Vec<Complex<f64>>, structure: Structure) -> Scene
where
    Y: Evaluate<Complex<f64>, Matrix = SMatrix<Complex<f64>, 7, 7>>
        + Spectrum
        + System<Parameter = f64>
        + Clone
        + 'static,
{
    let (plain_system, scan_system) = (system.clone(), system.clone());
    let beyn = Beyn::new(system.clone(), ELLIPSE);
    let certified = move || {
        let region = Region { re: -300.0..=5.0, im: -10.0..=12_000.0 };
        system.eigenvalues::<8>(region).map_or(Found::new(0), |list| {
            let mut found = Found::new(list.evaluations());
            let each = list.iter().flat_map(|root| (0..root.multiplicity).map(|_| root.lambda));
            each.for_each(|lambda| found.push(lambda));
            found
        })
    };
    Scene {
        name,
        exact,
        structure,
        shift: 0.0,
        has_close_roots: false,
        certified: Box::new(certified),
        plain: Box::new(move |tolerance| plain::strip(&plain_system, LINE, 12_000.0, tolerance)),
        scan: Box::new(move |tolerance| scan_rectangle(&scan_system, tolerance)),
        contour: Some(Box::new(move |nodes| beyn.solve(nodes))),
    }
}
