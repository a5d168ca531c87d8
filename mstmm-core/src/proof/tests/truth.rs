//! What proven intervals tell of the count at any frequency.

use crate::proof::count::Side;
use crate::proof::prover::{Precision, Prover};
use crate::search::NaturalFrequency;
use std::vec::Vec;

/// What is known of the count: bounds that proven intervals leave between them.
pub(super) struct Truth {
    /// The ends of intervals, in ascending order: from each on, or up to it, the count has these bounds.
    pub(super) roots: Vec<NaturalFrequency<f64>>,
}

impl Truth {
    /// Each interval between the nearest numbers at which the count is proven in four words.
    pub(super) fn new(mut roots: Vec<NaturalFrequency<f64>>, prover: &mut Prover<'_>) -> Self {
        for root in roots.iter_mut().filter(|root| root.omega > 0.0) {
            loop {
                let middle = root.lower + 0.5 * (root.upper - root.lower);
                if middle <= root.lower || middle >= root.upper {
                    break;
                }
                let last = root.index + root.multiplicity - 1;
                if prover.bound_at(middle, 1.0, Side::AtLeast, Precision::Four).count.is_some_and(|count| count >= last)
                {
                    root.upper = middle;
                } else if prover
                    .bound_at(middle, 1.0, Side::AtMost, Precision::Four)
                    .count
                    .is_some_and(|count| count < root.index)
                {
                    root.lower = middle;
                } else {
                    break;
                }
            }
        }
        Truth { roots }
    }

    /// Whether a frequency is within a relative distance of ω.
    pub(super) fn is_beside(&self, omega: f64, distance: f64) -> bool {
        self.roots.iter().any(|root| (root.omega - omega).abs() <= distance * omega)
    }

    /// At least so many frequencies are below ω, and at most so many; beyond the last interval nothing bounds them from above.
    pub(super) fn count(&self, omega: f64) -> [u64; 2] {
        let passed = self.roots.iter().rfind(|root| root.upper <= omega);
        let next = self.roots.iter().find(|root| omega <= root.lower);
        [passed.map_or(0, |root| root.index + root.multiplicity - 1), next.map_or(u64::MAX, |root| root.index - 1)]
    }
}
