//! The five examples of the paper.

use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality, first};
use crate::mode_shapes::recorded::recordable;
use crate::support::models::*;
use mstmm::prelude::*;

recordable! { in include_str!("../../../examples/paper/src/models.rs");
    TipBody TipBodySystem [beam_1 body_2] [];
    RestrainedBeam RestrainedBeamSystem [hinge_1 beam_3 hinge_5] [conn_2 conn_4];
    SpringAndMass SpringAndMassSystem [beam_1 spring_3 beam_4 mass_6 beam_7] [conn_2 conn_5];
    TwoSpans TwoSpansSystem [beam_1 beam_3 spring_5 mass_6 beam_7] [conn_2 conn_4];
    DampedOscillator DampedOscillatorSystem
        [beam_1 spring_3 beam_4 spring_6 mass_7 beam_8 torsion_spring_10 beam_11] [conn_2 conn_5 conn_9];
}

/// All checks of an undamped example: laws of modes 1 to 1000, the rest of fewer.
macro_rules! check_undamped {
    ($($test:ident: $model:expr;)*) => {$(
        #[test]
        fn $test() {
            let model = $model;
            let system = model.build().unwrap();
            let roots = first::<1000>(&system);
            println!("residual {:?}", check_laws(&model, &system, &roots));
            println!("products {:e}", check_orthogonality(&system, &roots[..20]));
            println!("products of high modes {:e}", check_orthogonality(&system, &roots[980..]));
            println!("energies {:e}", check_energies(&model, &system, &roots[..20]));
            println!("energies of high modes {:e}", check_energies(&model, &system, &roots[997..]));
        }
    )*};
}

check_undamped! {
    light_tip_body_4_1: light_tip_body();
    heavy_tip_body_4_1: heavy_tip_body();
    restrained_beam_4_2: restrained_beam();
    spring_and_mass_4_3: spring_and_mass();
    two_spans_4_4: two_spans();
}

#[test]
fn damped_oscillator_4_5() {
    let model = damped_oscillator();
    let system = model.build().unwrap();
    let roots = system.first_eigenvalues::<20>().unwrap();
    assert_eq!(roots.len(), 20);
    println!("residual {:?}", check_laws(&model, &system, &roots));
    println!("products {:e}", check_orthogonality(&system, &roots));
    println!("energies {:e}", check_energies(&model, &system, &roots));
    // λ with imaginary parts of the 50th mode and more
    let region = Region { re: -200.0..=0.0, im: 1.5e6..=1.7e6 };
    let high = system.eigenvalues::<16>(region).unwrap();
    assert!(high.len() > 1);
    println!("residual of {} high modes {:?}", high.len(), check_laws(&model, &system, &high));
    println!("products {:e}", check_orthogonality(&system, &high));
    println!("energies {:e}", check_energies(&model, &system, &high));
}
