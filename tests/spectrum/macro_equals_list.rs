//! Models of `system!` against the lists of steps of the same trees, bit for bit; and Δ of the plane method against the
//! determinant of the overall matrix.
//!
//! The models are written by `written_models_are_those_of_the_generator`: with `WRITE_MODELS=1` in the environment it
//! writes the files instead of comparing them.
#![expect(clippy::unwrap_used, reason = "the trees here are valid")]

mod write_models;

use crate::damped_models::for_each_damped;
use crate::oracles::finite_elements::Model;
use crate::oracles::legendre_beam::LegendreBeam;
use crate::support::list_of_tree::{any_steps, undamped_steps};
use crate::support::random_tree::{Random, random_tree};
use crate::support::tree::{Tree, next_space};
use crate::undamped_models::for_each_undamped;
use mstmm::Complex;
use mstmm::element::{ParameterError, SMatrix, Space};
use mstmm::list::{ListStep, StepList};
use mstmm::number::{Scaled, Single};
use mstmm::search::{Characteristic, Evaluate, ManyFrequencies, System};
use mstmm::search::{NaturalFrequencies, Undamped};
use nalgebra::DMatrix;

type C = Complex<f64>;

/// Beams of a tree.
const BEAMS: usize = 3;

/// The models are in the package's source.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/support");

/// The first trees of moderate size that have a spectrum.
fn trees(count: usize, damped: bool) -> Vec<(u64, Tree)> {
    let element = LegendreBeam::new(4);
    let usable = |seed: u64| {
        let tree = random_tree(seed, BEAMS, damped);
        let moderate = (5..30).contains(&tree.len()) && tree.iter().any(|step| matches!(step, ListStep::Connection(_)));
        let has_spectrum = Model::of(&tree, &element).is_some_and(|model| model.check().is_ok());
        let has_dashpot = format!("{tree:?}").contains("Damper");
        (moderate && has_spectrum && damped == has_dashpot).then_some((seed, tree))
    };
    (0..).filter_map(usable).take(count).collect()
}

#[test]
fn written_models_are_those_of_the_generator() {
    for (kind, trees) in [("Undamped", trees(24, false)), ("Damped", trees(16, true))] {
        let file = format!("{FOLDER}/{}_models.rs", kind.to_ascii_lowercase());
        let source = write_models::source(kind, &trees);
        if std::env::var_os("WRITE_MODELS").is_some() {
            std::fs::write(&file, &source).unwrap();
        }
        assert!(std::fs::read_to_string(&file).unwrap() == source, "{file}: not the models of the generator");
    }
}

/// Random frequencies, small and large.
fn frequencies(seed: u64) -> impl Iterator<Item = f64> {
    let mut random = Random(seed);
    (0..8).map(move |_| 10f64.powf(4.0 * random.unit() - 1.5))
}

/// Number of unknowns at the boundaries of a tree: half of the entries of each boundary's state.
fn unknowns(tree: &Tree) -> usize {
    // space of each open path, `None` for a support that leads to a connection
    let mut open: Vec<Option<Space>> = Vec::new();
    let mut sum = 0;
    for (index, step) in tree.iter().enumerate() {
        let next = next_space(tree, index);
        match step {
            ListStep::Tip(_) => {
                open.push(next);
                sum += next.map_or(0, |space| space.size() / 2);
            }
            ListStep::Element(part) => *open.last_mut().unwrap() = Some(part.space()),
            ListStep::Connection(inputs) => {
                let inputs = open.split_off(open.len() - inputs);
                let known = inputs.iter().flatten().copied().chain(next);
                let space = known.reduce(|a, b| a.join(b).unwrap()).unwrap();
                sum += inputs.iter().filter(|input| input.is_none()).count() * space.size() / 2;
                open.push(Some(next.unwrap_or(space)));
            }
            ListStep::Root(_) => sum += open[0].unwrap().size() / 2,
        }
    }
    sum
}

/// Numbers without sign of zero and exponent are equal only if all bits are.
fn assert_same_bits<S: Single>(actual: Scaled<S>, expected: Scaled<S>, seed: u64) {
    assert_eq!(format!("{actual:?}"), format!("{expected:?}"), "seed {seed}");
}

/// `det U_all` over Δ is one constant. The error of the determinant is that of elimination: `N²` roundings, relative to
/// the product of the norms of its rows once the columns have norm one.
fn check_proportional<Y, const N: usize>(seed: u64, system: &Y, tree: &Tree)
where
    Y: Characteristic<C> + Evaluate<C, Matrix = SMatrix<C, N, N>>,
{
    assert_eq!(N, unknowns(tree), "seed {seed}: size of the overall matrix");
    let mut random = Random(seed);
    let mut constant: Option<(C, f64)> = None;
    for _ in 0..6 {
        let lambda = C::new(random.unit() - 0.5, 0.5 + random.unit());
        let (determinant, delta) = (system.overall_determinant(lambda), system.characteristic(lambda));
        let exponent = determinant.exponent() - delta.exponent();
        let ratio = Scaled::new(determinant.mantissa() / delta.mantissa(), exponent).value();
        let mut matrix = DMatrix::from_iterator(N, N, system.overall_matrix(lambda).iter().copied());
        for mut column in matrix.column_iter_mut() {
            let norm = column.norm();
            column.iter_mut().for_each(|entry| *entry /= norm);
        }
        let size: f64 = matrix.row_iter().map(|row| row.norm()).product();
        let error = (N * N) as f64 * f64::EPSILON * size / matrix.determinant().norm();
        let (first, bound) = *constant.get_or_insert((ratio, error));
        let difference = (ratio / first - 1.0).norm();
        assert!(difference <= bound + error, "seed {seed}: {ratio} at {lambda}, {first} elsewhere");
    }
}

#[test]
fn undamped_models_equal_their_lists() {
    fn check<Y, const N: usize>(seed: u64, system: Result<Y, ParameterError>)
    where
        Y: Undamped + Characteristic<C> + System<Parameter = f64> + Evaluate<C, Matrix = SMatrix<C, N, N>>,
    {
        let (system, tree) = (system.unwrap(), random_tree(seed, BEAMS, false));
        let steps = undamped_steps(&tree);
        let list = StepList::new(&steps).unwrap();
        for omega in frequencies(seed) {
            assert_same_bits(system.characteristic(omega), list.characteristic(omega), seed);
            assert_eq!(system.count_below(omega), list.count_below(omega), "seed {seed}");
            let lambda = C::new(0.3 * omega, omega);
            assert_same_bits(system.characteristic(lambda), list.characteristic(lambda), seed);
        }
        let omegas: Vec<f64> = frequencies(seed).collect();
        let mut values = vec![Scaled::new(0.0, 0); omegas.len()];
        system.characteristics(&omegas, &mut values).unwrap();
        for (value, omega) in values.into_iter().zip(omegas) {
            assert_same_bits(value, list.characteristic(omega), seed);
        }
        check_proportional(seed, &system, &tree);
    }
    for_each_undamped!(check);
}

#[test]
fn damped_models_equal_their_lists() {
    fn check<Y, const N: usize>(seed: u64, system: Result<Y, ParameterError>)
    where
        Y: Characteristic<C> + Evaluate<C, Matrix = SMatrix<C, N, N>>,
    {
        let (system, tree) = (system.unwrap(), random_tree(seed, BEAMS, true));
        let steps = any_steps(&tree);
        let list = StepList::new(&steps).unwrap();
        for omega in frequencies(seed) {
            let lambda = C::new(-0.1 * omega, omega);
            assert_same_bits(system.characteristic(lambda), list.characteristic(lambda), seed);
        }
        check_proportional(seed, &system, &tree);
    }
    for_each_damped!(check);
}
