//! A model before it is built: its numbers, and the systems that are built of them.

use crate::model::ParameterError;
use crate::number::Parameter;

/// The parameters of a model, from which systems are built, over one type of number or another.
///
/// `system!` implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model",
    label = "not a model that `system!` declares",
    note = "a sweep takes models with their parameters, or references to them, and builds each itself: leave out `build()`",
    note = "a model with places is built and searched by itself, and so is a rotor, whose whirls are searched: `campbell` takes many speeds"
)]
pub trait Model {
    /// The built system over parameters of a type.
    type System<T: Parameter>;

    /// Room for the parameters of all elements.
    #[doc(hidden)]
    type Numbers: AsRef<[f64]>;

    /// The parameters of all elements.
    #[doc(hidden)]
    fn numbers(&self) -> Self::Numbers;

    /// The system of such numbers, without estimates; what else a system keeps is that of this model.
    #[doc(hidden)]
    fn of_numbers<T: Parameter>(&self, number: impl Fn(usize) -> T) -> Result<Self::System<T>, ParameterError>;

    /// Validates all parameters and builds the system.
    ///
    /// # Errors
    /// The error names the first element with a parameter out of its range, the parameter and its value.
    fn build(&self) -> Result<Self::System<f64>, ParameterError>;
}

impl<M: Model> Model for &M {
    type System<T: Parameter> = M::System<T>;
    type Numbers = M::Numbers;

    fn numbers(&self) -> M::Numbers {
        (*self).numbers()
    }

    fn of_numbers<T: Parameter>(&self, number: impl Fn(usize) -> T) -> Result<M::System<T>, ParameterError> {
        (*self).of_numbers(number)
    }

    fn build(&self) -> Result<M::System<f64>, ParameterError> {
        (*self).build()
    }
}
