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

#[cfg(test)]
mod tests {
    use super::*;

    /// Oracle: errors by hand.
    #[test]
    fn a_list_of_another_length_has_found_nothing() {
        let exact = [Complex::new(0.0, 2.0), Complex::new(-3.0, 4.0)];
        let mut found = Found::new(7);
        found.push(Complex::new(-3.0, 4.5));
        assert_eq!(found.error(&exact), f64::INFINITY);
        found.push(Complex::new(0.0, 2.0));
        assert_eq!(found.sorted().error(&exact), 0.1);
        // matched by order, not by nearness
        assert_eq!(Found { evaluations: 0, ..found }.error(&exact), 2.5_f64.hypot(3.0) / 2.0);
        found.push(Complex::new(0.0, 9.0));
        assert_eq!(found.error(&exact), f64::INFINITY);
    }

    #[test]
    fn what_is_not_a_number_is_not_found() {
        let found = Found::of_frequencies([f64::NAN, 2.0].into_iter(), 0);
        assert_eq!(found.error(&[Complex::new(0.0, 1.0), Complex::new(0.0, 2.0)]), f64::INFINITY);
    }

    #[test]
    fn more_roots_than_there_is_room_for_are_counted() {
        let found = Found::of_frequencies((1..=20).map(f64::from), 0);
        let exact: Vec<Complex<f64>> = (1..=8).map(|k| Complex::new(0.0, f64::from(k))).collect();
        assert_eq!(found.roots(), exact);
        assert_eq!(found.error(&exact), f64::INFINITY);
    }
}
