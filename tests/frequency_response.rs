//! Responses to harmonic loads against closed forms, sums over modes, and reciprocity.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(missing_docs)]

#[path = "../examples/paper/models.rs"]
mod models;

use models::*;
use mstmm::Point;
use mstmm::prelude::*;

system! {
    /// Beam with supports at its ends as the models below need them.
    pub struct Cantilever { l: f64, ei: f64, m: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> free;
}

system! {
    pub struct Simple { a: f64, b: f64, ei: f64, m: f64 }
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
