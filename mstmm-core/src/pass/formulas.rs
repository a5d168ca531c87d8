//! Models whose parameters are formulas of their fields.

use crate::model::{Fields, NamedFields, ParameterError};
use crate::number::Partials;
use crate::number::interval::Interval;
use crate::pass::characteristic::System;
use crate::pass::model::Numbered;

/// A model whose parameters are formulas of its fields, which can be enclosed over a box of them.
///
/// `system!` implements it where a formula depends on a field, but for rotors.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no box of fields",
    note = "a model has one whose parameters are formulas of fields; of a rotor take `ToleranceBox::between` of two whirls"
)]
pub trait Formulas: Numbered {
    /// The built system.
    type Built: System<Parameter = f64> + NamedFields;

    /// Whether a formula compares values that depend on fields.
    #[doc(hidden)]
    const COMPARES: bool;

    /// Whether a number is a parameter of an element of the user's own, of which nothing tells how it acts between two values.
    #[doc(hidden)]
    fn is_of_own_element(_: usize) -> bool {
        false
    }

    /// The values of the fields.
    #[doc(hidden)]
    fn values(&self) -> <Self::Built as Fields>::PerField<f64>;

    /// The system of numbers.
    #[doc(hidden)]
    fn built(&self, numbers: &Self::Numbers) -> Result<Self::Built, ParameterError>;

    /// Hands on each number that depends on a field: its place among the numbers, its interval over a box of fields, and the intervals of its slopes.
    #[doc(hidden)]
    fn enclose(
        &self,
        fields: &<Self::Built as Fields>::PerField<Interval>,
        take: &mut dyn FnMut(usize, Interval, &[Interval]),
    );
}

/// What a box has for each field.
pub(crate) type PerField<M, V> = <<M as Formulas>::Built as Fields>::PerField<V>;

/// Makes intervals of the fields of a model, for its formulas.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Enclosing<'f, const K: usize> {
    fields: &'f [Interval; K],
    variables: usize,
}

impl<'f, const K: usize> Enclosing<'f, K> {
    /// Starts with the first field.
    pub fn new(fields: &'f [Interval; K]) -> Self {
        Enclosing { fields, variables: 0 }
    }

    /// Makes a variable of the next field.
    pub fn variable(&mut self) -> Partials<K, Interval> {
        let index = self.variables;
        self.variables += 1;
        Partials::variable(self.fields[index], index)
    }

    /// A number that depends on no field, of the type of those that do.
    pub fn constant(&self, value: f64) -> Partials<K, Interval> {
        Partials::constant(value)
    }
}
