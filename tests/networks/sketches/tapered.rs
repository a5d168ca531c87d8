//! Tapered beams between the points of a line against the same in a path.

use super::{assert_near, frequencies};

use mstmm::motion::MotionError;
use mstmm::prelude::*;

mod tree {
    use mstmm::prelude::*;

    system! {
        /// A blade on a hub of its own inertia, a wedge behind it that leads back, and a spring with a mass.
        pub(super) struct Blade { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) speed: f64, pub(super) k: f64 }

        fixed -> tapered_beam 1 {
                length: l, bending_stiffness: ei, mass_per_length: m, width_taper: 0.5, height_taper: 0.5, rotary_inertia: 0.01 * m,
                rotation_speed: speed, hub_radius: 0.1 * l,
            }
            -> conn 2
            -> tapered_beam 3 {
                length: 2.0 * l, bending_stiffness: 0.0625 * ei, mass_per_length: 0.25 * m, width_taper: -1.0, height_taper: -1.0,
                axial_force: 0.3 * ei, foundation_stiffness: 0.1 * k,
            }
            -> conn 4 -> free;
        conn 2 <- spring 5 { stiffness: k } <- fixed;
        conn 4 <- spring 6 { stiffness: k } <- mass 7 { mass: m } <- free;
    }

    system! {
        pub(super) struct Damped { pub(super) l: f64, pub(super) c: f64 }

        fixed -> tapered_beam 1 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: 0.5 } -> conn 2 -> free;
        conn 2 <- damper 3 { damping: c } <- fixed;
    }

    system! {
        /// A wedge on a foundation, on which waves travel at its thick end alone: elsewhere they decay.
        pub(super) struct Trap { pub(super) stiffness: f64 }

        fixed -> tapered_beam 1 {
                length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, width_taper: 0.5, height_taper: 0.5, foundation_stiffness: stiffness,
            }
            -> conn tip -> point_mass 2 { mass: 0.0 } -> free;
    }
}

mod line {
    use mstmm::prelude::*;

    system! {
        /// The second beam has its input end where that of the path has its output end.
        pub(super) struct Blade { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) speed: f64, pub(super) k: f64 }

        fixed at 0.0 -> tapered_beam 1 {
                bending_stiffness: ei, mass_per_length: m, width_taper: 0.5, height_taper: 0.5, rotary_inertia: 0.01 * m, rotation_speed: speed,
                hub_radius: 0.1 * l,
            }
            -> conn 2 at l;
        conn 4 at 3.0 * l -> tapered_beam 3 {
                bending_stiffness: ei, mass_per_length: m, width_taper: 0.5, height_taper: 0.5, axial_force: 0.3 * ei,
                foundation_stiffness: 0.1 * k,
            }
            -> conn 2;
        conn 2 <- spring 5 { stiffness: k } <- fixed;
        conn 4 <- spring 6 { stiffness: k } <- mass 7 { mass: m } <- free;
    }

    system! {
        pub(super) struct Damped { pub(super) l: f64, pub(super) c: f64 }

        fixed at -0.5 -> tapered_beam 1 { bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: 0.5 } -> conn 2 at l - 0.5;
        conn 2 <- damper 3 { damping: c } <- fixed;
    }

    system! {
        pub(super) struct Trap { pub(super) stiffness: f64 }

        fixed at 0.0 -> tapered_beam 1 {
                bending_stiffness: 1.0, mass_per_length: 1.0, width_taper: 0.5, height_taper: 0.5, foundation_stiffness: stiffness,
            }
            -> conn tip at 1.0;
    }
}

const SPEEDS: [f64; 2] = [0.0, 3.0];

fn both(speed: f64) -> (tree::BladeSystem, line::BladeSystem) {
    let (l, ei, m, k) = (1.5, 2.0, 0.5, 8.0);
    let tree = tree::Blade { l, ei, m, speed, k }.build().unwrap();
    (tree, line::Blade { l, ei, m, speed, k }.build().unwrap())
}

/// Searches by minors and by charts propose, and both are proven.
#[test]
fn a_line_has_the_frequencies_of_its_path() {
    for speed in SPEEDS {
        let (tree, line) = both(speed);
        assert_near(&frequencies(&line), &frequencies(&tree), 1e-14);
        assert!(line.first_frequencies::<8>().unwrap().iter().all(|root| root.is_proven), "{speed}");
        for omega in [0.1, 3.0, 40.0, 700.0] {
            assert_eq!(line.count_below(omega), tree.count_below(omega), "{speed} {omega}");
        }
    }
}

#[test]
fn a_damped_line_has_the_eigenvalues_of_its_path() {
    for c in [0.05, 2.0] {
        let (l, region) = (2.0, Region { re: -20.0..=0.5, im: 0.1..=200.0 });
        let tree = tree::Damped { l, c }.build().unwrap().eigenvalues_in(region.clone()).unwrap();
        let line = line::Damped { l, c }.build().unwrap().eigenvalues_in(region).unwrap();
        assert!(tree.len() > 4);
        assert_eq!(tree.len(), line.len(), "{c}");
        for (one, other) in tree.iter().zip(&line) {
            assert!((one.lambda - other.lambda).norm() < 1e-13 * one.lambda.norm(), "{one:?} {other:?}");
        }
    }
}

/// Shapes at both ends and inside, and responses, to the last digits.
#[test]
fn a_line_moves_as_its_path() {
    use line::Blade as L;
    use tree::Blade as T;
    for speed in SPEEDS {
        let (tree, line) = both(speed);
        let roots = [tree.first_frequencies::<6>().unwrap(), line.first_frequencies::<6>().unwrap()];
        for (root, other) in roots[0].iter().zip(&roots[1]) {
            let (shape, other) = (tree.mode_shape(root).unwrap(), line.mode_shape(other).unwrap());
            let [tip, theirs] =
                [shape.state(T::tapered_beam_3.output()).y, other.value(L::conn_4.displacement_y()).unwrap()];
            let sign = (tip * theirs).signum();
            let near = |one: f64, other: f64, scale: f64| {
                assert!((one - sign * other).abs() <= 1e-11 * scale, "{one} {other} of {root}");
            };
            near(tip, theirs, 2.0);
            for part in [0.25, 0.6, 0.9] {
                let (inside, theirs) = (
                    shape.along(T::tapered_beam_1, 1.5 * part).unwrap(),
                    other.along(L::tapered_beam_1, 1.5 * part).unwrap(),
                );
                near(inside.y, theirs.displacement_y, 2.0);
                near(inside.theta, theirs.rotation_z, 4.0 * (1.0 + root.omega.sqrt()));
                // counted from the other end
                let (inside, theirs) = (
                    shape.along(T::tapered_beam_3, 3.0 * part).unwrap(),
                    other.along(L::tapered_beam_3, 3.0 * (1.0 - part)).unwrap(),
                );
                near(inside.y, theirs.displacement_y, 2.0);
            }
            assert!((other.modal_mass() - 1.0).abs() < 1e-12, "{root}");
        }
        let response = tree.frequency_response(T::conn_2.force(), T::conn_4.deflection()).unwrap();
        let other = line.frequency_response(L::conn_2.force_y(), L::conn_4.displacement_y()).unwrap();
        for omega in [0.0, 0.7, 12.0, 333.0] {
            let (one, other) = (response.at(omega).unwrap(), other.at(omega).unwrap());
            assert!((one - other).abs() <= 4.0 * f64::EPSILON * one.abs(), "{speed} {omega}: {one} {other}");
        }
    }
}

/// Asserts that shapes are refused or right, by differences of the frequencies. Returns how many are refused.
macro_rules! trapped {
    ($model:path) => {{
        let system = |stiffness: f64| {
            type Model = $model;
            Model { stiffness }.build().unwrap()
        };
        let mut refused = 0;
        for stiffness in [1e3, 1e4, 1e5, 1e6, 1e7, 1e8] {
            let own = system(stiffness);
            let roots = own.first_frequencies::<3>().unwrap();
            let [above, below] =
                [1.0 + 1e-4, 1.0 - 1e-4].map(|part| system(stiffness * part).first_frequencies::<3>().unwrap());
            for (index, root) in roots.iter().enumerate() {
                match own.mode_shape(root) {
                    Ok(shape) => {
                        let expected = (above[index].omega - below[index].omega) / (2e-4 * stiffness);
                        let derivative = own.sensitivity(root).unwrap().get("stiffness").unwrap();
                        assert!(
                            (derivative / expected - 1.0).abs() < 1e-6,
                            "{stiffness} {root}: {derivative} {expected}"
                        );
                        assert!((shape.modal_mass() - 1.0).abs() < 1e-8, "{stiffness} {root}");
                    }
                    Err(MotionError::Unresolved { .. }) => refused += 1,
                    Err(error) => panic!("{stiffness} {root}: {error}"),
                }
            }
        }
        refused
    }};
}

/// A motion that is trapped inside an element hardly moves its ends: the motion inside does not follow from them, and is refused.
#[test]
fn trapped_motions_are_refused() {
    let refused = [trapped!(tree::Trap), trapped!(line::Trap)];
    assert!(refused.iter().all(|refused| (3..=12).contains(refused)), "{refused:?}");
}
