//! Sensitivities against central differences in double-double arithmetic, and closed forms.

use crate::support::models::*;
use mstmm::motion::MotionError;
use mstmm::number::{DoubleDouble, Dual, Frequency, Oscillation, Parameter};
use mstmm::prelude::*;
use mstmm::search::{NaturalFrequency, System};

/// Relative steps of the differences: extrapolated to zero, what is left is of the sixth order. With fields of 24 bits these are
/// exact, and so are the differences of positions in the formulas of the models.
const FINE: [f64; 3] = steps(22);
/// Steps beside which the rounding of `mass * eccentricity * eccentricity` does not count.
const COARSE: [f64; 3] = steps(13);

const fn steps(exponent: u32) -> [f64; 3] {
    let step = 1.0 / (1_u64 << exponent) as f64;
    [step, 2.0 * step, 4.0 * step]
}

/// What rounding leaves of derivatives that are zero, in units of the root over the field.
const ROUNDING: f64 = 128.0 * f64::EPSILON;

/// The root of Δ in double-double near another, by Newton's method.
fn root_near<S, Y>(system: &Y, near: S) -> S
where
    S: Oscillation<DoubleDouble>,
    Dual<S>: Frequency<DoubleDouble>,
    Y: System<Parameter = DoubleDouble> + Characteristic<Dual<S>>,
{
    let mut x = near;
    for _ in 0..60 {
        let delta = system.characteristic(Dual::variable(x)).mantissa();
        let step = delta.value / delta.derivative;
        x -= step;
        if step.size() < 1e-28 * x.size() {
            break;
        }
    }
    x
}

/// The derivative at zero step of differences `d(h) = d + c h² + e h⁴`, from three steps, each twice the one before.
fn extrapolated(differences: [Complex<f64>; 3]) -> Complex<f64> {
    let [a, b, c] = differences;
    let (ab, bc) = ((a * 4.0 - b) / 3.0, (b * 4.0 - c) / 3.0);
    (ab * 16.0 - bc) / 15.0
}

fn to_complex<S: Oscillation<DoubleDouble>>(x: S) -> Complex<f64> {
    let x = x.to_complex();
    Complex::new(x.re.to_f64(), x.im.to_f64())
}

/// Compares the sensitivities of a root, for all fields of a model.
macro_rules! assert_sensitivities {
    ($model:expr, $root:expr, $scalar:ty, $steps:expr, [$($field:ident),* $(,)?]) => {{
        let (model, root) = ($model, $root);
        let sensitivities = model.build().unwrap().sensitivity(&root).unwrap();
        let names: Vec<_> = sensitivities.iter().map(|(name, _)| name).collect();
        assert_eq!(names, [$(stringify!($field)),*]);
        let x = Into::<Complex<f64>>::into(mstmm::motion::Root::<f64>::frequency(&root));
        let near = |x: Complex<f64>| {
            <$scalar>::from_complex(Complex::new(DoubleDouble::from(x.re), DoubleDouble::from(x.im)))
        };
        $({
            let value = Into::<Complex<f64>>::into(sensitivities.get(stringify!($field)).unwrap());
            let expected = extrapolated($steps.map(|step| {
                let (mut above, mut below) = (model, model);
                above.$field *= 1.0 + step;
                below.$field *= 1.0 - step;
                let away = value * (model.$field * step);
                let [above_root, below_root] = [(above, x + away), (below, x - away)]
                    .map(|(model, x)| root_near(&model.build_as::<DoubleDouble>().unwrap(), near(x)));
                let difference = above_root - below_root;
                to_complex(difference) / (above.$field - below.$field)
            }));
            let error = (value - expected).norm();
            let floor = ROUNDING * (x / model.$field).norm();
            println!("{} of {x}: {value} {:e}", stringify!($field), error / expected.norm());
            assert!(
                error < 1e-10 * expected.norm() || error < floor,
                "{} of {x}: {value} is not {expected}",
                stringify!($field)
            );
        })*
    }};
}

/// Rounds all fields to 24 bits.
macro_rules! shorten {
    ($model:expr, [$($field:ident),* $(,)?]) => {
        $($model.$field = f64::from($model.$field as f32);)*
    };
}

/// The first roots and high ones of an undamped model.
macro_rules! assert_undamped {
    ($model:expr, $steps:expr, $fields:tt) => {{
        let mut model = $model;
        shorten!(model, $fields);
        let roots = model.build().unwrap().first_frequencies::<40>().unwrap();
        for index in [0, 1, 2, 3, 9, 39] {
            assert_sensitivities!(model, roots[index], DoubleDouble, $steps, $fields);
        }
    }};
}

#[test]
fn of_the_tip_bodies() {
    for model in [light_tip_body(), heavy_tip_body()] {
        assert_undamped!(
            model,
            COARSE,
            [length, bending_stiffness, mass_per_length, mass, inertia, eccentricity, depth]
        );
    }
}

#[test]
fn of_the_restrained_beam() {
    assert_undamped!(
        restrained_beam(),
        FINE,
        [length, bending_stiffness, mass_per_length, left_stiffness, left_torsion, right_stiffness, right_torsion]
    );
}

#[test]
fn of_the_spring_and_the_mass() {
    assert_undamped!(
        spring_and_mass(),
        FINE,
        [length, bending_stiffness, mass_per_length, spring_position, mass_position, stiffness, mass]
    );
}

#[test]
fn of_the_two_spans() {
    assert_undamped!(
        two_spans(),
        FINE,
        [length, bending_stiffness, mass_per_length, support_position, spring_position, stiffness, mass]
    );
}

macro_rules! assert_damped {
    ($model:expr, $fields:tt) => {{
        let mut model = $model;
        shorten!(model, $fields);
        let region = Region { re: -1e4..=1.0, im: 0.0..=60_000.0 };
        let roots = model.build().unwrap().eigenvalues::<64>(region).unwrap();
        assert!(roots.len() > 8);
        for root in roots.iter() {
            assert_sensitivities!(model, *root, Complex<DoubleDouble>, FINE, $fields);
        }
    }};
}

system! {
    /// A string on a foundation, a mass, a rod in soil and a spring.
    #[derive(Clone, Copy, Debug)]
    struct Lines { length: f64, tension: f64, m: f64, k: f64, mass: f64, other: f64, ea: f64, soil: f64, spring: f64 }
    fixed -> string 1 { length, tension, mass_per_length: m, foundation_stiffness: k } -> mass 2 { mass }
        -> rod 3 { length: other, axial_stiffness: ea, mass_per_length: m, foundation_stiffness: soil }
        -> spring 4 { stiffness: spring } -> fixed
}

system! {
    /// Two shafts with a disk between them, and a beam that turns with their end.
    #[derive(Clone, Copy, Debug)]
    struct Shafts { length: f64, gj: f64, j: f64, disk: f64, other: f64, ei: f64, m: f64 }
    free -> shaft 1 { length, torsional_stiffness: gj, inertia_per_length: j } -> inertia 2 { inertia: disk }
        -> shaft 3 { length: other, torsional_stiffness: 2.0 * gj, inertia_per_length: j } -> conn 4;
    fixed -> beam 5 { length: 1.0, bending_stiffness: ei, mass_per_length: m } -> conn 4
        -> beam 6 { length: 0.5, bending_stiffness: ei, mass_per_length: m } -> pinned
}

#[test]
fn of_strings_rods_and_shafts() {
    let (length, other, tension, ea, m) = (1.3, 0.7, 20.0, 55.0, 0.8);
    let model = Lines { length, tension, m, k: 300.0, mass: 0.4, other, ea, soil: 7.0, spring: 12.0 };
    assert_undamped!(model, FINE, [length, tension, m, k, mass, other, ea, soil, spring]);
    let model = Shafts { length, gj: 4.0, j: 0.05, disk: 0.02, other, ei: 3.0, m };
    assert_undamped!(model, FINE, [length, gj, j, disk, other, ei, m]);
}

#[test]
fn of_the_damped_oscillator() {
    assert_damped!(
        damped_oscillator(),
        [
            length,
            bending_stiffness,
            mass_per_length,
            spring_position,
            oscillator_position,
            torsion_position,
            spring_stiffness,
            oscillator_stiffness,
            damping,
            mass,
            torsion_stiffness,
        ]
    );
}

system! {
    /// Two oscillators that share nothing but the ground.
    struct Twins { first: f64, second: f64 }
    free -> mass 1 { mass: 1.0 } -> spring 2 { stiffness: first } -> conn 3 -> spring 4 { stiffness: 1.0 } -> fixed;
    free -> mass 5 { mass: 1.0 } -> spring 6 { stiffness: second } -> conn 3 <- fixed;
}

system! {
    /// A beam that may turn about its pin.
    struct Pendulum {
        length: f64,
        /// Enters as a number.
        #[no_sensitivity]
        stiffness: f64,
    }
    pinned -> beam 1 { length, bending_stiffness: stiffness, mass_per_length: 2.0 } -> free;
}

system! {
    struct Oscillator { stiffness: f64, mass: f64 }
    fixed -> spring 1 { stiffness } -> mass 2 { mass } -> free;
}

/// `ω = sqrt(k/m)`: `∂ω/∂k = ω/(2k)`, `∂ω/∂m = -ω/(2m)`.
#[test]
fn of_an_oscillator_in_closed_form() {
    let (stiffness, mass) = (7.0, 0.3);
    let system = Oscillator { stiffness, mass }.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    let sensitivities = system.sensitivity(&root).unwrap();
    for (name, expected) in [("stiffness", root.omega / (2.0 * stiffness)), ("mass", -root.omega / (2.0 * mass))] {
        let value = sensitivities.get(name).unwrap();
        assert!((value - expected).abs() < 8.0 * f64::EPSILON * expected.abs(), "{name}: {value}");
    }
    assert_eq!(sensitivities.get("length"), None);
}

#[test]
fn roots_without_derivative_are_refused() {
    let twins = Twins { first: 4.0, second: 4.0 }.build().unwrap();
    let double = twins.first_frequencies::<2>().unwrap()[0];
    let error = twins.sensitivity(&double).unwrap_err();
    assert_eq!(error, MotionError::Multiple { root: double.omega, multiplicity: 2 });
    assert!(error.to_string().contains("multiplicity 2"), "{error}");

    let pendulum = Pendulum { length: 1.0, stiffness: 3.0 }.build().unwrap();
    let roots = pendulum.first_frequencies::<2>().unwrap();
    assert_eq!(pendulum.sensitivity(&roots[0]).unwrap_err(), MotionError::ZeroFrequency);
    assert!(MotionError::ZeroFrequency.to_string().contains("zero frequency"));
    let names: Vec<_> = pendulum.sensitivity(&roots[1]).unwrap().iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["length"]);

    let no_root = NaturalFrequency { omega: 1.5 * roots[1].omega, ..roots[1] };
    assert!(matches!(pendulum.sensitivity(&no_root).unwrap_err(), MotionError::NotARoot { .. }));
}
