//! What came of the models of a family.

use crate::oracles::dynamic_stiffness::Verdict;
use crate::support::shares::Shares;
use core::fmt::Debug;
use mstmm::search::SearchError;
use std::collections::BTreeMap;

/// Sums over the models of a family.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) models: usize,
    /// Entries of lists, and counts.
    pub(crate) entries: usize,
    pub(crate) misses: usize,
    /// Of the misses: in half widths of intervals or radii of discs.
    pub(crate) worst: f64,
    /// Entries of which the model itself cannot tell.
    pub(crate) unsure: usize,
    /// Searches that were refused, by the kind of the error.
    pub(crate) refusals: BTreeMap<String, usize>,
    /// Widths of the intervals, and what was not proven.
    pub(crate) shares: Shares,
    /// Of the first miss: enough to build the model again.
    pub(crate) first: Option<String>,
}

impl Tally {
    /// A wrong answer.
    pub(crate) fn miss(&mut self, worst: f64, what: &dyn Debug) {
        self.misses += 1;
        self.worst = self.worst.max(worst);
        if self.first.is_none() {
            self.first = Some(format!("{what:?}"));
        }
    }

    /// An answer that is right or wrong.
    pub(crate) fn entry(&mut self, is_right: bool, what: &dyn Debug) {
        self.entries += 1;
        if !is_right {
            self.miss(f64::INFINITY, what);
        }
    }

    pub(crate) fn verdicts(&mut self, verdicts: &[Verdict], what: &dyn Debug) {
        for (index, verdict) in verdicts.iter().enumerate() {
            self.entries += 1;
            match *verdict {
                Verdict::Holds => {}
                Verdict::Misses(worst) => self.miss(worst, &(index, worst, what)),
                Verdict::CannotTell => self.unsure += 1,
            }
        }
    }

    pub(crate) fn refusal(&mut self, error: &SearchError) {
        *self.refusals.entry(error.kind().to_owned()).or_default() += 1;
    }

    /// A refusal of a kind that needs a name of its own.
    pub(crate) fn refusal_named(&mut self, name: &str) {
        *self.refusals.entry(name.to_owned()).or_default() += 1;
    }

    /// Prints a row of the table, and the first miss.
    pub(crate) fn print(&self, family: &str) {
        let Tally { models, entries, misses, worst, unsure, refusals, shares, first } = self;
        println!("| {family} | {models} | {entries} | {misses} | {worst:.3e} | {unsure} | {refusals:?} |");
        if shares.searches > 0 {
            shares.show(&format!("  widths, {family}"));
        }
        if let Some(first) = first {
            println!("  {first}");
        }
    }

    /// No answer is wrong, and each entry of a list is proven.
    pub(crate) fn is_right(&self, family: &str) {
        assert!(self.entries > 0 || !self.refusals.is_empty(), "{family}: nothing was compared");
        let Tally { misses, entries, worst, shares, first, .. } = self;
        assert_eq!(*misses, 0, "{family}: of {entries}, the worst by {worst:e}; the first: {first:?}");
        assert_eq!(shares.not_proven, 0, "{family}: {:?}", shares.first);
    }
}
