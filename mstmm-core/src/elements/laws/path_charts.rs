//! Charts that are made of transfer matrices, beside those that elements give.

use super::charts::{assert_in_relation, columns, frequencies};
use super::*;
use crate::element::Charted;
use crate::number::{FrequencyPowers, Size};
use crate::structure::Chart;
use std::vec;

/// The number of natural frequencies with both ends held, by a chart of either form.
fn held(chart: &Chart<f64>) -> f64 {
    if chart.forces == 0 {
        return chart.below;
    }
    // the stiffness of the output end against the force there is -1 over the entry
    chart.below + 1.0 - f64::from(u8::from(chart.entry(1, 1) > 0.0))
}

/// A line at many frequencies: both charts hold the states, divide by one of two minors, and count alike.
fn charts_of_transfer_matrices<E>(line: E, wave: f64, stiffness: f64, is_rotation: bool)
where
    E: Element + Copy + Charted<f64> + TransferMatrix<f64>,
    MatrixOf<E, f64>: Index<(usize, usize), Output = f64>,
{
    let built = line.build().unwrap();
    let mut forms = [0; 2];
    for omega in frequencies().filter(|omega| *omega < 300.0) {
        let (phase, given) = (wave * omega, columns::<E, f64>(&built, omega));
        let transfer = [[given[0][0], given[1][0]], [given[0][1], given[1][1]]];
        let held_ends = (phase * core::f64::consts::FRAC_1_PI).whole();
        let unit = stiffness * phase.max(1.0);
        let chart = if is_rotation {
            Chart::rotation(transfer, held_ends, unit)
        } else {
            Chart::translation(transfer, held_ends, unit)
        };
        let own = E::chart(&built, &FrequencyPowers::new::<f64>(omega, true), 0.0);
        assert_in_relation(&chart, &given, <E::State as StateSpace>::SPACE, 1e-12);
        assert_eq!((chart.freedoms, held(&chart)), (own.freedoms, held(&own)), "{omega}");
        assert!((0..2).all(|row| (0..=row).all(|column| chart.entry(row, column).abs() < 8.0)), "{omega}: {chart:?}");
        forms[usize::from(chart.forces > 0)] += 1;
    }
    assert!(forms.iter().all(|count| *count > 10), "{forms:?}");
}

#[test]
fn charts_of_transfer_matrices_are_those_of_lines() {
    let rod = Rod { length: 1.3, axial_stiffness: 60.0, mass_per_length: 2.1, foundation_stiffness: 0.0 };
    charts_of_transfer_matrices(rod, 1.3 * (2.1_f64 / 60.0).sqrt(), 60.0 / 1.3, false);
    let shaft = Shaft { length: 0.7, torsional_stiffness: 3.0, inertia_per_length: 0.4 };
    charts_of_transfer_matrices(shaft, 0.7 * (0.4_f64 / 3.0).sqrt(), 3.0 / 0.7, true);
}

/// What ties its ends rigidly has no flexibility, and a spring no inertia.
#[test]
fn charts_of_masses_and_springs() {
    let mass = Chart::translation([[1.0, 0.0], [18.0, 1.0]], (0.0, false), 18.0);
    assert_eq!((mass.forces, mass.below), (0b10, -1.0));
    assert_in_relation(&mass, &[vec![1.0, 18.0], vec![0.0, 1.0]], Space::Translation, 1e-15);
    let spring = Chart::translation([[1.0, -0.25], [0.0, 1.0]], (0.0, false), 4.0);
    assert_in_relation(&spring, &[vec![1.0, 0.0], vec![-0.25, 1.0]], Space::Translation, 1e-15);
    assert_eq!(held(&spring), 0.0);
}
