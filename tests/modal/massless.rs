//! Members without mass, and springs without stiffness: beside closed forms, and beside models in which they are not.

use mstmm::prelude::*;

system! {
    /// A beam, with or without mass, under a point mass.
    #[derive(Clone, Copy)]
    struct Tip { ei: f64, m: f64, length: f64, mass: f64, inertia: f64 }
    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> point_mass 2 { mass, inertia } -> free;
}

system! {
    /// The same between places, with a bar's stiffness.
    #[derive(Clone, Copy)]
    struct PlacedTip { ei: f64, ea: f64, m: f64, length: f64, mass: f64, inertia: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn tip at (length, 0.0) -> point_mass 2 { mass, inertia };
}

/// ω² of `K - ω² diag(M, J)` with the stiffness of a cantilever at its tip.
fn exact(ei: f64, length: f64, mass: f64, inertia: f64) -> [f64; 2] {
    let [a, b, c] = [12.0 * ei / length.powi(3) / mass, -6.0 * ei / length.powi(2), 4.0 * ei / length / inertia];
    let (mean, half) = (0.5 * (a + c), 0.5 * (a - c));
    let root = (half * half + b * b / (mass * inertia)).sqrt();
    // the product of both is exact where their difference cancels
    let high = mean + root;
    [3.0 * (2.0 * ei).powi(2) / (length.powi(4) * mass * inertia) / high, high].map(f64::sqrt)
}

#[test]
fn a_massless_beam_under_a_mass_is_its_static_stiffness() {
    for (ei, length, mass, inertia) in [(1.0, 1.0, 1.0, 0.3), (3e5, 7.0, 20.0, 4.0), (1e-4, 0.2, 5.0, 1e-3)] {
        let exact = exact(ei, length, mass, inertia);
        let system = Tip { ei, m: 0.0, length, mass, inertia }.build().unwrap();
        let roots = system.first_frequencies::<2>().unwrap();
        let placed = PlacedTip { ei, ea: 1e9, m: 0.0, length, mass, inertia }.build().unwrap();
        let others = placed.first_frequencies::<2>().unwrap();
        for ((root, other), exact) in roots.iter().zip(others.iter()).zip(exact) {
            assert!((root.omega / exact - 1.0).abs() < 1e-14 && root.is_proven, "{root:?} {exact}");
            assert!((other.omega / exact - 1.0).abs() < 1e-14 && other.is_proven, "{other:?} {exact}");
        }
        assert_eq!(system.count_below(1e3 * exact[1]).unwrap(), 2);
    }
}

/// `ω² = k/(M + (33/140) m l)` to first order in m, whose shape is that of the beam at rest.
#[test]
fn the_slope_with_respect_to_a_mass_that_is_not_there_is_that_of_rayleigh() {
    let (ei, length, mass) = (2.0, 1.5, 4.0);
    let omega = (3.0 * ei / (mass * f64::powi(length, 3))).sqrt();
    let rayleigh = -0.5 * omega * (33.0 / 140.0) * length / mass;
    let system = Tip { ei, m: 0.0, length, mass, inertia: 0.0 }.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    assert!((root.omega / omega - 1.0).abs() < 1e-15);
    let slope = system.sensitivity(&root).unwrap().get("m").unwrap();
    assert!((slope / rayleigh - 1.0).abs() < 1e-14, "{slope} {rayleigh}");
    let placed = PlacedTip { ei, ea: 1e9, m: 0.0, length, mass, inertia: 0.0 }.build().unwrap();
    let root = placed.first_frequencies::<1>().unwrap()[0];
    let slope = placed.sensitivity(&root).unwrap().get("m").unwrap();
    assert!((slope / rayleigh - 1.0).abs() < 1e-14, "{slope} {rayleigh}");
}

/// Checks that two models say the same: one has a mass or a stiffness of zero, and the other one of next to nothing.
macro_rules! assert_alike {
    ($none:expr, $little:expr, $load:expr, [$($entry:expr),*]) => {{
        let (none, little) = ($none.build().unwrap(), $little.build().unwrap());
        let (roots, others) = (none.first_frequencies::<3>().unwrap(), little.first_frequencies::<3>().unwrap());
        for (root, other) in roots.iter().zip(others.iter()) {
            assert!((root.omega / other.omega - 1.0).abs() < 1e-14 && root.is_proven, "{root} {other}");
            let (slopes, slopes_of_other) = (none.sensitivity(root).unwrap(), little.sensitivity(other).unwrap());
            for ((name, one), (_, two)) in slopes.iter().zip(slopes_of_other.iter()) {
                assert_near(one, two, name);
            }
        }
        $({
            let one = none.modal_response::<3, _>(&roots, $load, $entry).unwrap();
            let two = little.modal_response::<3, _>(&others, $load, $entry).unwrap();
            assert_near(one.at(0.9 * roots[1].omega).unwrap(), two.at(0.9 * roots[1].omega).unwrap(), stringify!($entry));
        })*
        for omega in [0.0, 0.6 * roots[0].omega, 1.3 * roots[2].omega] {
            $({
                let one = none.frequency_response($load, $entry).unwrap().at(omega).unwrap();
                let two = little.frequency_response($load, $entry).unwrap().at(omega).unwrap();
                assert_near(one, two, stringify!($entry));
            })*
        }
    }};
}

#[track_caller]
fn assert_near(one: f64, two: f64, name: &str) {
    assert!((one - two).abs() < 1e-11 * one.abs().max(1e-6), "{name}: {one} {two}");
}

system! {
    /// Lines and beams of all kinds in paths, without places.
    #[derive(Clone, Copy)]
    struct Chain { m: f64, r: f64, force: f64, foundation: f64 }
    fixed -> beam 1 { length: 0.7, bending_stiffness: 2.0, mass_per_length: m, axial_force: force, foundation_stiffness: foundation } -> point_mass 2 { mass: 1.0, inertia: 0.1 }
        -> beam 3 { length: 0.5, bending_stiffness: 1.0, mass_per_length: m, shear_stiffness: 40.0, rotary_inertia: r }
        -> point_mass 4 { mass: 0.5 } -> beam 5 { length: 0.4, bending_stiffness: 3.0, mass_per_length: m } -> conn 6 -> mass 7 { mass: 0.3 }
        -> spring 8 { stiffness: 20.0 } -> fixed;
}

system! {
    #[derive(Clone, Copy)]
    struct Rods { m: f64, k: f64 }
    fixed -> rod 1 { length: 0.7, axial_stiffness: 2.0, mass_per_length: m } -> mass 2 { mass: 1.0 }
        -> rod 3 { length: 0.5, axial_stiffness: 1.0, mass_per_length: m, foundation_stiffness: k } -> mass 4 { mass: 0.5 }
        -> string 5 { length: 0.4, tension: 3.0, mass_per_length: m } -> mass 6 { mass: 0.7 } -> free;
}

system! {
    #[derive(Clone, Copy)]
    struct Bridge { m: f64, tension: f64, depth: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: m, axial_force: -0.3 } -> conn a at (1.0, 0.2);
    conn a -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: m, shear_stiffness: 50.0 } -> conn b at (2.0, 0.0)
        -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 1.0, mass_per_length: m } -> fixed at (3.0, -depth);
    conn a -> bar 4 { axial_stiffness: 40.0, bending_stiffness: 0.01, mass_per_length: m } -> pinned at (1.0, -depth);
    conn b -> string 5 { tension, axial_stiffness: 70.0, mass_per_length: m } -> pinned at (2.5, 1.0);
    conn b -> point_mass 7 { mass: 1.0, inertia: 0.2 };
}

#[test]
fn members_without_mass_are_those_of_next_to_none() {
    let chain = Chain { m: 0.0, r: 0.0, force: -0.2, foundation: 1.5 };
    let [moment, deflection] = [Chain::beam_1.input().moment(), Chain::conn_6.deflection()];
    assert_alike!(chain, Chain { m: 1e-40, r: 1e-40, ..chain }, Chain::conn_6.force(), [moment, deflection]);
    let rods = Rods { m: 0.0, k: 0.8 };
    let [force, deflection] = [Rods::rod_3.output().shear(), Rods::mass_6.output().deflection()];
    assert_alike!(rods, Rods { m: 1e-40, ..rods }, Rods::mass_4.output().force(), [force, deflection]);
    let bridge = Bridge { m: 0.0, tension: 3.0, depth: 0.8 };
    let [moment, deflection] = [Bridge::beam_2.input().moment(), Bridge::conn_b.displacement_y()];
    assert_alike!(bridge, Bridge { m: 1e-40, ..bridge }, Bridge::conn_a.force_y(), [moment, deflection]);
}

/// The units of charts followed the mass down to nothing, and shapes lost half of its digits.
#[test]
fn shapes_beside_members_of_hardly_any_mass_are_those_without() {
    let bridge = Bridge { m: 0.0, tension: 3.0, depth: 0.8 };
    let [moment, deflection] = [Bridge::beam_2.input().moment(), Bridge::conn_b.displacement_y()];
    for exponent in (20..200).step_by(15) {
        let m = 10_f64.powi(-exponent);
        assert_alike!(bridge, Bridge { m, ..bridge }, Bridge::conn_a.force_y(), [moment, deflection]);
    }
}

system! {
    /// A mass on a spring before one that may let go, and a mass on a spring behind it.
    #[derive(Clone, Copy)]
    struct Pair { left: f64, middle: f64, right: f64 }
    fixed -> spring 1 { stiffness: left } -> mass 2 { mass: 1.0 } -> spring 3 { stiffness: middle } -> mass 4 { mass: 2.0 } -> spring 5 { stiffness: right } -> fixed;
}

system! {
    #[derive(Clone, Copy)]
    struct Braced { brace: f64, hinge: f64, foot: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn a at (0.0, 1.0);
    conn a -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn b at (1.5, 1.0);
    conn b -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn c at (1.5, 0.0);
    conn c <- along (0.0, 1.0) <- spring 4 { stiffness: foot } <- fixed;
    conn c <- along (1.0, 0.0) <- spring 5 { stiffness: 50.0 } <- fixed;
    conn c <- torsion_spring 6 { stiffness: hinge } <- fixed;
    fixed at (0.0, 0.0) -> spring 7 { stiffness: brace } -> conn b;
}

system! {
    /// The same without the brace, the spring under the foot and the hinge.
    #[derive(Clone, Copy)]
    struct Bare { stiffness: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn a at (0.0, 1.0);
    conn a -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn b at (1.5, 1.0);
    conn b -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn c at (1.5, 0.0);
    conn c <- along (1.0, 0.0) <- spring 5 { stiffness } <- fixed;
}

#[test]
fn springs_without_stiffness_join_nothing_in_paths() {
    // the lower root on either side, and one side free
    for (left, right) in [(9.0, 2.0), (1.0, 50.0), (3.0, 6.0), (0.0, 5.0), (5.0, 0.0)] {
        let system = Pair { left, middle: 0.0, right }.build().unwrap();
        let mut exact = [(f64::sqrt(left), true), (f64::sqrt(0.5 * right), false)];
        exact.sort_by(|one, other| one.0.total_cmp(&other.0));
        let roots = system.frequencies(2).unwrap();
        let entries = roots.iter().flat_map(|root| (0..root.multiplicity).map(move |_| root));
        for (root, (exact, is_left)) in entries.zip(exact) {
            assert!((root.omega - exact).abs() <= 1e-15 * exact && root.is_proven, "{root} {exact}");
            let Ok(shape) = system.mode_shape(root) else { continue };
            let moving = [Pair::mass_2, Pair::mass_4].map(|mass| shape.state(mass.output()).y != 0.0);
            assert_eq!(moving, [is_left, !is_left]);
        }
        // the side that is pushed is a mass on a spring, and the other one does not answer
        let response =
            |entry| system.frequency_response(Pair::mass_2.output().force(), entry).unwrap().at(0.4).unwrap();
        assert!((response(Pair::mass_2.output().deflection()) * (left - 0.16) - 1.0).abs() < 1e-14);
        assert_eq!(response(Pair::mass_4.output().deflection()), 0.0);
        // Δ has the same zeros
        let delta = |omega: f64| (left - omega * omega) * (right - 2.0 * omega * omega);
        let determinant = |omega: f64| {
            let delta = system.overall_determinant(omega);
            delta.mantissa() * 2.0_f64.powi(i32::try_from(delta.exponent()).unwrap())
        };
        let [one, two] = [0.3, 4.7].map(|omega| determinant(omega) / delta(omega));
        assert!((one / two - 1.0).abs() < 1e-13, "{one} {two}");
    }
}

#[test]
fn springs_without_stiffness_join_nothing_in_frames() {
    let braced = Braced { brace: 0.0, hinge: 0.0, foot: 0.0 };
    let bare = Bare { stiffness: 50.0 };
    let [moment, deflection] = [Braced::beam_2.input().moment(), Braced::conn_b.displacement_y()];
    assert_alike!(
        braced,
        Braced { brace: 1e-60, hinge: 1e-60, foot: 1e-60 },
        Braced::conn_a.force_x(),
        [moment, deflection]
    );
    let (braced, bare) = (braced.build().unwrap(), bare.build().unwrap());
    for (root, other) in braced.frequencies(8).unwrap().iter().zip(bare.frequencies(8).unwrap()) {
        assert!((root.omega / other.omega - 1.0).abs() < 1e-15 && root.is_proven, "{root} {other}");
    }
}

#[test]
fn a_model_without_any_mass_has_no_frequency() {
    let system = Tip { ei: 1.0, m: 0.0, length: 1.0, mass: 0.0, inertia: 0.0 }.build().unwrap();
    assert_eq!(system.count_below(1e9).unwrap(), 0);
    assert!(matches!(system.frequencies(1), Err(mstmm::search::SearchError::TooFewRoots { found: 0, wanted: 1 })));
    assert_eq!(system.frequencies_in(0.0..=1e9).unwrap().len(), 0);
}

#[test]
fn numbers_below_zero_are_refused() {
    let chain = Pair { left: 1.0, middle: -1.0, right: 1.0 }.build().unwrap_err();
    assert_eq!(
        chain.to_string(),
        "spring 3: stiffness is -1, but must be zero, or positive and finite, with a finite reciprocal"
    );
    let tip = Tip { ei: 1.0, m: -1.0, length: 1.0, mass: 1.0, inertia: 0.0 }.build().unwrap_err();
    assert_eq!(tip.to_string(), "beam 1: mass_per_length is -1, but must be zero or positive, and finite");
}

system! {
    /// A beam of a damped material under a mass, and the mass on a dashpot beside a spring.
    #[derive(Clone, Copy)]
    struct Damped { m: f64, k: f64, c: f64, eta: f64 }
    fixed -> beam 1 { length: 1.5, bending_stiffness: 2.0, mass_per_length: m, loss_factor: eta } -> conn tip -> mass 2 { mass: 4.0 }
        -> spring 3 { stiffness: k, damping: c } -> fixed;
}

system! {
    /// A cantilever in space under a mass.
    #[derive(Clone, Copy)]
    struct InSpace { m: f64, polar: f64 }
    fixed at (0.0, 0.0, 0.0) -> beam 1 {
        axial_stiffness: 900.0, bending_stiffness_y: 3.0, bending_stiffness_z: 2.0, torsional_stiffness: 1.0, mass_per_length: m, polar_inertia_per_length: polar
    } -> conn tip at (1.5, 0.0, 0.0) -> point_mass 2 { mass: 4.0 };
}

#[test]
fn damped_members_without_mass_are_complex_springs() {
    let (stiffness, mass) = (3.0 * 2.0 / 1.5_f64.powi(3), 4.0);
    // λ² = -(1 + iη) k/m
    let system = Damped { m: 0.0, k: 0.0, c: 0.0, eta: 0.04 }.build().unwrap();
    let root = system.first_eigenvalues::<1>().unwrap()[0].lambda;
    let exact = (Complex::new(-1.0, -0.04) * stiffness / mass).sqrt();
    assert!((root - exact).norm().min((root + exact).norm()) < 1e-14 * exact.norm(), "{root} {exact}");
    // λ² m + λ c + k = 0
    let system = Damped { m: 0.0, k: 0.0, c: 0.7, eta: 0.0 }.build().unwrap();
    let root = system.first_eigenvalues::<1>().unwrap()[0].lambda;
    let decay = 0.7 / (2.0 * mass);
    let exact = Complex::new(-decay, (stiffness / mass - decay * decay).sqrt());
    assert!((root - exact).norm() < 1e-14 * exact.norm(), "{root} {exact}");
}

#[test]
fn members_without_mass_in_space_are_their_static_stiffness() {
    let system = InSpace { m: 0.0, polar: 0.0 }.build().unwrap();
    let cube = 1.5_f64.powi(3);
    let exact = [3.0 * 2.0 / cube / 4.0, 3.0 * 3.0 / cube / 4.0, 900.0 / 1.5 / 4.0].map(f64::sqrt);
    for (root, exact) in system.frequencies(3).unwrap().iter().zip(exact) {
        assert!((root.omega / exact - 1.0).abs() < 1e-15 && root.is_proven, "{root} {exact}");
    }
}

system! {
    /// A mass that slides along x, and a spring that leads nearly across: `ω² = k dx²/(m (dx² + 1))`.
    struct Steep { tilt: f64 }
    conn c at (0.0, 0.0) -> point_mass 1 { mass: 1.0 };
    conn c -> roller along (1.0, 0.0);
    conn c <- along (tilt, 1.0) <- spring 2 { stiffness: 1.0 } <- fixed;
}

system! {
    /// A short lever under a long beam: the spring at its end turns all of it.
    struct Lever { short: f64 }
    pinned -> beam 1 { length: short, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn c -> beam 2 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
    conn c <- spring 3 { stiffness: 1.0 } <- fixed;
}

system! {
    /// Two masses on springs in a row.
    struct Row { soft: f64, light: f64, stiff: f64, heavy: f64 }
    fixed -> spring 1 { stiffness: soft } -> mass 2 { mass: light } -> spring 3 { stiffness: stiff } -> mass 4 { mass: heavy } -> free;
}

/// No estimate knows how soft a stiff spring is on a short lever, or nearly across a motion: what moves slowly was told to rest.
#[test]
fn what_moves_slowly_does_not_rest() {
    for tilt in [1e-6, 1e-12, 1e-30, 1e-60] {
        let roots = Steep { tilt }.build().unwrap().frequencies(1).unwrap();
        assert!((roots[0].omega / tilt - 1.0).abs() < 1e-12 && roots[0].is_proven, "{tilt} {}", roots[0]);
    }
    for short in [1e-6, 1e-10, 1e-13] {
        let roots = Lever { short }.build().unwrap().frequencies(1).unwrap();
        // a rigid beam of length 1 about its pin
        assert!(
            (roots[0].omega / (short * 3.0_f64.sqrt()) - 1.0).abs() < 4.0 * short && roots[0].is_proven,
            "{short} {}",
            roots[0]
        );
    }
    // one word of the spring is lost beside the other one: either the frequency is told, or that rounding decides it
    let row = Row { soft: 4.25e2, light: 1.8e-54, stiff: 1.08e70, heavy: 2.27e31 }.build().unwrap();
    let exact = (4.25e2_f64 / 2.27e31).sqrt();
    if let Ok(roots) = row.frequencies(1) {
        assert!(roots[0].lower <= exact && exact <= roots[0].upper && roots[0].upper < 1.0, "{} {exact}", roots[0]);
    }
}

system! {
    /// A mass at the end of a beam, with a dashpot.
    struct Post { m: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: 30.0, mass_per_length: m } -> conn a at 1.0;
    conn a -> point_mass 2 { mass: 1.0, inertia: 0.1 };
    conn a -> damper 3 { damping: 0.3 } -> fixed;
}

/// The unit of a chart followed a mass to beyond all digits of the damped search.
#[test]
fn damped_frames_of_hardly_any_mass_have_their_eigenvalues() {
    let none = Post { m: 0.0 }.build().unwrap().first_eigenvalues::<2>().unwrap();
    for exponent in (16..300).step_by(12) {
        let little = Post { m: 10_f64.powi(-exponent) }.build().unwrap().first_eigenvalues::<2>().unwrap();
        for (one, other) in none.iter().zip(little.iter()) {
            assert!((one.lambda - other.lambda).norm() < 1e-12 * one.lambda.norm(), "1e-{exponent} {one:?} {other:?}");
        }
    }
}

system! {
    /// A portal with a soft hinge.
    #[derive(Clone, Copy)]
    struct Hinged { k: f64 }
    section steel { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 0.5 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 1.0);
    conn a -> hinge 2 { stiffness_rz: k } -> conn b -> beam 3 { ..steel } -> conn c at (1.5, 1.0);
    conn c -> beam 4 { ..steel } -> fixed at (1.5, 0.0);
}

/// Down to a part of 1e-23 of other stiffnesses; shapes of softer hinges are refused.
#[test]
fn soft_hinges_are_those_without_stiffness() {
    let [moment, deflection] = [Hinged::beam_3.output().moment(), Hinged::conn_a.displacement_x()];
    for exponent in [14, 18, 20, 22, 23] {
        let k = 10_f64.powi(-exponent);
        assert_alike!(Hinged { k: 0.0 }, Hinged { k }, Hinged::conn_a.force_x(), [moment, deflection]);
    }
}
