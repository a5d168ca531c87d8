//! What an element is across itself, and what it needs in order to stretch as well.

use crate::element::Element;
use crate::elements::shared::uniform_line::{LineSection, UniformLine};
use crate::model::InvalidParameter;
use crate::number::{FrequencyPowers, Parameter, Scalar};
use crate::structure::Chart;
use core::fmt::Debug;
use mstmm_plan::Freedoms;

/// The parameters of an element that moves across itself, or derivatives with respect to them.
pub trait Across: Sized {
    /// What each parameter is.
    type Number;

    /// The element of another length.
    #[must_use]
    fn of_length(self, length: Self::Number) -> Self;

    /// The derivatives, and those of a line along the element with respect to what it has in common with this.
    #[doc(hidden)]
    #[must_use]
    fn and_along(self, along: AlongGradient<Self::Number>) -> Self;
}

/// The derivatives of the dynamic work of the line along an element: with respect to its length, its axial stiffness, its mass per length and to
/// loss factor, time and external damping.
#[derive(Clone, Copy, Debug)]
pub struct AlongGradient<S> {
    pub(crate) length: S,
    pub(crate) stiffness: S,
    pub(crate) mass: S,
    pub(crate) damping: [S; 3],
}

/// An element of a line that stretches in the plane.
pub trait Stretching: Element + Across<Number: Parameter> {
    /// The line along it.
    type Line: Along<Self::Number>;

    /// Whether it is a string: where it stands in a path it moves along the path, and in the plane across itself.
    #[doc(hidden)]
    const IS_STRING: bool = false;

    /// The line of an axial stiffness along what is built.
    ///
    /// # Errors
    /// [`InvalidParameter`] names the parameter that is out of its range, with its value.
    #[doc(hidden)]
    fn line(built: &Self::Built, axial_stiffness: Self::Number) -> Result<Self::Line, InvalidParameter>;
}

/// A line along an element.
pub trait Along<T>: Copy + Debug {
    /// Its length and its axial stiffness.
    #[doc(hidden)]
    fn length_and_stiffness(&self) -> [T; 2];
}

/// An element whose chart across itself may stand beside that of a line along it.
pub(crate) trait ChartedAcross<S: Scalar>: Element {
    /// The chart, with an empty place for the displacement along the element at each end where that has an impedance.
    fn chart_across(built: &Self::Built, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S>;
}

/// The freedoms of a beam, with that along it or without, and the places of deflection and rotation of both ends among them.
pub(crate) fn freedoms_of_beam(stretches: bool) -> (Freedoms, [usize; 4]) {
    if stretches { (Freedoms::PLANE, [1, 2, 4, 5]) } else { (Freedoms::Y.union(Freedoms::RZ), [0, 1, 2, 3]) }
}

/// The line along a beam.
pub(crate) fn line_along<T: Parameter>(
    [length, axial_stiffness, mass_per_length]: [T; 3],
) -> Result<UniformLine<T>, InvalidParameter> {
    let section = LineSection { length, stiffness: axial_stiffness, inertia: mass_per_length, foundation: T::zero() };
    section.build(["length", "axial_stiffness", "mass_per_length", "foundation_stiffness"])
}
