//! Random subspaces for the laws of the plane method, spanned by states, and their coordinates.

use crate::element::{Element, PlaneStep};
use crate::elements::laws::{C, Rows, Sample, built};
use crate::model::StateSpace;
use crate::number::{FrequencyPowers, Scalar};
use crate::subspace::{Line, NoCount, Plane, Subspace};
use core::f64::consts::TAU;
use mstmm_plan::{Space, Support};
use proptest::test_runner::TestRunner;
use std::vec;
use std::vec::Vec;

/// Runs laws over all elements of the plane method, and laws of undamped elements over those among them.
macro_rules! laws_of_steps {
    (
        undamped { $($element:ident { $($_field:ident),* })* }
        damped { $($damped:ident { $($_damped_field:ident),* })* }
        spinning { $($spinning:ident)* } spinning damped { $($spinning_damped:ident)* }
    ) => {
        macro_rules! for_each_stepping_element {
            ($law:ident) => {
                $($law::<$crate::elements::$element<f64>>();)*
                $($law::<$crate::elements::$damped<f64>>();)*
                $($law::<$crate::elements::$spinning<f64>>();)*
                $($law::<$crate::elements::$spinning_damped<f64>>();)*
            };
        }
        macro_rules! for_each_undamped_stepping_element {
            ($law:ident) => {
                $($law::<$crate::elements::$element<f64>>();)*
                $($law::<$crate::elements::$spinning<f64>>();)*
            };
        }
        pub(super) use {for_each_stepping_element, for_each_undamped_stepping_element};
    };
}
crate::elements::stepping_elements!(laws_of_steps);

/// Runs a law on random samples of an element, random λ with a modulus in the given decades, and eight random numbers
/// in [-1, 1] for the states; a failure shows the law's own line and the element.
#[track_caller]
pub(super) fn check<E: Sample>(decades: core::ops::Range<f64>, law: impl Fn(E, C, &[f64])) {
    let parameters = proptest::collection::vec(0.5..2.0f64, 12);
    let states = proptest::collection::vec(-1.0..1.0f64, 8);
    let run = TestRunner::deterministic().run(
        &(parameters, states, decades, 0.0..TAU),
        |(parameters, states, decade, phase)| {
            let mut parameters = parameters.into_iter();
            let element = E::sample(|| parameters.next().unwrap());
            law(element, C::from_polar(10f64.powf(decade), phase), &states);
            Ok(())
        },
    );
    if let Err(error) = run {
        panic!("{}: {error}", core::any::type_name::<E>());
    }
}

/// States that span a random subspace which a path of reciprocal elements can leave at its end: all of a two-entry
/// state, in bending those with `p_YQ = p_ΘM`. With `imaginary = 0` they are real.
pub(super) fn random_states(space: Space, numbers: &[f64], imaginary: f64) -> Rows {
    let entry = |k: usize| C::new(numbers[k], imaginary * numbers[(k + 3) % 8]);
    if space.size() == 2 {
        return vec![vec![entry(0), entry(1)]];
    }
    // graph of a symmetric stiffness over Y and Θ, then another basis of the same plane
    let first = [C::ONE, C::ZERO, entry(0), entry(1)];
    let second = [C::ZERO, C::ONE, entry(2), -entry(0)];
    let (a, b) = (entry(3), entry(4));
    let mixed = |k: usize| (first[k] + a * second[k], b * first[k] + (a * b + 2.0) * second[k]);
    vec![(0..4).map(|k| mixed(k).0).collect(), (0..4).map(|k| mixed(k).1).collect()]
}

/// States that span the subspace of a support: the unit vectors of its unknowns.
pub(super) fn states_of_tip(space: Space, support: Support) -> Rows {
    let unit = |unknown| space.coordinates().iter().map(|&c| C::from(if c == unknown { 1.0 } else { 0.0 })).collect();
    support.unknowns(space).map(unit).collect()
}

/// Supports of a space.
pub(super) fn supports(space: Space) -> Vec<Support> {
    Support::ALL.into_iter().filter(|support| support.exists_in(space)).collect()
}

/// Coordinates of the subspace that states span, by their definition: `(y, q)`, in rotation paths `(θ, -μ)`, or the
/// minors `[p_YΘ, p_YM, p_YQ, p_ΘQ, p_MQ]`.
pub(super) fn coordinates(space: Space, states: &Rows) -> Vec<C> {
    let sign = if space.is(Space::Rotation) { -1.0 } else { 1.0 };
    match states.as_slice() {
        [line] => vec![line[0], line[1] * sign],
        [a, b] => MINORS.iter().map(|&(i, j)| a[i] * b[j] - a[j] * b[i]).collect(),
        _ => panic!("{} states", states.len()),
    }
}

/// Rows of the minors of a plane.
pub(super) const MINORS: [(usize, usize); 5] = [(0, 1), (0, 2), (0, 3), (1, 3), (2, 3)];

/// A line or plane with given coordinates.
pub(super) fn subspace<S: Scalar>(space: Space, coordinates: &[S]) -> Subspace<S> {
    match *coordinates {
        [y, q] => Subspace::Line(Line { y, q, exponent: 0 }, space),
        [y_theta, y_m, w, theta_q, m_q] => Subspace::Plane(Plane { y_theta, y_m, w, theta_q, m_q, exponent: 0 }),
        _ => panic!("{} coordinates", coordinates.len()),
    }
}

/// Coordinates of a subspace that is not a tip, and their power of two.
pub(super) fn read<S: Scalar>(subspace: Subspace<S>) -> (Vec<S>, i32) {
    match subspace {
        Subspace::Tip(..) => panic!("a tip has no coordinates"),
        Subspace::Grounded(..) | Subspace::Line(..) => {
            let Line { y, q, exponent } = subspace.line();
            (vec![y, q], exponent)
        }
        Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => {
            let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = subspace.plane();
            (vec![y_theta, y_m, w, theta_q, m_q], exponent)
        }
    }
}

/// Coordinates in plain numbers.
pub(super) fn plain<S: Scalar>(subspace: Subspace<S>) -> Vec<S> {
    let (coordinates, exponent) = read(subspace);
    coordinates.into_iter().map(|x| x.times_power_of_two(exponent)).collect()
}

/// Space of an element's states.
pub(super) fn space<E: Element>() -> Space {
    E::State::SPACE
}

/// The step of an element at a frequency.
pub(super) fn step<E, S>(element: &E, x: S, input: Subspace<S>) -> Subspace<S>
where
    S: crate::number::frequency::Frequency<f64>,
    E: Sample + PlaneStep<S>,
{
    E::step(&E::coefficients(&built(*element), &FrequencyPowers::new(x, E::WAVES)), input, &mut NoCount)
}
