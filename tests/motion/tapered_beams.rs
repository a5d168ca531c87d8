//! Motions of tapered and rotating blades: closed forms at rest, differences of roots, orthogonal modes.

use mstmm::prelude::*;

system! {
    #[derive(Clone, Copy)]
    struct Blade { speed: f64, height: f64, radius: f64, mass: f64, angle: f64, k: f64 }
    fixed -> tapered_beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: height, rotary_inertia: 0.0001,
        rotation_speed: speed, hub_radius: radius, setting_angle: angle, foundation_stiffness: k, axial_force: mass * speed * speed * (1.0 + radius),
    } -> point_mass 2 { mass, inertia: 0.0 } -> free
}

const BLADE: Blade = Blade { speed: 3.0, height: 0.5, radius: 0.2, mass: 0.1, angle: 0.7, k: 3.0 };

/// Closed form: a wedge under a force at its tip gives way by `∫ (1 - x)²/EI dx`.
#[test]
fn a_wedge_at_rest_gives_way_as_its_sections_do() {
    for height in [0.5_f64, 0.9, -3.0] {
        let system = Blade { speed: 0.0, height, k: 0.0, ..BLADE }.build().unwrap();
        let tip = Blade::tapered_beam_1.output();
        let response = system.frequency_response(tip.force(), tip.deflection()).unwrap().at(0.0).unwrap();
        let rest = 1.0 - height;
        let expected = (2.0 * rest - 0.5 * rest * rest - rest.ln() - 1.5) / height.powi(3);
        assert!((response / expected - 1.0).abs() < 1e-13, "{response} {expected}");
    }
}

/// Differences of roots for the parameters that enter in many ways; modes up to the twentieth are orthogonal, with nodes as their numbers.
#[test]
fn shapes_and_sensitivities_of_a_rotating_blade() {
    let system = BLADE.build().unwrap();
    let roots = system.first_frequencies::<20>().unwrap();
    for number in [1, 6, 20] {
        let root = &roots[number - 1];
        let shape = system.mode_shape(root).unwrap();
        assert_eq!(shape.nodes(Blade::tapered_beam_1), number - 1);
        let stiffness = shape.modal_stiffness() / (shape.modal_mass() * root.omega * root.omega);
        assert!((stiffness - 1.0).abs() < 1e-11, "{stiffness} in mode {number}");
        let sensitivity = system.sensitivity(root).unwrap();
        let step = 1e-5;
        let at = |change: [f64; 6]| {
            let [speed, height, radius, mass, angle, k] = change;
            let model = Blade {
                speed: BLADE.speed + speed,
                height: BLADE.height + height,
                radius: BLADE.radius + radius,
                mass: BLADE.mass + mass,
                angle: BLADE.angle + angle,
                k: BLADE.k + k,
            };
            let near = root.omega * 0.99..=root.omega * 1.01;
            model.build().unwrap().natural_frequencies::<2>(near).unwrap()[0].omega
        };
        for (k, name) in ["speed", "height", "radius", "mass", "angle", "k"].into_iter().enumerate() {
            let moved = |by: f64| at(core::array::from_fn(|place| if place == k { by } else { 0.0 }));
            let expected = (moved(step) - moved(-step)) / (2.0 * step);
            let found = sensitivity.get(name).unwrap();
            let rounding = 32.0 * f64::EPSILON * root.omega / step;
            assert!((found - expected).abs() < 1e-7 * expected.abs() + rounding, "{name}: {found} {expected}");
        }
    }
}
