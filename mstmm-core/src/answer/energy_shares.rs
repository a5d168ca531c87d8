//! Energies of a mode, element by element.

use crate::answer::energies::{Form, FormOf};
use crate::answer::mode_shape::ModeShape;
use crate::model::{Ends, Label, State};
use crate::number::{Oscillation, Scalar};
use crate::pass::tree::Tree;
use num_complex::Complex;
use num_traits::Zero;

/// Shares of an element in the energies of a mode, from 0 to 1. The shares of all elements in an energy add up to 1, or to 0 if
/// the mode has none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyShares<T> {
    /// Share in the strain energy.
    pub strain: T,
    /// Share in the kinetic energy.
    pub kinetic: T,
    /// Share in the energy that dampers dissipate.
    pub dissipated: T,
}

impl<Y, S> ModeShape<'_, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// The shares of an element in the energies of this mode, averaged over a cycle.
    pub fn energy_shares<E>(&self, label: Label<Y::Model, E>) -> EnergyShares<Y::Parameter> {
        let share = |form: Form| {
            let of = |step: usize| self.energy(form, step);
            let whole =
                (0..self.system.scheme().len()).map(of).fold(Y::Parameter::from_f64(0.0), |sum, part| sum + part);
            if whole.is_zero() { whole } else { of(label.step) / whole }
        };
        // at a real frequency the form of first order is that of gyroscopic moments, which take no energy
        let is_real = self.x.lambda().is_zero();
        let dissipated = if is_real { Y::Parameter::from_f64(0.0) } else { share(Form::Damping) };
        EnergyShares { strain: share(Form::Stiffness), kinetic: share(Form::Mass), dissipated }
    }

    /// A form of the motion of an element and its conjugate, real and positive; that of damping with what a loss factor, a seal and a damped material that
    /// turns take, `Im K/Im λ`.
    fn energy(&self, form: Form, step: usize) -> Y::Parameter {
        let energy = self.with_conjugate(form, step).re;
        let is_lossy = matches!(form, Form::Damping) && !self.system.frequency_estimates().have_images();
        if !is_lossy {
            return energy;
        }
        energy + self.with_conjugate(Form::Stiffness, step).im / self.x.to_complex().im
    }

    /// A form of the motion of an element and its conjugate.
    fn with_conjugate(&self, form: Form, step: usize) -> Complex<Y::Parameter> {
        let first = self.ends(step);
        let conjugate = |state: State<S>| state.map(S::conjugate);
        let second = Ends { x: first.x.conjugate(), input: conjugate(first.input), output: conjugate(first.output) };
        let value = self.system.visit(None, step, FormOf { form, first, second });
        value.map_or(Complex::zero(), S::to_complex)
    }
}
