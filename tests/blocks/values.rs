//! Evaluations in blocks against evaluations alone: every bit, on every instruction set, whatever is beside a frequency.
#![expect(clippy::unwrap_used, reason = "the trees here are valid")]

use crate::support::list_of_tree::{any_steps, undamped_steps};
use crate::support::models;
use crate::support::random_tree::{Random, random_tree};
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::{AnyUndamped, ListStep, Room, StepList};
use mstmm::number::{DoubleDouble, Dual, Frequency, InLanes, Scaled};
use mstmm::prelude::*;
use mstmm::search::{InBlocks, SearchError, System};
use mstmm_lanes::InstructionSet;
use proptest::prelude::*;

type C = Complex<f64>;

/// Most steps of a list here.
const STEPS: usize = 320;

/// Numbers are the same only if all bits are; `Debug` shows the sign of zero, and all NaN alike.
fn bits<S: mstmm::number::Single>(value: Scaled<S>) -> String {
    format!("{value:?}")
}

/// Asserts that values in blocks are those alone, on every instruction set.
pub(crate) fn assert_values<Y, S>(system: &Y, frequencies: &[S])
where
    S: Frequency<Y::Parameter> + InLanes,
    Y: InBlocks<S> + System,
{
    for set in InstructionSet::ALL {
        let set = set.limit();
        let mut values = vec![Scaled::new(S::zero(), 0); frequencies.len()];
        system.characteristics(frequencies, &mut values).unwrap();
        for (value, &x) in values.iter().zip(frequencies) {
            assert_eq!(bits(*value), bits(Characteristic::<S>::characteristic(system, x)), "at {x:?} on {set:?}");
        }
    }
}

/// The same for counts.
pub(crate) fn assert_counts<Y: Undamped + System<Parameter = f64>>(system: &Y, omegas: &[f64]) {
    for set in InstructionSet::ALL {
        let set = set.limit();
        let mut counts = vec![Ok(0); omegas.len()];
        system.counts_below(omegas, &mut counts).unwrap();
        for (count, &omega) in counts.iter().zip(omegas) {
            // as text: an error that carries a NaN is not equal to itself
            assert_eq!(format!("{count:?}"), format!("{:?}", system.count_below(omega)), "at {omega} on {set:?}");
        }
    }
}

/// Frequencies of all sizes without any order, and what is none.
pub(crate) fn frequencies(seed: u64, count: usize) -> Vec<f64> {
    let mut random = Random(seed);
    let mut all: Vec<f64> = (0..count).map(|_| 10f64.powf(14.0 * random.unit() - 5.0)).collect();
    for (place, odd) in [0.0, -3.0, f64::NAN, f64::INFINITY, 1e-160, 1e160, f64::MAX, 5e-324].into_iter().enumerate() {
        if let Some(omega) = all.get_mut(7 * place + 2) {
            *omega = odd;
        }
    }
    all
}

fn check_undamped<Y>(system: &Y, end: f64)
where
    Y: InBlocks<f64> + InBlocks<Dual<f64>> + InBlocks<C> + Undamped + System<Parameter = f64>,
{
    let scan: Vec<f64> = (1..=150).map(|k| end * f64::from(k) / 150.0).collect();
    for omegas in [scan, frequencies(1, 97)] {
        assert_values(system, &omegas);
        assert_counts(system, &omegas);
        assert_values(system, &omegas.iter().map(|&omega| Dual::variable(omega)).collect::<Vec<_>>());
        assert_values(system, &omegas.iter().map(|&omega| C::new(-0.01 * omega, omega)).collect::<Vec<_>>());
    }
}

#[test]
fn the_examples_of_the_paper() {
    check_undamped(&models::light_tip_body().build().unwrap(), 1700.0);
    check_undamped(&models::restrained_beam().build().unwrap(), 3000.0);
    check_undamped(&models::spring_and_mass().build().unwrap(), 2000.0);
    check_undamped(&models::two_spans().build().unwrap(), 2e7);
    let damped = models::damped_oscillator().build().unwrap();
    let lambdas: Vec<C> = (0..150).map(|k| C::new(-2.0 * f64::from(k), 80.0 * f64::from(k))).collect();
    for lambdas in [lambdas, frequencies(2, 97).iter().map(|&omega| C::new(-0.1 * omega, omega)).collect()] {
        assert_values(&damped, &lambdas);
        assert_values(&damped, &lambdas.iter().map(|&lambda| Dual::variable(lambda)).collect::<Vec<_>>());
    }
}

system! {
    /// A beam that hangs on a string on a foundation, with a shaft and a rod.
    struct Hung { k: f64, soil: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 3.0, mass_per_length: 2.0 } -> conn 2
        -> beam 3 { length: 0.5, bending_stiffness: 3.0, mass_per_length: 2.0 } -> free;
    fixed -> string 4 { length: 0.8, tension: 5.0, mass_per_length: 0.4, foundation_stiffness: k } -> mass 5 { mass: 0.3 }
        -> rod 6 { length: 0.7, axial_stiffness: 90.0, mass_per_length: 1.1, foundation_stiffness: soil } -> conn 2;
    free -> inertia 7 { inertia: 0.02 } -> shaft 8 { length: 1.2, torsional_stiffness: 7.0, inertia_per_length: 0.3 } -> conn 2;
}

/// Waves that decay, so that lanes beyond the limit of waves are evaluated alone, and waves that travel.
#[test]
fn strings_rods_and_shafts() {
    for k in [0.0, 1e3, 1e9] {
        check_undamped(&Hung { k, soil: 0.3 * k }.build().unwrap(), 300.0);
    }
}

#[test]
fn other_scalars() {
    let omegas = frequencies(3, 40);
    let single = models::two_spans().build_as::<f32>().unwrap();
    assert_values(&single, &omegas.iter().map(|&omega| omega as f32).collect::<Vec<_>>());
    let double = models::two_spans().build_as::<DoubleDouble>().unwrap();
    assert_values(&double, &omegas.iter().map(|&omega| DoubleDouble::from(omega)).collect::<Vec<_>>());
    let undamped = models::two_spans().build().unwrap();
    assert_values(&undamped, &omegas.iter().map(|&omega| DoubleDouble::from(omega)).collect::<Vec<_>>());
}

/// Every kind of element, support, branch, narrowing and widening.
fn check_tree(seed: u64, count: usize) {
    let omegas = frequencies(seed, count);
    let steps = undamped_steps(&random_tree(seed, 5, false));
    if let Ok(list) = StepList::new(&steps) {
        let mut room = Room::<STEPS>::new();
        let list = list.planned(&mut room).unwrap();
        assert_values(&list, &omegas);
        assert_counts(&list, &omegas);
    }
    let steps = any_steps(&random_tree(seed, 5, true));
    if let Ok(list) = StepList::new(&steps) {
        let mut room = Room::<STEPS>::new();
        let list = list.planned(&mut room).unwrap();
        let lambdas: Vec<C> = omegas.iter().map(|&omega| C::new(-0.1 * omega, omega)).collect();
        assert_values(&list, &lambdas);
    }
}

/// Trees in which lanes leave the range of the others, and some more.
#[test]
fn trees_at_the_ends_of_the_range() {
    for seed in [272, 421, 5472, 10_360, 11_456, 19_500].into_iter().chain(0..10) {
        check_tree(seed, 64);
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn more_trees() {
    for seed in 10..150 {
        check_tree(seed, 64);
    }
}

/// Connections that lead to connections, and one path alone through a connection.
#[test]
fn connections_in_a_row() {
    let spring = |stiffness| mstmm::elements::Spring { stiffness }.try_into().unwrap();
    let beam = |length| Beam { length, bending_stiffness: 3.0, mass_per_length: 0.2 }.try_into().unwrap();
    let tip = |support| ListStep::Tip(support);
    let steps: [ListStep<AnyUndamped<f64>>; 16] = [
        tip(Support::Fixed),
        ListStep::Element(beam(1.0)),
        tip(Support::Pinned),
        ListStep::Connection(2),
        ListStep::Connection(1),
        ListStep::Element(beam(0.7)),
        tip(Support::Free),
        ListStep::Element(beam(0.4)),
        tip(Support::Fixed),
        ListStep::Element(spring(5.0)),
        ListStep::Connection(2),
        ListStep::Connection(2),
        ListStep::Connection(1),
        ListStep::Element(beam(2.0)),
        ListStep::Connection(1),
        ListStep::Root(Support::Free),
    ];
    let mut room = Room::<STEPS>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    let near: Vec<f64> =
        list.first_frequencies::<8>().unwrap().iter().flat_map(|root| [root.lower, root.omega, root.upper]).collect();
    for omegas in [frequencies(5, 64), near] {
        assert_values(&list, &omegas);
        assert_counts(&list, &omegas);
    }
}

/// Where the square root has branches: parts that vanish beside others.
#[test]
fn lopsided_eigenvalues() {
    let system = models::light_tip_body().build().unwrap();
    let parts = [0.0, -0.0, 1e-310, 1e-160, 1e-3, 7.0, 1e18, 1e60];
    let lambdas: Vec<C> = parts.iter().flat_map(|&re| parts.map(|im| C::new(-re, im))).collect();
    assert_values(&system, &lambdas);
    let single = models::light_tip_body().build_as::<f32>().unwrap();
    let lambdas: Vec<Complex<f32>> = lambdas.iter().map(|z| Complex::new(z.re as f32, z.im as f32)).collect();
    assert_values(&single, &lambdas);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn random_trees(seed in 0..20_000_u64, count in 1..80_usize) {
        check_tree(seed, count);
    }

    /// What is beside a frequency does not matter, nor where in a block it is.
    #[test]
    fn neighbours_do_not_matter(omega in 1.0..1e5_f64, seed in any::<u64>(), place in 0..32_usize) {
        let system = models::spring_and_mass().build().unwrap();
        let mut omegas = frequencies(seed, 32);
        omegas[place] = omega;
        let mut values = [Scaled::new(0.0, 0); 32];
        system.characteristics(&omegas, &mut values).unwrap();
        prop_assert_eq!(bits(values[place]), bits(Characteristic::<f64>::characteristic(&system, omega)));
    }
}

/// Far beyond the range of a number: minors are shifted on the way, at other steps in other lanes.
#[test]
fn long_chains() {
    let beam = |length| Beam { length, bending_stiffness: 3e4, mass_per_length: 0.2 };
    let steps: Vec<ListStep<AnyUndamped<f64>>> = [ListStep::Tip(Support::Pinned)]
        .into_iter()
        .chain((0..300).map(|k| ListStep::Element(beam(0.2 + 0.001 * f64::from(k)).try_into().unwrap())))
        .chain([ListStep::Root(Support::Pinned)])
        .collect();
    let mut room = Room::<STEPS>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    let omegas: Vec<f64> = (1..=64).map(|k| 300.0 * f64::from(k * k)).collect();
    assert_values(&list, &omegas);
    assert_counts(&list, &omegas);
}

/// More paths open at once than a block has room for.
#[test]
fn wide_trees() {
    let spring = || mstmm::elements::Spring { stiffness: 2.0 }.try_into().unwrap();
    let mass = || mstmm::elements::Mass { mass: 0.5 }.try_into().unwrap();
    let mut steps: Vec<ListStep<AnyUndamped<f64>>> = Vec::new();
    for _ in 0..20 {
        steps.extend([ListStep::Tip(Support::Fixed), ListStep::Element(spring())]);
    }
    steps.extend([ListStep::Connection(20), ListStep::Element(mass()), ListStep::Root(Support::Free)]);
    let mut room = Room::<STEPS>::new();
    let list = StepList::new(&steps).unwrap().planned(&mut room).unwrap();
    assert_values(&list, &frequencies(4, 50));
    assert_counts(&list, &frequencies(4, 50));
}

#[test]
fn results_need_room() {
    let system = models::spring_and_mass().build().unwrap();
    let mut values = [Scaled::new(0.0, 0); 2];
    let error = system.characteristics(&[1.0, 2.0, 3.0], &mut values).unwrap_err();
    assert_eq!(error, SearchError::Capacity { capacity: 2 });
    assert_eq!(
        system.counts_below(&[1.0, 2.0, 3.0], &mut [Ok(0); 2]).unwrap_err(),
        SearchError::Capacity { capacity: 2 }
    );
    assert_eq!(system.characteristics(&[], &mut values), Ok(()));
}
