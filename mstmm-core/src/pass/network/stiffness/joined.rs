//! How members that do not share all freedoms with their nodes are added: by a call, compiled with this library once for each number, and
//! for vectors on their own instruction set. Most structures have none.

use crate::number::Frequency;
use crate::pass::network::stiffness::fronts::StiffnessFronts;
use crate::pass::network::stiffness::in_front::InFront;
use crate::pass::network::stiffness::released::OwnStiffness;

/// A number at which such members are added.
pub(super) trait Joins: Frequency<f64> {
    /// Adds a member.
    fn join<const N: usize>(
        own: &mut OwnStiffness<Self, N>,
        fronts: &mut StiffnessFronts<'_, Self>,
        member: InFront<'_>,
    );
}

impl Joins for f64 {
    #[inline(never)]
    fn join<const N: usize>(
        own: &mut OwnStiffness<Self, N>,
        fronts: &mut StiffnessFronts<'_, Self>,
        member: InFront<'_>,
    ) {
        own.join(fronts, member);
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
mod in_vectors {
    use super::{InFront, Joins, OwnStiffness, StiffnessFronts};
    use crate::number::lanes::Waving;
    use mstmm_lanes::{Eight, Four, Lanes, Part, Vector};

    /// The join of a member.
    struct Join<'a, 'r, V: Waving, const N: usize> {
        own: &'a mut OwnStiffness<Lanes<V>, N>,
        fronts: &'a mut StiffnessFronts<'r, Lanes<V>>,
        member: InFront<'a>,
    }

    impl<V: Waving, const N: usize> Part for Join<'_, '_, V, N> {
        #[inline(always)]
        fn run(self) {
            self.own.join(self.fronts, self.member);
        }
    }

    macro_rules! vectors {
        ($($vector:ty),*) => {$(
            impl Joins for Lanes<$vector> {
                #[inline(never)]
                fn join<const N: usize>(
                    own: &mut OwnStiffness<Self, N>,
                    fronts: &mut StiffnessFronts<'_, Self>,
                    member: InFront<'_>,
                ) {
                    <$vector>::call(Join { own, fronts, member });
                }
            }
        )*};
    }
    vectors!(Eight, Four);
}
