//! What is not proven does not say so.

use super::exact::{double, fault_of_squares, pi, square};
use super::in_full;
use crate::support::random_tree::Random;
use mstmm::prelude::*;

system! {
    struct Column { length: f64, force: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> pinned
}

/// Columns beside buckling: estimates, some of whose intervals miss, claim nothing; lists claim what they prove, and hold the closed form.
fn columns_and_claims(models: usize) {
    let random = &mut Random(0xb8);
    let mut misses = 0;
    for model in 0..models {
        let (length, force) = match model {
            0 => (1.93, 2.649_458_285_029_749),
            _ => {
                let length = 0.5 + 2.0 * random.unit();
                let part = 10_f64.powf(-1.0 - 9.0 * random.unit());
                (length, std::f64::consts::PI.powi(2) / (length * length) * (1.0 - part))
            }
        };
        let squares: Vec<_> = (1..=4)
            .map(|n| {
                let wave = pi(n) * pi(n) / (double(length) * double(length));
                wave * (wave - double(force))
            })
            .collect();
        let column = Column { length, force }.build().unwrap();
        let estimates = column.estimates::<2>().unwrap();
        assert!(estimates.iter().all(|root| !root.is_proven), "{length} {force} {estimates:?}");
        let misses_one = |(root, exact): (&NaturalFrequency, &mstmm::number::DoubleDouble)| {
            *exact < square(root.lower) || *exact >= square(root.upper)
        };
        misses += usize::from(estimates.iter().zip(&squares).any(misses_one));
        let found = column.first_frequencies::<2>().unwrap();
        assert_eq!(fault_of_squares(&found, &squares), None, "{length} {force}");
    }
    println!("| columns whose estimates miss | {misses} of {models} |");
    assert!(misses > 0);
}

in_full! {
    columns_and_claims(100, 3000) = some_columns_and_claims, all_columns_and_claims;
}
