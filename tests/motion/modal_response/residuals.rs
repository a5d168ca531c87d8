//! What is not in the list gives way at once.

use super::assert_close;
use mstmm::prelude::*;

system! {
    /// A mass on two springs, between which nothing has mass.
    #[derive(Clone, Copy, Debug)]
    struct Massless { m: f64, k: f64, l: f64 }
    free -> mass 1 { mass: m } -> spring 2 { stiffness: k } -> spring 3 { stiffness: l } -> fixed;
}

/// Closed form. The point between the springs yields by `1/l` in the end: with the mass as far as they hold that together, and
/// against the resting mass, as `1/(k + l)`, at once.
#[test]
fn a_massless_point_gives_way_at_once() {
    let (m, k, l) = (2.0, 3.0, 5.0);
    let system = Massless { m, k, l }.build().unwrap();
    let roots = system.natural_frequencies::<4>(0.0..=1e6).unwrap();
    assert_eq!(roots.len(), 1);
    let point = Massless::spring_2.output();
    let response = system.modal_response::<4, _>(&roots, point.force(), point.deflection()).unwrap();
    let (at_once, in_the_end) = (1.0 / (k + l), 1.0 / l);
    let omega = (k * l / (k + l) / m).sqrt();
    let mut history = response.history(0.1).unwrap();
    for n in 0..40 {
        let t = 0.1 * f64::from(n);
        let expected = at_once + (in_the_end - at_once) * (1.0 - (omega * t).cos());
        assert_close(response.to_step(t), expected, in_the_end * (1.0 + t), 4.0);
        assert_close(history.next(3.0), 3.0 * expected, 3.0 * in_the_end * (1.0 + f64::from(n)), 4.0);
    }
    assert_close(response.static_value().unwrap(), in_the_end, in_the_end, 4.0);
    assert_eq!(response.to_step(-0.1), 0.0);
    let damped = response.with_damping_ratio(0.1).unwrap();
    assert_close(damped.to_step(0.0), at_once, in_the_end, 4.0);
    assert_close(damped.static_value().unwrap(), in_the_end, in_the_end, 8.0);
}
