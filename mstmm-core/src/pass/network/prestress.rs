//! Structures whose members take axial forces once they are built.

use crate::element::MemberElement;
use crate::model::InvalidParameter;
use crate::pass::network::memory::Memory;
use crate::pass::network::placed::Placed;
use crate::pass::network::structure::Network;

/// A structure whose members take further axial forces once it is built.
pub trait Prestressed: Placed + Clone {
    /// Adds an axial force \[N\], tension positive, to a member: the sum of two words. Returns whether the member bears one; none for a member that
    /// the structure has not got. [`describe`](Prestressed::describe) has to follow.
    #[doc(hidden)]
    fn add_axial_force(&mut self, member: usize, force: [f64; 2]) -> Option<Result<bool, InvalidParameter>>;

    /// Describes all members anew: their numbers, and the estimates from which searches take their first steps.
    #[doc(hidden)]
    fn describe(&mut self);

    /// The name of a member, or of its kind.
    #[doc(hidden)]
    fn name_of_member(&self, member: usize) -> &'static str;
}

impl<E: MemberElement, M: Memory> Prestressed for Network<E, M> {
    fn add_axial_force(&mut self, member: usize, force: [f64; 2]) -> Option<Result<bool, InvalidParameter>> {
        let own = self.members.as_mut().get_mut(member)?;
        let borne = E::under_axial_force((*own)?, force).map(|built| {
            let bears = built.is_some();
            *own = built.or(*own);
            bears
        });
        Some(borne)
    }

    fn describe(&mut self) {
        for (index, member) in self.members.as_ref().iter().enumerate() {
            if let Some(member) = member {
                self.stiffness.set_member(index, E::member_numbers(member), &self.placements.as_ref()[index]);
            }
        }
        self.stiffness.arrange(&self.order.get());
        self.estimate();
    }

    fn name_of_member(&self, member: usize) -> &'static str {
        self.kinds().get(member).copied().unwrap_or_default()
    }
}
