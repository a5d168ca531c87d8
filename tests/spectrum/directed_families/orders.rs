//! Equal parts at a joint, in all orders of its paths.

use super::parts::{beam, below, body, decimal, joint, mass, root, spring, tip};
use super::searches::{counts_up_to, first_frequencies};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::list_of_tree::undamped_steps;
use crate::support::random_tree::Random;
use crate::support::tree::Tree;
use mstmm::element::Support;
use mstmm::list::StepList;
use mstmm::search::{NaturalFrequencies, NaturalFrequency};

/// A path into the joint.
fn path(random: &mut Random) -> Tree {
    let kind = below(random, 5);
    let support = [Support::Fixed, Support::Pinned, Support::Free, Support::Guided][below(random, 4)];
    let mut number = |from, to| decimal(random, from, to);
    match kind {
        0 | 1 => vec![tip(support), beam(number(0.3, 2.0), number(0.5, 2.0), number(0.5, 2.0))],
        2 => vec![tip(Support::Fixed), spring(number(0.5, 20.0))],
        3 => vec![tip(Support::Free), mass(number(0.2, 2.0)), spring(number(0.5, 20.0))],
        _ => {
            let (mass, centre) = (number(0.2, 2.0), number(-1.0, 1.0));
            let body = body(mass, mass * centre * centre + number(0.01, 0.5), number(-1.0, 1.0), centre);
            vec![tip(Support::Free), body, beam(number(0.3, 2.0), number(0.5, 2.0), number(0.5, 2.0))]
        }
    }
}

/// All orders of so many things.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for shorter in permutations(count - 1) {
        for place in 0..count {
            let mut longer = shorter.clone();
            longer.insert(place, count - 1);
            all.push(longer);
        }
    }
    all
}

/// Whether the parts of two lists that are next to each other meet.
fn overlap(a: &[NaturalFrequency], b: &[NaturalFrequency]) -> bool {
    let ordinals = |list: &[NaturalFrequency]| -> Vec<(f64, f64)> {
        list.iter().flat_map(|root| (0..root.multiplicity).map(|_| (root.lower, root.upper))).collect()
    };
    ordinals(a).iter().zip(ordinals(b)).all(|(a, b)| a.0 <= b.1 && b.0 <= a.1)
}

pub(crate) fn run(models: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..models {
        let random = &mut Random(seed);
        let number = 3 + below(random, 2);
        let mut paths = vec![path(random)];
        while paths.len() < number {
            let next = if random.unit() < 0.6 { paths[below(random, paths.len())].clone() } else { path(random) };
            paths.push(next);
        }
        // the joint goes on as a bending path, which it is only if one leads to it
        paths.push(vec![tip(Support::Free)]);
        let last = beam(decimal(random, 0.3, 2.0), 1.0, 1.0);
        let end = [last, root([Support::Fixed, Support::Free, Support::Pinned][below(random, 3)])];
        tally.models += 1;
        let mut first: Option<Vec<NaturalFrequency>> = None;
        for order in permutations(number) {
            let mut in_order: Vec<&Tree> = order.iter().map(|&index| &paths[index]).collect();
            in_order.push(&paths[number]);
            let tree = joint(&in_order, &end);
            let model = Stiffness::of(&tree);
            first_frequencies::<6>(&tree, &model, &mut tally);
            counts_up_to(&tree, 30.0, &mut Random(seed), &model, &mut tally);
            let steps = undamped_steps(&tree);
            if let Ok(found) = StepList::new(&steps).unwrap().first_frequencies::<6>() {
                let other = first.get_or_insert_with(|| found.to_vec());
                tally.entry(overlap(&found, other), &("in another order", &tree));
            }
        }
    }
    tally
}
