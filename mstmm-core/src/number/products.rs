//! Exact products of two `f64`, as the machine finds them: where it has a fused multiply-add, that gives the error at once, with the same bits.

use crate::number::task::{Task, run};

/// `2^27 + 1`: multiplication by it separates the upper 26 bits of a factor from the lower ones.
const SPLITTER: f64 = 134_217_729.0;

/// Two parts of 26 bits with `upper + lower = a`, whose products are exact (Veltkamp).
const fn split(a: f64) -> (f64, f64) {
    let shifted = SPLITTER * a;
    let upper = shifted - (shifted - a);
    (upper, a - upper)
}

/// The exact product of two `f64`, in two words (Dekker).
pub(crate) const fn exact_product(a: f64, b: f64) -> [f64; 2] {
    let product = a * b;
    let ((a_upper, a_lower), (b_upper, b_lower)) = (split(a), split(b));
    let cross = ((a_upper * b_upper - product) + a_upper * b_lower) + a_lower * b_upper;
    [product, cross + a_lower * b_lower]
}

/// How the exact product of two `f64` is found.
pub trait Products {
    /// The exact product, in two words.
    fn of(a: f64, b: f64) -> [f64; 2];
}

/// By splitting both factors.
#[derive(Debug)]
pub(crate) struct Split;

impl Products for Split {
    #[inline(always)]
    fn of(a: f64, b: f64) -> [f64; 2] {
        exact_product(a, b)
    }
}

/// By a fused multiply-add.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
struct Fused;

#[cfg(all(feature = "std", target_arch = "x86_64"))]
impl Products for Fused {
    #[inline(always)]
    fn of(a: f64, b: f64) -> [f64; 2] {
        let product = a * b;
        [product, a.mul_add(b, -product)]
    }
}

/// Work that is compiled for both ways.
pub(crate) trait Operation {
    /// The result.
    type Output;

    /// Does it. Mark it `#[inline(always)]`, as all that it calls.
    fn by<P: Products>(self) -> Self::Output;
}

/// Work on the instruction set of the machine.
struct OnMachine<O>(O);

impl<O: Operation> Task for OnMachine<O> {
    type Output = O::Output;

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) -> O::Output {
        self.0.by::<Fused>()
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) -> O::Output {
        self.0.by::<Fused>()
    }

    #[inline(always)]
    fn alone(self) -> O::Output {
        self.0.by::<Split>()
    }
}

/// Does work on the instruction set of the machine.
#[inline(always)]
pub(crate) fn on_machine<O: Operation>(operation: O) -> O::Output {
    run(OnMachine(operation))
}
