//! Elements on which a uniform load acts.

use crate::model::{Label, Load};

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
