//! Shapes that are known in closed form.

use crate::mode_shapes::checks::first;
use crate::mode_shapes::single_beams::*;
use core::f64::consts::PI;
use mstmm::element::State;
use mstmm::motion::{Label, ModeShape, Planned, Tree};
use mstmm::prelude::*;

/// Asserts that deflections at 98 places are those of a function up to a common sign, to a tolerance relative to a size.
fn assert_shape<Y, E>(
    shape: &ModeShape<'_, Y, f64>,
    label: Label<Y::Model, E>,
    length: f64,
    exact: impl Fn(f64) -> f64,
    tolerance: f64,
) where
    Y: Tree<f64> + Planned,
    E: mstmm::element::Element,
{
    let places = (0..=97).map(|k| length * f64::from(k) / 97.0);
    let pairs: Vec<(f64, f64)> = places.map(|x| (shape.along(label, x).unwrap().y, exact(x))).collect();
    let largest = pairs.iter().map(|(_, exact)| exact.abs()).fold(0.0, f64::max);
    let sign: f64 = pairs.iter().map(|(y, exact)| y * exact).sum::<f64>().signum();
    for (k, (y, exact)) in pairs.into_iter().enumerate() {
        let error = (sign * y - exact).abs() / largest;
        assert!(error <= tolerance, "place {k}: {y}, {exact}, {error:e}");
    }
}

/// Oracle: `sqrt(2/(ml)) sin(nπx/l)`; its argument is known to rounding.
#[test]
fn pinned_beams_move_in_sines() {
    let model = PinnedPinned { l: 1.7, ei: 3.1, m: 0.9 };
    let system = model.build().unwrap();
    let roots = first::<1000>(&system);
    for n in [1, 2, 3, 10, 100, 999, 1000] {
        let shape = system.mode_shape(&roots[n - 1]).unwrap();
        let wave = n as f64 * PI / model.l;
        let amplitude = (2.0 / (model.m * model.l)).sqrt();
        let tolerance = 4.0 * f64::EPSILON * (1.0 + n as f64 * PI);
        assert_shape(&shape, PinnedPinned::beam_1, model.l, |x| amplitude * (wave * x).sin(), tolerance);
    }
}

/// Oracle: `[ch βx - cos βx - σ (sh βx - sin βx)]/sqrt(ml)` with `σ = (ch z + cos z)/(sh z + sin z)`, `cos z ch z = -1`;
/// at the tip it is 2.
#[test]
fn cantilevers_move_as_in_textbooks() {
    let model = Cantilever { l: 0.8, ei: 210.0, m: 1.9 };
    let system = model.build().unwrap();
    for (k, root) in first::<8>(&system).iter().enumerate() {
        let is_even = k % 2 == 0;
        let mut z = (k as f64 + 0.5) * PI;
        for _ in 0..60 {
            let beyond = (1.0 / z.cosh()).asin();
            z = (k as f64 + 0.5) * PI + if is_even { beyond } else { -beyond };
        }
        let shape = system.mode_shape(root).unwrap();
        // where sin z = ±th z, σ is th z/2 or its inverse, and 1 - σ has no cancellation
        let (beta, rest) = (z / model.l, if is_even { 2.0 / (z.exp() + 1.0) } else { -2.0 / (z.exp() - 1.0) });
        let sigma = 1.0 - rest;
        let factor = 1.0 / (model.m * model.l).sqrt();
        let exact = |x: f64| {
            let u = beta * x;
            // ch u - σ sh u = e^{-u} + (1 - σ) sh u
            factor * ((-u).exp() + rest * u.sinh() - u.cos() + sigma * u.sin())
        };
        assert_shape(&shape, Cantilever::beam_1, model.l, exact, 1e-11);
        let tip = shape.state(Cantilever::beam_1.output()).y.abs();
        assert!((tip / (2.0 * factor) - 1.0).abs() <= 1e-12, "{tip}");
        let unit = shape.with_unit_deflection().unwrap();
        assert!((unit.state(Cantilever::beam_1.output()).y - 1.0).abs() <= 1e-12, "{unit:?}");
    }
}

/// Oracle: mass j of n moves by `sqrt(2/((n+1) m)) sin(jkπ/(n+1))`.
#[test]
fn chains_of_masses_move_in_sines() {
    let model = FiveMasses { k: 7.0, m: 0.3 };
    let system = model.build().unwrap();
    for (k, root) in (1..).zip(&first::<5>(&system)) {
        let shape = system.mode_shape(root).unwrap();
        let y =
            [FiveMasses::mass_m1, FiveMasses::mass_m2, FiveMasses::mass_m3, FiveMasses::mass_m4, FiveMasses::mass_m5]
                .map(|mass| shape.state(mass.output()).y);
        let exact = |j: usize| (2.0 / (6.0 * model.m)).sqrt() * ((j * k) as f64 * PI / 6.0).sin();
        let sign = (y[0] * exact(1)).signum();
        for (j, y) in (1..).zip(y) {
            assert!((sign * y - exact(j)).abs() <= 1e-14, "mode {k}, mass {j}: {y}, {}", exact(j));
        }
    }
}

/// Oracle: disc j of n turns by `sqrt(2/(nJ)) cos(kπ(j - ½)/n)`; all alike by `sqrt(1/(nJ))` without frequency.
#[test]
fn free_shafts_turn_in_cosines() {
    let model = FourDiscs { k: 5.0, j: 0.2 };
    let system = model.build().unwrap();
    for (k, root) in first::<4>(&system).iter().enumerate() {
        assert_eq!(root.omega == 0.0, k == 0);
        let shape = system.mode_shape(root).unwrap();
        let turns = [FourDiscs::inertia_1, FourDiscs::inertia_2, FourDiscs::inertia_3, FourDiscs::inertia_4]
            .map(|disc| shape.state(disc.input()).theta);
        let amplitude = (if k == 0 { 1.0 } else { 2.0 } / (4.0 * model.j)).sqrt();
        let exact = |j: usize| amplitude * (k as f64 * PI * (j as f64 + 0.5) / 4.0).cos();
        let sign = (turns[0] * exact(0)).signum();
        for (j, turn) in turns.into_iter().enumerate() {
            assert!((sign * turn - exact(j)).abs() <= 1e-14, "mode {k}, disc {j}: {turn}, {}", exact(j));
        }
    }
}

/// Oracle: straight lines without moment and shear, of unit modal mass and orthogonal: their deflections at both ends have
/// `ml (a₁b₁ + a₂b₂)/3 + ml (a₁b₂ + a₂b₁)/6` as products.
#[test]
fn free_beams_have_two_rigid_motions() {
    let model = FreeFree { l: 2.3, ei: 11.0, m: 0.4 };
    let system = model.build().unwrap();
    let roots = first::<3>(&system);
    assert_eq!((roots[0].omega, roots[0].multiplicity), (0.0, 2));
    let list = system.mode_shapes::<2, _>(&roots[0]).unwrap();
    let shapes: Vec<_> = list.iter().collect();
    assert_eq!(shapes.len(), 2);
    let ends = shapes.iter().map(|shape| {
        let [a, b] = [FreeFree::beam_1.input(), FreeFree::beam_1.output()].map(|end| shape.state(end));
        let slope = (b.y - a.y) / model.l;
        for part in [0.0, 0.3, 0.5, 1.0] {
            let State { y, theta, m, q } = shape.along(FreeFree::beam_1, part * model.l).unwrap();
            let size = a.y.abs().max(b.y.abs());
            assert!((y - a.y - slope * part * model.l).abs() <= 1e-13 * size);
            assert!((theta - slope).abs() * model.l <= 1e-12 * size, "{theta} {slope}");
            let strain = (m * model.l * model.l).abs() + (q * model.l.powi(3)).abs();
            assert!(strain <= 1e-11 * model.ei * size, "{m} {q}");
        }
        [a.y, b.y]
    });
    let ends: Vec<_> = ends.collect();
    for (i, a) in ends.iter().enumerate() {
        for (j, b) in ends.iter().enumerate() {
            let product = model.m * model.l * ((a[0] * b[0] + a[1] * b[1]) / 3.0 + (a[0] * b[1] + a[1] * b[0]) / 6.0);
            assert!((product - f64::from(u8::from(i == j))).abs() <= 1e-10, "{product}");
            assert!((shapes[i].product(shapes[j]) - product).abs() <= 1e-10);
        }
    }
}

/// Oracle: `sqrt(3/(ml³)) x` from the pin.
#[test]
fn a_beam_on_one_pin_swings_as_a_line() {
    let model = FreePinned { l: 2.3, ei: 11.0, m: 0.4 };
    let system = model.build().unwrap();
    let root = first::<1>(&system)[0];
    assert_eq!((root.omega, root.multiplicity), (0.0, 1));
    let shape = system.mode_shape(&root).unwrap();
    let slope = (3.0 / (model.m * model.l.powi(3))).sqrt();
    assert_shape(&shape, FreePinned::beam_1, model.l, |x| slope * (model.l - x), 1e-13);
}
