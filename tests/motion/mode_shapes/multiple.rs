//! Multiple roots and close pairs.

use crate::mode_shapes::checks::{LIMIT, check_laws, first};
use crate::mode_shapes::energy::forms;
use crate::mode_shapes::models::*;
use crate::mode_shapes::recorded::{Recordable, Sketched, record};
use crate::mode_shapes::residuals::worst_residual;
use crate::mode_shapes::single_beams::*;
use mstmm::prelude::*;
use mstmm::search::System;

/// Asserts that the shapes of a root are as many as its multiplicity, keep all laws and are orthonormal.
pub(crate) fn check_basis<M, Y>(model: &M, system: &Y, root: &NaturalFrequency)
where
    M: Sketched,
    Y: Recordable<f64> + System<Parameter = f64> + mstmm::motion::ExtendedTree<f64>,
{
    let sketch = model.sketch();
    let list = system.mode_shapes::<4, _>(root).unwrap();
    let shapes: Vec<_> = list.iter().collect();
    assert_eq!(shapes.len() as u64, root.multiplicity);
    let mut worst = [0.0_f64; 3];
    for (i, first) in shapes.iter().enumerate() {
        let recorded = record(system, *first, root);
        let residual = worst_residual(&sketch, &recorded);
        assert!(residual.size <= LIMIT, "{root:?}, shape {i}: {residual:?}");
        worst[0] = worst[0].max(residual.size);
        for (j, second) in shapes.iter().enumerate() {
            let expected = if i == j { 1.0 } else { 0.0 };
            let product = first.product(second) - expected;
            let by_quadrature = forms(&sketch, &recorded, &record(system, *second, root)).mass - expected;
            worst = [worst[0], worst[1].max(product.abs()), worst[2].max(by_quadrature.norm())];
        }
    }
    println!(
        "{} times {}: residual {:e}, product {:e}, by quadrature {:e}",
        root.multiplicity, root.omega, worst[0], worst[1], worst[2]
    );
    assert!(worst[1] <= LIMIT && worst[2] <= LIMIT, "{root:?}: {worst:?}");
}

/// Checks all multiple roots of a list, of which there must be some.
fn check_bases<M, Y>(model: &M, system: &Y, roots: &[NaturalFrequency], multiplicity: u64)
where
    M: Sketched,
    Y: Recordable<f64> + System<Parameter = f64> + mstmm::motion::ExtendedTree<f64>,
{
    // the last ones may have neighbours that are not in the list
    let multiple = || roots[..roots.len() - 2].iter().filter(|root| root.multiplicity > 1);
    assert!(multiple().count() > 0 && multiple().all(|root| root.multiplicity == multiplicity), "{roots:?}");
    multiple().for_each(|root| check_basis(model, system, root));
}

/// Oracle: at a clamped frequency of an arm the middle of a star rests, and forces of m arms cancel in m - 1 ways.
#[test]
fn stars_of_equal_arms() {
    for l in [0.3, 1.0, 4.0] {
        let model = Star3 { l1: l, l2: l, l3: l };
        let system = model.build().unwrap();
        check_bases(&model, &system, &first::<20>(&system), 2);
        let model = Star4 { l, ei: 3.0 };
        let system = model.build().unwrap();
        check_bases(&model, &system, &first::<20>(&system), 3);
        let model = HeldStar4 { l, ei: 0.1 };
        let system = model.build().unwrap();
        check_bases(&model, &system, &first::<20>(&system), 4);
    }
}

#[test]
fn clamped_rows_of_equal_spans() {
    let model = ClampedRow { l1: 0.7, l2: 0.7, l3: 0.7 };
    let system = model.build().unwrap();
    check_bases(&model, &system, &first::<15>(&system), 3);
    let model = ClampedRow { l1: 0.7, l2: 1.1, l3: 0.7 };
    let system = model.build().unwrap();
    let roots = first::<15>(&system);
    roots.iter().filter(|root| root.multiplicity == 2).for_each(|root| check_basis(&model, &system, root));
    check_laws(&model, &system, &roots);
}

#[test]
fn two_equal_oscillators_on_a_wall() {
    for (k2, m2) in [(3.0, 0.5), (3e9, 0.5e9), (3e-12, 0.5e-12)] {
        let model = TwoOscillators { k1: 3.0, m1: 0.5, k2, m2 };
        let system = model.build().unwrap();
        let roots = first::<2>(&system);
        assert_eq!(roots[0].multiplicity, 2, "{roots:?}");
        check_basis(&model, &system, &roots[0]);
    }
}

/// The frequencies of a clamped arm, twice each, and of a cantilever are the same to rounding here: three roots in one.
#[test]
fn high_modes_of_a_star() {
    let model = Star3 { l1: 1.0, l2: 1.0, l3: 1.0 };
    let system = model.build().unwrap();
    let roots = first::<120>(&system);
    let triple: Vec<_> = roots.iter().filter(|root| root.multiplicity == 3).collect();
    assert!(triple.len() > 20);
    triple.iter().step_by(5).for_each(|root| check_basis(&model, &system, root));
}

/// Pairs of arms whose lengths differ by a thousandth.
#[test]
fn close_pairs() {
    let gap = 1e-3;
    let model = Star3 { l1: 1.0, l2: 1.0 + gap, l3: 1.0 - 0.7 * gap };
    let system = model.build().unwrap();
    let roots = &first::<20>(&system)[..15];
    let sketch = model.sketch();
    println!("{:?}", check_laws(&model, &system, roots));
    for pair in roots.windows(2).filter(|pair| pair.iter().all(|root| root.multiplicity == 1)) {
        let shapes = [0, 1].map(|k| system.mode_shape(&pair[k]).unwrap());
        let product = shapes[0].product(&shapes[1]);
        assert!(product.abs() <= LIMIT, "{pair:?}: {product:e}");
        let recorded = [0, 1].map(|k| record(&system, &shapes[k], &pair[k]));
        let by_quadrature = forms(&sketch, &recorded[0], &recorded[1]).mass.re;
        assert!((product - by_quadrature).abs() <= LIMIT, "{pair:?}: {by_quadrature:e}");
    }
}

/// Roots that several arms share, or nearly: the frequencies of an arm held at the joint and of one that is free there come closer
/// from mode to mode, and lengths that differ by as little as their rounding part the former.
#[test]
fn close_roots_of_arms_at_one_joint() {
    for (l, gap) in [(1.0, 0.0), (0.3, 0.0), (1.0, 1e-4), (1.0, 1e-6), (1.0, 1e-9), (1.0, 1e-12)] {
        let model = Star3 { l1: l, l2: l * (1.0 + gap), l3: l * (1.0 - 0.7 * gap) };
        let (system, sketch) = (model.build().unwrap(), model.sketch());
        for root in first::<20>(&system).iter().take(13) {
            for shape in system.mode_shapes::<4, _>(root).unwrap().iter() {
                let residual = worst_residual(&sketch, &record(&system, shape, root));
                assert!(residual.size <= LIMIT, "{l}, {gap}: {root:?}: {residual:?}");
            }
        }
    }
}
