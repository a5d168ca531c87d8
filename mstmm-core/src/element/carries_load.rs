//! Elements on which a uniform load acts.

use crate::model::{InSpace, Label, Load, MemberLabel, PlaneLoad};

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
        PlaneLoad::along(self.handle(), 0)
    }

    /// A load of 1 N along y on each metre of the member's length, whatever its direction.
    pub const fn uniform_load_y(self) -> PlaneLoad<M>
    where
        E: CarriesLoad,
    {
        PlaneLoad::along(self.handle(), 1)
    }
}

impl<M: InSpace, E: CarriesLoad> MemberLabel<M, E> {
    /// A load of 1 N along z on each metre of the member's length, whatever its direction, in space.
    pub const fn uniform_load_z(self) -> PlaneLoad<M> {
        PlaneLoad::along(self.handle(), 3)
    }
}

/// The label of a member of a list, whose type is known at run time.
impl CarriesLoad for () {}
