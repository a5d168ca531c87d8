//! Elements on which a uniform load acts.

use crate::model::{Label, Load, MemberLabel, PlaneLoad};

/// An element on which a load acts all along, known by [`load_work`](crate::Energies::load_work).
///
/// Whether an element of a list carries one is known at run time; others say [`NoUniformLoad`](crate::MotionError::NoUniformLoad).
#[diagnostic::on_unimplemented(
    message = "no uniform load acts on `{Self}`",
    label = "carries no load along its length",
    note = "beams, strings, rods and shafts take `uniform_load()`; a spring or a body has points, which take `force()` and `torque()`"
)]
pub trait CarriesLoad {}

impl<M, E> Label<M, E> {
    /// A load of 1 N/m all along the element, towards Y; of a shaft a torque of 1 N m/m, towards Θ.
    ///
    /// ```
    /// use mstmm::prelude::*;
    ///
    /// system! {
    ///     struct Cantilever { length: f64, ei: f64, m: f64 }
    ///     fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> free;
    /// }
    ///
    /// let beam = Cantilever { length: 2.0, ei: 1e4, m: 3.0 }.build()?;
    /// let tip = Cantilever::beam_1.output();
    /// let response = beam.frequency_response(Cantilever::beam_1.uniform_load(), tip.deflection())?;
    /// assert!((response.at(0.0)? - 2.0_f64.powi(4) / 8e4).abs() < 1e-18); // q l⁴/(8 EI)
    /// assert!(response.at(20.0)? > response.at(0.0)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn uniform_load(self) -> Load<M>
    where
        E: CarriesLoad,
    {
        Load::along(self.step)
    }
}

impl<M, E> MemberLabel<M, E> {
    /// A load of 1 N along x on each metre of the member's length, whatever its direction.
    pub const fn uniform_load_x(self) -> PlaneLoad<M>
    where
        E: CarriesLoad,
    {
        PlaneLoad::along(self.index(), 0)
    }

    /// A load of 1 N along y on each metre of the member's length, whatever its direction.
    ///
    /// ```
    /// use mstmm::prelude::*;
    ///
    /// system! {
    ///     /// A portal under a load on its girder.
    ///     struct Portal { height: f64, span: f64, ea: f64, ei: f64, m: f64 }
    ///     fixed at (0.0, 0.0)
    ///         -> planar_beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
    ///         -> planar_beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
    ///         <- planar_beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (span, 0.0);
    /// }
    ///
    /// let portal = Portal { height: 3.0, span: 4.0, ea: 1e12, ei: 1e6, m: 20.0 }.build()?;
    /// let girder = Portal::planar_beam_2;
    /// let response = portal.frequency_response(girder.uniform_load_y(), girder.input().moment())?;
    ///
    /// // the diagram of moments at rest, for bars that do not stretch: q l²/(6 (2 + h/l)) at the corners, with q l²/8 less in the middle
    /// let at_rest = response.states(0.0)?;
    /// let corner = 16.0 / (6.0 * (2.0 + 0.75));
    /// for (part, moment) in [(0.0, corner), (0.5, corner - 2.0), (1.0, corner)] {
    ///     assert!((at_rest.along(girder, 4.0 * part)?.moment - moment).abs() < 1e-4);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn uniform_load_y(self) -> PlaneLoad<M>
    where
        E: CarriesLoad,
    {
        PlaneLoad::along(self.index(), 1)
    }
}

/// The label of a member of a list, whose type is known at run time.
impl CarriesLoad for () {}
