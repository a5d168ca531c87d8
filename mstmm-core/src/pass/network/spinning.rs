//! A network some of whose members spin.

use crate::element::MemberSpins;
use crate::pass::network::memory::Vectors;
use crate::pass::network::structure::Network;

impl<E: MemberSpins> Network<E, Vectors> {
    /// The network as the other whirl sees it.
    pub(crate) fn turned_round(mut self) -> Self {
        for (index, member) in self.members.iter_mut().enumerate() {
            *member = member.take().map(E::turned_round);
            if let Some(member) = member {
                self.stiffness.set_numbers(index, E::member_numbers(member));
            }
        }
        self
    }
}
