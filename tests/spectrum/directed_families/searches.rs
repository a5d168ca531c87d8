//! The searches of a tree, judged by its dynamic stiffness.

use super::tally::Tally;
use crate::counts::count_below;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::list_of_tree::{any_steps, undamped_steps};
use crate::support::random_tree::Random;
use crate::support::tree::{Part, Tree};
use mstmm::list::{ListStep, StepList};
use mstmm::search::SearchError;
use mstmm::search::{Eigenvalues, NaturalFrequencies};

/// A frequency above all of a model without beams, even those of an inertia that rounding alone has left.
const HIGHEST: f64 = 1e30;

fn has_beams(tree: &Tree) -> bool {
    tree.iter().any(|step| matches!(step, ListStep::Element(Part::Beam(_))))
}

/// Counts the refusal of a search for so many undamped frequencies, and says whether the model asks for it.
fn refused(error: SearchError, wanted: u64, model: &Stiffness, tally: &mut Tally, tree: &Tree) {
    match error {
        SearchError::TooFewRoots { found, .. } => {
            let all = if has_beams(tree) { None } else { model.count_below(HIGHEST.into()) };
            match all {
                Some(all) => tally.entry(all == found && all < wanted, &("too few", found, all, tree)),
                None => tally.unsure += 1,
            }
            tally.refusal(&error);
        }
        SearchError::Zero { .. } if model.is_sound() => tally.refusal_named("Zero of a sound model"),
        other => tally.refusal(&other),
    }
}

/// The first `N` frequencies.
pub(crate) fn first_frequencies<const N: usize>(tree: &Tree, model: &Stiffness, tally: &mut Tally) {
    let steps = undamped_steps(tree);
    let list = StepList::new(&steps).unwrap();
    let found = list.first_frequencies::<N>();
    tally.shares.search(&found, &|| format!("{tree:?}"));
    match found {
        Ok(found) => tally.verdicts(&model.judge_intervals(&found, 0), &tree),
        Err(error) => refused(error, N as u64, model, tally, tree),
    }
}

/// All frequencies up to one, and their number.
pub(crate) fn frequencies_up_to(tree: &Tree, end: f64, model: &Stiffness, tally: &mut Tally) {
    let steps = undamped_steps(tree);
    let list = StepList::new(&steps).unwrap();
    let found = list.natural_frequencies::<64>(0.0..=end);
    tally.shares.search(&found, &|| format!("up to {end}: {tree:?}"));
    match found {
        Ok(found) => {
            tally.verdicts(&model.judge_intervals(&found, 0), &tree);
            if let Some(expected) = model.sure_count(end) {
                let total: u64 = found.iter().map(|root| root.multiplicity).sum();
                tally.entry(total == expected, &("up to", end, total, expected, tree));
            }
        }
        Err(error) => refused(error, 0, model, tally, tree),
    }
}

/// Counts below random frequencies up to one.
pub(crate) fn counts_up_to(tree: &Tree, end: f64, random: &mut Random, model: &Stiffness, tally: &mut Tally) {
    let steps = undamped_steps(tree);
    let list = StepList::new(&steps).unwrap();
    for _ in 0..3 {
        let omega = end * (0.01 + 0.99 * random.unit());
        // rounding moves a frequency by no more than this where the condition is ordinary
        let ends = [1.0 - 1e-9, 1.0 + 1e-9].map(|factor| model.sure_count(omega * factor));
        if let [Some(expected), Some(above)] = ends
            && expected == above
        {
            match count_below(&list, omega) {
                Ok(count) => tally.entry(count == expected, &("below", omega, count, expected, tree)),
                Err(error) => refused(error, 0, model, tally, tree),
            }
        }
    }
}

/// The first `N` eigenvalues.
pub(crate) fn first_eigenvalues<const N: usize>(tree: &Tree, model: &Stiffness, tally: &mut Tally) {
    let steps = any_steps(tree);
    let list = StepList::new(&steps).unwrap();
    match list.first_eigenvalues::<N>() {
        Ok(found) => tally.verdicts(&model.judge_discs(&found), &tree),
        Err(error) => {
            if let SearchError::TooFewRoots { found, .. } = error {
                let all = if has_beams(tree) { None } else { model.eigenvalues_within(HIGHEST) };
                // each but the real ones has a mirror image
                let are_all = |&all: &u64| found < N as u64 && found <= all && all <= 2 * found;
                tally.entry(all.as_ref().is_some_and(are_all), &("too few", found, all, tree));
            }
            tally.refusal(&error);
        }
    }
}

/// The first six intervals, and the first six discs, of undamped trees.
pub(crate) fn intervals_and_discs(trees: impl Iterator<Item = Tree>) -> [Tally; 2] {
    let (mut intervals, mut discs) = (Tally::default(), Tally::default());
    for tree in trees {
        let model = Stiffness::of(&tree);
        intervals.models += 1;
        discs.models += 1;
        first_frequencies::<6>(&tree, &model, &mut intervals);
        first_eigenvalues::<6>(&tree, &model, &mut discs);
    }
    [intervals, discs]
}
