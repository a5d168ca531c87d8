//! Numbers out of range: typed errors that carry them, never a panic, never a wrong number in silence.

mod one_element;

use mstmm::elements::{ELEMENTS, STRETCHING};
use mstmm::prelude::*;
use mstmm::search::SearchError;
use one_element::{C, Range, SCENES};

const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
/// Smallest positive number.
const TINY: f64 = 5e-324;

impl Range {
    /// Values outside, those next to the limit among them.
    fn outside(self) -> Vec<f64> {
        let finite: &[f64] = match self {
            Range::Moderate | Range::Tame | Range::TameOrRigid => &[0.0, -0.0, -TINY, -1.0, f64::MIN],
            Range::Invertible | Range::InvertibleOrRigid => &[0.0, -0.0, TINY, 1e-309, -1.0, f64::MIN],
            Range::ZeroOrRigid | Range::ZeroOrInvertible => &[-TINY, TINY, 1e-309, -1.0, f64::MIN],
            Range::NonNegative
            | Range::ModerateOrZero
            | Range::TameOrZero
            | Range::ZeroOrModerate
            | Range::ZeroOrTame => &[-TINY, -1.0, f64::MIN],
            Range::Position | Range::Speed => &[],
            // -1/f - G
            Range::Tension => &[-2.0, -3.0, f64::MIN],
            Range::Taper => &[0.999_999_1, 1.0, 2.0, f64::MAX, -1.000_001e6, f64::MIN],
        };
        let is_rigid = |value: f64| {
            value == f64::INFINITY && matches!(self, Range::InvertibleOrRigid | Range::TameOrRigid | Range::ZeroOrRigid)
        };
        [&NOT_FINITE, finite].concat().into_iter().filter(|&value| !is_rigid(value)).collect()
    }

    /// Values inside, the limits among them.
    fn inside(self) -> &'static [f64] {
        match self {
            Range::Moderate => &[1e-60, 1.0, 1e60],
            Range::ModerateOrZero => &[0.0, -0.0, TINY, 1e-60, 1.0, 1e60],
            Range::ZeroOrRigid => &[0.0, -0.0, 1e-60, 1.0, 1e60, f64::INFINITY],
            Range::ZeroOrInvertible => &[0.0, -0.0, f64::MIN_POSITIVE, 1.0, f64::MAX],
            Range::ZeroOrModerate => &[0.0, -0.0, 1e-60, 1.0, 1e60],
            Range::ZeroOrTame => &[0.0, -0.0, 1e-20, 1.0, 1e20],
            Range::Invertible => &[f64::MIN_POSITIVE, 1.0, f64::MAX],
            Range::InvertibleOrRigid => &[f64::MIN_POSITIVE, 1.0, f64::MAX, f64::INFINITY],
            Range::NonNegative => &[0.0, -0.0, TINY, f64::MIN_POSITIVE, 1.0, f64::MAX],
            Range::TameOrRigid => &[1e-20, 1.0, 1e20, f64::INFINITY],
            Range::Tame => &[1e-20, 1.0, 1e20],
            Range::TameOrZero => &[0.0, -0.0, TINY, 1e-20, 1.0, 1e20],
            Range::Taper => &[-1e6, -1.0, -TINY, 0.0, 0.5, 0.999_999],
            Range::Tension => &[-1.999, -TINY, 0.0, 1.0, 1e20],
            // a mass centre at ±1 needs just the inertia of 1 that there is
            Range::Position => &[-1.0, -TINY, 0.0, TINY, 1.0],
            // at 1 the stiffness of the material vanishes at λ = -1 + i
            Range::Speed => &[-1.0, -TINY, 0.0, TINY, 2.0, f64::MAX],
        }
    }
}

/// Equal, or both not a number.
fn same(a: f64, b: f64) -> bool {
    a == b || (a.is_nan() && b.is_nan())
}

/// Oracle: the list of the core.
#[test]
fn every_element_of_the_language_has_its_scene() {
    let mut tested: Vec<String> = SCENES.iter().map(|scene| scene.type_name.to_owned()).collect();
    // a string that stretches stands between places, which these scenes have none of
    let in_plane = STRETCHING.iter().filter(|name| !name.ends_with("String")).map(|name| format!("Planar{name}"));
    let mut elements: Vec<String> = ELEMENTS.iter().map(|element| element.name.to_owned()).chain(in_plane).collect();
    tested.sort_unstable();
    elements.sort_unstable();
    assert_eq!(tested, elements, "scenes of support/one_element.rs, and elements of the core");
}

/// Oracle: the ranges that the documentation of the language states.
#[test]
fn a_value_out_of_range_is_refused_by_the_names_of_element_and_parameter() {
    for scene in SCENES {
        for (index, parameter) in scene.parameters.iter().enumerate() {
            for bad in parameter.range.outside() {
                let what = format!("{}: {} = {bad}", scene.element, parameter.name);
                let Err(error) = (scene.build)(&scene.with(index, bad)) else { panic!("{what} is accepted") };
                assert_eq!((error.element, error.parameter), (scene.element, parameter.name), "{what}");
                assert!(same(error.value, bad), "{what}, reported as {}", error.value);
                let message = error.to_string();
                let told = message.strip_prefix(&format!("{}: {} is ", scene.element, parameter.name));
                let number = told.and_then(|told| told.split_once(", but must be ")).map(|(number, _)| number.parse());
                assert!(matches!(number, Some(Ok(number)) if same(number, bad)), "{what}: {error}");
            }
        }
    }
}

/// Oracle: the same ranges.
#[test]
fn a_value_at_the_limit_of_its_range_is_accepted() {
    for scene in SCENES {
        for (index, parameter) in scene.parameters.iter().enumerate() {
            for &good in parameter.range.inside() {
                let result = (scene.build)(&scene.with(index, good));
                assert_eq!(result, Ok(()), "{}: {} = {good}", scene.element, parameter.name);
            }
        }
    }
}

/// Oracle: J about the input end is at least `m c²` with c = 0.5; a step of 1e-12 is far beyond the rounding of the limit.
#[test]
fn a_body_needs_the_inertia_of_its_eccentric_mass() {
    for (type_name, centres) in [("Body", &[0.5][..]), ("PlanarBody", &[0.3, -0.4])] {
        let scene = SCENES.iter().find(|scene| scene.type_name == type_name).unwrap();
        let mut values = scene.ordinary();
        let first = values.len() - centres.len();
        values[first..].copy_from_slice(centres);
        let least = values[0] * 0.25;
        for (inertia, valid) in [(least, true), (least * (1.0 - 1e-12), false), (0.0, false), (f64::MAX, true)] {
            values[1] = inertia;
            let refused = (scene.build)(&values).err().map(|error| (error.element, error.parameter, error.value));
            assert_eq!(refused, (!valid).then_some(("body 7", "inertia_about_input", inertia)));
        }
        values[first] = f64::MAX; // the bound itself overflows
        assert_eq!((scene.build)(&values).unwrap_err().parameter, "inertia_about_input");
    }
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct Branched { l: f64, k: f64, m: f64 }
    fixed -> beam arm { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> free;
    fixed -> spring r#in { stiffness: k } -> conn 2;
    free -> mass 12 { mass: m } -> conn 2;
}

/// One parameter is out of range at a time, so that it is known which element the error must name.
#[test]
fn the_error_names_the_one_element_of_several() {
    let valid = Branched { l: 1.0, k: 1.0, m: 1.0 };
    assert!(valid.build().is_ok());
    let refused = |model: Branched| model.build().unwrap_err();
    let error = refused(Branched { l: -1.0, ..valid });
    assert_eq!((error.element, error.parameter, error.value), ("beam arm", "length", -1.0));
    let error = refused(Branched { k: -3.0, ..valid });
    assert_eq!((error.element, error.parameter, error.value), ("spring in", "stiffness", -3.0));
    let error = refused(Branched { m: -2.0, ..valid });
    assert_eq!((error.element, error.parameter, error.value), ("mass 12", "mass", -2.0));
}

/// Frequencies at which formulas overflow, vanish or are undefined.
const EXTREME: [f64; 8] = [0.0, -0.0, 1e-300, 1e300, f64::MAX, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

/// A determinant that depends on the frequency has no value where the frequency has none or its square overflows.
#[test]
fn no_frequency_panics_or_passes_for_a_number_that_it_is_not() {
    for scene in SCENES {
        let values = scene.ordinary();
        let depends = (scene.at_lambda)(&values, C::new(0.3, 1.0)) != (scene.at_lambda)(&values, C::new(0.3, 2.0));
        for re in EXTREME {
            for im in EXTREME {
                let mantissa = (scene.at_lambda)(&values, C::new(re, im)).mantissa();
                if depends && (re.is_nan() || im.is_nan()) {
                    assert!(!mantissa.re.is_finite(), "{} at {re} + {im}i: {mantissa}", scene.element);
                }
            }
        }
        let Some(at_omega) = scene.at_omega else { continue };
        for omega in EXTREME {
            let mantissa = at_omega(&values, omega).mantissa();
            if depends {
                assert_eq!(mantissa.is_finite(), omega.abs() < 1e300, "{} at {omega}: {mantissa}", scene.element);
            }
        }
        assert_eq!(at_omega(&values, 1e-300), at_omega(&values, 0.0), "{}: ω² underflows to rest", scene.element);
    }
}

/// Valid parameters of every size, at ordinary and at extreme frequencies.
#[test]
fn no_valid_parameter_panics() {
    let mut evaluations = 0;
    for scene in SCENES {
        for (index, parameter) in scene.parameters.iter().enumerate() {
            for &value in parameter.range.inside() {
                for frequency in [1.0].into_iter().chain(EXTREME) {
                    let values = scene.with(index, value);
                    let determinant = (scene.at_lambda)(&values, C::new(-frequency, frequency));
                    let real = scene.at_omega.map(|at_omega| at_omega(&values, frequency));
                    let ordinary = frequency == 1.0 && value == 1.0;
                    assert!(!ordinary || determinant.mantissa().re.is_finite(), "{}", scene.element);
                    assert!(!ordinary || real.is_none_or(|real| real.mantissa().is_finite()), "{}", scene.element);
                    evaluations += 1;
                }
            }
        }
    }
    assert!(evaluations > 1000, "{evaluations}");
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct Dashpot { k: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free
}
system! {
    #[derive(Clone, Copy, Debug)]
    struct Brake { c: f64, j: f64 }
    fixed -> torsion_damper 1 { damping: c } -> inertia 2 { inertia: j } -> free
}

/// Closed form: `Δ = mλ² + cλ + k` is an entire function, also where `k + cλ = 0`.
#[test]
fn the_determinant_has_no_pole_at_a_dashpots_own_zero() {
    let (k, c, m) = (2.0, 0.5, 3.0);
    let lambda = -k / c;
    let at_pole = Dashpot { k, c, m }.build().unwrap().overall_determinant(Complex::from(lambda)).value();
    let expected = m * lambda * lambda;
    assert!((at_pole - expected).norm() <= 16.0 * f64::EPSILON * expected, "{at_pole} instead of {expected}");
    let at_rest = Brake { c, j: 1.0 }.build().unwrap().overall_determinant(Complex::ZERO).value();
    assert!(at_rest.norm() <= f64::EPSILON * (1.0 + c), "{at_rest} instead of 0, beside {} at λ = 1", 1.0 + c);
}

/// Closed form: `|Δ| = |jλ² + cλ|` with c = 0, a valid damping.
#[test]
fn a_damper_without_damping_is_a_gap() {
    let system = Brake { c: 0.0, j: 2.0 }.build().unwrap();
    let lambda = Complex::new(-1.0, 2.0);
    let (actual, expected) = (system.overall_determinant(lambda).value().norm(), (lambda * lambda * 2.0).norm());
    assert!((actual - expected).abs() <= 16.0 * f64::EPSILON * expected, "{actual} instead of {expected}");
}

/// A search refuses its input before it evaluates anything.
#[test]
fn a_search_refuses_bad_input_by_a_typed_error() {
    let line = |range, points, tolerance| {
        fmin1d::<8, f64>(|x| panic!("evaluated at {x}"), range, points, tolerance).unwrap_err()
    };
    let plane = |x, y, points, tolerances| {
        fmin2d::<8, f64>(|x, y| panic!("evaluated at ({x}, {y})"), [x, y], points, tolerances).unwrap_err()
    };
    let unit = || 0.0..=1.0;
    for (start, end) in
        [(1.0, 1.0), (2.0, 1.0), (f64::NAN, 1.0), (0.0, f64::NAN), (0.0, f64::INFINITY), (f64::MIN, f64::MAX)]
    {
        let refused = [
            line(start..=end, 9, 0.1),
            plane(start..=end, unit(), [9, 9], [0.1, 0.1]),
            plane(unit(), start..=end, [9, 9], [0.1, 0.1]),
        ];
        for error in refused {
            let SearchError::Range { start: s, end: e } = error else { panic!("{error} for {start}..={end}") };
            assert!(same(s, start) && same(e, end), "{error} for {start}..={end}");
        }
    }
    let system = Branched { l: 1.0, k: 1.0, m: 1.0 }.build().unwrap();
    for (start, end) in [(10.0, 5.0), (5.0, 5.0), (-1.0, 500.0), (f64::NAN, 5.0), (0.0, f64::NAN), (0.0, f64::INFINITY)]
    {
        let error = system.natural_frequencies::<8>(start..=end).unwrap_err();
        let SearchError::Range { start: s, end: e } = error else { panic!("{error} for {start}..={end}") };
        assert!(same(s, start) && same(e, end), "{error} for {start}..={end}");
    }
    for points in 0..3 {
        for error in [
            line(unit(), points, 0.1),
            plane(unit(), unit(), [points, 9], [0.1, 0.1]),
            plane(unit(), unit(), [9, points], [0.1, 0.1]),
        ] {
            assert!(matches!(error, SearchError::Grid { points: p, .. } if p == points), "{error} for {points} points");
        }
    }
    for tolerance in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY] {
        for error in [
            line(unit(), 9, tolerance),
            plane(unit(), unit(), [9, 9], [tolerance, 0.1]),
            plane(unit(), unit(), [9, 9], [0.1, tolerance]),
        ] {
            let SearchError::Tolerance { tolerance: t } = error else { panic!("{error} for {tolerance}") };
            assert!(same(t, tolerance), "{error} for {tolerance}");
        }
    }
}

/// What goes wrong during a search is reported with its place.
#[test]
fn a_search_reports_what_is_not_a_number_and_what_does_not_fit() {
    let system = Branched { l: 1.0, k: 1.0, m: 1.0 }.build().unwrap();
    let delta = |omega: f64| system.overall_determinant(omega);
    let overflow = fmin1d::<8, _>(delta, 0.0..=1e300, 3, 1.0).unwrap_err();
    assert_eq!(overflow, SearchError::NotANumber { x: 5e299, y: 0.0 });
    assert_eq!(fmin1d::<1, _>(delta, 0.1..=200.0, 200, 1e-3).unwrap_err(), SearchError::Capacity { capacity: 1 });
    let message = SearchError::Capacity { capacity: 1 }.to_string();
    assert!(message.contains("capacity of 1"), "{message}");
}
