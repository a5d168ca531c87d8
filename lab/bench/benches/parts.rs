//! Time of each question to a built system, for all five examples of the paper, and against the number of elements, the number
//! of roots and the mode number.
//!
//! `cargo bench --bench parts`, with a filter: `cargo bench --bench parts -- two_spans`.

use divan::{Bencher, black_box};
use mstmm::prelude::*;
use paper::models;
use subjects::{PinnedBeam, around, chain, valid};

pub mod subjects;

fn main() {
    divan::main();
}

/// Benches of an example: those that all have, at some frequency and for the lowest root of a search, and its own.
macro_rules! example {
    ($name:ident, at: $at:expr, lowest: $lowest:ident, tip: $tip:expr, $($own:item)*) => {
        mod $name {
            use super::*;

            #[divan::bench]
            fn build(bencher: Bencher) {
                let model = models::$name();
                bencher.bench_local(|| black_box(&model).build());
            }

            #[divan::bench]
            fn characteristic(bencher: Bencher) {
                let system = valid(models::$name().build());
                bencher.bench_local(|| black_box(&system).characteristic(black_box($at)));
            }

            #[divan::bench]
            fn overall_determinant(bencher: Bencher) {
                let system = valid(models::$name().build());
                bencher.bench_local(|| black_box(&system).overall_determinant(black_box($at)));
            }

            #[divan::bench]
            fn mode_shape(bencher: Bencher) {
                let system = valid(models::$name().build());
                let root = valid(system.$lowest::<1>())[0];
                bencher.bench_local(|| black_box(&system).mode_shape(black_box(&root)).is_ok());
            }

            #[divan::bench]
            fn sensitivity(bencher: Bencher) {
                let system = valid(models::$name().build());
                let root = valid(system.$lowest::<1>())[0];
                bencher.bench_local(|| black_box(&system).sensitivity(black_box(&root)).is_ok());
            }

            #[divan::bench]
            fn frequency_response(bencher: Bencher) {
                let system = valid(models::$name().build());
                let response = valid(system.frequency_response($tip.force(), $tip.deflection()));
                bencher.bench_local(|| black_box(&response).at(black_box($at)));
            }

            $($own)*
        }
    };
}

/// An example without dampers, searched in the range of its table.
macro_rules! undamped {
    ($name:ident, at: $at:expr, range: $range:expr, tip: $tip:expr) => {
        example! {
            $name, at: $at, lowest: first_frequencies, tip: $tip,

            #[divan::bench]
            fn count_below(bencher: Bencher) {
                let system = valid(models::$name().build());
                bencher.bench_local(|| black_box(&system).count_below(black_box($at)));
            }

            #[divan::bench]
            fn first_frequencies(bencher: Bencher) {
                let system = valid(models::$name().build());
                bencher.bench_local(|| black_box(&system).first_frequencies::<5>());
            }

            #[divan::bench]
            fn natural_frequencies(bencher: Bencher) {
                let system = valid(models::$name().build());
                bencher.bench_local(|| black_box(&system).natural_frequencies::<8>(black_box($range)));
            }
        }
    };
}

undamped!(light_tip_body, at: 300.0, range: 1.0..=1600.0, tip: models::TipBody::body_2.output());
undamped!(restrained_beam, at: 1000.0, range: 100.0..=3000.0, tip: models::RestrainedBeam::conn_4);
undamped!(spring_and_mass, at: 1000.0, range: 100.0..=2000.0, tip: models::SpringAndMass::conn_5);
undamped!(two_spans, at: 10_000.0, range: 100.0..=20_000.0, tip: models::TwoSpans::conn_4);

example! {
    damped_oscillator, at: Complex::new(-10.0, 8000.0), lowest: first_eigenvalues, tip: models::DampedOscillator::conn_5,

    /// The rectangle of Table 6.
    fn rectangle() -> Region {
        black_box(Region { re: -300.0..=5.0, im: -10.0..=12_000.0 })
    }

    #[divan::bench]
    fn count_in(bencher: Bencher) {
        let system = valid(models::damped_oscillator().build());
        bencher.bench_local(|| black_box(&system).count_in(rectangle()));
    }

    #[divan::bench]
    fn eigenvalues(bencher: Bencher) {
        let system = valid(models::damped_oscillator().build());
        bencher.bench_local(|| black_box(&system).eigenvalues::<8>(rectangle()).map(|found| found.len()));
    }
}

/// A chain of so many beams.
mod elements_of_a_chain {
    use super::*;

    const SIZES: [usize; 4] = [1, 10, 100, 1000];

    #[divan::bench(args = SIZES)]
    fn characteristic(bencher: Bencher, elements: usize) {
        let chain = chain(elements);
        bencher.bench_local(|| -> mstmm::number::Scaled<f64> { black_box(&chain).characteristic(black_box(30.0)) });
    }

    #[divan::bench(args = SIZES)]
    fn count_below(bencher: Bencher, elements: usize) {
        let chain = chain(elements);
        bencher.bench_local(|| black_box(&chain).count_below(black_box(30.0)));
    }
}

/// One beam with all its roots.
mod roots_of_a_beam {
    use super::*;

    /// The first so many.
    #[divan::bench(consts = [1, 10, 100, 1000])]
    fn first_frequencies<const N: usize>(bencher: Bencher) {
        let beam = valid(PinnedBeam {}.build());
        bencher.bench_local(|| black_box(&beam).first_frequencies::<N>().map(|found| found.len()));
    }

    /// The one with this number.
    #[divan::bench(args = [1, 10, 100, 1000])]
    fn natural_frequency(bencher: Bencher, mode: usize) {
        let beam = valid(PinnedBeam {}.build());
        bencher.bench_local(|| black_box(&beam).natural_frequencies::<1>(black_box(around(mode))));
    }
}
