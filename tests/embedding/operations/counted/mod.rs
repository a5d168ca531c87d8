//! A real scalar that counts: what an evaluation needs of arithmetic, operation by operation.

mod arithmetic;
mod functions;
mod operations;
mod tape;

use mstmm::Complex;
use mstmm::number::Scalar;
use mstmm::search::Characteristic;
pub(crate) use operations::{ADD, COS, DIV, EXP, MUL, Operations, SIN, SQRT};
use tape::Origin;

/// An `f64` that knows which operation it is the result of.
///
/// Each operation is a node on a tape of the thread. The count is over the nodes that the result or a branch depends on:
/// an optimiser drops what nobody uses. Nor does it count what an optimiser folds: operations on constants alone, `x·1`,
/// `x/1`, `x - 0`. It may not fold `x·0` and `x + 0`, for the sake of NaN and -0, so these count.
///
/// - A multiplication by 0.5 or 2 is a multiplication, `x + x` an addition, a subtraction an addition.
/// - Negation, absolute value, comparisons and [`times_power_of_two`](mstmm::number::Scalar::times_power_of_two) count nothing. A
///   look at the size of numbers is a comparison: what is done with sizes, which are `f64`, is not seen, what they are
///   sizes of is needed.
/// - Sine, cosine and exponential count as one each, however they are computed; of one argument sine and cosine come
///   together, and hyperbolic sine and cosine are together one exponential.
///
/// Numbers made outside of [`count`] are given: parameters, the frequency, and all that `build()` computes. So an
/// operation on parameters alone counts if it is done in the evaluation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counted {
    value: f64,
    origin: Origin,
}

/// The real numbers that a number is made of.
pub(crate) trait Parts {
    fn parts(&self) -> Vec<Counted>;
}

impl Parts for Counted {
    fn parts(&self) -> Vec<Counted> {
        vec![*self]
    }
}

impl Parts for Complex<Counted> {
    fn parts(&self) -> Vec<Counted> {
        vec![self.re, self.im]
    }
}

/// What was counted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    /// Operations that the result, or a branch on the way to it, depends on.
    pub(crate) needed: Operations,
    /// All that were executed, those without use as well.
    pub(crate) executed: Operations,
}

/// Counts the operations of Δ at a frequency, and returns the mantissa as well.
pub(crate) fn count<S: Scalar + Parts>(system: &impl Characteristic<S>, x: S) -> (Counts, S) {
    let (counts, mantissas) = count_of(|| vec![system.characteristic(x).mantissa()]);
    (counts, mantissas[0])
}

/// Counts the operations of any numbers, and returns them as well.
pub(crate) fn count_of<S: Parts>(compute: impl FnOnce() -> Vec<S>) -> (Counts, Vec<S>) {
    tape::start();
    let values = compute();
    let tape = tape::stop();
    let origins = values.iter().flat_map(Parts::parts).map(|part| part.origin);
    (Counts { needed: tape.needed_for(origins), executed: tape.executed() }, values)
}

impl From<f64> for Counted {
    /// A given number outside of [`count`], a constant inside.
    fn from(value: f64) -> Self {
        Counted { value, origin: tape::literal(value) }
    }
}
