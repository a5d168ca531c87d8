//! From the parameters of elements to the fields of a model: the chain rule.

use crate::model::ends::Ends;
use crate::number::{Partials, Scalar};
use core::fmt::Debug;

/// A built system tells how many numbers it has derivatives with respect to: the fields of its model but those that are marked
/// `#[no_sensitivity]`, or the parameters of all elements of a list.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no sensitivities",
    note = "a `StepList` has them with a plan: `.planned(&mut room)?`"
)]
pub trait Fields {
    /// A value for each of them: an array.
    type PerField<V: Copy + Debug>: Copy + Debug + AsRef<[V]> + AsMut<[V]>;

    /// The same value for each.
    fn per_field<V: Copy + Debug>(value: V) -> Self::PerField<V>;
}

/// A built system whose fields have names.
#[diagnostic::on_unimplemented(
    message = "the parameters of `{Self}` have no names",
    note = "of a list ask for one by one: `sensitivity.of(list.parameter(step, \"stiffness\").unwrap())`"
)]
pub trait NamedFields: Fields {
    /// The names of the fields, in the order of the struct.
    const NAMES: &'static [&'static str];
}

/// A built system whose dynamic work has derivatives with respect to the fields of the model.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no sensitivities",
    note = "a `StepList` has them with a plan: `.planned(&mut room)?`"
)]
pub trait Chain<S: Scalar>: Fields {
    /// `∂L/∂(field) = Σ ∂L/∂(parameter) · ∂(parameter)/∂(field)`, summed over the elements of the sketch and their parameters,
    /// at the values of the model.
    ///
    /// `ends` gives the states at the ends of the element that is a step of the [`Scheme`](mstmm_plan::Scheme), by the step's
    /// index; the states at its ends are all that an element's `∂L/∂(parameter)` depends on.
    #[doc(hidden)]
    fn chain(&self, ends: impl Fn(usize) -> Ends<S>) -> Self::PerField<S>;
}

/// The chain rule sums up what [`Chain::chain`] returns: it turns the fields into variables, and adds each parameter that the formulas
/// of a model compute from them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct ChainRule<S, const K: usize> {
    sums: [S; K],
    variables: usize,
}

impl<S: Scalar, const K: usize> ChainRule<S, K> {
    /// Starts from sums of zero, one per field.
    pub fn new(sums: [S; K]) -> Self {
        ChainRule { sums, variables: 0 }
    }

    /// Makes a variable of the next field.
    pub fn variable(&mut self, value: f64) -> Partials<K> {
        let index = self.variables;
        self.variables += 1;
        Partials::variable(value, index)
    }

    /// Makes a number that depends on no field, of the type of those that do: a formula may yield either.
    pub fn constant(&self, value: f64) -> Partials<K> {
        Partials::constant(value)
    }

    /// Adds a parameter, weighted by `∂L/∂(parameter)`.
    pub fn add(&mut self, weight: S, parameter: Partials<K>) {
        for (sum, partial) in self.sums.iter_mut().zip(parameter.partials) {
            *sum += weight * S::from_f64(partial);
        }
    }

    /// Returns the sums.
    pub fn finish(self) -> [S; K] {
        self.sums
    }
}
