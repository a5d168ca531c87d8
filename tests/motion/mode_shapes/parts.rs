//! ModalAnalysis that live in a part of a system, and parts that differ by many orders of magnitude.

use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality, first};
use crate::mode_shapes::models::*;
use crate::mode_shapes::recorded::Sketched;
use crate::mode_shapes::recorded::{C, record};
use crate::mode_shapes::residuals::{entries, worst_residual};
use crate::mode_shapes::single_beams::*;
use mstmm::element::State;
use mstmm::number::DoubleDouble;
use mstmm::prelude::*;

/// Asserts that an arm moves less than `1e-12` of another, entry by entry.
fn is_at_rest(arm: [State<C>; 2], beside: [State<C>; 2]) {
    let largest = |ends: [State<C>; 2]| -> [f64; 4] {
        let [a, b] = ends.map(|state| entries(&state).map(|entry| entry.norm()));
        core::array::from_fn(|k| a[k].max(b[k]))
    };
    // moments and forces: the displacements of clamped arms are zero at their ends
    for (rest, moving) in largest(arm).into_iter().zip(largest(beside)).skip(2) {
        assert!(rest <= 1e-12 * moving, "{arm:?} beside {beside:?}");
    }
}

/// Oracle: through a clamped middle nothing goes, so that one arm moves, as a clamped beam or a cantilever, and the other rests.
#[test]
fn a_clamped_middle_keeps_a_mode_in_one_arm() {
    for (l1, l2) in [(1.0, 1.3), (0.2, 5.0), (1.0, 0.01)] {
        let model = Uncoupled { l1, l2 };
        let system = model.build().unwrap();
        let roots = first::<30>(&system);
        check_laws(&model, &system, &roots);
        check_orthogonality(&system, &roots);
        check_energies(&model, &system, &roots);
        for root in roots.iter().filter(|root| root.multiplicity == 1) {
            let shape = system.mode_shape(root).unwrap();
            let recorded = record(&system, &shape, root);
            let ends = |name: &str| [recorded.elements[name].input, recorded.elements[name].output];
            let z = (root.omega * (3.0f64 / 2.0).sqrt()).sqrt() * l1;
            // a clamped arm: cos z ch z = 1
            let in_first_arm = (z.cos() - 1.0 / z.cosh()).abs() < 1e-9 * z;
            let [moving, rest] = if in_first_arm { ["beam_1", "beam_2"] } else { ["beam_2", "beam_1"] };
            is_at_rest(ends(rest), ends(moving));
        }
    }
}

/// Oracle: between clamps no end of a beam ever moves.
#[test]
fn rows_of_clamped_spans_move_inside_only() {
    let model = ClampedRow { l1: 1.0, l2: 1.31, l3: 0.77 };
    let system = model.build().unwrap();
    let roots = first::<40>(&system);
    check_laws(&model, &system, &roots);
    check_orthogonality(&system, &roots);
    check_energies(&model, &system, &roots);
    for root in roots.iter().filter(|root| root.multiplicity == 1) {
        let shape = system.mode_shape(root).unwrap();
        let spans = [(ClampedRow::beam_1, 1.0), (ClampedRow::beam_3, 1.31), (ClampedRow::beam_5, 0.77)];
        let moves = spans.map(|(beam, length)| shape.along(beam, 0.31 * length).unwrap().y.abs());
        let most = moves.iter().copied().fold(0.0, f64::max);
        assert_eq!(moves.iter().filter(|y| **y > 1e-11 * most).count(), 1, "{moves:?}");
        let unit = shape.with_unit_deflection().unwrap();
        let largest = spans.map(|(beam, length)| {
            let places = (0..=400).map(|k| unit.along(beam, length * f64::from(k) / 400.0).unwrap().y.abs());
            places.fold(0.0, f64::max)
        });
        let largest = largest.into_iter().fold(0.0, f64::max);
        assert!(largest <= 1.0 + 1e-12 && largest > 0.98, "{largest}");
    }
}

/// Oracle: a spring that is very weak leaves cantilevers to themselves.
#[test]
fn weak_springs_leave_modes_where_they_are() {
    for k in [1e-6, 1e-12, 1e-20] {
        let model = WeaklyCoupled { k, l1: 1.0, l2: 1.17 };
        let system = model.build().unwrap();
        let roots = first::<30>(&system);
        assert!(roots.iter().all(|root| root.multiplicity == 1));
        check_laws(&model, &system, &roots);
        check_orthogonality(&system, &roots);
        check_energies(&model, &system, &roots);
        let shape = system.mode_shape(&roots[0]).unwrap();
        // the longer one swings first, with 2/sqrt(ml) at its tip
        let tip = shape.state(WeaklyCoupled::beam_5.input()).y.abs();
        let other = shape.state(WeaklyCoupled::beam_1.output()).y.abs();
        assert!((tip / (2.0 / 1.17f64.sqrt()) - 1.0).abs() <= 1e-6f64.max(k), "{tip}");
        assert!(other <= 10.0 * k, "{other}");
    }
}

#[test]
fn stiff_and_soft_heavy_and_light() {
    for stiff in [1e-12, 1.0, 1e12] {
        for heavy in [1e-9, 1e9] {
            for light in [1e-9, 1e9] {
                for k in [1e-6, 1e6] {
                    let model = Mixture { stiff, soft: 1.0, heavy, light, k };
                    let system = model.build().unwrap();
                    let roots = first::<12>(&system);
                    check_laws(&model, &system, &roots);
                    check_orthogonality(&system, &roots);
                    check_energies(&model, &system, &roots);
                }
            }
        }
    }
}

/// Oracle: the same laws with the rounding of single precision, and the shapes of double-double arithmetic.
#[test]
fn shapes_in_other_arithmetic() {
    let model = Behind { a: 0.875, b: 1.375, ky: 20.0, kt: 3.0 };
    let sketch = model.sketch();
    let (single, double) = (model.build_as::<f32>().unwrap(), model.build().unwrap());
    let long = model.build_as::<DoubleDouble>().unwrap();
    let singles = single.first_frequencies::<12>().unwrap();
    let longs = long.first_frequencies::<12>().unwrap();
    for ((short, root), exact) in singles.iter().zip(&first::<12>(&double)).zip(&*longs) {
        let (a, b, c) =
            (single.mode_shape(short).unwrap(), double.mode_shape(root).unwrap(), long.mode_shape(exact).unwrap());
        let (a, b, c) = (record(&single, &a, short), record(&double, &b, root), record(&long, &c, exact));
        let residual = worst_residual(&sketch, &a);
        assert!(residual.size <= 500.0 * f64::from(f32::EPSILON), "{residual:?}");
        let residual = worst_residual(&sketch, &c);
        assert!(residual.size <= 200.0 * f64::EPSILON, "{residual:?}");
        let sign = (b.elements["beam_1"].output.y * c.elements["beam_1"].output.y).re.signum();
        for (name, ends) in &c.elements {
            for (x, y) in entries(&ends.output).into_iter().zip(entries(&b.elements[name].output)) {
                let largest = c.elements.values().map(|ends| ends.output.m.norm() + ends.output.q.norm());
                assert!((x - y * sign).norm() <= 1e-13 * largest.fold(1.0, f64::max), "{name}: {x} {y}");
            }
        }
    }
}

/// Oracle: beyond critical damping λ is real, and `Y² = 1/(m + C/2λ)`.
#[test]
fn overdamped_oscillators() {
    for (k, c, m) in [(1.0, 3.0, 1.0), (4.0, 1e3, 0.2), (1.0, 2.0001, 1.0), (1e6, 1e9, 3.0)] {
        let model = Oscillator { k, c, m };
        let system = model.build().unwrap();
        let roots = system.first_eigenvalues::<2>().unwrap();
        assert_eq!(roots.iter().filter(|root| root.lambda.im == 0.0).count(), 2, "{roots:?}");
        check_laws(&model, &system, &roots);
        check_orthogonality(&system, &roots);
        for root in &*roots {
            let shape = system.mode_shape(root).unwrap();
            let y = shape.state(Oscillator::mass_2.output()).y;
            let exact = 1.0 / (m + c / (2.0 * root.lambda));
            assert!((y * y - exact).norm() <= 1e-11 * exact.norm(), "{root:?}: {y} {exact}");
        }
    }
}

/// Oracle: none but the laws; heavily damped frames have real eigenvalues among the others.
#[test]
fn heavily_damped_frames() {
    let model = Dampers { c: 40.0, ct: 15.0, k: 3.0, l: 1.0 };
    let system = model.build().unwrap();
    let roots = system.first_eigenvalues::<30>().unwrap();
    assert!(roots.iter().filter(|root| root.lambda.im == 0.0).count() > 2);
    println!("{:?}", check_laws(&model, &system, &roots));
    println!("{:e}", check_orthogonality(&system, &roots));
    println!("{:e}", check_energies(&model, &system, &roots));
}
