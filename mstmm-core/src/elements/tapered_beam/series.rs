//! Taylor series whose terms follow from those before them.

use crate::number::{Scalar, Size};

/// Terms that a recurrence may look back at.
const MEMORY: usize = 8;

/// Terms beyond which a series is given up; where sections may vanish no nearer than at twice the length of a part they fall as `2^-n`.
const MOST_TERMS: usize = 600;

/// The last terms of a series of several numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recent<S, const N: usize> {
    terms: [[S; N]; MEMORY],
    last: usize,
}

impl<S: Scalar, const N: usize> Recent<S, N> {
    /// The term of a number so many orders before the last one; zero before the first.
    pub(super) fn before(&self, orders: usize, number: usize) -> S {
        self.terms[(self.last + MEMORY - orders) % MEMORY][number]
    }

    /// `Σ_j c_j a_(n-j)` over the terms of a number, the last of which is of the order n.
    pub(super) fn convolved(&self, coefficients: &[S], number: usize) -> S {
        let terms = coefficients.iter().enumerate().map(|(orders, factor)| *factor * self.before(orders, number));
        terms.fold(S::zero(), |sum, term| sum + term)
    }

    /// `Σ_j c_(j+1) (n-j) a_(n-j)`: what the slope of a number has besides its newest term, times a polynomial whose first coefficient is 1.
    pub(super) fn convolved_slope(&self, coefficients: &[S], number: usize) -> S {
        let mut sum = S::zero();
        for (orders, factor) in coefficients.iter().skip(1).enumerate() {
            if orders >= self.last {
                break;
            }
            let order = S::from_f64((self.last - orders) as f64);
            sum += *factor * order * self.before(orders, number);
        }
        sum
    }
}

/// The sum of a series at 1, from its first term and the slopes that follow from the terms so far: the next term is the slope of order n
/// over n + 1. `None` if it does not converge.
pub(super) fn sum<S: Scalar, const N: usize>(first: [S; N], slope: impl Fn(&Recent<S, N>) -> [S; N]) -> Option<[S; N]> {
    let mut recent = Recent { terms: [[S::zero(); N]; MEMORY], last: 0 };
    recent.terms[0] = first;
    let mut sums = first;
    let mut sizes = first.map(|entry| entry.size().first());
    let mut quiet = 0;
    for order in 1..MOST_TERMS {
        let inverse = S::one() / S::from_f64(order as f64);
        let mut term = slope(&recent);
        let mut counts = false;
        for number in 0..N {
            term[number] *= inverse;
            sums[number] += term[number];
            let size = term[number].size().first();
            sizes[number] += size;
            // each number by itself: at low frequencies some are far smaller than others
            counts |= size > sizes[number] * (S::EPSILON / 64.0);
        }
        (recent.last, recent.terms[order % MEMORY]) = (order, term);
        quiet = if counts { 0 } else { quiet + 1 };
        // an axial force may start with two zeros, so that fewer terms may be none
        if quiet >= 4 {
            return Some(sums);
        }
    }
    None
}
