//! The modal assurance criterion: how far two shapes are one.

use crate::model::error;
use crate::number::{Scalar, binary_exponent};
use core::fmt;
use num_complex::Complex;

/// Why two shapes cannot be compared.
#[derive(Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum MacError {
    /// The shapes have no entries.
    Empty,
    /// The shapes have different numbers of entries.
    Lengths {
        /// Entries of the first shape.
        first: usize,
        /// Entries of the second shape.
        second: usize,
    },
    /// All entries of a shape are zero: it has no direction.
    Zero {
        /// The shape, 1 or 2.
        shape: usize,
    },
    /// An entry is not finite.
    NotFinite {
        /// The shape, 1 or 2.
        shape: usize,
        /// The entry, from 0 on.
        entry: usize,
    },
}

impl fmt::Display for MacError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            MacError::Empty => write!(f, "the shapes have no entries: there is nothing to compare"),
            MacError::Lengths { first, second } => {
                write!(
                    f,
                    "the first shape has {first} entries and the second {second}: compare them at the same points"
                )
            }
            MacError::Zero { shape } => write!(f, "all entries of shape {shape} are zero: it has no direction"),
            MacError::NotFinite { shape, entry } => write!(f, "entry {entry} of shape {shape} is not finite"),
        }
    }
}

error! { MacError }

/// The modal assurance criterion `|φᴴψ|²/(φᴴφ · ψᴴψ)` of two shapes at the same points: 1 where one is a multiple of the other, by a complex
/// factor too, and 0 where they are orthogonal.
///
/// Entries are real or complex and may have any unit, the same in all of a shape; measured shapes may be scaled as they come. Neither overflow
/// nor underflow spoils it: each shape is measured in its largest entry. An entry below 1e-154 of that is lost in it, as it is in the result.
///
/// ```
/// use mstmm_core::{Complex, mac};
///
/// let computed = [0.0, 0.34, 1.0];
/// let measured = [Complex::new(0.0, 0.01), Complex::new(0.0, 0.7), Complex::new(0.0, 2.0)];
/// assert!(mac(&computed, &measured)? > 0.999);
/// assert_eq!(mac(&[1.0, 1.0], &[1.0, -1.0])?, 0.0);
/// # Ok::<(), mstmm_core::MacError>(())
/// ```
///
/// # Errors
/// [`MacError`] for shapes without entries, with different numbers of them, that are zero or not finite.
///
/// # Source
/// Allemang and Brown, A correlation coefficient for modal vector analysis, 1st IMAC, 1982.
pub fn mac<A, B>(first: &[A], second: &[B]) -> Result<f64, MacError>
where
    A: Copy + Into<Complex<f64>>,
    B: Copy + Into<Complex<f64>>,
{
    if first.len() != second.len() {
        return Err(MacError::Lengths { first: first.len(), second: second.len() });
    }
    let (one, other) = (largest_exponent(first, 1)?, largest_exponent(second, 2)?);
    let (mut product, mut sizes) = (Complex::new(0.0, 0.0), [0.0; 2]);
    for (&a, &b) in first.iter().zip(second) {
        let (a, b) = (a.into().times_power_of_two(-one), b.into().times_power_of_two(-other));
        product += a.conj() * b;
        sizes[0] += a.norm_sqr();
        sizes[1] += b.norm_sqr();
    }
    // rounding may lift it above 1
    Ok((product.norm_sqr() / (sizes[0] * sizes[1])).min(1.0))
}

/// The binary exponent of the largest part of a shape.
fn largest_exponent<A: Copy + Into<Complex<f64>>>(shape: &[A], number: usize) -> Result<i32, MacError> {
    let mut largest = 0.0_f64;
    for (entry, &value) in shape.iter().enumerate() {
        let value: Complex<f64> = value.into();
        if !(value.re.is_finite() && value.im.is_finite()) {
            return Err(MacError::NotFinite { shape: number, entry });
        }
        largest = largest.max(value.re.abs()).max(value.im.abs());
    }
    match (shape.is_empty(), largest == 0.0) {
        (true, _) => Err(MacError::Empty),
        (false, true) => Err(MacError::Zero { shape: number }),
        (false, false) => Ok(binary_exponent(largest)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn complex() -> impl Strategy<Value = Complex<f64>> {
        (-1.0..1.0, -1.0..1.0).prop_map(|(re, im)| Complex::new(re, im))
    }

    proptest! {
        /// Oracle: the cosine of the angle between two vectors, by the part of one that is orthogonal to the other.
        #[test]
        fn is_what_is_left_of_the_orthogonal_part(pairs in proptest::collection::vec((complex(), complex()), 1..20)) {
            let (a, b): (Vec<_>, Vec<_>) = pairs.into_iter().unzip();
            let square = |v: &[Complex<f64>]| v.iter().map(Complex::norm_sqr).sum::<f64>();
            prop_assume!(square(&a) > 1e-6 && square(&b) > 1e-6);
            let along = a.iter().zip(&b).map(|(a, b)| a.conj() * b).sum::<Complex<f64>>() / square(&a);
            let rest: Vec<_> = a.iter().zip(&b).map(|(a, b)| b - along * a).collect();
            let expected = 1.0 - square(&rest) / square(&b);
            let found = mac(&a, &b).unwrap();
            prop_assert!((found - expected).abs() < 1e-13, "{found} {expected}");
            prop_assert!((mac(&b, &a).unwrap() - found).abs() < 1e-14);
        }

        /// A complex factor changes nothing, nor does its size.
        #[test]
        fn does_not_see_factors(a in proptest::collection::vec(complex(), 2..9), factor in complex(), exponent in -1000..1000) {
            prop_assume!(factor.norm() > 1e-3 && a.iter().any(|a| a.norm() > 1e-3));
            let b: Vec<_> = a.iter().map(|a| (a * factor).times_power_of_two(exponent)).collect();
            prop_assert!(mac(&a, &b).unwrap() > 1.0 - 1e-14);
        }
    }

    use std::vec::Vec;

    #[test]
    fn real_and_complex_shapes_compare() {
        // 4²/(5 · 5): by hand
        assert_eq!(mac(&[1.0, 2.0], &[2.0, 1.0]), Ok(0.64));
        let turned = [Complex::new(0.0, 2.0), Complex::new(0.0, 1.0)];
        assert_eq!(mac(&[1.0, 2.0], &turned), Ok(0.64));
        // φᴴψ of (1, i) and (1, -i) is 0, φᵀψ is 2
        assert_eq!(mac(&[Complex::new(1.0, 0.0), Complex::i()], &[Complex::new(1.0, 0.0), -Complex::i()]), Ok(0.0));
        assert_eq!(mac(&[Complex::new(1.0, 0.0), Complex::i()], &[Complex::new(1.0, 0.0), Complex::i()]), Ok(1.0));
    }

    #[test]
    fn the_ends_of_the_range_do_not_overflow() {
        for size in [f64::MAX, f64::MIN_POSITIVE, 5e-324] {
            assert_eq!(mac(&[size, size], &[1.0, 1.0]), Ok(1.0));
            assert_eq!(mac(&[size, -size], &[1.0, 1.0]), Ok(0.0));
        }
    }

    #[test]
    fn errors_say_what_is_wrong() {
        let none: [f64; 0] = [];
        assert_eq!(mac(&none, &none), Err(MacError::Empty));
        assert_eq!(mac(&[1.0], &[1.0, 2.0]), Err(MacError::Lengths { first: 1, second: 2 }));
        assert_eq!(mac(&[1.0, 1.0], &[0.0, 0.0]), Err(MacError::Zero { shape: 2 }));
        assert_eq!(mac(&[0.0], &[1.0]), Err(MacError::Zero { shape: 1 }));
        let nan = [Complex::new(0.0, 1.0), Complex::new(0.0, f64::NAN)];
        assert_eq!(mac(&[1.0, 1.0], &nan), Err(MacError::NotFinite { shape: 2, entry: 1 }));
        assert_eq!(mac(&[f64::INFINITY], &[1.0]), Err(MacError::NotFinite { shape: 1, entry: 0 }));
    }
}
