//! A model before it is built: its numbers, and the systems that are built of them.

use crate::model::ParameterError;
use crate::number::{Parameter, Real};

/// A model by its numbers: places and parameters of elements, as its formulas give them.
///
/// `system!` implements it.
pub trait Numbered {
    /// Room for the numbers.
    #[doc(hidden)]
    type Numbers: AsRef<[f64]> + AsMut<[f64]> + Copy;

    /// The numbers of the model.
    #[doc(hidden)]
    fn numbers(&self) -> Self::Numbers;
}

/// A model that builds a system of its numbers, or of others in their place.
///
/// `system!` implements it.
pub trait Build: Numbered {
    /// The built system over parameters of a type.
    type System<T: Parameter>;

    /// Validates numbers and builds the system of them; what else a system keeps is that of this model.
    #[doc(hidden)]
    fn build_of<T: Real>(&self, numbers: &Self::Numbers) -> Result<Self::System<T>, ParameterError>;
}

impl<M: Numbered> Numbered for &M {
    type Numbers = M::Numbers;

    fn numbers(&self) -> M::Numbers {
        (*self).numbers()
    }
}

impl<M: Build> Build for &M {
    type System<T: Parameter> = M::System<T>;

    fn build_of<T: Real>(&self, numbers: &M::Numbers) -> Result<M::System<T>, ParameterError> {
        (*self).build_of(numbers)
    }
}

/// A model whose systems are built over one type of number or another: what sweeps take.
///
/// `system!` implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model",
    label = "not a model that `system!` declares",
    note = "a sweep takes models with their parameters, or references to them, and builds each itself: leave out `build()`",
    note = "a model with places is built and searched by itself, and so is a rotor, whose whirls are searched: `campbell` takes many speeds"
)]
pub trait Model: Numbered {
    /// The built system over parameters of a type. That of [`Build`] is the same; with one of its own an error about a type that is no model says so.
    type System<T: Parameter>;

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

    fn of_numbers<T: Parameter>(&self, number: impl Fn(usize) -> T) -> Result<M::System<T>, ParameterError> {
        (*self).of_numbers(number)
    }

    fn build(&self) -> Result<M::System<f64>, ParameterError> {
        (*self).build()
    }
}
