//! Responses to harmonic loads against closed forms, sums over modes, and reciprocity.
#![allow(missing_docs)]

use crate::support::models::*;
use mstmm::motion::{MotionError, Point};
use mstmm::prelude::*;
use mstmm::search::Eigenvalue;

system! {
    /// Beam with supports at its ends as the models below need them.
    struct Cantilever { l: f64, ei: f64, m: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> free;
}

system! {
    struct Simple { a: f64, b: f64, ei: f64, m: f64 }
    pinned -> beam 1 { length: a, bending_stiffness: ei, mass_per_length: m }
           -> beam 3 { length: b, bending_stiffness: ei, mass_per_length: m } -> pinned;
}

fn assert_relative(actual: f64, expected: f64, limit: f64) {
    let error = ((actual - expected) / expected).abs();
    assert!(error <= limit, "{actual} is not {expected}: {error:e}");
}

#[test]
fn static_deflections_are_those_of_beam_theory() {
    let (l, ei) = (1.7, 33.0);
    let cantilever = Cantilever { l, ei, m: 0.4 }.build().unwrap();
    let (clamp, tip) = (Cantilever::beam_1.input(), Cantilever::beam_1.output());
    let at = |load, entry| cantilever.frequency_response(load, entry).unwrap().at(0.0).unwrap();
    assert_relative(at(tip.force(), tip.deflection()), l * l * l / (3.0 * ei), 1e-12);
    assert_relative(at(tip.force(), tip.rotation()), l * l / (2.0 * ei), 1e-12);
    assert_relative(at(tip.torque(), tip.deflection()), l * l / (2.0 * ei), 1e-12);
    assert_relative(at(tip.torque(), tip.rotation()), l / ei, 1e-12);
    // EI Y'' is positive where a load bends the tip up, and Q = EI Y''' falls by what the load adds
    assert_relative(at(tip.force(), clamp.moment()), l, 1e-12);
    assert_relative(at(tip.force(), clamp.shear()), -1.0, 1e-12);
    assert_relative(at(tip.torque(), clamp.moment()), 1.0, 1e-12);

    let (a, b) = (0.7, 1.0);
    let simple = Simple { a, b, ei, m: 0.4 }.build().unwrap();
    let at = |load, entry| simple.frequency_response(load, entry).unwrap().at(0.0).unwrap();
    let (left, middle, right) = (Simple::beam_1.input(), Simple::beam_1.output(), Simple::beam_3.output());
    assert_relative(at(middle.force(), middle.deflection()), a * a * b * b / (3.0 * ei * (a + b)), 1e-12);
    assert_relative(at(middle.force(), left.rotation()), a * b * (a + 2.0 * b) / (6.0 * ei * (a + b)), 1e-12);
    assert_relative(at(middle.force(), right.rotation()), -a * b * (b + 2.0 * a) / (6.0 * ei * (a + b)), 1e-12);
    assert_relative(at(middle.force(), middle.moment()), -a * b / (a + b), 1e-12);
    assert_relative(at(left.torque(), right.rotation()), -(a + b) / (6.0 * ei), 1e-12);
}

/// `H(ω) - H(0) = Σ φ_r φ_f ω²/(ω_k² (ω_k² - ω²))`: its terms fall with the eighth power of the mode number, so that a sum over
/// 200 modes is exact to rounding; that of H itself falls with the fourth, and leaves about `S_200 - S_100` over 7.
macro_rules! sums_over_modes {
    ($test:ident, $model:expr, $type:ident, $load:expr, $entries:expr) => {
        #[test]
        fn $test() {
            let system = $model.build().unwrap();
            let roots = system.first_frequencies::<200>().unwrap();
            let shapes: Vec<_> = roots.iter().map(|root| system.mode_shape(root).unwrap()).collect();
            let load: Point<$type> = $load;
            for entry in $entries {
                let entry: Point<$type> = entry;
                let response = system.frequency_response(load.force(), entry.deflection()).unwrap();
                let rest = response.at(0.0).unwrap();
                for share in [0.3, 0.97, 3.3, 8.7] {
                    let omega = share * roots[2].omega;
                    let terms: Vec<f64> = (shapes.iter().zip(roots.iter()))
                        .map(|(shape, root)| {
                            shape.state(load).y * shape.state(entry).y / (root.omega * root.omega - omega * omega)
                        })
                        .collect();
                    let sum: f64 =
                        terms.iter().zip(roots.iter()).map(|(term, root)| term * (omega / root.omega).powi(2)).sum();
                    let size: f64 = terms
                        .iter()
                        .zip(roots.iter())
                        .map(|(term, root)| (term * (omega / root.omega).powi(2)).abs())
                        .sum();
                    let value = response.at(omega).unwrap();
                    // the response rests on Δ, whose rounding is magnified by the distance to the next root
                    let error = (value - rest - sum).abs() / (size + rest.abs());
                    assert!(error < 1e-12, "{entry:?} at {share}: {error:e}");
                    let plain: f64 = terms.iter().sum();
                    let half: f64 = terms[..100].iter().sum();
                    let tail: f64 = terms[100..].iter().map(|term| term.abs()).sum();
                    assert!((value - plain).abs() <= tail / 3.0 + 1e-12 * value.abs(), "{value} {plain} {half} {tail}");
                }
            }
        }
    };
}

sums_over_modes!(
    of_a_light_tip_body,
    light_tip_body(),
    TipBody,
    TipBody::body_2.output(),
    [TipBody::beam_1.output(), TipBody::body_2.output()]
);
sums_over_modes!(
    of_a_heavy_tip_body,
    heavy_tip_body(),
    TipBody,
    TipBody::beam_1.output(),
    [TipBody::beam_1.output(), TipBody::body_2.output()]
);
sums_over_modes!(
    of_a_restrained_beam,
    restrained_beam(),
    RestrainedBeam,
    RestrainedBeam::conn_2,
    [RestrainedBeam::conn_2, RestrainedBeam::conn_4]
);
sums_over_modes!(
    of_a_spring_and_a_mass,
    spring_and_mass(),
    SpringAndMass,
    SpringAndMass::conn_5,
    [SpringAndMass::conn_2, SpringAndMass::conn_5, SpringAndMass::mass_6.output()]
);
sums_over_modes!(
    of_two_spans,
    two_spans(),
    TwoSpans,
    TwoSpans::mass_6.output(),
    [TwoSpans::conn_4, TwoSpans::mass_6.input(), TwoSpans::spring_5.output()]
);

/// `H(λ) - H(0) = Σ φ_r φ_f λ/(2 λ_k² (λ - λ_k))` over all eigenvalues: those above the real axis, their conjugates, and real ones.
#[test]
fn damped_responses_are_sums_over_complex_modes() {
    let model = damped_oscillator();
    let system = model.build().unwrap();
    let last = 201.5 * std::f64::consts::PI / model.length;
    let omega = last * last * (model.bending_stiffness / model.mass_per_length).sqrt();
    let region = Region { re: -1e4..=1.0, im: 0.0..=omega };
    let roots = system.eigenvalues::<256>(region).unwrap();
    assert!(roots.len() > 200, "{}", roots.len());
    let load = DampedOscillator::mass_7.output();
    for entry in [DampedOscillator::conn_2, load] {
        let response = system.frequency_response(load.force(), entry.deflection()).unwrap();
        let rest = response.at(Complex::new(0.0, 0.0)).unwrap();
        for lambda in [Complex::new(0.0, 300.0), Complex::new(-20.0, 2500.0), Complex::new(5.0, 9000.0)] {
            let term = |root: &Eigenvalue| {
                let shape = system.mode_shape(root).unwrap();
                let of = |pole: Complex<f64>, product: Complex<f64>| {
                    product * lambda / (2.0 * pole * pole * (lambda - pole))
                };
                let product = shape.state(load).y * shape.state(entry).y;
                let own = of(root.lambda, product);
                if root.lambda.im == 0.0 { own } else { own + of(root.lambda.conj(), product.conj()) }
            };
            let terms: Vec<_> = roots.iter().map(term).collect();
            let sum: Complex<f64> = terms.iter().sum();
            let size: f64 = terms.iter().map(|term| term.norm()).sum();
            let value = response.at(lambda).unwrap();
            let error = (value - rest - sum).norm() / (size + rest.norm());
            assert!(error < 1e-12, "{entry:?} at {lambda}: {error:e}");
        }
    }
}

/// Maxwell and Betti: the work of one unit load in the displacement that another causes is that of the other in its own.
macro_rules! assert_reciprocal {
    ($system:expr, $x:expr, $of:ident, $points:expr) => {{
        let (system, points): (_, Vec<Point<$of>>) = ($system, $points.into());
        for x in $x {
            for (a, b) in points.iter().flat_map(|a| points.iter().map(move |b| (a, b))) {
                let loads = [(a.force(), a.deflection()), (a.torque(), a.rotation())];
                let others = [(b.force(), b.deflection()), (b.torque(), b.rotation())];
                for (load, own) in loads {
                    for (other_load, other) in others {
                        let Ok(there) = system.frequency_response(load, other) else { continue };
                        let Ok(back) = system.frequency_response(other_load, own) else { continue };
                        let (there, back) = (there.at(x).unwrap(), back.at(x).unwrap());
                        let direct = [(load, own), (other_load, other)].map(|(load, own)| system.frequency_response(load, own).unwrap().at(x).unwrap());
                        // where the two points do not feel each other there are only roundings of what each feels itself
                        let scale = size(there).max((size(direct[0]) * size(direct[1])).sqrt());
                        assert!(size(there - back) <= 1e-12 * scale, "{a:?} {b:?} at {x}: {there} {back}");
                    }
                }
            }
        }
    }};
}

fn size(value: impl mstmm::number::Single) -> f64 {
    mstmm::number::Scalar::size(value)
}

#[test]
fn responses_are_reciprocal() {
    let omegas = [0.0, 1.0, 700.0, 31_000.0];
    assert_reciprocal!(
        light_tip_body().build().unwrap(),
        omegas,
        TipBody,
        [TipBody::beam_1.output(), TipBody::body_2.output()]
    );
    assert_reciprocal!(
        restrained_beam().build().unwrap(),
        omegas,
        RestrainedBeam,
        [RestrainedBeam::conn_2, RestrainedBeam::conn_4]
    );
    assert_reciprocal!(
        spring_and_mass().build().unwrap(),
        omegas,
        SpringAndMass,
        [
            SpringAndMass::beam_1.input(),
            SpringAndMass::conn_2,
            SpringAndMass::conn_5,
            SpringAndMass::beam_7.output(),
            SpringAndMass::mass_6.input(),
        ]
    );
    assert_reciprocal!(
        two_spans().build().unwrap(),
        omegas,
        TwoSpans,
        [
            TwoSpans::beam_1.input(),
            TwoSpans::conn_2,
            TwoSpans::conn_4,
            TwoSpans::beam_7.output(),
            TwoSpans::mass_6.input(),
            TwoSpans::spring_5.input(),
        ]
    );
    let lambdas = omegas.map(|omega| Complex::new(-0.1 * omega, omega));
    assert_reciprocal!(
        damped_oscillator().build().unwrap(),
        lambdas,
        DampedOscillator,
        [
            DampedOscillator::conn_2,
            DampedOscillator::conn_5,
            DampedOscillator::conn_9,
            DampedOscillator::mass_7.input(),
            DampedOscillator::torsion_spring_10.output(),
            DampedOscillator::beam_1.input(),
            DampedOscillator::beam_11.output(),
        ]
    );
}

#[test]
fn loads_that_no_state_carries_are_refused() {
    let system = two_spans().build().unwrap();
    let error =
        system.frequency_response(TwoSpans::mass_6.output().torque(), TwoSpans::conn_4.deflection()).unwrap_err();
    assert_eq!(error, MotionError::NoSuchEntry { coordinate: mstmm::element::Coordinate::M });
    assert_eq!(error.to_string(), "no state at this point has a moment M: no bending or rotation path leads there");
    let error =
        system.frequency_response(TwoSpans::conn_4.force(), TwoSpans::spring_5.output().rotation()).unwrap_err();
    assert_eq!(error, MotionError::NoSuchEntry { coordinate: mstmm::element::Coordinate::Theta });
    let response = system.frequency_response(TwoSpans::conn_4.force(), TwoSpans::conn_4.deflection()).unwrap();
    assert_eq!(response.on(&[1.0, 2.0], &mut [0.0]), Err(MotionError::Capacity { capacity: 1 }));
    assert!(matches!(response.at(f64::NAN), Err(MotionError::NotFinite { .. })));
}

/// A free beam moves away under a static force.
#[test]
fn a_response_without_support_is_infinite_at_rest() {
    system! { struct Float { l: f64 } free -> beam 1 { length: l, bending_stiffness: 2.0, mass_per_length: 3.0 } -> free; }
    let system = Float { l: 1.5 }.build().unwrap();
    let response =
        system.frequency_response(Float::beam_1.input().force(), Float::beam_1.output().deflection()).unwrap();
    assert_eq!(response.at(0.0), Err(MotionError::Resonance { frequency: 0.0 }));
    // two rigid modes: F (1/m + (l/2)(-l/2)/J)/-ω², and their sum with the others far below the first of those
    let (mass, omega) = (3.0 * 1.5, 1e-3);
    let rigid = (1.0 / mass - 0.75 * 0.75 / (mass * 1.5 * 1.5 / 12.0)) / -(omega * omega);
    assert_relative(response.at(omega).unwrap(), rigid, 1e-5);
}

#[test]
fn curves_show_every_resonance() {
    let system = damped_oscillator().build().unwrap();
    let response =
        system.frequency_response(DampedOscillator::conn_2.force(), DampedOscillator::conn_2.deflection()).unwrap();
    let roots = system.eigenvalues::<16>(Region { re: -500.0..=1.0, im: 1.0..=20_000.0 }).unwrap();
    let curve = response.curve::<2000, _>(10.0..=20_000.0, &roots, 1e-2).unwrap();
    for root in &roots {
        let near = |omega: f64| (omega - root.lambda.im).abs() <= root.lambda.re.abs();
        assert!(curve.iter().filter(|sample| near(sample.omega)).count() >= 3, "{root:?}");
    }
    for pair in curve.windows(2) {
        let share = 0.5;
        let omega = pair[0].omega + share * (pair[1].omega - pair[0].omega);
        let value = response.at(Complex::new(0.0, omega)).unwrap();
        let straight = (pair[0].value + pair[1].value) * share;
        let largest = [pair[0].value, pair[1].value, value].map(|value| value.norm()).into_iter().fold(0.0, f64::max);
        assert!((value - straight).norm() <= 2e-2 * largest, "{omega}");
    }
    let few = response.curve::<20, _>(10.0..=20_000.0, &roots, 1e-2);
    assert_eq!(few.unwrap_err(), MotionError::Capacity { capacity: 20 });
}

system! {
    struct Lossy { eta: f64 }
    free -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, loss_factor: eta } -> conn tip -> free;
}

/// The path in the numbers of the model has the digits that stiffnesses and the distance of a root leave, and says what it does not answer.
#[test]
fn responses_at_speed_are_those_in_32_digits_but_for_their_last() {
    let (tip, simple) = (Simple::beam_1.output(), Simple { a: 0.7, b: 1.0, ei: 33.0, m: 0.4 }.build().unwrap());
    let response = simple.frequency_response(tip.force(), tip.deflection()).unwrap();
    let largest = response.at(0.0).unwrap();
    for k in 0..500_u16 {
        let omega = 2.3 * f64::from(k);
        let [exact, quick] = [response.at(omega), response.at_speed(omega)].map(Result::unwrap);
        assert!((quick - exact).abs() <= 1e-9 * exact.abs().max(largest), "{omega}: {quick} {exact}");
    }
    let lossy = Lossy { eta: 0.02 }.build().unwrap();
    let response = lossy.frequency_response(Lossy::conn_tip.force(), Lossy::conn_tip.deflection()).unwrap();
    let above = Complex::new(-0.1, 3.0);
    assert!((response.at_speed(above).unwrap() / response.at(above).unwrap() - 1.0).norm() < 1e-12);
    assert_eq!(response.at_speed(above.conj()).err(), Some(MotionError::LossFactor));
    assert_eq!(response.at(above.conj()).unwrap(), response.at(above).unwrap().conj());
    let rest = Complex::new(0.0, 0.0);
    assert_eq!(response.at_speed(rest).err(), Some(MotionError::Resonance { frequency: 0.0 }));
}
