//! Responses near resonances and near rest, and sensitivities of close roots: errors grow with the inverse of the distance.

use crate::support::list_of_tree::{MOST, Planned, point, undamped, undamped_steps};
use crate::support::random_tree::varied_tree;
use crate::support::tree::Part;
use mstmm::Complex;
use mstmm::element::Support;
use mstmm::elements::{Beam, Mass, Spring};
use mstmm::list::{AnyUndamped, InList, ListStep, StepList};
use mstmm::motion::{Entry, Load, ModalAnalysis};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::search::{Eigenvalue, NaturalFrequencies, NaturalFrequency};

/// The load and the displacement in which a point moves, by the space there.
fn own(step: usize, system: &Planned<AnyUndamped<f64>>) -> (Load<InList>, Entry<InList>) {
    let point = point(step, false);
    match system.frequency_response(point.force(), point.deflection()) {
        Ok(_) => (point.force(), point.deflection()),
        Err(_) => (point.torque(), point.rotation()),
    }
}

/// The same model of numbers with twice the digits answers the same, however near a root is.
#[test]
fn responses_lose_no_digits_beside_a_root() {
    let mut compared = 0;
    for seed in (1..80).step_by(2) {
        let tree = varied_tree(seed);
        let steps = undamped_steps::<f64>(&tree);
        let Ok(list) = StepList::new(&steps) else { continue };
        let Ok(roots) = list.first_frequencies::<6>() else { continue };
        if tree.len() > MOST {
            continue;
        }
        let (system, exact) = (undamped::<f64>(&tree), undamped::<DoubleDouble>(&tree));
        let (load, entry) = own(tree.len() / 2, &system);
        // where something is held twice, its forces are not determined, and neither is a response
        let between = 0.5 * (roots[0].omega + roots[1].omega);
        if roots[0].omega * 1.1 < roots[1].omega && system.frequency_response(load, entry).unwrap().at(between).is_err()
        {
            continue;
        }
        for root in roots.iter().filter(|root| root.multiplicity == 1 && root.omega > 1e-3) {
            let is_close = |other: &&NaturalFrequency| (other.omega / root.omega - 1.0).abs() < 1e-2;
            if roots.iter().filter(is_close).count() > 1 {
                continue;
            }
            for distance in [1e-3, 1e-6, 1e-9] {
                let omega = root.omega * (1.0 + distance);
                let wide = Complex::new(DoubleDouble::from(0.0), DoubleDouble::from(omega));
                let at = |entry| {
                    let exact = exact.frequency_response(load, entry).unwrap().at(wide).unwrap();
                    (system.frequency_response(load, entry).unwrap().at(omega).unwrap(), exact.re.to_f64())
                };
                let all: Vec<_> = (0..tree.len() - 1).map(|step| at(own(step, &system).1)).collect();
                let largest = all.iter().fold(0.0, |largest, (_, exact)| exact.abs().max(largest));
                for (actual, exact) in all {
                    // a support takes a load at it, and nothing moves
                    let error = if largest == 0.0 { actual.abs() } else { (actual - exact).abs() / largest };
                    assert!(
                        error <= f64::EPSILON,
                        "seed {seed}, {omega}, {distance:e}: {actual} {exact} {error:e}\nvec!{tree:?}"
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Closed form: at a hundred-millionth of the first frequency what a beam of any number of parts does is static to rounding.
#[test]
fn just_above_rest_a_beam_is_static() {
    let (ei, parts) = (3.0, [0.7, 0.4, 0.9]);
    let beam = |length| ListStep::Element(Part::Beam(Beam { length, bending_stiffness: ei, mass_per_length: 2.0 }));
    let [a, b, c] = parts.map(beam);
    let system = undamped::<f64>(&vec![ListStep::Tip(Support::Fixed), a, b, c, ListStep::Root(Support::Free)]);
    let ends = [0.0_f64, 0.7, 1.1, 2.0];
    for (load, from) in ends.iter().enumerate().skip(1) {
        for (entry, to) in ends.iter().enumerate().skip(1) {
            let (near, far) = (from.min(*to), from.max(*to));
            let expected = near * near * (3.0 * far - near) / (6.0 * ei);
            let response =
                system.frequency_response(point(load, false).force(), point(entry, false).deflection()).unwrap();
            for omega in [1e-8, 1e-20, 0.0] {
                let actual = response.at(omega).unwrap();
                assert!((actual - expected).abs() < 64.0 * f64::EPSILON * expected, "{omega}: {actual} {expected}");
            }
        }
    }
}

/// Beams between supports of all kinds, of several parts, in twice the digits.
#[test]
fn just_above_rest_beams_between_supports_keep_their_digits() {
    let beam = |length| ListStep::Element(Part::Beam(Beam { length, bending_stiffness: 3.0, mass_per_length: 2.0 }));
    let lengths = [0.75, 0.375, 0.875];
    for ends in
        [(Support::Fixed, Support::Fixed), (Support::Pinned, Support::Pinned), (Support::Guided, Support::Pinned)]
    {
        let [a, b, c] = lengths.map(beam);
        let tree = vec![ListStep::Tip(ends.0), a, b, c, ListStep::Root(ends.1)];
        let (system, exact) = (undamped::<f64>(&tree), undamped::<DoubleDouble>(&tree));
        let pairs = [1, 2].into_iter().flat_map(|load| [0, 1, 2, 3].map(|entry| (load, entry)));
        for (load, entry) in pairs {
            let (load, entry) = (point(load, false).force(), point(entry, false));
            for entry in [entry.deflection(), entry.rotation(), entry.moment(), entry.shear()] {
                for omega in [1e-8, 1e-4, 1e-2] {
                    let wide = Complex::new(DoubleDouble::from(0.0), DoubleDouble::from(omega));
                    let actual = system.frequency_response(load, entry).unwrap().at(omega).unwrap();
                    let expected = exact.frequency_response(load, entry).unwrap().at(wide).unwrap().re.to_f64();
                    // lengths and stiffnesses are of order one, and so are forces
                    assert!((actual - expected).abs() <= f64::EPSILON, "{ends:?} {omega}: {actual} {expected}");
                }
            }
        }
    }
}

/// Two oscillators that share nothing: the frequency of one depends on its own spring alone, `dω/dk = ω/(2k)`.
#[test]
fn close_roots_keep_their_own_sensitivities() {
    let (mass, held) = (ListStep::Element(Part::Mass(Mass { mass: 1.0 })), ListStep::Tip(Support::Fixed));
    let spring = |stiffness| ListStep::Element(Part::Spring(Spring { stiffness }));
    let free = ListStep::Tip(Support::Free);
    for gap in [1e-3, 1e-6, 1e-9] {
        let (first, second) = (4.0_f64, 4.0 * (1.0 + gap));
        let connection = ListStep::Connection(3);
        let tree = vec![
            free,
            mass,
            spring(first),
            free,
            mass,
            spring(second),
            held,
            connection,
            spring(1.0),
            ListStep::Root(Support::Fixed),
        ];
        let system = undamped::<f64>(&tree);
        for (stiffness, own, other) in [(first, 2, 5), (second, 5, 2)] {
            let omega = stiffness.sqrt();
            let (lambda, error) = (Complex::new(0.0, omega), f64::EPSILON);
            let root = Eigenvalue { lambda, error, multiplicity: 1, ..Eigenvalue::default() };
            let sensitivity = system.sensitivity(&root).unwrap();
            let [own, other] = [own, other].map(|step| sensitivity.of(system.parameter(step, "stiffness").unwrap()));
            let scale = omega / (2.0 * stiffness);
            let limit = 64.0 * f64::EPSILON * scale;
            assert!((own - Complex::new(0.0, scale)).norm() < limit, "{gap}: {own}");
            assert!(other.norm() < limit, "{gap}: {other}");
        }
    }
}
