//! What motions cost, in evaluations of Δ.

use super::counted::{Counted, Counts, count, count_of};
use super::models::{self, DampedOscillator, RestrainedBeam, SpringAndMass, TipBody, TwoSpans};
use mstmm::Point;
use mstmm::prelude::*;

/// The dearest of all responses between some points, in evaluations of Δ.
macro_rules! dearest_response {
    ($model:expr, $of:ident, $x:expr, $points:expr) => {{
        let (system, x) = ($model.build_as::<Counted>().unwrap(), $x);
        let (own, _) = count(&system, x);
        let points: Vec<Point<$of>> = $points.into();
        let mut dearest = 0.0_f64;
        for (from, to) in points.iter().flat_map(|from| points.iter().map(move |to| (from, to))) {
            for load in [from.force(), from.torque()] {
                for entry in [to.deflection(), to.rotation(), to.moment(), to.shear()] {
                    let Ok(response) = system.frequency_response(load, entry) else { continue };
                    let (counts, _) = count_of(|| vec![response.at(x).unwrap()]);
                    dearest = dearest.max(evaluations(counts, own));
                }
            }
        }
        dearest
    }};
}

/// All operations of something as a multiple of those of Δ, both as executed and as needed.
fn evaluations(counts: Counts, of_delta: Counts) -> f64 {
    let ratio = |all: usize, own: usize| all as f64 / own as f64;
    let executed = ratio(counts.executed.total(), of_delta.executed.total());
    executed.max(ratio(counts.needed.total(), of_delta.needed.total()))
}

#[test]
fn a_response_costs_at_most_four_evaluations() {
    let lambda = Complex::new(Counted::from(-10.0), Counted::from(12_000.0));
    let dearest = [
        dearest_response!(models::light_tip_body(), TipBody, Counted::from(300.0), {
            [TipBody::beam_1.input(), TipBody::beam_1.output(), TipBody::body_2.output()]
        }),
        dearest_response!(models::restrained_beam(), RestrainedBeam, Counted::from(1000.0), {
            [RestrainedBeam::conn_2, RestrainedBeam::conn_4, RestrainedBeam::elastic_hinge_1.input()]
        }),
        dearest_response!(models::spring_and_mass(), SpringAndMass, Counted::from(2000.0), {
            let ends = [SpringAndMass::beam_1.input(), SpringAndMass::beam_7.output(), SpringAndMass::mass_6.input()];
            [&ends[..], &[SpringAndMass::conn_2, SpringAndMass::conn_5]].concat()
        }),
        dearest_response!(models::two_spans(), TwoSpans, Counted::from(10_000.0), {
            let ends = [TwoSpans::beam_1.input(), TwoSpans::beam_7.output(), TwoSpans::mass_6.input()];
            [&ends[..], &[TwoSpans::conn_2, TwoSpans::conn_4]].concat()
        }),
        dearest_response!(models::damped_oscillator(), DampedOscillator, lambda, {
            let ends = [DampedOscillator::beam_1.input(), DampedOscillator::beam_11.output()];
            let ends = [&ends[..], &[DampedOscillator::mass_7.input(), DampedOscillator::torsion_spring_10.output()]];
            [ends.concat(), vec![DampedOscillator::conn_2, DampedOscillator::conn_9]].concat()
        }),
    ];
    println!("dearest responses of 4.1 to 4.5: {dearest:.2?} evaluations");
    assert!(dearest.iter().all(|dearest| *dearest <= 4.0), "{dearest:?}");
}
