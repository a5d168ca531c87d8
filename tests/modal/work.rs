//! The work of loads on shapes.

use crate::models::{Cantilever, Portal, assert_close, number, reference};
use mstmm::motion::{Load, MotionError, PlaneLoad, PlanePoint};
use mstmm::prelude::*;

/// The weight works the factor of participation, whose square is the effective mass; by momentum it is the force of what holds the model over -ω².
#[test]
fn the_weight_works_the_factor_of_participation() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<8>().unwrap();
    let modes = reference("participation")["cantilever"]["modes"].clone();
    for (root, mode) in roots.iter().zip(modes.as_array().unwrap()) {
        let shape = cantilever.mode_shape(root).unwrap();
        let factor = shape.work(Load::self_weight()).unwrap();
        assert_close(factor * factor, number(&mode["effective_mass_y"]), 1e-12);
        let tip = shape.work(Cantilever::conn_tip.force()).unwrap();
        assert_eq!(tip, shape.state(Cantilever::conn_tip).y);
        assert_close(tip.abs(), number(&mode["tip"]), 1e-13);
        assert_eq!(shape.work(Cantilever::conn_tip.torque()).unwrap(), shape.state(Cantilever::conn_tip).theta);
        // the clamp and the spring push back what moves: the shear at the clamp, and -k y
        let held = shape.state(Cantilever::beam_1.input()).q - 350.0 * tip;
        assert_close(factor, -held / root.omega.powi(2), 1e-11);
    }
    // all masses that move are in the sum of squares, of a beam without end
    let sum: f64 =
        roots.iter().map(|root| cantilever.mode_shape(root).unwrap().work(Load::self_weight()).unwrap().powi(2)).sum();
    assert!(sum < 3.8 && sum > 3.6, "{sum}");
}

/// In the plane, along x and y; motions of supports work against their reactions.
#[test]
fn loads_of_the_plane_work_on_shapes() {
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<9>().unwrap();
    let modes = reference("participation")["portal"]["modes"].clone();
    for (root, mode) in roots.iter().zip(modes.as_array().unwrap()) {
        let shape = portal.mode_shape(root).unwrap();
        let [x, y] = [PlaneLoad::self_weight_x(), PlaneLoad::self_weight_y()].map(|load| shape.work(load).unwrap());
        assert_close(x * x, number(&mode["effective_mass_x"]), 1e-11);
        assert_close(y * y, number(&mode["effective_mass_y"]), 1e-11);
        let sway = shape.work(Portal::conn_b.force_x()).unwrap();
        assert_close(sway.abs(), number(&mode["displacement_x_B"]).abs(), 1e-12);
        assert_close(x * sway, number(&mode["gamma_x_times_phi_x"]), 1e-11);
        let held = [Portal::conn_a, Portal::conn_d];
        for (axis, factor) in [(0, x), (1, y)] {
            let reaction = |point| {
                let point: PlanePoint<_> = point;
                let entry = if axis == 0 { point.reaction_x() } else { point.reaction_y() };
                shape.value(entry).unwrap()
            };
            let sum: f64 = held.into_iter().map(reaction).sum();
            assert_close(factor, -sum / root.omega.powi(2), 1e-10);
        }
        let motion = shape.work(Portal::conn_a.motion_x()).unwrap();
        assert_close(motion, -shape.value(Portal::conn_a.reaction_x()).unwrap(), 1e-14);
    }
    // a path's mass has no direction there, and a load of another kind acts nowhere
    let cantilever = Cantilever {}.build().unwrap();
    let shape = cantilever.mode_shape(&cantilever.first_frequencies::<1>().unwrap()[0]).unwrap();
    assert!(matches!(shape.work(Cantilever::spring_3.output().torque()), Err(MotionError::NoSuchEntry { .. })));
}
