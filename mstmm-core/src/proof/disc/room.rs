//! What an examination keeps of each unknown and of each entry, and its memory.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::level::Level;
use crate::proof::tree::Path;
use num_complex::Complex;

/// An unknown: a variable of the matrix, or g, which is the last one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unknown<N> {
    /// Its place in the matrix as that was put together.
    pub(crate) place: usize,
    /// The power of two of its row and its column.
    pub(crate) scale: f64,
    /// What the solution nearly is, exactly known, and a correction of it.
    pub(crate) value: ComplexBall<N>,
    pub(crate) correction: Complex<f64>,
    pub(crate) border: Complex<f64>,
    /// A bound of the residual of its row.
    pub(crate) residual: f64,
    /// What the words of its row are off by, and the sum of their sizes.
    pub(crate) unknown: f64,
    pub(crate) row: f64,
    /// The sum of the sizes in its row of what the inverse times these words lacks of 1.
    pub(crate) product: f64,
    /// The sums of the bounds of derivatives in its row: alone, and times the solution.
    pub(crate) slopes: f64,
    pub(crate) products: f64,
}

/// The derivative of an entry with respect to λ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    /// The quotient of the difference at two frequencies, and a bound of its rounding.
    pub(crate) value: Complex<f64>,
    pub(crate) rounded: f64,
    /// A bound of the distance of each derivative on the disc from that.
    pub(crate) off: f64,
}

/// Memory for a number W of variables: `W (W + 1)/2` entries, `W + 1` unknowns and their square.
pub(crate) struct Room<'m, N: Level> {
    pub(crate) entries: &'m mut [ComplexBall<N>],
    pub(crate) others: &'m mut [ComplexBall<N>],
    pub(crate) slopes: &'m mut [Slope],
    pub(crate) unknowns: &'m mut [Unknown<N>],
    pub(crate) matrix: &'m mut [Complex<f64>],
    pub(crate) inverse: &'m mut [Complex<f64>],
    pub(crate) is_taken: &'m mut [bool],
    pub(crate) pivots: &'m mut [usize],
    pub(crate) paths: &'m mut [Path<N::Alone>],
}

/// What an examination tells.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Examined {
    /// A radius, at most the one that was asked for: each disc from it up to that one holds exactly one eigenvalue. None where nothing is proven.
    pub(crate) radius: Option<f64>,
    /// Newton's step to the eigenvalue; it decides nothing.
    pub(crate) step: Complex<f64>,
}

impl<N> Unknown<N>
where
    N: Level<Word = f64, Alone = N>,
{
    /// No unknown.
    pub(crate) fn none() -> Self {
        let zero = Complex::new(0.0, 0.0);
        Unknown {
            place: 0,
            scale: 1.0,
            value: ComplexBall::of(0.0),
            correction: zero,
            border: zero,
            residual: 0.0,
            unknown: 0.0,
            row: 0.0,
            product: 0.0,
            slopes: 0.0,
            products: 0.0,
        }
    }
}

impl Slope {
    /// No slope.
    pub(crate) fn none() -> Self {
        Slope { value: Complex::new(0.0, 0.0), rounded: 0.0, off: 0.0 }
    }
}
