//! What motions cost, in evaluations of Δ.

use super::counted::{Counted, Counts, Parts, count, count_of};
use crate::support::models::{self, DampedOscillator, RestrainedBeam, SpringAndMass, TipBody, TwoSpans};
use mstmm::element::{FrequencyPowers, Line, NoCount, Plane, PlaneStep, Space, StateSpace, Subspace};
use mstmm::elements::{Beam, Body, ElasticHinge, Mass, Spring, SpringDamper};
use mstmm::motion::Point;
use mstmm::number::{Dual, Frequency, Scalar};
use mstmm::prelude::*;
use mstmm::search::{Eigenvalue, NaturalFrequency};

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
            [RestrainedBeam::conn_2, RestrainedBeam::conn_4, RestrainedBeam::hinge_1.input()]
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

/// What all sensitivities of a root cost beyond four evaluations of Δ, in derivatives of a step per parameter of the sketch: the
/// step of an element on dual numbers is its derivative with respect to one of them.
macro_rules! sensitivities {
    ($model:expr, $root:expr, [$(($count:literal, $element:expr)),*]) => {{
        let (system, root) = ($model.build_as::<Counted>().unwrap(), $root);
        let x = mstmm::motion::Root::<Counted>::frequency(&root);
        let (own, _) = count(&system, x);
        let (counts, _) =
            count_of(|| system.sensitivity(&root).unwrap().iter().map(|(_, value)| value).collect::<Vec<_>>());
        let derivatives: usize = [$($count * step_derivative($element, x)),*].iter().sum();
        let beyond = |counts: usize, own: usize| (counts as f64 - 4.0 * own as f64) / derivatives as f64;
        beyond(counts.executed.total(), own.executed.total())
    }};
}

/// The operations of a step on dual numbers.
fn step_derivative<E, S>(element: E, x: S) -> usize
where
    S: Parts + Scalar,
    E: PlaneStep<Dual<S>>,
    Dual<S>: Frequency<Counted>,
{
    let Ok(built) = element.build() else { unreachable!("valid parameters") };
    let minors =
        [1.1, 1.2, 1.3, 1.4, 1.5].map(|minor| Dual { value: S::from_f64(minor), derivative: S::from_f64(minor) });
    let [y_theta, y_m, w, theta_q, m_q] = minors;
    let input = match E::State::SPACE {
        Space::Bending => Subspace::Plane(Plane { y_theta, y_m, w, theta_q, m_q, exponent: 0 }),
        space => Subspace::Line(Line { y: y_theta, q: y_m, exponent: 0 }, space),
    };
    let (counts, _) = count_of(|| {
        let at = FrequencyPowers::new(Dual::variable(x), E::WAVES);
        match E::step(&E::coefficients(&built, &at), input, &mut NoCount) {
            Subspace::Plane(p) => [p.y_theta, p.y_m, p.w, p.theta_q, p.m_q].into_iter().flat_map(both).collect(),
            other => [other.line().y, other.line().q].into_iter().flat_map(both).collect::<Vec<S>>(),
        }
    });
    counts.executed.total()
}

fn both<S>(number: Dual<S>) -> [S; 2] {
    [number.value, number.derivative]
}

/// A natural frequency of a model, as one of counted numbers.
macro_rules! natural_frequency {
    ($model:expr, $index:expr) => {{
        let root = $model.build().unwrap().first_frequencies::<8>().unwrap()[$index];
        let [omega, lower, upper] = [root.omega, root.lower, root.upper].map(Counted::from);
        NaturalFrequency { omega, lower, upper, multiplicity: 1, ..NaturalFrequency::default() }
    }};
}

fn beam(length: f64, bending_stiffness: f64, mass_per_length: f64) -> Beam<Counted> {
    Beam { length: length.into(), bending_stiffness: bending_stiffness.into(), mass_per_length: mass_per_length.into() }
}

#[test]
fn all_sensitivities_cost_four_evaluations_and_a_step_derivative_per_parameter() {
    let region = Region { re: -1e3..=1.0, im: 1.0..=20_000.0 };
    let damped = models::damped_oscillator().build().unwrap().eigenvalues::<16>(region).unwrap();
    let one = || Counted::from(1.0);
    let (stiffness, mass) = (Spring { stiffness: one() }, Mass { mass: one() });
    for index in [0, 2, 5] {
        let Eigenvalue { lambda, error, multiplicity, is_proven } = damped[index];
        let (lambda, error) = (Complex::new(lambda.re.into(), lambda.im.into()), error.into());
        let [tip, restrained] =
            [models::light_tip_body().bending_stiffness, models::restrained_beam().bending_stiffness];
        let body = Body { mass: one(), inertia: one(), output_x: one(), centre_x: one() };
        let hinge = ElasticHinge { stiffness_y: one(), stiffness_theta: one() };
        let both = SpringDamper { stiffness: one(), damping: one() };
        let beyond = [
            sensitivities!(
                models::light_tip_body(),
                natural_frequency!(models::light_tip_body(), index),
                [(3, beam(1.0, tip, 0.212)), (4, body)]
            ),
            sensitivities!(
                models::restrained_beam(),
                natural_frequency!(models::restrained_beam(), index),
                [(3, beam(1.0, restrained, 7.8)), (4, hinge)]
            ),
            sensitivities!(
                models::spring_and_mass(),
                natural_frequency!(models::spring_and_mass(), index),
                [(9, beam(0.3, 166.0, 0.78)), (1, stiffness), (1, mass)]
            ),
            sensitivities!(
                models::two_spans(),
                natural_frequency!(models::two_spans(), index),
                [(9, beam(0.4, restrained, 15.4)), (1, stiffness), (1, mass)]
            ),
            sensitivities!(
                models::damped_oscillator(),
                Eigenvalue { lambda, error, multiplicity, is_proven },
                [(12, beam(0.2, 63476.0, 15.3)), (2, stiffness), (1, mass), (2, both)]
            ),
        ];
        println!("all sensitivities of root {index} of 4.1 to 4.5: {beyond:.2?} step derivatives per parameter");
        assert!(beyond.iter().all(|beyond| *beyond <= 1.0), "{beyond:?}");
    }
}
