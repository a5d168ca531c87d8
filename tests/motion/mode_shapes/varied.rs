//! Varied models with random parameters: connections that narrow and widen, sixteen arms, lines, hinges, bodies, dampers.

use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality, first};
use crate::mode_shapes::models::*;
use mstmm::prelude::*;

/// Sets of parameters per model.
const SETS: u64 = 6;

/// Numbers between 0.3 and 3, from a seed.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        0.3 * 10f64.powf((state >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// Laws, products and energies of the first modes of a model with random parameters; all of them if they are fewer than 10.
macro_rules! check_varied {
    ($($test:ident: $model:ident { $($field:ident),* }, $modes:expr;)*) => {$(
        #[test]
        fn $test() {
            for seed in 1..=SETS {
                let mut next = numbers(seed);
                let model = $model { $($field: next()),* };
                let system = model.build().unwrap();
                let roots = first::<{ $modes }>(&system);
                let residual = check_laws(&model, &system, &roots);
                let products = check_orthogonality(&system, &roots);
                let energies = check_energies(&model, &system, &roots);
                println!("{seed}: {residual:?}, products {products:e}, energies {energies:e}");
            }
        }
    )*};
}

check_varied! {
    two_spans: Spans { l1, l2, ei, m }, 10;
    stars: Star3 { l1, l2, l3 }, 10;
    narrowing_and_widening: Narrowing { a, b, k, kt }, 10;
    connections_behind_connections: Behind { a, b, ky, kt }, 10;
    sixteen_arms: Hub { l, k, kt, m }, 20;
    bodies_with_offsets: Bodies { b, c, m, l }, 10;
    lines_of_masses: MassLine { k1, k2, m1, m2 }, 4;
    lines_of_inertias: TorsionLine { k1, k2, j1, j2 }, 4;
    mixtures: Mixture { stiff, soft, heavy, light, k }, 10;
    weakly_coupled: WeaklyCoupled { k, l1, l2 }, 10;
}

#[test]
fn dampers_of_all_kinds() {
    for seed in 1..=SETS {
        let mut next = numbers(seed);
        let model = Dampers { c: 0.3 * next(), ct: 0.1 * next(), k: next(), l: next() };
        let system = model.build().unwrap();
        let roots = system.first_eigenvalues::<20>().unwrap();
        let residual = check_laws(&model, &system, &roots);
        let products = check_orthogonality(&system, &roots);
        let energies = check_energies(&model, &system, &roots);
        println!("{seed}: {} roots, {residual:?}, products {products:e}, energies {energies:e}", roots.len());
    }
}
