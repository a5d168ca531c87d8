//! The count of every element, against Sylvester's inertia.

use crate::element::{MatrixOf, PlaneStep, TransferMatrix};
use crate::elements::laws::subspaces::{
    check, coordinates, for_each_undamped_stepping_element, random_states, space, subspace, supports,
};
use crate::elements::laws::{C, Rows, Sample, built, rows};
use crate::number::FrequencyPowers;
use crate::subspace::{Connecting, NoCount, Subspace, WittrickWilliams};
use core::ops::Index;
use std::vec::Vec;

/// Decades of ω up to 2: no beam of the samples has a frequency of its own there when both ends are clamped, since
/// z = 2.83 ω^(1/2) at most, below 4.73. Lumped elements have none anywhere.
const BELOW_CLAMPED_FREQUENCIES: core::ops::Range<f64> = -3.0..0.3;

/// A symmetric matrix of one or two rows.
#[derive(Clone, Copy, Debug)]
enum Stiffness {
    Line(f64),
    Plane([f64; 3]),
}

impl Stiffness {
    /// Number of negative eigenvalues, and the ratio of the one nearest to zero to the largest.
    fn inertia(self) -> (u64, f64) {
        match self {
            Stiffness::Line(k) => (u64::from(k < 0.0), 1.0),
            Stiffness::Plane([a, b, d]) => {
                let (mean, radius) = ((a + d) / 2.0, ((a - d) / 2.0).hypot(b));
                let (low, high) = (mean - radius, mean + radius);
                let negative = u64::from(low < 0.0) + u64::from(high < 0.0);
                (negative, low.abs().min(high.abs()) / low.abs().max(high.abs()))
            }
        }
    }

    fn plus(self, other: Stiffness) -> Stiffness {
        match (self, other) {
            (Stiffness::Line(a), Stiffness::Line(b)) => Stiffness::Line(a + b),
            (Stiffness::Plane(a), Stiffness::Plane(b)) => Stiffness::Plane(core::array::from_fn(|k| a[k] + b[k])),
            _ => panic!("stiffnesses of different size"),
        }
    }

    /// Stiffness of the end of a path, from its coordinates: `-q/y`, or `[[p_ΘQ, -w], [-w, p_YM]]/p_YΘ`.
    fn of_path(coordinates: &[f64]) -> Stiffness {
        match *coordinates {
            [y, q] => Stiffness::Line(-q / y),
            [y_theta, y_m, w, theta_q, _] => Stiffness::Plane([theta_q / y_theta, -w / y_theta, y_m / y_theta]),
            _ => panic!("{} coordinates", coordinates.len()),
        }
    }

    /// Stiffness of the input end of an element whose output end is held: with `U = [[A, B], [C, D]]` for displacements
    /// and forces, `force = -B⁻¹ A displacement`. `None` where no force, or a force in one direction alone, moves the ends apart.
    fn of_input_end(space: mstmm_plan::Space, u: &Rows) -> Option<Stiffness> {
        let entry = |i: usize, j: usize| u[i][j].re;
        if u.len() == 2 {
            // the element pushes back with -q, in rotation paths with μ
            let sign = if space.is(mstmm_plan::Space::Rotation) { -1.0 } else { 1.0 };
            return (entry(0, 1) != 0.0).then(|| Stiffness::Line(-entry(0, 0) / entry(0, 1) * sign));
        }
        let determinant = entry(0, 2) * entry(1, 3) - entry(0, 3) * entry(1, 2);
        if determinant == 0.0 {
            return None;
        }
        // rows of -B⁻¹ A: moment, then force
        let moment = |j: usize| -(entry(1, 3) * entry(0, j) - entry(0, 3) * entry(1, j)) / determinant;
        let force = |j: usize| -(entry(0, 2) * entry(1, j) - entry(1, 2) * entry(0, j)) / determinant;
        // the path has moment = K Θ and force = -K Y, the element the opposite
        Some(Stiffness::Plane([force(0), force(1), -moment(1)]))
    }

    /// The sum of stiffnesses in the direction in which alone the ends of an element move apart, against springs; none if there is
    /// no such direction.
    fn in_the_only_soft_direction(self, u: &Rows) -> Option<Stiffness> {
        let Stiffness::Plane([a, _, d]) = self else { return None };
        let (by_moment, by_force) = (u[1][2].re, u[0][3].re);
        if by_moment == 0.0 && by_force == 0.0 {
            return None;
        }
        assert!((by_moment == 0.0) != (by_force == 0.0) && u[0][2].re == 0.0 && u[1][3].re == 0.0, "{u:?}");
        Some(Stiffness::Line(if by_force == 0.0 { d + 1.0 / by_moment } else { a - 1.0 / by_force }))
    }
}

/// Elements that can be evaluated at a real frequency count the negative eigenvalues of the stiffness at their input end,
/// of the path before and their own: that point is inside the system from now on.
fn a_step_counts_the_inertia_of_what_it_eliminates<E>()
where
    E: Sample + PlaneStep<f64> + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check(BELOW_CLAMPED_FREQUENCIES, |element: E, lambda, numbers| {
        let (omega, space) = (lambda.norm(), space::<E>());
        // of the size of the elements' own stiffnesses, so that sums change their sign
        let near_own: Vec<f64> = numbers.iter().map(|x| x * 2.0).collect();
        let states = random_states(space, &near_own, 0.0);
        let input: Vec<f64> = coordinates(space, &states).iter().map(|z| z.re).collect();
        let mut count = WittrickWilliams::<f64>::default();
        let coefficients = E::coefficients(&built(element), &FrequencyPowers::new(omega, E::WAVES));
        E::step(&coefficients, subspace(space, &input), &mut count);
        let (path, u) = (Stiffness::of_path(&input), rows(&element, C::new(0.0, omega)));
        let own = Stiffness::of_input_end(space, &u);
        let alone = || path.in_the_only_soft_direction(&u).map_or((0, 1.0), Stiffness::inertia);
        let expected = own.map_or_else(alone, |own| path.plus(own).inertia());
        // an eigenvalue so near zero may fall on either side by the rounding of the oracle
        if expected.1 > 1e-9 {
            assert_eq!(count.below(), expected.0, "{element:?} at {omega} behind {input:?}");
        }
    });
}

/// The last step before the root counts as a step and the root do, and Δ is the same with and without a count.
fn a_step_into_the_root_counts_as_a_step_and_the_root<E>()
where
    E: Sample + PlaneStep<f64>,
{
    check(-4.0..2.5, |element: E, lambda, numbers| {
        let coefficients = E::coefficients(&built(element), &FrequencyPowers::new(lambda.norm(), E::WAVES));
        let space = space::<E>();
        let random: Vec<f64> = coordinates(space, &random_states(space, numbers, 0.0)).iter().map(|z| z.re).collect();
        let mut inputs: Vec<_> = supports(space).into_iter().map(|support| Subspace::Tip(support, space)).collect();
        inputs.push(subspace(space, &random));
        for input in inputs {
            for support in supports(space) {
                let (mut short, mut long) = (WittrickWilliams::<f64>::default(), WittrickWilliams::<f64>::default());
                let root = E::root(&coefficients, input, support, &mut short);
                let behind = E::step(&coefficients, input, &mut long);
                assert_eq!((root, short), (behind.at_root(support, &mut long), long));
                assert_eq!(root, E::root(&coefficients, input, support, &mut NoCount));
            }
        }
    });
}

/// Two halves of an element count as the whole does, far above its own clamped frequencies: z up to 90. What the halves
/// eliminate on their own is the point between them.
fn two_halves_count_as_the_whole<E>()
where
    E: Sample + PlaneStep<f64>,
{
    check(-3.0..3.0, |element: E, lambda, numbers| {
        let Some(half) = element.halves() else { return };
        let at = FrequencyPowers::new(lambda.norm(), E::WAVES);
        let [whole, half] = [element, half].map(|element| E::coefficients(&built(element), &at));
        let space = space::<E>();
        let input: Vec<f64> = coordinates(space, &random_states(space, numbers, 0.0)).iter().map(|z| z.re).collect();
        for support in supports(space) {
            let (mut once, mut twice) = (WittrickWilliams::<f64>::default(), WittrickWilliams::<f64>::default());
            E::step(&whole, subspace(space, &input), &mut once).at_root(support, &mut once);
            let middle = E::step(&half, subspace(space, &input), &mut twice);
            E::step(&half, middle, &mut twice).at_root(support, &mut twice);
            // a lever may cancel in one step where it does not in two
            assert_eq!(once.below(), twice.below(), "{element:?} at {lambda} behind {input:?}, then {support:?}");
        }
    });
}

#[test]
fn counts_of_undamped_elements() {
    for_each_undamped_stepping_element!(a_step_counts_the_inertia_of_what_it_eliminates);
    for_each_undamped_stepping_element!(a_step_into_the_root_counts_as_a_step_and_the_root);
    for_each_undamped_stepping_element!(two_halves_count_as_the_whole);
}
