//! Motions of damped structures: responses beside those of a stiffness matrix, shapes at eigenvalues.

use crate::families::damped::damped_structure;
use crate::motions::balance::{largest_force, largest_gap, largest_sum};
use crate::oracle::Oracle;
use crate::stiffness_matrix::discs::C;
use crate::structure::Freedoms;
use crate::through_library::asked_to_decay;
use mstmm::Complex;
use mstmm::motion::PlanePoint;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

/// Part of the largest displacement, by condition, that responses may be off.
const PART: f64 = 1e-12;

/// Part of the largest force or displacement by which nothing in a shape may differ.
const OFF: f64 = 1e-11;

fn of(lambda: Complex<f64>) -> C {
    C::new(DoubleDouble::from(lambda.re), DoubleDouble::from(lambda.im))
}

fn size(values: impl IntoIterator<Item = [Complex<f64>; 3]>) -> f64 {
    values.into_iter().flatten().map(|value| value.norm()).fold(0.0, f64::max)
}

fn difference(one: &[[Complex<f64>; 3]], other: &[[Complex<f64>; 3]]) -> f64 {
    size(one.iter().zip(other).map(|(one, other)| [0, 1, 2].map(|k| one[k] - other[k])))
}

fn compare_responses(seeds: u64) {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for seed in 0..seeds {
        let structure = damped_structure(seed);
        let oracle = Oracle::damped(&structure);
        let exact = |lambda: Complex<f64>, node: usize| {
            let values = oracle.response(of(lambda), node, 0)?;
            Some(values.iter().map(|node| node.map(|v| Complex::new(v.re.to_f64(), v.im.to_f64()))).collect::<Vec<_>>())
        };
        for lambda in [Complex::new(0.0, 0.83), Complex::new(-0.4, 5.1), Complex::new(-0.01, 61.0)] {
            let free = |node: &usize| structure.nodes[*node].held == Freedoms::NONE;
            let Some(node) = (0..structure.nodes.len()).filter(free).nth((seed % 2) as usize) else { continue };
            let beside = lambda * (1.0 + 1e-9);
            let (Some(exact), Some(beside)) = (exact(lambda, node), exact(beside, node)) else { continue };
            let largest = size(exact.iter().copied());
            if largest == 0.0 {
                continue;
            }
            let found = asked_to_decay(&structure, |network| {
                let point = PlanePoint::node(node);
                let response = network.frequency_response(point.force_x(), point.displacement_x());
                let states =
                    response.and_then(|response| response.states(lambda)).map_err(|error| error.to_string())?;
                (0..structure.nodes.len()).map(|node| states.node(node).map_err(|error| error.to_string())).collect()
            });
            assert!(found.is_ok(), "{seed} at {lambda}: {found:?}");
            let found: Vec<_> = found.unwrap_or_default();
            let condition = 1.0 + difference(&beside, &exact) / largest / 1e-9;
            let error = difference(&found, &exact) / largest / condition;
            assert!(error <= PART, "{seed} at {lambda}, node {node}: {error:e}");
            (compared, worst) = (compared + 1, worst.max(error));
        }
    }
    println!("{compared} responses of damped structures, worst {worst:.1e} of the largest by condition");
    assert!(compared as u64 > 2 * seeds);
}

#[test]
fn responses_of_damped_structures_are_those_of_a_stiffness_matrix() {
    compare_responses(24);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn responses_of_hundreds_of_damped_structures_are_those_of_a_stiffness_matrix() {
    compare_responses(300);
}

fn look_at_shapes(seeds: u64) {
    let (mut shapes, mut refused, mut worst) = (0, 0, [0.0_f64; 3]);
    for seed in 0..seeds {
        let structure = damped_structure(seed);
        let told = asked_to_decay(&structure, |network| {
            let roots = network.first_eigenvalues::<8>().map_err(|error| error.to_string())?;
            let simple = roots.iter().filter(|root| root.multiplicity == 1 && root.lambda.norm() > root.error);
            let all: Vec<_> = simple.map(|root| network.mode_shape(root)).collect();
            let refused = all.iter().filter(|shape| shape.is_err()).count();
            let found: Vec<_> = all.into_iter().flatten().collect();
            let mut worst = [0.0_f64; 3];
            for (k, one) in found.iter().enumerate() {
                let sum = largest_sum(&structure, one) / largest_force(&structure, one, one.frequency().norm());
                let products = found[..k].iter().map(|other| one.product(other).norm());
                let product = products.fold((one.modal_mass() - 1.0).norm(), f64::max);
                let seen = [sum, largest_gap(&structure, one), product];
                worst = [0, 1, 2].map(|kind| worst[kind].max(seen[kind]));
            }
            Ok((found.len(), refused, worst))
        });
        let Ok((found, lost, off)) = told else { continue };
        let is_right = off[0] < OFF && off[1] < OFF && off[2] < 1e-8;
        assert!(is_right, "{seed}: {off:?}");
        (shapes, refused, worst) = (shapes + found, refused + lost, [0, 1, 2].map(|kind| worst[kind].max(off[kind])));
    }
    let [sum, gap, product] = worst;
    println!(
        "{shapes} shapes of damped structures, {refused} refused; sums of forces {sum:.1e}, differences of displacements {gap:.1e}, \
         products {product:.1e}"
    );
    assert!(shapes > 20 * refused);
}

#[test]
fn shapes_of_damped_structures_fit_together_and_are_orthogonal() {
    look_at_shapes(10);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn shapes_of_hundreds_of_damped_structures_fit_together_and_are_orthogonal() {
    look_at_shapes(300);
}
