//! How members that do not share all freedoms with their nodes are added: by a call, compiled with this library once for each number, and
//! for vectors on their own instruction set. Most structures have none.

use crate::number::Frequency;
use crate::pass::network::stiffness::front::StiffnessFront;
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::released::OwnStiffness;

/// A number at which such members are added.
pub(super) trait Joins: Frequency<f64> {
    /// Adds a member that does not share all freedoms with its nodes.
    fn join<const N: usize>(
        own: &mut OwnStiffness<Self, N>,
        front: &mut StiffnessFront<'_, Self>,
        member: &StiffnessMember,
    );
}

impl Joins for f64 {
    #[inline(never)]
    fn join<const N: usize>(
        own: &mut OwnStiffness<Self, N>,
        front: &mut StiffnessFront<'_, Self>,
        member: &StiffnessMember,
    ) {
        own.join(front, member);
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
mod in_vectors {
    use super::{Joins, OwnStiffness, StiffnessFront, StiffnessMember};
    use crate::number::lanes::Waving;
    use mstmm_lanes::{Eight, Four, Lanes, Part, Vector};

    /// The join of a member.
    struct Join<'a, 'r, V: Waving, const N: usize> {
        own: &'a mut OwnStiffness<Lanes<V>, N>,
        front: &'a mut StiffnessFront<'r, Lanes<V>>,
        member: &'a StiffnessMember,
    }

    impl<V: Waving, const N: usize> Part for Join<'_, '_, V, N>
    where
        Lanes<V>: Joins,
    {
        type Output = ();

        #[inline(always)]
        fn run(self) {
            self.own.join(self.front, self.member);
        }
    }

    macro_rules! vectors {
        ($($vector:ty),*) => {$(
            impl Joins for Lanes<$vector> {
                #[inline(never)]
                fn join<const N: usize>(
                    own: &mut OwnStiffness<Self, N>,
                    front: &mut StiffnessFront<'_, Self>,
                    member: &StiffnessMember,
                ) {
                    <$vector>::call(Join { own, front, member });
                }
            }
        )*};
    }
    vectors!(Eight, Four);
}
