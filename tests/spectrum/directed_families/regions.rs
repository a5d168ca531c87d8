//! Regions that are long in the real direction: whoever wants all overdamped motions writes one.

use super::parts::{beam, damper, joint, root, tip};
use super::tally::Tally;
use crate::support::list_of_tree::any_steps;
use mstmm::element::Support;
use mstmm::list::StepList;
use mstmm::search::{Eigenvalues, Region};

/// Evaluations of a long region beside those of a short one: a few cuts of each decade.
const MORE: usize = 20;

pub(crate) fn run(decades: core::ops::RangeInclusive<i32>) -> Tally {
    let arm = vec![tip(Support::Fixed), beam(1.0, 1.0, 1.0)];
    let dashpot = vec![tip(Support::Fixed), damper(1.0)];
    let tree = joint(&[&arm, &dashpot], &[beam(1.0, 1.0, 1.0), root(Support::Free)]);
    let steps = any_steps(&tree);
    let list = StepList::new(&steps).unwrap();
    let mut tally = Tally { models: 1, ..Tally::default() };
    let mut short = None;
    for decade in decades {
        let region = Region { re: -10f64.powi(decade)..=1.0, im: -1.0..=300.0 };
        let start = std::time::Instant::now();
        let found = list.eigenvalues::<32>(region.clone());
        println!("to -1e{decade}: {:?} in {:?}", found.as_ref().map(|f| (f.len(), f.evaluations())), start.elapsed());
        match &found {
            Err(error) => {
                tally.refusal(error);
                continue;
            }
            Ok(found) => {
                let total: u64 = found.iter().map(|root| root.multiplicity).sum();
                let (first, few) = *short.get_or_insert((total, found.evaluations()));
                tally.entry(total == first, &(decade, "found", total, "instead of", first));
                tally.entry(found.evaluations() <= MORE * few, &(decade, "evaluations", found.evaluations(), few));
                match list.count_in(region) {
                    Ok(count) => tally.entry(count == total, &(decade, "counted", count, "found", total)),
                    Err(error) => tally.refusal(&error),
                }
            }
        }
    }
    tally
}
