//! What is multiplied and counted while a network is evaluated: Δ and its natural frequencies.

use crate::number::{Scalar, Scaled, Size};

/// Size of a row beside its terms, in units of rounding, below which it is rounding alone.
const ROUNDING: f64 = 4.0;

/// The product of all pivots and charts, which is Δ at the end, and the count.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Total<S: Scalar> {
    product: S,
    exponent: i64,
    /// Negative pivots and natural frequencies of held members, less the number of forces: at the end the frequencies below.
    pub(crate) below: S::Size,
    /// Whether rows carry what rounding has done to them.
    pub(super) carries_errors: bool,
    /// The node that is eliminated, and the first one where a row was nothing but rounding.
    pub(super) node: u32,
    pub(crate) vanished_at: Option<u32>,
    /// The size of a pivot or of its row and its error in units of rounding, where the first is smallest beside the second.
    pub(crate) smallest_row: [f64; 2],
    pub(crate) smallest_at: u32,
}

impl<S: Scalar> Total<S> {
    /// Nothing yet, given whether errors are to be carried along.
    pub(crate) fn new(carries_errors: bool) -> Self {
        let (product, below) = (S::one(), S::Size::of(0.0));
        Total {
            product,
            exponent: 0,
            below,
            carries_errors,
            node: 0,
            vanished_at: None,
            smallest_row: [1.0; 2],
            smallest_at: 0,
        }
    }

    /// Not a number, of a network that could not be evaluated.
    pub(crate) fn unknown() -> Self {
        Total { product: S::from_f64(f64::NAN), ..Total::new(false) }
    }

    /// Δ, once all variables are eliminated.
    pub(crate) fn delta(&self) -> Scaled<S> {
        Scaled::new(self.product, self.exponent)
    }

    /// Multiplies Δ by a number and a power of two.
    #[inline]
    pub(super) fn multiply(&mut self, factor: S, exponent: i64) {
        let product = self.product * factor;
        let ([product], shift) = S::in_range([product], product.size());
        self.product = product;
        self.exponent += exponent + i64::from(shift);
    }

    /// Looks at a pivot, given its size and its error: it may be rounding in a row that is not.
    #[inline]
    pub(super) fn look_at_pivot(&mut self, size: f64, error: f64) {
        let [smallest, of] = self.smallest_row;
        if size * of < smallest * error {
            (self.smallest_row, self.smallest_at) = ([size, error], self.node);
        }
    }

    /// Looks at the row of a pivot, given the sizes of its largest entry and of its largest term, and its error.
    #[inline]
    pub(super) fn look_at_row(&mut self, largest: f64, term: f64, error: f64) {
        self.look_at_pivot(largest, error);
        if largest <= ROUNDING * S::EPSILON * term {
            self.vanished_at = self.vanished_at.or(Some(self.node));
        }
    }

    /// Adds to the count.
    #[inline]
    pub(crate) fn count(&mut self, number: f64) {
        self.below = self.below + S::Size::of(number);
    }

    /// Adds one to the count where a truth holds.
    #[inline]
    pub(super) fn count_if(&mut self, truth: S::Truth) {
        self.below = self.below + S::Size::one_if(truth);
    }
}
