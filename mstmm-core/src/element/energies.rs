//! The energies of an element, and how its parameters change them.

use crate::element::traits::Element;
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Scalar};

/// The interior of an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// Length \[m\].
    pub length: f64,
    /// Wave number of the deflection along the element [rad/m].
    pub wave_number: f64,
}

/// An element whose energies are known.
///
/// The dynamic work of an element is `L = V + λ² T + λ D`, with `2V` its stiffness, `2T` its mass and `2D` its damping form.
/// Summed over a system it is stationary and zero at a mode, so that `dλ/dp = -(∂L/∂p)/(∂L/∂λ)`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say how it moves",
    label = "no `Energies<{S}>` for this element",
    note = "mode shapes, responses and sensitivities need it; planar elements have motions between points with places; an element of your own \
            implements `mstmm::element::Energies<S>`"
)]
pub trait Energies<S: Scalar>: Element {
    /// The derivatives with respect to the parameters: the struct of the parameters, over `S`.
    type Gradient;

    /// Usual sizes of forces per displacement in the element, `[Q/Y, M/Θ]`, by which entries of a state are compared.
    fn units(built: &Self::Built, at: &FrequencyPowers<S>) -> [f64; 2];

    /// The mass form of two motions, `∫ m Y₁ Y₂ dx` for a beam: twice the kinetic energy over `(dt)²` of one.
    fn mass_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S;

    /// The stiffness form of two motions, `∫ EI Y₁'' Y₂'' dx` for a beam: twice the strain energy of one.
    fn stiffness_form(built: &Self::Built, first: &Ends<S>, second: &Ends<S>) -> S;

    /// The damping form of two motions, `C ΔY₁ ΔY₂` for a damper.
    #[inline]
    fn damping_form(_built: &Self::Built, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    /// The interior between the ends; `None` for an element without one.
    #[inline]
    fn inside(_built: &Self::Built, _x: S) -> Option<Inside> {
        None
    }

    /// The state at a distance from the input end, up to the length of [`inside`](Energies::inside).
    #[inline]
    fn state_at(_built: &Self::Built, ends: &Ends<S>, _distance: f64) -> State<S> {
        ends.input
    }

    /// The work of a load of 1 per length all along the element on a motion: `∫ Y dx`, of a shaft `∫ Θ dx`; `None` where no such load acts.
    #[inline]
    fn load_work(_built: &Self::Built, _ends: &Ends<S>) -> Option<S> {
        None
    }

    /// The mass per length of an element on which a uniform load acts; zero where its motion is a rotation.
    #[inline]
    fn mass_per_length(_built: &Self::Built) -> S {
        S::zero()
    }

    /// `∂L/∂p` for each parameter, with the displacements at both ends held.
    fn gradient(built: &Self::Built, ends: &Ends<S>) -> Self::Gradient;
}
