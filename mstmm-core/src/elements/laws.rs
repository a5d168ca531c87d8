//! Laws that every element obeys, run over the list of all elements.

mod charts;
mod count_steps;
mod motions;
mod path_charts;
mod plane_steps;
mod subspaces;

use super::*;
use crate::element::{Element, MatrixOf, TransferMatrix};
use crate::model::StateSpace;
use crate::number::assert_close;
use core::ops::Index;
use mstmm_plan::Coordinate;
use num_complex::Complex;
use proptest::test_runner::TestRunner;
use std::vec::Vec;

/// A random valid element.
pub(super) trait Sample: Element + Copy + core::fmt::Debug {
    /// Draws each parameter from `next`, which returns numbers in [0.5, 2].
    fn sample(next: impl FnMut() -> f64) -> Self;

    /// Half of the element, where two halves in a row make the whole.
    fn halves(self) -> Option<Self> {
        None
    }

    /// The largest phase of its waves at `|λ| = s²`, whose rounding the law of halves allows: s where it grows with `sqrt(|λ|)`.
    fn phase(&self, s: f64) -> f64 {
        s
    }

    /// Its length, where a chart takes one.
    fn length(&self) -> f64 {
        1.0
    }

    /// The element without its springs to the ground.
    fn untied(self) -> Self {
        self
    }

    /// The element without a loss factor, which makes it differ for conjugate frequencies.
    fn lossless(self) -> Self {
        self
    }
}

type C = Complex<f64>;
type Rows = Vec<Vec<C>>;

/// Runs a law on random samples of an element at random λ; a failure shows the law's own line and the element.
#[track_caller]
fn check<E: Sample>(law: impl Fn(E, C)) {
    let numbers = proptest::collection::vec(0.5..2.0f64, 12);
    let run = TestRunner::deterministic().run(&(numbers, -3.0..3.0f64, -3.0..3.0f64), |(numbers, re, im)| {
        let mut numbers = numbers.into_iter();
        law(E::sample(|| numbers.next().unwrap()), C::new(re, im));
        Ok(())
    });
    if let Err(error) = run {
        panic!("{}: {error}", core::any::type_name::<E>());
    }
}

/// A built sample; samples are valid.
fn built<E: Sample>(element: E) -> E::Built {
    match element.build() {
        Ok(built) => built,
        Err(error) => panic!("{element:?}: {error:?}"),
    }
}

/// Transfer matrix at λ as plain rows.
fn rows<E>(element: &E, lambda: C) -> Rows
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    let size = E::State::SPACE.size();
    let u = E::transfer_matrix(&built(*element), lambda);
    (0..size).map(|i| (0..size).map(|j| u[(i, j)]).collect()).collect()
}

fn product(a: &Rows, b: &Rows) -> Rows {
    let entry = |i: usize, j: usize| (0..b.len()).map(|k| a[i][k] * b[k][j]).sum();
    (0..a.len()).map(|i| (0..a.len()).map(|j| entry(i, j)).collect()).collect()
}

fn largest(a: &Rows) -> f64 {
    a.iter().flatten().map(|z| z.norm()).fold(1.0, f64::max)
}

fn assert_same(a: &Rows, b: &Rows, scale: f64) {
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        // sums of up to 6 products of matrices whose entries carry about ten roundings each
        assert_close((a - b).norm(), 0.0, scale, 6.0 * 10.0);
    }
}

/// `UᵀJU = J` for the form that pairs X with Qx, Y with Q and, with the opposite sign, Θ with M: power in equals power
/// out. It implies det U = 1.
fn is_symplectic<E>()
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(|element: E, lambda| {
        let u = rows(&element, lambda);
        let coordinates = E::State::SPACE.coordinates();
        let pairs = [
            (Coordinate::X, Coordinate::Qx, 1.0),
            (Coordinate::Y, Coordinate::Q, 1.0),
            (Coordinate::Theta, Coordinate::M, -1.0),
        ];
        let form = |a: Coordinate, b: Coordinate| {
            let sign = |(x, q, sign): &(Coordinate, Coordinate, f64)| match () {
                () if (*x, *q) == (a, b) => *sign,
                () if (*x, *q) == (b, a) => -*sign,
                () => 0.0,
            };
            C::from(pairs.iter().map(sign).sum::<f64>())
        };
        let j: Rows = coordinates.iter().map(|&a| coordinates.iter().map(|&b| form(a, b)).collect()).collect();
        let transposed: Rows = (0..u.len()).map(|i| (0..u.len()).map(|k| u[k][i]).collect()).collect();
        assert_same(&product(&transposed, &product(&j, &u)), &j, largest(&u).powi(2));
    });
}

fn two_halves_make_the_whole<E>()
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(|element: E, lambda| {
        let Some(half) = element.halves() else { return };
        let (whole, half) = (rows(&element, lambda), rows(&half, lambda));
        assert_same(&product(&half, &half), &whole, largest(&half).powi(2));
    });
}

/// At λ = 0 a displacement needs no force, but for springs of the element to the ground.
fn rests_without_force<E>()
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(|element: E, _| {
        let size = E::State::SPACE.size();
        if E::denominator(&built(element), C::ZERO).is_some_and(|kappa| kappa == C::ZERO) {
            return; // a damper alone has a pole at rest
        }
        let u = rows(&element.untied(), C::ZERO);
        for row in &u[size / 2..] {
            assert!(row[..size / 2].iter().all(|&entry| entry == C::ZERO), "{row:?}");
        }
    });
}

fn conjugate_frequencies_give_conjugate_matrices<E>()
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(|element: E, lambda| {
        let element = element.lossless();
        let u = rows(&element, lambda);
        let conjugate: Rows =
            rows(&element, lambda.conj()).iter().map(|r| r.iter().map(|z| z.conj()).collect()).collect();
        assert_same(&u, &conjugate, largest(&u));
    });
}

/// A real ω and the complex λ = iω are the same frequency.
fn real_and_complex_agree<E>()
where
    E: Sample + TransferMatrix<C> + TransferMatrix<f64>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
    MatrixOf<E, f64>: Index<(usize, usize), Output = f64>,
{
    check(|element: E, lambda| {
        let omega = lambda.re;
        let complex = rows(&element, C::new(0.0, omega));
        let u = E::transfer_matrix(&built(element), omega);
        let size = complex.len();
        let real: Rows = (0..size).map(|i| (0..size).map(|j| C::from(u[(i, j)])).collect()).collect();
        assert_same(&real, &complex, largest(&complex));
    });
}

/// The transfer matrix times the denominator has no pole where the denominator vanishes.
fn denominator_removes_the_pole<E>()
where
    E: Sample + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(|element: E, _| {
        let Some(at_rest) = E::denominator(&built(element), C::ZERO) else { return };
        let denominator = |lambda: C| E::denominator(&built(element), lambda).unwrap();
        // by the secant method: a hinge has a factor for each freedom
        let (mut before, mut pole) = ((C::ZERO, at_rest), C::new(-0.1, 0.1));
        for _ in 0..100 {
            let value = denominator(pole);
            let slope = (value - before.1) / (pole - before.0);
            if value.norm() < 1e-14 || slope.norm() < 1e-14 {
                break;
            }
            (before, pole) = ((pole, value), pole - value / slope);
        }
        let freed = [1e-7, 2e-7].map(|distance| {
            let near = pole + C::new(distance, 0.0);
            denominator(near).norm() * largest(&rows(&element, near))
        });
        assert!((freed[0] / freed[1] - 1.0).abs() < 1e-2 && freed[0] > 1e-6, "{freed:?} {pole}");
    });
}

/// NaN, infinite and negative parameters are refused, one at a time; where a parameter may be negative, NaN is not.
fn refuses_what_is_not_a_number<E: Sample>() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let parameters = {
            let mut count = 0;
            E::sample(|| {
                count += 1;
                1.0
            });
            count
        };
        for position in 0..parameters {
            let mut count = 0;
            let element = E::sample(|| {
                count += 1;
                if count == position + 1 { bad } else { 1.0 }
            });
            assert!(element.build().is_err(), "parameter {position} = {bad}");
        }
    }
}

/// Every sample is in range.
fn accepts_valid_samples<E: Sample>() {
    check(|element: E, _| assert!(element.build().is_ok()));
}

#[test]
fn laws_of_all_elements() {
    for_each_element!(is_symplectic);
    for_each_element!(two_halves_make_the_whole);
    for_each_element!(rests_without_force);
    for_each_element!(conjugate_frequencies_give_conjugate_matrices);
    for_each_element!(denominator_removes_the_pole);
    for_each_element!(refuses_what_is_not_a_number);
    for_each_element!(accepts_valid_samples);
}

#[test]
fn laws_of_undamped_elements() {
    for_each_undamped_element!(real_and_complex_agree);
}

/// Stiffnesses divide in the transfer matrix: one without a finite reciprocal is refused by its name.
#[test]
fn a_stiffness_has_a_finite_reciprocal() {
    fn refused<E: Element>(element: E) -> &'static str {
        element.build().err().map_or("nothing", |error| error.parameter)
    }
    let (stiffness, damping, ordinary) = (1e-320, 0.0, 1.0);
    assert_eq!(refused(Spring { stiffness }), "stiffness");
    assert_eq!(refused(TorsionSpring { stiffness }), "stiffness");
    assert_eq!(refused(SpringDamper { stiffness, damping }), "stiffness");
    assert_eq!(refused(TorsionSpringDamper { stiffness, damping }), "stiffness");
    assert_eq!(refused(ElasticHinge { stiffness_y: stiffness, stiffness_theta: ordinary }), "stiffness_y");
    assert_eq!(refused(ElasticHinge { stiffness_y: ordinary, stiffness_theta: stiffness }), "stiffness_theta");
    let hinge = PlanarHinge { stiffness_x: ordinary, stiffness_y: ordinary, stiffness_theta: ordinary };
    assert_eq!(refused(PlanarHinge { stiffness_x: stiffness, ..hinge }), "stiffness_x");
    assert_eq!(refused(PlanarHinge { stiffness_y: stiffness, ..hinge }), "stiffness_y");
    assert_eq!(refused(PlanarHinge { stiffness_theta: stiffness, ..hinge }), "stiffness_theta");
}
