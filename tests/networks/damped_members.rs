//! Members of frames with damping of their material or in a medium.
#![expect(clippy::unwrap_used, reason = "a helper that fails fails the test that called it")]

use mstmm::motion::MotionError;
use mstmm::prelude::*;
use mstmm::search::{Eigenvalue, ProportionalDamping, SearchError};
use serde_json::Value;

type C = Complex<f64>;

system! {
    /// `hysteretic_l_frame` of tests/data/frames.json.
    struct LFrame { loss: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e6, bending_stiffness: 100.0, mass_per_length: 1.0, loss_factor: loss }
        -> conn 2 at (0.0, 1.0)
        -> beam 3 { axial_stiffness: 1e6, bending_stiffness: 100.0, mass_per_length: 1.0, loss_factor: loss } -> conn 4 at (1.5, 1.0);
    conn 4 <- along (0.0, 1.0) <- damper 5 { damping: 1.5 } <- fixed
}

fn complex(value: &Value) -> C {
    let part = |k: usize| value[k].as_str().unwrap().parse().unwrap();
    C::new(part(0), part(1))
}

fn distance(roots: &[Eigenvalue], exact: C) -> f64 {
    roots.iter().map(|root| (root.lambda - exact).norm()).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_frame_with_a_loss_factor_and_a_dashpot_is_exact() {
    let file: Value = serde_json::from_str(include_str!("../data/frames.json")).unwrap();
    let wanted = &file["hysteretic_l_frame"]["wanted"];
    let frame = LFrame { loss: 0.1 }.build().unwrap();
    let first = frame.first_eigenvalues::<6>().unwrap();
    let region = Region { re: -100.0..=1.0, im: 1e-3..=500.0 };
    let in_region = frame.eigenvalues::<8>(region.clone()).unwrap();
    assert_eq!((first.len(), in_region.len(), frame.count_in(region)), (6, 6, Ok(6)));
    for exact in wanted["lambda"].as_array().unwrap().iter().map(complex) {
        for roots in [&*first, &*in_region] {
            // condition of a root: half for stiffness and mass each, 2 for lengths
            assert!(
                distance(roots, exact) <= 3e-14 * exact.norm(),
                "{exact}: {:e}",
                distance(roots, exact) / exact.norm()
            );
        }
    }
    let response = frame.frequency_response(LFrame::conn_4.force_y(), LFrame::conn_4.displacement_y()).unwrap();
    for row in wanted["receptance"][0]["rows"].as_array().unwrap() {
        let (omega, exact) = (row["omega"].as_f64().unwrap(), complex(&row["H"][0]));
        let value = response.at(C::new(0.0, omega)).unwrap();
        assert!((value - exact).norm() <= 1e-14 * 8.0 * exact.norm(), "{omega}: {value} beside {exact}");
        let below = response.at(C::new(0.0, -omega)).unwrap();
        assert!(omega == 0.0 || below == value.conj(), "{omega}: {below}");
    }
    assert!(matches!(response.states(C::new(0.0, -5.0)), Err(MotionError::LossFactor)));
    let refused = frame.eigenvalues::<8>(Region { re: -100.0..=1.0, im: 0.0..=500.0 });
    assert_eq!(refused.err(), Some(SearchError::LossFactor { im: 0.0 }));
}

system! {
    /// A portal with a brace and a shear-soft girder.
    struct Portal {}
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0 } -> conn b at (0.2, 1.1)
        -> beam 2 { axial_stiffness: 3e3, bending_stiffness: 60.0, mass_per_length: 1.5, shear_stiffness: 2e3, rotary_inertia: 0.02 }
        -> conn c at (1.5, 1.0)
        -> beam 3 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0, rotary_inertia: 0.05 } -> pinned at (1.6, 0.0);
    conn b -> spring 4 { stiffness: 800.0 } -> conn g at (0.9, 0.0) <- fixed;
    conn c <- along (1.0, 0.5) <- rod 5 { length: 0.8, axial_stiffness: 300.0, mass_per_length: 0.3 } <- fixed
}

system! {
    struct LossyPortal { eta: f64, c: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0, loss_factor: eta, kelvin_voigt_time: c }
        -> conn b at (0.2, 1.1)
        -> beam 2 { axial_stiffness: 3e3, bending_stiffness: 60.0, mass_per_length: 1.5, shear_stiffness: 2e3, rotary_inertia: 0.02,
            loss_factor: eta, kelvin_voigt_time: c }
        -> conn c at (1.5, 1.0)
        -> beam 3 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0, rotary_inertia: 0.05, loss_factor: eta,
            kelvin_voigt_time: c } -> pinned at (1.6, 0.0);
    conn b -> spring 4 { stiffness: 800.0, loss_factor: eta, kelvin_voigt_time: c } -> conn g at (0.9, 0.0) <- fixed;
    conn c <- along (1.0, 0.5)
        <- rod 5 { length: 0.8, axial_stiffness: 300.0, mass_per_length: 0.3, loss_factor: eta, kelvin_voigt_time: c } <- fixed
}

/// Closed form: `λ² + (1 + cλ)(1 + iη) ω² = 0` at certified frequencies.
#[test]
fn one_loss_for_a_frame_is_damping_in_proportion() {
    let plain = Portal {}.build().unwrap().first_frequencies::<9>().unwrap();
    for (eta, c) in [(0.15, 0.0), (0.0, 5e-4), (0.1, 2e-4)] {
        let damping = ProportionalDamping::new(0.0, c, eta).unwrap();
        let found = LossyPortal { eta, c }.build().unwrap().first_eigenvalues::<5>().unwrap();
        let all: Vec<Eigenvalue> = plain.iter().flat_map(|root| damping.eigenvalues(root)).flatten().collect();
        for root in &found {
            assert!(distance(&all, root.lambda) <= 1e-13 * root.frequency(), "{root:?} of {eta}, {c}");
        }
        assert_eq!(found.len(), 5);
    }
}

system! {
    struct InMedium { alpha: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0, axial_force: -40.0, external_damping: 2.0 * alpha }
        -> conn b at (0.2, 1.1)
        -> beam 2 { axial_stiffness: 3e3, bending_stiffness: 60.0, mass_per_length: 1.5, foundation_stiffness: 70.0,
            external_damping: 1.5 * alpha } -> conn c at (1.5, 1.0);
    conn c <- along (1.0, 0.5) <- string 3 { length: 0.8, tension: 30.0, mass_per_length: 0.3, external_damping: 0.3 * alpha } <- fixed
}

system! {
    struct InVacuum {}
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e3, bending_stiffness: 90.0, mass_per_length: 2.0, axial_force: -40.0 }
        -> conn b at (0.2, 1.1)
        -> beam 2 { axial_stiffness: 3e3, bending_stiffness: 60.0, mass_per_length: 1.5, foundation_stiffness: 70.0 }
        -> conn c at (1.5, 1.0);
    conn c <- along (1.0, 0.5) <- string 3 { length: 0.8, tension: 30.0, mass_per_length: 0.3 } <- fixed
}

/// Closed form: `λ² + αλ + ω² = 0` where a medium resists all displacements in proportion to masses.
#[test]
fn a_medium_resists_along_members_and_across() {
    let plain = InVacuum {}.build().unwrap().first_frequencies::<8>().unwrap();
    let damping = ProportionalDamping::new(7.0, 0.0, 0.0).unwrap();
    let all: Vec<Eigenvalue> = plain.iter().flat_map(|root| damping.eigenvalues(root)).flatten().collect();
    let found = InMedium { alpha: 7.0 }.build().unwrap().first_eigenvalues::<6>().unwrap();
    for root in &found {
        assert!(distance(&all, root.lambda) <= 1e-13 * root.frequency(), "{root:?}");
    }
}

system! {
    struct Tree { eta: f64, c: f64, medium: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 30.0, mass_per_length: 1.5, shear_stiffness: 250.0, rotary_inertia: 0.02,
            axial_force: -10.0, foundation_stiffness: 25.0, loss_factor: eta, external_damping: medium } -> conn 2
        -> beam 3 { length: 0.7, bending_stiffness: 20.0, mass_per_length: 1.0, kelvin_voigt_time: c } -> conn 4 -> free;
    conn 2 <- torsion_spring 6 { stiffness: 4.0, kelvin_voigt_time: c } <- fixed;
    conn 4 <- spring 5 { stiffness: 60.0, loss_factor: 0.5 * eta } <- fixed
}

system! {
    struct Line { eta: f64, c: f64, medium: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: 30.0, mass_per_length: 1.5, shear_stiffness: 250.0, rotary_inertia: 0.02,
            axial_force: -10.0, foundation_stiffness: 25.0, loss_factor: eta, external_damping: medium } -> conn 2 at 1.0
        -> beam 3 { bending_stiffness: 20.0, mass_per_length: 1.0, kelvin_voigt_time: c } -> conn 4 at 1.7;
    conn 2 <- torsion_spring 6 { stiffness: 4.0, kelvin_voigt_time: c } <- fixed;
    conn 4 <- spring 5 { stiffness: 60.0, loss_factor: 0.5 * eta } <- fixed
}

/// Minors and stiffnesses share the constants of beams alone: roots, responses, shapes, energies and sensitivities agree.
#[test]
fn trees_and_fronts_agree() {
    for (eta, c, medium) in [(0.2, 1e-3, 2.0), (0.0, 2e-3, 3.0), (0.4, 0.0, 0.0)] {
        let (tree, line) = (Tree { eta, c, medium }.build().unwrap(), Line { eta, c, medium }.build().unwrap());
        let (roots, others) = (tree.first_eigenvalues::<4>().unwrap(), line.first_eigenvalues::<4>().unwrap());
        for (root, other) in roots.iter().zip(&others) {
            assert!((root.lambda - other.lambda).norm() <= 1e-13 * root.frequency(), "{root:?} {other:?}");
            let (one, two) = (tree.sensitivity(root).unwrap(), line.sensitivity(other).unwrap());
            for (name, value) in one.iter() {
                let difference = (two.get(name).unwrap() - value).norm();
                assert!(difference <= 1e-10 * (value.norm() + root.frequency()), "{name}: {value} {:?}", two.get(name));
            }
            let (shape, plane) = (tree.mode_shape(root).unwrap(), line.mode_shape(other).unwrap());
            let (share, plane_share) = (shape.energy_shares(Tree::beam_1), plane.energy_shares(Line::beam_1).unwrap());
            for (a, b) in [
                (share.strain, plane_share.strain),
                (share.kinetic, plane_share.kinetic),
                (share.dissipated, plane_share.dissipated),
            ] {
                assert!((a - b).abs() < 1e-10, "{share:?} {plane_share:?}");
            }
        }
        let response = tree.frequency_response(Tree::conn_2.force(), Tree::conn_4.rotation()).unwrap();
        let other = line.frequency_response(Line::conn_2.force_y(), Line::conn_4.rotation_z()).unwrap();
        for omega in [0.0, 3.0, 17.0, 300.0, -17.0] {
            let [a, b] = [response.at(C::new(0.0, omega)).unwrap(), other.at(C::new(0.0, omega)).unwrap()];
            assert!((a - b).norm() <= 1e-12 * a.norm(), "{omega}: {a} {b}");
        }
    }
}

/// The determinant of the overall matrix over Δ is one number at all frequencies.
#[test]
fn the_overall_matrix_of_damped_members_is_that_of_fronts() {
    let portal = LossyPortal { eta: 0.15, c: 5e-4 }.build().unwrap();
    let ratio = |lambda: C| {
        let (all, delta) = (portal.overall_determinant(lambda), portal.characteristic(lambda));
        all.mantissa() / delta.mantissa() * 2f64.powi((all.exponent() - delta.exponent()) as i32)
    };
    let first = ratio(C::new(-1.0, 9.0));
    for lambda in [C::new(-3.0, 30.0), C::new(2.0, 1.0), C::new(-10.0, 100.0)] {
        assert!((ratio(lambda) - first).norm() <= 1e-10 * first.norm(), "{lambda}: {} {first}", ratio(lambda));
    }
}

system! {
    /// A portal of which one member has damping of all kinds, by fields.
    struct Detail { eta: f64, c: f64, medium: f64, span: f64, ea: f64, ei: f64, m: f64, shear: f64, k: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m, shear_stiffness: shear,
            rotary_inertia: 0.03, loss_factor: eta, kelvin_voigt_time: c, external_damping: medium } -> conn b at (0.3, 1.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 40.0, mass_per_length: 1.0, axial_force: 15.0, foundation_stiffness: k,
            loss_factor: 0.5 * eta } -> pinned at (span, 1.2);
    conn b <- along (1.0, 0.4) <- spring 3 { stiffness: k, kelvin_voigt_time: 2.0 * c } <- fixed
}

const DETAIL: Detail =
    Detail { eta: 0.1, c: 1e-3, medium: 2.0, span: 1.4, ea: 700.0, ei: 30.0, m: 1.2, shear: 500.0, k: 20.0 };

/// Oracle: differences of the roots of models with fields a little larger and smaller.
#[test]
fn sensitivities_are_differences_of_roots() {
    let system = DETAIL.build().unwrap();
    let roots = system.first_eigenvalues::<3>().unwrap();
    type Change = fn(&mut Detail, f64);
    let changes: [(&str, f64, Change); 9] = [
        ("eta", 0.1, |model, by| model.eta += by),
        ("c", 1e-3, |model, by| model.c += by),
        ("medium", 2.0, |model, by| model.medium += by),
        ("span", 1.4, |model, by| model.span += by),
        ("ea", 700.0, |model, by| model.ea += by),
        ("ei", 30.0, |model, by| model.ei += by),
        ("m", 1.2, |model, by| model.m += by),
        ("shear", 500.0, |model, by| model.shear += by),
        ("k", 20.0, |model, by| model.k += by),
    ];
    for (k, root) in roots.iter().enumerate() {
        let sensitivity = system.sensitivity(root).unwrap();
        for (name, size, change) in changes {
            let step = 1e-4 * size;
            let [above, below] = [step, -step].map(|by| {
                let mut model = DETAIL;
                change(&mut model, by);
                model.build().unwrap().first_eigenvalues::<3>().unwrap()[k].lambda
            });
            let difference = (above - below) / (2.0 * step);
            let value = sensitivity.get(name).unwrap();
            // the truncation of central differences
            assert!(
                (difference - value).norm() * size <= 2e-7 * root.frequency(),
                "{name} of {k}: {value} {difference}"
            );
        }
    }
}

system! {
    /// The first member of the same portal in two parts.
    struct InParts { part: f64, eta: f64, c: f64, medium: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 700.0, bending_stiffness: 30.0, mass_per_length: 1.2, shear_stiffness: 500.0,
            rotary_inertia: 0.03, loss_factor: eta, kelvin_voigt_time: c, external_damping: medium } -> conn a at (0.3 * part, 1.0 * part)
        -> beam 4 { axial_stiffness: 700.0, bending_stiffness: 30.0, mass_per_length: 1.2, shear_stiffness: 500.0,
            rotary_inertia: 0.03, loss_factor: eta, kelvin_voigt_time: c, external_damping: medium } -> conn b at (0.3, 1.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 40.0, mass_per_length: 1.0, axial_force: 15.0, foundation_stiffness: 20.0,
            loss_factor: 0.5 * eta } -> pinned at (1.4, 1.2);
    conn b <- along (1.0, 0.4) <- spring 3 { stiffness: 20.0, kelvin_voigt_time: 2.0 * c } <- fixed
}

/// Oracle: a point between two parts of the member.
#[test]
fn motions_inside_of_members_are_those_of_points_there() {
    let (part, length) = (0.37, (0.09_f64 + 1.0).sqrt());
    let Detail { eta, c, medium, .. } = DETAIL;
    let (whole, parts) = (DETAIL.build().unwrap(), InParts { part, eta, c, medium }.build().unwrap());
    let load = whole.frequency_response(Detail::conn_b.force_x(), Detail::conn_b.displacement_y()).unwrap();
    let other = parts.frequency_response(InParts::conn_b.force_x(), InParts::conn_b.displacement_y()).unwrap();
    for lambda in [C::new(0.0, 7.0), C::new(-1.0, 40.0), C::new(0.0, 200.0)] {
        let (states, others) = (load.states(lambda).unwrap(), other.states(lambda).unwrap());
        let inside = states.along(Detail::beam_1, part * length).unwrap();
        let [x, y, rotation] =
            [InParts::conn_a.displacement_x(), InParts::conn_a.displacement_y(), InParts::conn_a.rotation_z()]
                .map(|entry| others.value(entry).unwrap());
        let size = x.norm() + y.norm() + rotation.norm();
        let found = [inside.displacement_x, inside.displacement_y, inside.rotation_z];
        for (found, exact) in found.into_iter().zip([x, y, rotation]) {
            assert!((found - exact).norm() <= 1e-11 * size, "{lambda}: {found} {exact}");
        }
        let end = InParts::beam_1.output();
        for (found, entry) in
            [(inside.moment, end.moment()), (inside.shear, end.shear()), (inside.axial_force, end.axial_force())]
        {
            let exact = others.value(entry).unwrap();
            assert!((found - exact).norm() <= 1e-10 * exact.norm(), "{lambda}: {found} {exact}");
        }
    }
}

system! {
    /// A lossy cantilever on rollers along its foundation, which nothing holds along x.
    struct Unheld { eta: f64 }
    guided at (0.0, 0.0) along (1.0, 0.0)
        -> beam 1 { axial_stiffness: 1e3, bending_stiffness: 2.0, mass_per_length: 1.0, loss_factor: eta } -> conn a at (1.0, 0.0)
}

/// The response at rest is the limit from above, `(1 + iη) K`, whether or not something else moves off.
#[test]
fn the_response_at_rest_is_the_limit_from_above() {
    let system = Unheld { eta: 0.25 }.build().unwrap();
    let response = system.frequency_response(Unheld::conn_a.force_y(), Unheld::conn_a.displacement_y()).unwrap();
    let exact = (C::new(1.0, 0.25) * 6.0).inv();
    let value = response.at(C::ZERO).unwrap();
    assert!((value - exact).norm() <= 1e-11 * exact.norm(), "{value} beside {exact}");
    let along = system.frequency_response(Unheld::conn_a.force_x(), Unheld::conn_a.displacement_x()).unwrap();
    assert!(matches!(along.at(C::ZERO), Err(MotionError::Resonance { .. })));
}

system! {
    /// A beam that swings about a pin in a medium: it rests anywhere, and comes to rest with the rate c/m.
    struct Swinging { c: f64 }
    pinned at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5, external_damping: c } -> conn b at (1.0, 0.0);
}

system! {
    /// A free beam of a lossy material, with three motions at rest, each twice.
    struct Free { time: f64 }
    conn a at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5, kelvin_voigt_time: time } -> conn b at (1.0, 0.0);
}

/// Oracle: `λ (m λ + c) = 0` for the motion without strain.
#[test]
fn motions_at_rest_of_damped_frames_are_found() {
    let found = Swinging { c: 0.1 }.build().unwrap().first_eigenvalues::<4>().unwrap();
    assert_eq!((found[0].lambda, found[0].multiplicity), (C::new(0.0, 0.0), 1));
    assert!((found[1].lambda + 0.1 / 1.5).norm() < 1e-15, "{}", found[1].lambda);
    assert!((found[2].lambda.re + 0.05 / 1.5).abs() < 1e-13 && found[2].lambda.im > 1.0);
    let free = Free { time: 1e-4 }.build().unwrap();
    for size in [1e-4, 1e-2, 1.0, 10.0] {
        assert_eq!(free.count_in(Region { re: -size..=size, im: -size..=size }), Ok(6), "{size}");
    }
}
