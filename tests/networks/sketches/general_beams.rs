//! General beams between points: beside trees of the same beams, turned round, and under critical loads of frames.

use super::{assert_near, frequencies};
use mstmm::prelude::*;
use mstmm::search::critical_loads;

mod trees {
    use mstmm::prelude::*;

    system! {
        /// A beam with shear under tension, one on a foundation, a strut, with an oscillator.
        pub(super) struct Chain { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) ga: f64, pub(super) r: f64, pub(super) n: f64, pub(super) k: f64 }

        fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r } -> conn 2
            -> beam 3 {
                length: 1.5 * l, bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r,
                axial_force: n, foundation_stiffness: k
            }
            -> beam 5 { length: l, bending_stiffness: 2.0 * ei, mass_per_length: m, axial_force: -0.1 * n }
            -> beam 7 { length: l, bending_stiffness: ei, mass_per_length: m, foundation_stiffness: k } -> pinned;
        conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass: m } <- free;
    }
}

mod sketches {
    use mstmm::prelude::*;

    system! {
        pub(super) struct Chain { pub(super) l: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) ga: f64, pub(super) r: f64, pub(super) n: f64, pub(super) k: f64 }

        fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r } -> conn 2 at l
            -> beam 3 {
                bending_stiffness: ei, mass_per_length: m, shear_stiffness: ga, rotary_inertia: r, axial_force: n,
                foundation_stiffness: k
            } -> conn 4 at 2.5 * l
            -> beam 5 { bending_stiffness: 2.0 * ei, mass_per_length: m, axial_force: -0.1 * n } -> conn 6 at 3.5 * l
            -> beam 7 { bending_stiffness: ei, mass_per_length: m, foundation_stiffness: k } -> pinned at 4.5 * l;
        conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass: m } <- free;
    }

    system! {
        /// A cantilever of general beams in a direction, nearly rigid along it.
        pub(super) struct Turned { pub(super) x: f64, pub(super) y: f64, pub(super) ea: f64, pub(super) f: f64, pub(super) r: f64, pub(super) n: f64, pub(super) k: f64 }

        fixed at (0.0, 0.0) -> beam 1 {
            axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
            foundation_stiffness: k
        } -> conn 2 at (0.4 * x, 0.4 * y) <- beam 3 {
            axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
            foundation_stiffness: k
        } <- free at (x, y);
    }
}

system! {
    struct Cantilever { f: f64, r: f64, n: f64, k: f64 }
    fixed -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
        foundation_stiffness: k
    } -> free
}

system! {
    struct PlainPortal { ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (0.0, 1.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn c at (1.5, 1.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned at (1.5, 0.0)
}

system! {
    struct GeneralPortal { ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn b at (0.0, 1.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0} -> conn c at (1.5, 1.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0} -> pinned at (1.5, 0.0)
}

/// Declares square portals whose columns are under a load each.
macro_rules! swaying {
    ($($model:ident = $foot:ident;)*) => {$(
        system! {
            struct $model { load: f64, ea: f64 }
            $foot at (0.0, 0.0)
                -> beam 1 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } -> conn b at (0.0, 1.0)
                -> beam 2 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn c at (1.0, 1.0);
            conn c <- beam 3 { axial_stiffness: ea, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } <- $foot at (1.0, 0.0);
        }
    )*};
}
swaying! {
    ClampedFeet = fixed;
    PinnedFeet = pinned;
}

const CHAINS: [[f64; 7]; 3] = [
    [1.0, 1.0, 1.0, 50.0, 0.01, 2.0, 30.0],
    [0.7, 3.0, 2.0, 900.0, 0.002, 60.0, 500.0],
    [2.0, 0.5, 0.4, 4.0, 0.1, -0.3, 1.0],
];

#[test]
fn a_line_of_general_beams_is_their_tree() {
    for [l, ei, m, ga, r, n, k] in CHAINS {
        let tree = trees::Chain { l, ei, m, ga, r, n, k };
        let sketch = sketches::Chain { l, ei, m, ga, r, n, k };
        let (tree, sketch) = (tree.build().unwrap(), sketch.build().unwrap());
        let [expected, found] = [frequencies(&tree), frequencies(&sketch)];
        assert_near(&found, &expected, 1e-14);
        let beyond = 30.0 * expected[9];
        assert_eq!(sketch.count_below(beyond), tree.count_below(beyond));
        // Δ by stiffnesses is that by minors up to one constant, whatever the charts divide by
        let ratio = |omega: f64| {
            let (front, minors) = (Characteristic::<f64>::characteristic(&sketch, omega), tree.characteristic(omega));
            let power = i32::try_from(front.exponent() - minors.exponent()).unwrap();
            front.mantissa() / minors.mantissa() * 2_f64.powi(power)
        };
        let constant = ratio(0.5 * expected[0]);
        for k in 1..60 {
            let omega = 0.37 * expected[0] * 1.11_f64.powi(k);
            assert!((ratio(omega) / constant - 1.0).abs() <= 1e-9, "{omega}: {} and {constant}", ratio(omega));
        }
        for index in [0, 4, 9] {
            let roots =
                (tree.first_frequencies::<10>().unwrap()[index], sketch.first_frequencies::<10>().unwrap()[index]);
            let sensitivities = (tree.sensitivity(&roots.0).unwrap(), sketch.sensitivity(&roots.1).unwrap());
            let fields = [("l", l), ("ei", ei), ("m", m), ("ga", ga), ("r", r), ("n", n), ("k", k)];
            for (field, value) in fields {
                let [one, other] = [sensitivities.0.get(field).unwrap(), sensitivities.1.get(field).unwrap()];
                let difference = ((one - other) * value).abs();
                assert!(difference <= 1e-10 * roots.0.omega, "{field} in mode {index}: {one} and {other}");
            }
            let shapes = (tree.mode_shape(&roots.0).unwrap(), sketch.mode_shape(&roots.1).unwrap());
            let ratio = shapes.1.value(sketches::Chain::conn_4.rotation_z()).unwrap()
                / shapes.0.state(trees::Chain::beam_3.output()).theta;
            for part in [0.1, 0.5, 0.93] {
                let length = 1.5 * l;
                let one = shapes.0.along(trees::Chain::beam_3, part * length).unwrap();
                let other = shapes.1.along(sketches::Chain::beam_3, part * length).unwrap();
                let size = one.y.abs() + one.theta.abs() * l;
                assert!(
                    (other.displacement_y - ratio * one.y).abs() <= 1e-9 * size * ratio.abs(),
                    "{one:?} {other:?} {ratio}"
                );
            }
        }
    }
}

/// A cantilever at an angle, in two parts with arrows against each other, bends as one along a path.
#[test]
fn a_general_beam_at_an_angle_is_that_of_a_path() {
    for [f, r, n, k] in [[0.05, 0.002, 3.0, 10.0], [0.0, 0.0, -1.0, 0.0], [0.3, 0.05, 0.0, 200.0]] {
        let path = Cantilever { f, r, n, k }.build().unwrap();
        let expected: Vec<f64> = path.first_frequencies::<6>().unwrap().iter().map(|root| root.omega).collect();
        for (x, y) in [(1.0, 0.0), (0.6, 0.8), (-0.28, -0.96)] {
            let turned = sketches::Turned { x, y, ea: 1e12, f, r, n, k }.build().unwrap();
            assert_near(&frequencies(&turned)[..6], &expected, 1e-13);
        }
    }
}

#[test]
fn general_beams_of_zeros_are_plain_beams() {
    for ea in [30.0, 1e4, 1e9] {
        let [plain, general] =
            [frequencies(&PlainPortal { ea }.build().unwrap()), frequencies(&GeneralPortal { ea }.build().unwrap())];
        assert_near(&general, &plain, 1e-14);
    }
}

/// Published to 15 digits for columns and a girder that do not stretch: 7.37915356079898 and 1.8212928240015 EI/l².
#[test]
fn a_square_portal_sways_at_its_critical_load() {
    let ea = 1e18;
    let clamped = critical_loads::<1, _>(1.0..=20.0, |load| ClampedFeet { load, ea }.build()).unwrap();
    let pinned = critical_loads::<1, _>(0.5..=9.0, |load| PinnedFeet { load, ea }.build()).unwrap();
    for (found, exact) in [(clamped[0], 7.379_153_560_798_98), (pinned[0], 1.821_292_824_001_5)] {
        assert!((found.factor / exact - 1.0).abs() <= 1e-14, "{} beside {exact}", found.factor);
        assert_eq!(found.multiplicity, 1);
    }
    let beyond = ClampedFeet { load: 7.4, ea }.build().unwrap();
    assert_eq!(beyond.unstable_modes(), Ok(1));
}
