//! Words whose parameters say what they are: beams, springs, hinges, links, and sections that share parameters.

use mstmm::prelude::*;

system! {
    /// A pinned beam with all that a beam may have, by its names.
    #[derive(Clone, Copy)]
    struct Stocky { l: f64, ei: f64, m: f64, shear: f64, rotary: f64, force: f64, ground: f64 }
    section plain { bending_stiffness: ei, mass_per_length: m }
    section stocky { shear_stiffness: shear, rotary_inertia: rotary }
    pinned -> beam 1 { length: l, ..plain, ..stocky, axial_force: force, foundation_stiffness: ground } -> pinned;
}

const STOCKY: Stocky = Stocky { l: 1.3, ei: 2.0, m: 0.7, shear: 9.0, rotary: 0.02, force: -1.5, ground: 3.0 };

/// Closed form: between pins a half wave of `sin(nπx/l)` is a motion of two numbers, deflection and rotation.
fn of_half_wave(beam: &Stocky, n: f64) -> f64 {
    let k = n * core::f64::consts::PI / beam.l;
    let f = 1.0 / beam.shear;
    // V = ½ ∫ EI Θ'² + (Y' - Θ)²/f + N Y'² + k Y², T = ½ ∫ m Ẏ² + r Θ̇²: det(K - ω² M) = 0
    let (yy, yt, tt) = (k * k * (1.0 / f + beam.force) + beam.ground, -k / f, k * k * beam.ei + 1.0 / f);
    let (a, b, c) = (beam.m * beam.rotary, -(yy * beam.rotary + tt * beam.m), yy * tt - yt * yt);
    ((-b - (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt()
}

#[test]
fn a_beam_of_many_names_has_the_frequencies_of_its_half_waves() {
    let roots = STOCKY.build().unwrap().first_frequencies::<5>().unwrap();
    // and that of cross sections that turn as one, without deflection
    let turning = (STOCKY.shear / STOCKY.rotary).sqrt();
    let mut all: Vec<f64> = (1..=6).map(|n| of_half_wave(&STOCKY, f64::from(n))).chain([turning]).collect();
    all.sort_by(f64::total_cmp);
    for (expected, root) in all.into_iter().zip(&roots) {
        assert!(root.is_proven && (root.omega / expected - 1.0).abs() < 1e-12, "{root} is not {expected}");
    }
}

/// The derivatives with respect to the shear stiffness are those of the closed form, and zero where it is infinite.
#[test]
fn sensitivities_to_a_shear_stiffness_are_those_of_the_closed_form() {
    let system = STOCKY.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    let step = 1e-5 * STOCKY.shear;
    let [above, below] = [step, -step].map(|step| of_half_wave(&Stocky { shear: STOCKY.shear + step, ..STOCKY }, 1.0));
    let (found, expected) = (system.sensitivity(&root).unwrap().get("shear").unwrap(), (above - below) / (2.0 * step));
    assert!((found / expected - 1.0).abs() < 1e-8, "{found} is not {expected}");

    let rigid = Stocky { shear: f64::INFINITY, ..STOCKY }.build().unwrap();
    let root = rigid.first_frequencies::<1>().unwrap()[0];
    // without shear the rotation is the slope
    let k = core::f64::consts::PI / STOCKY.l;
    let stiffness = STOCKY.ei * k.powi(4) + STOCKY.force * k * k + STOCKY.ground;
    let expected = (stiffness / (STOCKY.m + STOCKY.rotary * k * k)).sqrt();
    assert!(root.is_proven && (root.omega / expected - 1.0).abs() < 1e-12, "{root} is not {expected}");
    assert_eq!(rigid.sensitivity(&root).unwrap().get("shear").unwrap(), 0.0);
}

system! {
    /// An oscillator with all damping that a spring may have.
    #[derive(Clone, Copy)]
    struct Damped { k: f64, d: f64, eta: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: k, damping: d, loss_factor: eta, kelvin_voigt_time: c } -> mass 2 { mass: m } -> free;
}

/// Closed form: `m λ² + k (1 + iη)(1 + cλ) + dλ = 0`, of which the root with Im λ > 0 is a motion.
#[test]
fn a_spring_may_have_a_dashpot_beside_its_losses() {
    let model = Damped { k: 4.0, d: 0.3, eta: 0.1, c: 0.02, m: 0.5 };
    let root = |model: Damped| {
        let Damped { k, d, eta, c, m } = model;
        let (stiff, i) = (Complex::new(k, k * eta), Complex::new(0.0, 1.0));
        let (half, constant) = ((stiff * c + d) / (2.0 * m), stiff / m);
        -half + i * (constant - half * half).sqrt()
    };
    let system = model.build().unwrap();
    let found = system.first_eigenvalues::<1>().unwrap()[0];
    assert!((found.lambda - root(model)).norm() < 1e-12, "{found:?} is not {}", root(model));
    let sensitivity = system.sensitivity(&found).unwrap();
    let step = 1e-6;
    let expected = (root(Damped { d: 0.3 + step, ..model }) - root(Damped { d: 0.3 - step, ..model })) / (2.0 * step);
    let found = sensitivity.get("d").unwrap();
    assert!((found - expected).norm() < 1e-7, "{found} is not {expected}");
}

/// Models of the same fields.
macro_rules! models {
    ($fields:tt $($model:ident { $($paths:tt)* })*) => {$(
        system! {
            struct $model $fields
            $($paths)*
        }
    )*};
}

// A cantilever with a hinge in it and an arm at its end, written in two ways.
models! {
    { l: f64, ei: f64, m: f64, turn: f64, mass: f64 }
    InPaths {
        section piece { bending_stiffness: ei, mass_per_length: m }
        fixed -> beam 1 { length: l, ..piece } -> hinge 2 { stiffness_rz: turn } -> beam 3 { length: l, ..piece }
              -> rigid_link 4 { output_x: 0.5 * l } -> point_mass 5 { mass } -> free;
    }
    AlongALine {
        section piece { bending_stiffness: ei, mass_per_length: m }
        fixed at 0.0 -> beam 1 { ..piece } -> conn a at l -> hinge 2 { stiffness_rz: turn } -> beam 3 { ..piece }
              -> conn b at 2.0 * l -> rigid_link 4 {};
        point_mass 5 { mass } <- conn c at 2.5 * l -> rigid_link 4;
    }
}

#[test]
fn hinges_and_links_are_the_same_in_paths_and_between_places() {
    let [l, ei, m, turn, mass] = [0.8, 2.0, 0.6, 1.7, 0.2];
    let in_paths = InPaths { l, ei, m, turn, mass }.build().unwrap();
    let along = AlongALine { l, ei, m, turn, mass }.build().unwrap();
    let [first, second] = [in_paths.first_frequencies::<5>().unwrap(), along.first_frequencies::<5>().unwrap()];
    for (index, (one, other)) in first.iter().zip(&second).enumerate() {
        assert!(one.is_proven && other.is_proven, "{one} and {other}");
        assert!(one.lower <= other.upper && other.lower <= one.upper, "{one} and {other}");
        let (in_path, along_line) = (in_paths.sensitivity(one).unwrap(), along.sensitivity(other).unwrap());
        for field in ["l", "ei", "m", "turn", "mass"] {
            let [one, other] = [in_path.get(field).unwrap(), along_line.get(field).unwrap()];
            assert!((one - other).abs() <= 1e-9 * one.abs().max(1.0), "mode {index}, {field}: {one} and {other}");
        }
    }
}

/// Numbers out of range are named by the words of the model, of joints between places, too.
#[test]
fn errors_name_the_words_of_the_model() {
    let [l, ei, m, mass] = [0.8, 2.0, 0.6, 0.2];
    let error = InPaths { l, ei, m, turn: -1.0, mass }.build().unwrap_err();
    assert_eq!((error.element, error.parameter, error.value), ("hinge 2", "stiffness_rz", -1.0));
    let error = AlongALine { l, ei, m, turn: -1.0, mass }.build().unwrap_err();
    assert_eq!((error.element, error.parameter, error.value), ("hinge 2", "stiffness_rz", -1.0));
    let error = Stocky { force: -20.0, ..STOCKY }.build().unwrap_err().to_string();
    let range = "finite and greater than -shear_stiffness - foundation_shear_stiffness = -9";
    assert_eq!(error, format!("beam 1: axial_force is -20, but must be {range}"));
    let error = Stocky { shear: 0.0, ..STOCKY }.build().unwrap_err();
    assert_eq!((error.element, error.parameter, error.value), ("beam 1", "shear_stiffness", 0.0));
}

// An L of two beams with a hinge at its corner that gives way in some freedoms.
models! {
    { ei: f64, m: f64, k: f64, stiff: f64 }
    Turning {
        section piece { axial_stiffness: 50.0 * ei, bending_stiffness: ei, mass_per_length: m }
        fixed at (0.0, 0.0) -> beam 1 { ..piece } -> conn a at (0.0, 1.0) -> hinge 2 { stiffness_rz: k }
            -> beam 3 { ..piece } -> free at (0.9, 1.2 + 0.0 * stiff);
    }
    TurningOld {
        section piece { axial_stiffness: 50.0 * ei, bending_stiffness: ei, mass_per_length: m }
        fixed at (0.0, 0.0) -> beam 1 { ..piece } -> conn a at (0.0, 1.0)
            -> hinge 2 { stiffness_x: stiff, stiffness_y: stiff, stiffness_rz: k }
            -> beam 3 { ..piece } -> free at (0.9, 1.2);
    }
    Sliding {
        section piece { axial_stiffness: 50.0 * ei, bending_stiffness: ei, mass_per_length: m }
        fixed at (0.0, 0.0) -> beam 1 { ..piece } -> conn a at (0.0, 1.0) -> hinge 2 { stiffness_x: k, stiffness_y: 2.0 * k }
            -> beam 3 { ..piece } -> free at (0.9, 1.2 + 0.0 * stiff);
    }
    SlidingOld {
        section piece { axial_stiffness: 50.0 * ei, bending_stiffness: ei, mass_per_length: m }
        fixed at (0.0, 0.0) -> beam 1 { ..piece } -> conn a at (0.0, 1.0)
            -> hinge 2 { stiffness_x: k, stiffness_y: 2.0 * k, stiffness_rz: stiff }
            -> beam 3 { ..piece } -> free at (0.9, 1.2);
    }
}

/// What a hinge does not name is rigid: it is the limit of large stiffnesses.
#[test]
fn what_a_hinge_in_the_plane_does_not_name_is_rigid() {
    let [ei, m, k, stiff] = [2.0, 0.6, 30.0, 1e9];
    macro_rules! roots {
        ($model:ident) => {
            $model { ei, m, k, stiff }.build().unwrap().first_frequencies::<4>().unwrap()
        };
    }
    let pairs = [(roots!(Turning), roots!(TurningOld)), (roots!(Sliding), roots!(SlidingOld))];
    for (rigid, stiff) in pairs {
        for (rigid, stiff) in rigid.iter().zip(&stiff) {
            assert!((rigid.omega / stiff.omega - 1.0).abs() < 1e-6, "{rigid} and {stiff}");
        }
    }
}

// A path of planar elements without places, by new words and by old ones.
models! {
    { l: f64, ea: f64, ei: f64, m: f64, k: f64, stiff: f64 }
    Named {
        let m = m + 0.0 * stiff;
        fixed -> beam 1 { length: l, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> hinge 2 { stiffness_rz: k }
            -> rigid_link 3 { output_x: 0.2 * l, output_y: 0.3 * l }
            -> beam 4 { length: l, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> free;
    }
    NamedByType {
        fixed -> beam 1 { length: l, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
            -> hinge 2 { stiffness_x: stiff, stiffness_y: stiff, stiffness_rz: k }
            -> body 3 { mass: 0.0, inertia_about_input: 0.0, output_x: 0.2 * l, output_y: 0.3 * l, centre_x: 0.0, centre_y: 0.0 }
            -> beam 4 { length: l, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> free;
    }
}

#[test]
fn planar_paths_are_made_of_the_same_words() {
    let [l, ea, ei, m, k] = [0.7, 40.0, 2.0, 0.5, 3.0];
    let named = Named { l, ea, ei, m, k, stiff: 1.0 }.build().unwrap();
    let by_type = NamedByType { l, ea, ei, m, k, stiff: f64::INFINITY }.build().unwrap();
    assert_eq!(NamedSystem::N, NamedByTypeSystem::N);
    for omega in [0.3, 1.1, 7.0] {
        assert_eq!(named.overall_matrix(omega), by_type.overall_matrix(omega));
        assert!(named.overall_determinant(omega).value().is_finite());
    }
}
