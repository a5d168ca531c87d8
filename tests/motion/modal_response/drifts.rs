//! What nothing but dampers holds moves off, or drifts.

use super::assert_close;
use mstmm::prelude::*;

system! {
    /// Two masses that a damper alone joins, and nothing holds.
    #[derive(Clone, Copy, Debug)]
    struct Joined { m: f64, c: f64, n: f64 }
    free -> mass 1 { mass: m } -> damper 2 { damping: c } -> mass 3 { mass: n } -> free;
}

system! {
    /// Two masses that dampers alone hold, from the ground and from each other: both come to rest, wherever that is.
    #[derive(Clone, Copy, Debug)]
    struct OnDampers { m: f64, c: f64 }
    fixed -> damper 1 { damping: c } -> mass 2 { mass: m } -> damper 3 { damping: c } -> mass 4 { mass: m } -> free;
}

/// Closed form. The velocities obey `m v̇ = -c A v + f` with `A = [[2, -1], [-1, 1]]`, whose eigenvalues are `(3 ± √5)/2`; a force
/// on the last mass passes both dampers in the end, one on the first none but its own.
#[test]
fn masses_that_dampers_hold_come_to_rest() {
    let (m, c) = (2.0, 0.5);
    let system = OnDampers { m, c }.build().unwrap();
    let roots = system.first_eigenvalues::<4>().unwrap();
    assert_eq!(roots.iter().map(|root| root.multiplicity).collect::<Vec<_>>(), [2, 1, 1]);
    let (first, last) = (OnDampers::mass_2.output(), OnDampers::mass_4.output());
    let at = |entry| system.modal_response::<3, _>(&roots, last.force(), entry).unwrap();
    let (near, far) = (at(last.deflection()), at(first.deflection()));
    // shares of the two motions in the deflections of the last and of the first mass
    let shares = [1.0, -1.0].map(|sign| {
        let eigenvalue = (3.0 + sign * 5.0_f64.sqrt()) / 2.0;
        let own = 2.0 - eigenvalue;
        (eigenvalue, own * own / (1.0 + own * own), own / (1.0 + own * own))
    });
    for t in [0.0, 1e-3, 0.4, 5.0, 60.0] {
        let [mut here, mut there] = [[0.0; 2]; 2];
        for (eigenvalue, own, other) in shares {
            let rate = eigenvalue * c / m;
            let velocity: f64 = (1.0 - (-rate * t).exp()) / (eigenvalue * c);
            let path = (t - (1.0 - (-rate * t).exp()) / rate) / (eigenvalue * c);
            for (sum, value) in here.iter_mut().zip([velocity, path]) {
                *sum += own * value;
            }
            for (sum, value) in there.iter_mut().zip([velocity, path]) {
                *sum += other * value;
            }
        }
        let scale = (1.0 + t) / c;
        assert_close(near.to_impulse(t), here[0], scale, 32.0);
        assert_close(far.to_impulse(t), there[0], scale, 32.0);
        assert_close(near.to_step(t), here[1], scale, 32.0);
        assert_close(far.to_step(t), there[1], scale, 32.0);
    }
    assert!(near.static_value().is_err());
}

/// Closed form. The centre moves off as one body; the damper slips with the velocity `e^{-at}`, `a = c (m + n)/(m n)`, times
/// the impulse over the mass.
#[test]
fn two_masses_that_a_damper_joins() {
    let (m, c, n) = (2.0, 3.0, 1.0);
    let system = Joined { m, c, n }.build().unwrap();
    let roots = system.first_eigenvalues::<4>().unwrap();
    let (here, there) = (Joined::mass_3.output(), Joined::mass_1.output());
    let at = |entry| system.modal_response::<4, _>(&roots, here.force(), entry).unwrap();
    let (near, far) = (at(here.deflection()), at(there.deflection()));
    let (whole, a) = (m + n, c * (m + n) / (m * n));
    for t in [0.0, 1e-3, 0.4, 2.0, 9.0] {
        let decayed: f64 = 1.0 - (-a * t).exp();
        // the slip after an impulse, and under a constant force
        let (slip, under_force) = (decayed / (a * n), (t - decayed / a) / (a * n));
        let scale = 1.0 + t + t * t;
        assert_close(near.to_impulse(t), t / whole + m / whole * slip, scale, 16.0);
        assert_close(far.to_impulse(t), t / whole - n / whole * slip, scale, 16.0);
        assert_close(near.to_step(t), t * t / (2.0 * whole) + m / whole * under_force, scale, 16.0);
        assert_close(far.to_step(t), t * t / (2.0 * whole) - n / whole * under_force, scale, 16.0);
    }
    assert!(near.static_value().is_err());
}
