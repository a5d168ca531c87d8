//! What of a stiffness pass is compiled with this library, once for each number: called, and for vectors on their own instruction set.

use crate::number::Frequency;
use crate::pass::network::stiffness::fronts::StiffnessFronts;
use crate::pass::network::stiffness::in_front::InFront;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::pass::eliminate_all;
use crate::pass::network::stiffness::released::OwnStiffness;

/// A number at which networks are evaluated by stiffnesses.
pub(super) trait StiffnessScalar: Frequency<f64> {
    /// Eliminates all nodes. Returns whether that is possible.
    fn eliminate_all(model: &StiffnessModel<'_>, fronts: &mut StiffnessFronts<'_, Self>, omega: &Self) -> bool;

    /// Adds a member that does not share all freedoms with its nodes: a call, since most structures have none.
    fn join<const N: usize>(
        own: &mut OwnStiffness<Self, N>,
        fronts: &mut StiffnessFronts<'_, Self>,
        member: InFront<'_>,
    );
}

impl StiffnessScalar for f64 {
    #[inline(never)]
    fn eliminate_all(model: &StiffnessModel<'_>, fronts: &mut StiffnessFronts<'_, Self>, omega: &Self) -> bool {
        eliminate_all(model, fronts, *omega).is_some()
    }

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
    use super::{InFront, OwnStiffness, StiffnessFronts, StiffnessModel, StiffnessScalar, eliminate_all};
    use crate::number::lanes::Waving;
    use mstmm_lanes::{Eight, Four, Lanes, Part, Vector};

    /// The elimination of all nodes.
    struct Elimination<'a, 'm, 'r, V: Waving> {
        model: &'a StiffnessModel<'m>,
        fronts: &'a mut StiffnessFronts<'r, Lanes<V>>,
        omega: &'a Lanes<V>,
        is_whole: &'a mut bool,
    }

    impl<V: Waving> Part for Elimination<'_, '_, '_, V>
    where
        Lanes<V>: StiffnessScalar,
    {
        #[inline(always)]
        fn run(self) {
            *self.is_whole = eliminate_all(self.model, self.fronts, *self.omega).is_some();
        }
    }

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
            impl StiffnessScalar for Lanes<$vector> {
                #[inline(never)]
                fn eliminate_all(
                    model: &StiffnessModel<'_>,
                    fronts: &mut StiffnessFronts<'_, Self>,
                    omega: &Self,
                ) -> bool {
                    let mut is_whole = false;
                    <$vector>::call(Elimination { model, fronts, omega, is_whole: &mut is_whole });
                    is_whole
                }

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
