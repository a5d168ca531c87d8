//! mstmm through the re-export of another crate: this file does not name it.

use surroundings::methods::prelude::*;

surroundings::methods::system! {
    struct Oscillator { k: f64, c: f64, m: f64 }
    let stiffness = 2.0 * k;
    fixed -> spring 1 { stiffness, damping: c } -> surroundings::methods::elements::Mass 2 { mass: m } -> free
}

/// Closed form: `λ² + 2λ + 10 = 0`.
#[test]
fn a_crate_behind_a_re_export_does_not_matter() {
    let system = Oscillator { k: 5.0, c: 2.0, m: 1.0 }.build().unwrap();
    let found = system.first_eigenvalues::<1>().unwrap();
    assert!((found[0].lambda - Complex::new(-1.0, 3.0)).norm() <= 32.0 * f64::EPSILON, "{:?}", found[0]);
}
