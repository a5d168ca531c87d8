//! Peaks of responses over bands: exact values, closed forms, what is refused.
#![expect(clippy::unwrap_used, reason = "a model that does not build fails the test")]

use crate::models::{Cantilever, number, reference};
use mstmm::Complex;
use mstmm::elements::{Spring, SpringDamper};
use mstmm::frame::{DampedStructure, Frame, Ground, Line, Point, Section};
use mstmm::motion::{MotionError, Peak, PeakError};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::{Eigenvalue, ProportionalDamping, SearchError};

type C = Complex<f64>;

system! {
    /// The cantilever of the reference values, with a damper at its tip.
    #[derive(Clone, Copy)]
    struct DampedCantilever { c: f64 }
    fixed -> beam 1 { length: 1.2, bending_stiffness: 180.0, mass_per_length: 2.5 } -> point_mass 2 { mass: 0.8, inertia: 0.0 } -> conn tip -> free;
    fixed -> spring 3 { stiffness: 350.0 } -> conn tip;
    fixed -> damper 4 { damping: c } -> conn tip;
}

/// A mass on a spring with a damper, its point, and its eigenvalues up to a frequency.
fn oscillator(k: f64, c: f64, m: f64) -> (DampedStructure<Line>, Point<Line>) {
    let mut frame = Frame::new();
    let point = frame.point(0.0);
    frame.member(point, Ground, SpringDamper { stiffness: k, damping: c });
    frame.mass(point, m);
    (frame.build_damped().unwrap(), point)
}

/// Two masses in a row on damped springs.
struct TwoMasses {
    k: [f64; 2],
    c: [f64; 2],
    m: [f64; 2],
}

impl TwoMasses {
    fn built(&self) -> (DampedStructure<Line>, [Point<Line>; 2]) {
        let mut frame = Frame::new();
        let points @ [first, second] = [0.0, 1.0].map(|place| frame.point(place));
        frame.member(first, Ground, SpringDamper { stiffness: self.k[0], damping: self.c[0] });
        frame.member(first, second, SpringDamper { stiffness: self.k[1], damping: self.c[1] });
        (0..2).for_each(|n| frame.mass(points[n], self.m[n]));
        (frame.build_damped().unwrap(), points)
    }

    /// Motions under a force at the first mass.
    fn motions(&self, omega: f64) -> [C; 2] {
        let lambda = C::new(0.0, omega);
        let [base, link] = [0, 1].map(|n| lambda * self.c[n] + self.k[n]);
        let [first, second] = self.m.map(|m| lambda * lambda * m);
        let delta = (first + base + link) * (second + link) - link * link;
        [(second + link) / delta, link / delta]
    }
}

/// The largest of a function over many frequencies of a band.
fn most(start: f64, end: f64, at: impl Fn(f64) -> f64) -> f64 {
    (0..=40_000).map(|n| at(start + (end - start) * f64::from(n) / 4e4)).fold(0.0, f64::max)
}

/// Values of exact fields with 40 digits, tolerances from 1e-2 to 1e-10, lists that are complete, empty, or of the band alone.
#[test]
fn peaks_of_six_bands_are_those_of_exact_fields() {
    let model = DampedCantilever { c: 3.0 }.build().unwrap();
    let (tip, foot) = (DampedCantilever::conn_tip, DampedCantilever::beam_1.input());
    let roots = model.eigenvalues_in(Region { re: -500.0..=0.0, im: 1.0..=2000.0 }).unwrap();
    let part = reference("peak");
    let questions = [
        ("tip", tip.force(), tip.deflection()),
        ("mom", tip.force(), foot.moment()),
        ("motion", foot.slip(), tip.deflection()),
    ];
    for (name, load, entry) in questions {
        let response = model.frequency_response(load, entry).unwrap();
        for row in part[name].as_array().unwrap() {
            let [start, end] = [0, 1].map(|k| number(&row["band"][k]));
            let (expected, omega) = (number(&row["peak"]), number(&row["omega"]));
            for tolerance in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10] {
                let in_band: Vec<_> =
                    roots.iter().filter(|r| r.lambda.im > start && r.lambda.im < end).copied().collect();
                for (list, most) in [(&roots[..], 120), (&in_band[..], 700), (&[], 3000)] {
                    let peak = response.peak(start..=end, list, tolerance).unwrap();
                    let about = format!("{name} {start} {tolerance:e} {peak:?}");
                    assert!(peak.lower <= expected * (1.0 + 1e-14) && expected <= peak.upper, "{about}");
                    assert!(peak.upper <= peak.lower * (1.0 + tolerance * 1.001), "{about}");
                    assert!((peak.omega / omega - 1.0).abs() < 0.1 * tolerance.sqrt(), "{about}");
                    assert!(peak.evaluations <= most, "{about}");
                    let found = response.at(C::new(0.0, peak.omega)).unwrap().norm();
                    assert!((peak.lower / found - 1.0).abs() < 1e-14, "{about}");
                }
            }
        }
    }
}

/// Closed form: `1/(c sqrt(ω² - (c/2m)²))` of an oscillator, from critical damping to a ratio of 1e-6; the ends of bands that miss its peak.
#[test]
fn peaks_of_oscillators() {
    for ratio in [0.6, 0.1, 1e-3, 1e-6] {
        let (k, m) = (81.0, 1.0);
        let c = 2.0 * ratio * 9.0;
        let (model, point) = oscillator(k, c, m);
        let roots = model.eigenvalues_in(Region { re: -20.0..=0.0, im: -20.0..=20.0 }).unwrap();
        let response = model.frequency_response(point.force_y(), point.displacement_y()).unwrap();
        let exact = 1.0 / (c * (k / m - 0.25 * c * c).sqrt());
        for tolerance in [1e-2, 1e-5, 1e-8, 1e-10] {
            let peak = response.peak(0.0..=30.0, &roots, tolerance).unwrap();
            assert!(peak.lower <= exact * (1.0 + 1e-14) && exact <= peak.upper, "{ratio} {tolerance} {peak:?}");
            // a pole is known to sixteen digits of its frequency: beside a narrow one pieces shrink to its width where more than ten are asked for
            assert!(peak.evaluations < if tolerance < 1e-8 { 3000 } else { 2000 }, "{ratio} {tolerance} {peak:?}");
            assert!(peak.upper <= peak.lower * (1.0 + 1.001 * tolerance), "{peak:?}");
        }
        // below and above the resonance the ends of the band are the peak and the least value
        let size = |omega: f64| 1.0 / C::new(k - omega * omega, c * omega).norm();
        for (band, [high, low]) in [(0.0..=4.0, [4.0, 0.0]), (12.0..=40.0, [12.0, 40.0])] {
            let [peak, least] =
                [response.peak(band.clone(), &roots, 1e-8), response.least(band, &roots, 1e-8)].map(Result::unwrap);
            for (found, omega) in [(peak, high), (least, low)] {
                assert!((found.omega - omega).abs() < 1e-6, "{found:?} for {omega}");
                assert!(
                    found.lower <= size(omega) * (1.0 + 1e-14) && size(omega) <= found.upper * (1.0 + 1e-14),
                    "{found:?}"
                );
            }
        }
    }
}

/// Far above all roots of a system of few, with lists of all of them and of none, up to a thousand times the last one.
#[test]
fn bands_far_above_all_roots() {
    let two = TwoMasses { k: [200.0, 50.0], c: [0.3, 0.1], m: [2.0, 1.0] };
    let (model, [first, second]) = two.built();
    let roots = model.eigenvalues_in(Region { re: -5.0..=0.0, im: 0.0..=30.0 }).unwrap();
    let response = model.frequency_response(first.force_y(), second.displacement_y()).unwrap();
    for list in [&roots[..], &[]] {
        let peak = response.peak(100.0..=1e4, list, 1e-8).unwrap();
        let exact = two.motions(100.0)[1].norm();
        assert!(peak.omega == 100.0 && peak.lower <= exact * (1.0 + 1e-14) && exact <= peak.upper, "{peak:?}");
        let least = response.least(100.0..=1e4, list, 1e-8).unwrap();
        let exact = two.motions(1e4)[1].norm();
        assert!(least.omega == 1e4 && least.lower <= exact && exact <= least.upper * (1.0 + 1e-14), "{least:?}");
    }
}

/// Without damping: between two roots the response has a zero, or it has none; bands with a root are refused, whether the list has it or not.
#[test]
fn bands_without_damping() {
    let model = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let roots = model.first_frequencies::<5>().unwrap();
    let response = model.frequency_response(tip.force(), tip.deflection()).unwrap();
    let size = |omega: f64| response.at(omega).unwrap().abs();
    let [low, high] = [1.05 * roots[1].omega, 0.95 * roots[2].omega];
    let peak = response.peak(low..=high, &roots, 1e-9).unwrap();
    let ends = size(low).max(size(high));
    assert!(peak.lower <= ends * (1.0 + 1e-14) && ends <= peak.upper && [low, high].contains(&peak.omega), "{peak:?}");
    // a collocated response changes its sign between any two roots
    let least = response.least(low..=high, &roots, 1e-9).unwrap();
    assert_eq!((least.lower, least.upper), (0.0, 0.0));
    let beside = least.omega * 1e-9;
    assert!(response.at(least.omega - beside).unwrap() * response.at(least.omega + beside).unwrap() < 0.0);
    // in a band on one side of the zero it is at an end
    let least = response.least(low..=least.omega * 0.9, &roots, 1e-9).unwrap();
    let expected = 1.0 / most(low, least.omega, |omega| 1.0 / size(omega));
    assert!(least.lower > 0.0 && least.lower <= expected && expected <= least.upper * (1.0 + 1e-12), "{least:?}");
    // eigenvalues of a system without damping are as good as natural frequencies
    let eigenvalues = model.eigenvalues_in(Region { re: -1.0..=1.0, im: 0.0..=700.0 }).unwrap();
    assert_eq!(response.peak(low..=high, &eigenvalues, 1e-9).unwrap().upper, peak.upper);
    for list in [&roots[..], &roots[3..]] {
        let refused = response.peak(low..=roots[2].omega * 1.01, list, 1e-6).unwrap_err();
        let PeakError::Resonance { omega } = refused else { panic!("{refused}") };
        assert!((omega / roots[2].omega - 1.0).abs() < 1e-9, "{omega}");
    }
    let at_end = response.peak(low..=roots[2].omega, &roots, 1e-6).unwrap_err();
    assert!(at_end.to_string().contains("without damping"), "{at_end}");
}

/// Closed form: two masses, their responses and their ratios, the least of each by dense samples.
#[test]
fn ratios_and_least_values() {
    let two = TwoMasses { k: [400.0, 90.0], c: [0.8, 0.05], m: [1.5, 0.4] };
    let (model, [first, second]) = two.built();
    let roots = model.eigenvalues_in(Region { re: -5.0..=0.0, im: 0.0..=60.0 }).unwrap();
    let response = |point: Point<Line>| model.frequency_response(first.force_y(), point.displacement_y()).unwrap();
    let [of_first, of_second] = [response(first), response(second)];
    let ratio = of_second.over(&of_first);
    let (start, end) = (1.0, 50.0);
    let check = |name: &str, peak: Peak, least: Peak, at: &dyn Fn(f64) -> f64| {
        let [high, low] = [most(start, end, at), 1.0 / most(start, end, |omega| 1.0 / at(omega))];
        assert!(high <= peak.upper && high >= peak.lower * (1.0 - 1e-4), "{name} {high} {peak:?}");
        assert!(low >= least.lower && low <= least.upper * (1.0 + 1e-4), "{name} {low} {least:?}");
        assert!(
            (peak.upper / peak.lower - 1.0).abs() < 1.001e-7 && least.upper / least.lower - 1.0 < 1.001e-7,
            "{name}"
        );
        assert!(
            (at(peak.omega) / peak.lower - 1.0).abs() < 1e-12 && (at(least.omega) / least.upper - 1.0).abs() < 1e-12,
            "{name}"
        );
    };
    for (name, response, which) in [("first", &of_first, 0), ("second", &of_second, 1)] {
        let [peak, least] =
            [response.peak(start..=end, &roots, 1e-7), response.least(start..=end, &roots, 1e-7)].map(Result::unwrap);
        check(name, peak, least, &|omega| two.motions(omega)[which].norm());
    }
    let [peak, least] =
        [ratio.peak(start..=end, &roots, 1e-7), ratio.least(start..=end, &roots, 1e-7)].map(Result::unwrap);
    check("ratio", peak, least, &|omega| {
        let [first, second] = two.motions(omega);
        (second / first).norm()
    });
    // the absorber takes the motion of the first mass at its own frequency
    assert!((peak.omega / (90.0_f64 / 0.4).sqrt() - 1.0).abs() < 1e-3, "{peak:?}");
    let (other, point) = oscillator(1.0, 0.1, 1.0);
    let other = other.frequency_response(point.force_y(), point.displacement_y()).unwrap();
    assert_eq!(of_first.over(&other).peak(start..=end, &roots, 1e-6).unwrap_err(), PeakError::OtherSystem);
}

/// A ratio whose divisor vanishes is infinite, and its inverse has a zero; ratios of equals are one.
#[test]
fn ratios_of_undamped_responses() {
    let model = Cantilever {}.build().unwrap();
    let (tip, foot) = (Cantilever::conn_tip, Cantilever::beam_1.input());
    let roots = model.first_frequencies::<5>().unwrap();
    let of_tip = model.frequency_response(tip.force(), tip.deflection()).unwrap();
    let of_foot = model.frequency_response(tip.force(), foot.moment()).unwrap();
    let band = 1.05 * roots[1].omega..=0.95 * roots[2].omega;
    let refused = of_foot.over(&of_tip).peak(band.clone(), &roots, 1e-6).unwrap_err();
    assert!(matches!(refused, PeakError::Infinite { .. }) && refused.to_string().contains("vanishes"), "{refused}");
    let least = of_tip.over(&of_foot).least(band.clone(), &roots, 1e-6).unwrap();
    assert_eq!((least.lower, least.upper), (0.0, 0.0));
    let one = of_tip.over(&of_tip).peak(band.start() * 1.0..=band.start() * 1.05, &roots, 1e-9).unwrap();
    assert!(one.lower <= 1.0 && 1.0 <= one.upper && one.upper < 1.0 + 2e-9, "{one:?}");
}

/// A beam on two equal supports under a load in its middle: what is antisymmetric does not move, to rounding.
#[test]
fn responses_that_symmetry_makes_zero() {
    let mut frame = Frame::new();
    let points @ [left, middle, right] = [0.0, 1.0, 2.0].map(|place| frame.point(place));
    let section = Section::new().bending_stiffness(37.0).mass_per_length(1.3);
    let beams = [frame.member(left, middle, section), frame.member(middle, right, section)];
    [left, right].into_iter().for_each(|end| frame.hold(end, Support::Pinned));
    frame.member(middle, Ground, SpringDamper { stiffness: 3.0, damping: 0.2 });
    let model = frame.build_damped().unwrap();
    let roots = model.eigenvalues_in(Region { re: -50.0..=0.0, im: 0.1..=200.0 }).unwrap();
    let turned = model.frequency_response(points[1].force_y(), middle.rotation_z()).unwrap();
    // antisymmetric modes are not damped, so that the band keeps away from them
    let least_undamped = roots.iter().find(|root| root.lambda.re.abs() < 1e-9).map(|root| root.lambda.im).unwrap();
    let band = 0.5..=0.9 * least_undamped;
    let peak = turned.peak(band.clone(), &roots, 1e-6).unwrap();
    let moved = model.frequency_response(middle.force_y(), middle.displacement_y()).unwrap();
    let scale = moved.peak(band.clone(), &roots, 1e-6).unwrap();
    assert!(peak.upper < 1e-18 * scale.upper && peak.lower <= peak.upper, "{peak:?} {scale:?}");
    let least = turned.least(band.clone(), &roots, 1e-6).unwrap();
    assert!(least.lower == 0.0 && least.upper <= peak.upper, "{least:?}");
    let moment = model.frequency_response(middle.force_y(), beams[0].input().moment()).unwrap();
    let at_pin = moment.peak(band, &roots, 1e-6).unwrap();
    assert!(at_pin.upper < 1e-18, "a pin has no moment: {at_pin:?}");
}

/// Sums over modes and exact responses in proportion: both are one where the list is long, and dense samples are below.
#[test]
fn peaks_of_modal_sums_and_of_damping_in_proportion() {
    let model = Cantilever {}.build().unwrap();
    let tip = Cantilever::conn_tip;
    let roots = model.first_frequencies::<6>().unwrap();
    let exact = model.frequency_response(tip.force(), tip.deflection()).unwrap();
    let sum = model.modal_response::<12, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let band = 1.0..=0.9 * roots[3].omega;
    let inside = 0.5 * (roots[0].omega + roots[1].omega);
    assert!(matches!(sum.peak(band.clone(), 1e-6), Err(PeakError::Resonance { .. })));
    assert!(sum.peak(inside..=inside * 1.1, 1e-6).unwrap().upper > 0.0);
    for (alpha, beta, eta) in [(0.5, 1e-4, 0.0), (0.0, 0.0, 0.03), (2.0, 0.0, 0.0), (0.1, 2e-3, 0.0)] {
        let damping = ProportionalDamping::new(alpha, beta, eta).unwrap();
        let peak = damping.peak(&exact, band.clone(), &roots, 1e-8).unwrap();
        let least = damping.least(&exact, band.clone(), &roots, 1e-8).unwrap();
        let at = |omega: f64| damping.response(&exact, C::new(0.0, omega)).unwrap().norm();
        let sampled: Vec<f64> = (0..=4000).map(|n| at(1.0 + (band.end() - 1.0) * f64::from(n) / 4e3)).collect();
        assert!(
            sampled.iter().all(|value| *value <= peak.upper && *value >= least.lower),
            "{alpha} {beta} {eta} {peak:?} {least:?}"
        );
        assert!((at(peak.omega) / peak.lower - 1.0).abs() < 1e-13 && peak.upper < peak.lower * (1.0 + 1.001e-8));
        assert!((at(least.omega) / least.upper - 1.0).abs() < 1e-13 && least.upper < least.lower * (1.0 + 1.001e-8));
        let refused = damping.peak(&exact, band.clone(), &roots[1..], 1e-8).unwrap_err();
        assert!(
            matches!(refused, PeakError::Missing { .. }) && refused.to_string().contains("the list has"),
            "{refused}"
        );
        if eta == 0.0 {
            let damped = sum.with_damping(&damping).unwrap();
            let of_modes = damped.peak(band.clone(), 1e-8).unwrap();
            assert!((of_modes.upper / peak.upper - 1.0).abs() < 1e-4, "{of_modes:?} {peak:?}");
        } else {
            let refused = damping.peak(&exact, 0.0..=20.0, &roots, 1e-8).unwrap_err();
            assert!(matches!(refused, PeakError::Search(SearchError::LossFactor { .. })), "{refused}");
        }
    }
    let undamped = ProportionalDamping::new(0.0, 0.0, 0.0).unwrap();
    assert!(matches!(undamped.peak(&exact, band, &roots, 1e-8), Err(PeakError::Resonance { .. })));
}

/// Materials with a loss factor and of Kelvin and Voigt, against dense samples.
#[test]
fn peaks_with_damping_of_materials() {
    system! {
        struct Bar { eta: f64, time: f64 }
        fixed -> beam 1 { length: 1.0, bending_stiffness: 100.0, mass_per_length: 1.0, loss_factor: eta, kelvin_voigt_time: time } -> conn tip -> free;
    }
    for (eta, time) in [(0.02, 0.0), (0.0, 1e-4), (0.3, 2e-4)] {
        let model = Bar { eta, time }.build().unwrap();
        let roots = model.eigenvalues_in(Region { re: -300.0..=0.0, im: 1.0..=1300.0 }).unwrap();
        let response = model.frequency_response(Bar::conn_tip.force(), Bar::conn_tip.deflection()).unwrap();
        let (start, end) = (2.0, 1000.0);
        let peak = response.peak(start..=end, &roots, 1e-7).unwrap();
        let least = response.least(start..=end, &roots, 1e-7).unwrap();
        for n in 0..=3000 {
            let omega = start * (end / start).powf(f64::from(n) / 3e3);
            let size = response.at(C::new(0.0, omega)).unwrap().norm();
            assert!(size <= peak.upper && size >= least.lower, "{eta} {time} {omega}: {size} {peak:?} {least:?}");
        }
        if eta > 0.0 {
            let refused = response.peak(0.0..=end, &roots, 1e-7).unwrap_err();
            assert!(matches!(refused, PeakError::Search(SearchError::LossFactor { .. })), "{refused}");
        } else {
            assert!(response.peak(0.0..=end, &roots, 1e-7).unwrap().upper >= peak.lower);
        }
    }
}

/// Closed form: a disc that tilts on a damped spring, `1/(I_d λ² + (c - i I_p Ω) λ + k)` forward, and with the other sign backward. From zero on bands are of both whirls.
#[test]
fn peaks_of_both_whirls() {
    system! {
        struct Rotor { ip: f64, speed: f64 }
        free -> disc 1 { mass: 3.0, inertia: 0.2, polar_inertia: ip, speed } -> conn a -> free;
        fixed -> spring 2 { stiffness: 1200.0, damping: 4.0 } -> conn a;
        fixed -> torsion_spring 3 { stiffness: 500.0, damping: 0.7 } -> conn a;
    }
    let rotor = Rotor { ip: 0.3, speed: 35.0 }.build().unwrap();
    for (whirl, sign) in [(Whirl::Forward, 1.0), (Whirl::Backward, -1.0)] {
        let model = rotor.whirl(whirl);
        let roots = model.first_eigenvalues::<2>().unwrap();
        let response = model.frequency_response(Rotor::conn_a.torque(), Rotor::conn_a.rotation()).unwrap();
        let size =
            |omega: f64| C::new(500.0 - 0.2 * omega * omega + sign * 0.3 * 35.0 * omega, 0.7 * omega).norm().recip();
        let peak = response.peak(1.0..=200.0, &roots, 1e-8).unwrap();
        let expected = most(1.0, 200.0, size);
        assert!(peak.upper >= expected && (size(peak.omega) / peak.lower - 1.0).abs() < 1e-13, "{whirl:?} {peak:?}");
        assert!(peak.upper <= peak.lower * (1.0 + 1.001e-8));
        let refused = response.peak(0.0..=200.0, &roots, 1e-8).unwrap_err();
        assert!(matches!(refused, PeakError::Search(SearchError::OtherWhirl { .. })), "{refused}");
    }
}

#[test]
fn bad_questions_are_refused() {
    let (model, point) = oscillator(9.0, 0.1, 1.0);
    let roots = model.eigenvalues_in(Region { re: -5.0..=0.0, im: 0.0..=10.0 }).unwrap();
    let response = model.frequency_response(point.force_y(), point.displacement_y()).unwrap();
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY, 0.7, 1e-13] {
        let refused = response.peak(1.0..=5.0, &roots, tolerance).unwrap_err();
        assert!(
            matches!(refused, PeakError::Tolerance { .. }) && refused.to_string().contains(&tolerance.to_string()),
            "{refused}"
        );
    }
    for (start, end) in [(5.0, 1.0), (2.0, 2.0), (f64::NAN, 2.0), (1.0, f64::NAN), (1.0, f64::INFINITY)] {
        let refused = response.least(start..=end, &roots, 1e-3).unwrap_err();
        assert!(matches!(refused, PeakError::Motion(MotionError::Range { .. })), "{refused}");
    }
    // a free body moves off at rest
    let mut frame = Frame::new();
    let [one, other] = [0.0, 1.0].map(|place| frame.point(place));
    frame.member(one, other, Spring { stiffness: 3.0 });
    [one, other].into_iter().for_each(|point| frame.mass(point, 1.0));
    let free = frame.build().unwrap();
    let roots = free.frequencies(2).unwrap();
    let response = free.frequency_response(one.force_y(), other.displacement_y()).unwrap();
    assert!(matches!(response.peak(0.0..=1.0, &roots, 1e-6), Err(PeakError::Resonance { omega: 0.0 })));
    let none: [Eigenvalue; 0] = [];
    let refused = response.peak(0.0..=1.0, &none, 1e-6).unwrap_err();
    assert!(matches!(refused, PeakError::Resonance { .. } | PeakError::Search(_)), "{refused:?}");
    // 1/(2 m ω²) and less than nothing of the other mode: the start of the band
    let peak = response.peak(0.01..=0.1, &roots, 1e-6).unwrap();
    assert!((peak.omega - 0.01).abs() < 1e-9 && (peak.lower * 2e-4 - 1.0).abs() < 1e-3, "{peak:?}");
}
