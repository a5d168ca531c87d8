//! Tapered and rotating beams: Bessel functions, published values, limits in which they are other beams.

use crate::general_chains::families::PLAIN;
use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, GeneralBeam, Spring, TaperedBeam};
use mstmm::list::{ListStep, StepList};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::{FrequencyList, SearchError};

system! {
    struct Blade { width: f64, height: f64 }
    fixed -> tapered_beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, width_taper: width, height_taper: height } -> free
}

system! {
    /// The same blade from its tip to its root.
    struct Inwards { width: f64, height: f64 }
    let b = 1.0 - width;
    let h = 1.0 - height;
    free -> tapered_beam 1 {
        length: 1.0, bending_stiffness: b * h * h * h, mass_per_length: b * h, width_taper: -width / b, height_taper: -height / h,
    } -> fixed
}

system! {
    struct Rotor { speed: f64, radius: f64 }
    fixed -> tapered_beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, rotation_speed: speed, hub_radius: radius,
    } -> free
}

system! {
    /// A rotating blade of two halves.
    struct Halves { height: f64, speed: f64, radius: f64, force: f64 }
    let middle = 1.0 - 0.5 * height;
    fixed -> tapered_beam 1 {
        length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: 0.5 * height, rotation_speed: speed,
        hub_radius: radius, axial_force: force,
    } -> tapered_beam 2 {
        length: 0.5, bending_stiffness: middle * middle * middle, mass_per_length: middle, height_taper: 0.5 * height / middle,
        rotation_speed: speed, hub_radius: radius + 0.5,
    } -> free
}

system! {
    /// The blade of [`Halves`] in one.
    struct Whole { height: f64, speed: f64, radius: f64 }
    fixed -> tapered_beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: height, rotation_speed: speed, hub_radius: radius,
    } -> free
}

system! {
    /// The same from its tip to the axis, where the force is.
    struct WholeInwards { height: f64, speed: f64, radius: f64, force: f64 }
    let h = 1.0 - height;
    free -> tapered_beam 1 {
        length: 1.0, bending_stiffness: h * h * h, mass_per_length: h, height_taper: -height / h, rotation_speed: speed,
        hub_radius: -radius - 1.0, axial_force: force,
    } -> fixed
}

system! {
    /// A blade on a foundation, set at an angle to the axis.
    #[derive(Clone, Copy)]
    struct Set { height: f64, speed: f64, angle: f64, k: f64 }
    fixed -> tapered_beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: height, rotation_speed: speed, hub_radius: 0.2,
        setting_angle: angle, foundation_stiffness: k,
    } -> free
}

system! {
    struct Floating { k: f64 }
    pinned -> tapered_beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: k } -> pinned
}

/// Frequencies to some digits.
#[track_caller]
fn assert_roots<const N: usize>(found: &FrequencyList<f64, N>, expected: &[f64], digits: f64) {
    for (root, expected) in found.iter().zip(expected) {
        let error = (root.omega / expected - 1.0).abs();
        assert!(error <= digits, "{} beside {expected}: {error:e}", root.omega);
        assert_eq!(root.multiplicity, 1);
    }
    assert_eq!(found.len(), expected.len());
}

/// Modes and frequencies of a cantilever of some tapers.
type Exact = (f64, f64, [(u64, &'static str); 6]);

/// Clamped at the thick end, free at the thin one: with `z = 2k √u/c`, `u = 1 - cx`, `ω = k²` deflections are `u^-½ C(z)` with J₁, Y₁, I₁, K₁ for
/// C in a wedge, and `u^-1 C(z)` with J₂, Y₂, I₂, K₂ in a cone (Kirchhoff); zeros of their determinants in 50 digits.
const BESSEL: [Exact; 3] = [
    (
        0.0,
        0.5,
        [
            (1, "3.823784847290279785770414237614709"),
            (2, "18.31726090417472443235694011282017"),
            (3, "47.26482701048062585306695627482952"),
            (10, "651.386352317727062256012454556547"),
            (30, "6260.030016453369957381608250879872"),
            (100, "71190.55860068995200893418430703074"),
        ],
    ),
    (
        0.0,
        0.875,
        [
            (1, "4.527454470669520712695429939209937"),
            (2, "15.11225616784720505187332856474787"),
            (3, "33.87905335336378013724745428246059"),
            (10, "414.6402832339396419298659559948805"),
            (30, "3940.962126473354199742749215793871"),
            (100, "44761.56127563855364587351233277415"),
        ],
    ),
    (
        0.75,
        0.75,
        [
            (1, "5.823065872005917651432647342297442"),
            (2, "18.47970477156098106452622944228752"),
            (3, "41.32134256745354310246681944679471"),
            (10, "508.5188175774557590138387091431016"),
            (30, "4839.027823805176375961413081056538"),
            (100, "54970.5219695109235605996718017723"),
        ],
    ),
];

#[test]
fn wedges_and_cones_have_the_frequencies_of_bessel_functions() {
    for (width, height, modes) in BESSEL {
        for (number, exact) in modes {
            let exact: DoubleDouble = exact.parse().unwrap();
            let near = exact.to_f64();
            let outwards = Blade { width, height }.build().unwrap();
            let inwards = Inwards { width, height }.build().unwrap();
            let span = near * (1.0 - 0.3 / number as f64)..=near * (1.0 + 0.3 / number as f64);
            let found = [
                outwards.natural_frequencies::<2>(span.clone()).unwrap(),
                inwards.natural_frequencies::<2>(span).unwrap(),
            ];
            for list in &found {
                let [root] = list[..] else { panic!("{list:?} around {near}") };
                let error = ((DoubleDouble::from(root.omega) - exact) / exact).to_f64().abs() / f64::EPSILON;
                assert!(error < 2.0, "{error} eps in mode {number} of {width}, {height}");
                assert!(DoubleDouble::from(root.lower) <= exact && exact <= DoubleDouble::from(root.upper));
            }
            assert_eq!(outwards.count_below(near * (1.0 + 1e-9)).unwrap(), number);
            assert_eq!(inwards.count_below(near * (1.0 - 1e-9)).unwrap(), number - 1);
        }
    }
}

/// Ozdemir Ozgumus and Kaya (2006).
#[test]
fn double_tapered_cantilevers_have_their_published_frequencies() {
    for (height, width, published) in [
        (0.2, 0.0, [3.608_275, 20.621_018, 56.192_278]),
        (0.4, 0.4, [4.318_779, 20.049_984, 51.334_633]),
        (0.8, 0.8, [6.196_391, 18.385_467, 39.833_630]),
    ] {
        let blade = Blade { width, height }.build().unwrap();
        assert_roots(&blade.first_frequencies::<3>().unwrap(), &published, 1.5e-7);
    }
}

/// SDLL09 of the guide of the SFM, after Mabie and Rogers (1972), in units of the section at the tip: 23.289, 73.9, 165.23, 299.7, 478.1 and
/// 24.308, 75.56, 167.21, 301.9, 480.4 are published.
#[test]
fn the_tapered_cantilevers_of_sdll09_have_their_frequencies() {
    for (width, expected) in [
        (0.75, [23.292_3, 73.918_8, 165.285_4, 299.779_9, 478.180_1]),
        (0.8, [24.311_2, 75.577_9, 167.252_0, 301.933_7, 480.458_5]),
    ] {
        let blade = Blade { width, height: 0.75 }.build().unwrap();
        assert_roots(&blade.first_frequencies::<5>().unwrap(), &expected.map(|omega| omega / 4.0), 3e-6);
    }
}

/// Wright, Smith, Thresher and Wang (1982) as quoted: 3.6817, 22.1810, 61.8418 and 13.1702, 37.6031, 79.6145.
#[test]
fn rotating_beams_have_their_published_frequencies() {
    for (speed, radius, expected) in [
        (1.0, 0.0, &[3.681_647, 22.181_011, 61.841_763, 121.050_922][..]),
        (2.0, 0.0, &[4.137_320, 22.614_922, 62.273_184, 121.496_695]),
        (4.0, 0.0, &[5.585_001, 24.273_349, 63.966_760, 123.261_485]),
        (8.0, 0.0, &[9.256_838, 29.995_382, 70.292_962, 130.049_032]),
        (12.0, 0.0, &[13.170_150, 37.603_112, 79.614_478, 140.534_354]),
        (1.0, 1.0, &[3.888_824, 22.375_014, 62.043_053]),
        (12.0, 1.0, &[19.721_542, 51.070_134, 98.526_797]),
    ] {
        let rotor = Rotor { speed, radius }.build().unwrap();
        if expected.len() == 4 {
            assert_roots(&rotor.first_frequencies::<4>().unwrap(), expected, 1.5e-7);
        } else {
            assert_roots(&rotor.first_frequencies::<3>().unwrap(), expected, 1.5e-7);
        }
    }
}

/// Closed form: all that a setting angle changes is `ω² - Ω² sin² ψ`, whatever the taper; without taper a foundation of `-m Ω² sin² ψ` is the same.
#[test]
fn a_blade_is_softer_in_the_plane_of_rotation() {
    for height in [0.0, 0.7] {
        let flapping = Set { height, speed: 5.0, angle: 0.0, k: 0.0 };
        let flaps = flapping.build().unwrap().first_frequencies::<8>().unwrap();
        for angle in [0.4_f64, std::f64::consts::FRAC_PI_2, -1.0] {
            let soft = (flapping.speed * angle.sin()).powi(2);
            let expected: Vec<f64> = flaps.iter().map(|root| (root.omega * root.omega - soft).sqrt()).collect();
            let lags = Set { angle, ..flapping }.build().unwrap().first_frequencies::<8>().unwrap();
            assert_roots(&lags, &expected, 1e-14);
            if height == 0.0 {
                let founded = Set { k: -soft, ..flapping }.build().unwrap().first_frequencies::<8>().unwrap();
                assert_roots(&founded, &expected, 1e-14);
            }
        }
    }
}

/// Closed form: `ω² = (nπ)⁴ + k` of a pinned beam, and as many motions grow as these are negative.
#[test]
fn foundations_of_either_sign_move_the_squares_of_frequencies() {
    let bending = |n: u32| (f64::from(n) * std::f64::consts::PI).powi(4);
    for k in [1e4, -90.0, -1e3, -2e6] {
        let system = Floating { k }.build().unwrap();
        let growing = (1..20).filter(|n| bending(*n) + k < 0.0).count() as u64;
        assert_eq!(system.unstable_modes(), Ok(growing), "{k}");
        if growing > 0 {
            assert_eq!(system.first_frequencies::<3>().unwrap_err(), SearchError::Unstable { modes: growing });
            continue;
        }
        let expected: Vec<f64> = (1..=6).map(|n| (bending(n) + k).sqrt()).collect();
        assert_roots(&system.first_frequencies::<6>().unwrap(), &expected, 1e-14);
    }
    // beside the loss of stability
    for (part, growing) in [(1e-9, 0), (-1e-9, 1)] {
        let system = Floating { k: -bending(1) * (1.0 - part) }.build().unwrap();
        assert_eq!(system.unstable_modes(), Ok(growing), "{part}");
    }
}

/// Two halves are the whole, and a blade drawn towards the axis is the blade, with the force at its inner end.
#[test]
fn a_rotating_blade_may_be_drawn_in_parts_and_from_either_end() {
    let (height, speed, radius) = (0.6, 9.0, 0.3);
    // Ω² ∫ m (R + x) dx of the whole blade, and of its outer half
    let moment = |from: f64| {
        let primitive = |x: f64| radius * x + (1.0 - height * radius) * x * x / 2.0 - height * x * x * x / 3.0;
        speed * speed * (primitive(1.0) - primitive(from))
    };
    let whole = Whole { height, speed, radius }.build().unwrap().first_frequencies::<12>().unwrap();
    let halves = Halves { height, speed, radius, force: moment(0.5) }.build().unwrap();
    let inwards = WholeInwards { height, speed, radius, force: moment(0.0) }.build().unwrap();
    let exact: Vec<f64> = whole.iter().map(|root| root.omega).collect();
    assert_roots(&halves.first_frequencies::<12>().unwrap(), &exact, 4e-15);
    assert_roots(&inwards.first_frequencies::<12>().unwrap(), &exact, 8e-15);
}

const SUPPORTS: [Support; 4] = [Support::Fixed, Support::Pinned, Support::Guided, Support::Free];

/// Without taper the beam is the uniform one, whose formulas are closed: under axial force, with rotary inertia, on springs.
#[test]
fn without_taper_the_beam_is_the_uniform_one() {
    let (length, bending_stiffness, mass_per_length) = (1.3, 2.0, 0.7);
    for (axial_force, rotary_inertia, foundation_stiffness) in
        [(0.0, 0.0, 0.0), (30.0, 0.01, 25.0), (-3.0, 0.0, 0.0), (400.0, 0.002, 3e3), (-30.0, 0.0, 80.0)]
    {
        let uniform = GeneralBeam {
            length,
            bending_stiffness,
            mass_per_length,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            ..PLAIN
        };
        let tapered = TaperedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            width_taper: 0.0,
            height_taper: 0.0,
            rotary_inertia,
            axial_force,
            axial_load: 0.0,
            rotation_speed: 0.0,
            hub_radius: 0.0,
            setting_angle: 0.0,
            foundation_stiffness,
        };
        for (tip, root) in SUPPORTS.into_iter().flat_map(|tip| SUPPORTS.map(|root| (tip, root))) {
            let frequencies = |beam: AnyUndamped<f64>| {
                let spring: AnyUndamped<f64> = Spring { stiffness: 5.0 }.try_into().unwrap();
                let steps = [
                    ListStep::Tip(tip),
                    ListStep::Element(beam),
                    ListStep::Tip(Support::Fixed),
                    ListStep::Element(spring),
                    ListStep::Connection(2),
                    ListStep::Element(beam),
                    ListStep::Root(root),
                ];
                let list = StepList::new(&steps).unwrap();
                (list.first_frequencies::<10>(), list.unstable_modes().unwrap())
            };
            let (exact, growing) = frequencies(uniform.try_into().unwrap());
            let (found, also_growing) = frequencies(tapered.try_into().unwrap());
            assert_eq!(growing, also_growing, "{tip:?} {root:?} {axial_force}");
            match (exact, found) {
                (Err(SearchError::Unstable { .. }), Err(SearchError::Unstable { .. })) => assert!(growing > 0),
                (Ok(exact), Ok(found)) => {
                    for (exact, found) in exact.iter().zip(&found) {
                        assert_eq!(exact.multiplicity, found.multiplicity);
                        let error = (exact.omega - found.omega).abs() / exact.omega.max(1e-3);
                        assert!(error < 1e-13, "{exact:?} {found:?} {tip:?} {root:?} {axial_force}");
                    }
                }
                other => panic!("{other:?} {tip:?} {root:?} {axial_force}"),
            }
        }
    }
}

/// Beyond the parts that a beam may have there is an error, neither a wrong number nor a wait.
#[test]
fn too_many_waves_are_an_error() {
    let blade = Blade { width: 0.2, height: 0.3 }.build().unwrap();
    for omega in [1e9, 1e20, 1e200] {
        assert!(blade.count_below(omega).is_err(), "{omega}");
        assert!(blade.natural_frequencies::<4>(omega..=omega * 1.001).is_err(), "{omega}");
    }
    let rotor = Rotor { speed: 1e9, radius: 0.0 }.build().unwrap();
    assert!(rotor.first_frequencies::<2>().is_err());
}
