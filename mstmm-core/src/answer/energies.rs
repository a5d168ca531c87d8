//! Mass, stiffness and damping forms of elements, and their sums over a system.

use crate::answer::states::SystemStates;
use crate::element::{CoefficientsOf, Moving, Visit};
use crate::model::Ends;
use crate::number::Single;
use crate::pass::tree::Tree;

/// A form of two motions of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Form {
    Mass,
    Stiffness,
    Damping,
}

/// Evaluates a form.
pub(crate) struct FormOf<S> {
    pub(crate) form: Form,
    pub(crate) first: Ends<S>,
    pub(crate) second: Ends<S>,
}

impl<S: Single> Visit<S> for FormOf<S> {
    type Output = S;

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> S {
        match self.form {
            Form::Mass => E::mass_form(built, &self.first, &self.second),
            Form::Stiffness => E::stiffness_form(built, &self.first, &self.second),
            Form::Damping => E::damping_form(built, &self.first, &self.second),
        }
    }
}

impl<Y: Tree<S> + ?Sized, S: Single> SystemStates<'_, Y, S> {
    /// A form of this motion and another, summed over the system.
    pub(crate) fn form(&self, form: Form, other: &Self) -> S {
        let of =
            |step| self.system.visit(None, step, FormOf { form, first: self.ends(step), second: other.ends(step) });
        (0..self.system.scheme().len()).filter_map(of).fold(S::zero(), |sum, form| sum + form)
    }
}
