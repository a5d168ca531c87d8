//! What a method found, and how far it is from the exact roots.

use mstmm::prelude::Complex;

/// Room for the roots of a scene: no allocation is timed.
const ROOM: usize = 8;

/// The roots that a method found, by ascending imaginary part, and what they cost. Undamped roots are λ = iω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    roots: [Complex<f64>; ROOM],
    /// Number of roots; those beyond the room are counted, too.
    count: usize,
    /// Evaluations of Δ or of the matrix, or unknowns of an eigenproblem.
    pub evaluations: u64,
}

impl Found {
    /// No roots so far.
    pub fn new(evaluations: usize) -> Self {
        Found { roots: [Complex::new(0.0, 0.0); ROOM], count: 0, evaluations: evaluations as u64 }
    }

    /// One more root.
    pub fn push(&mut self, root: Complex<f64>) {
        if let Some(place) = self.roots.get_mut(self.count) {
            *place = root;
        }
        self.count += 1;
    }

    /// The roots.
    pub fn roots(&self) -> &[Complex<f64>] {
        &self.roots[..self.count.min(ROOM)]
    }

    /// These roots by ascending imaginary part.
    pub fn sorted(mut self) -> Self {
        let count = self.count.min(ROOM);
        self.roots[..count].sort_by(|a, b| a.im.total_cmp(&b.im));
        self
    }

    /// From natural frequencies.
    pub fn of_frequencies(frequencies: impl Iterator<Item = f64>, evaluations: usize) -> Self {
        let mut found = Found::new(evaluations);
        frequencies.for_each(|omega| found.push(Complex::new(0.0, omega)));
        found
    }

    /// Largest relative error, roots matched by their order. Infinite if there are more or fewer than the exact ones: a list
    /// that may lack any root, or hold one that is none, says nothing about the others.
    pub fn error(&self, exact: &[Complex<f64>]) -> f64 {
        if self.count != exact.len() {
            return f64::INFINITY;
        }
        let errors = self.roots().iter().zip(exact).map(|(root, exact)| (root - exact).norm() / exact.norm());
        // not a number is as bad as missing
        errors.fold(0.0, |largest, error| if error.is_nan() { f64::INFINITY } else { error.max(largest) })
    }
}
