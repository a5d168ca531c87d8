//! How many frequencies are proven between neighbouring numbers, and how many need more: sums over a family, a row of a table.

use mstmm::search::{FrequencyList, NaturalFrequency, SearchError};

/// Widest intervals of the columns, in units of eps.
const WIDTHS: [f64; 4] = [1.0, 2.0, 4.0, 16.0];

/// Entries of lists by the widths of their intervals, and what else came of searches.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shares {
    pub(crate) searches: usize,
    /// Entries that do not rest.
    pub(crate) entries: usize,
    /// By [`WIDTHS`], and wider ones.
    pub(crate) widths: [usize; 5],
    /// Searches that took runs in four words: of models in which nothing rests, and of those in which something does.
    pub(crate) in_four_words: [usize; 2],
    pub(crate) runs: [usize; 2],
    /// Searches that were refused as [`SearchError::Unproven`].
    pub(crate) refused: usize,
    /// Entries that say that they are not proven.
    pub(crate) not_proven: usize,
    /// The first that was refused or not proven, and why.
    pub(crate) first: Option<String>,
}

impl Shares {
    /// A table's head, up to the columns of [`Shares::cells`].
    pub(crate) fn head(before: &str) {
        println!(
            "| {before} | entries | to 1 eps | 2 | 4 | 16 | wider | searches | in four words | with rest | refused | not proven |"
        );
    }

    pub(crate) fn entry(&mut self, root: &NaturalFrequency, what: &dyn Fn() -> String) {
        if !root.is_proven {
            self.not_proven += 1;
            self.first.get_or_insert_with(|| format!("{root:?}: {}", what()));
        }
        if root.omega > 0.0 {
            self.entries += 1;
            // a quotient is rounded, too
            let width = (root.upper - root.lower) / (f64::EPSILON * root.omega) * 0.999;
            self.widths[WIDTHS.iter().position(|limit| width <= *limit).unwrap_or(WIDTHS.len())] += 1;
        }
    }

    pub(crate) fn list<const N: usize>(&mut self, list: &FrequencyList<f64, N>, what: &dyn Fn() -> String) {
        self.searches += 1;
        list.iter().for_each(|root| self.entry(root, what));
        let runs = list.proof_runs();
        let rests = list.first().is_some_and(|root| root.omega == 0.0);
        self.in_four_words[usize::from(rests)] += usize::from(runs[1] > 0);
        self.runs = [self.runs[0] + runs[0], self.runs[1] + runs[1]];
    }

    /// A refusal; others than those of a proof are not counted here.
    pub(crate) fn refusal(&mut self, error: &SearchError, what: &dyn Fn() -> String) {
        if let SearchError::Unproven { .. } = error {
            self.searches += 1;
            self.refused += 1;
            self.first.get_or_insert_with(|| format!("{error}: {}", what()));
        }
    }

    pub(crate) fn search<const N: usize>(
        &mut self,
        found: &Result<FrequencyList<f64, N>, SearchError>,
        what: &dyn Fn() -> String,
    ) {
        match found {
            Ok(list) => self.list(list, what),
            Err(error) => self.refusal(error, what),
        }
    }

    /// Columns of a row.
    pub(crate) fn cells(&self) -> String {
        let Shares { searches, entries, widths, in_four_words, refused, not_proven, .. } = self;
        let ([one, two, four, sixteen, wider], [moving, resting]) = (widths, in_four_words);
        format!(
            "{entries} | {one} | {two} | {four} | {sixteen} | {wider} | {searches} | {moving} | {resting} | {refused} | {not_proven}"
        )
    }

    /// Prints a row, and the first that was refused or not proven.
    pub(crate) fn show(&self, name: &str) {
        println!("| {name} | {} |", self.cells());
        if let Some(first) = &self.first {
            println!("  {first}");
        }
    }

    /// That all is proven, and nothing refused.
    pub(crate) fn all_proven(&self, name: &str) {
        assert!(self.entries > 0 && self.refused == 0 && self.not_proven == 0, "{name}: {self:?}");
    }

    /// The sum with another family.
    pub(crate) fn and(&mut self, other: &Shares) {
        self.searches += other.searches;
        self.entries += other.entries;
        self.widths.iter_mut().zip(other.widths).for_each(|(sum, more)| *sum += more);
        self.in_four_words.iter_mut().zip(other.in_four_words).for_each(|(sum, more)| *sum += more);
        self.runs.iter_mut().zip(other.runs).for_each(|(sum, more)| *sum += more);
        self.refused += other.refused;
        self.not_proven += other.not_proven;
        self.first = self.first.take().or_else(|| other.first.clone());
    }
}
