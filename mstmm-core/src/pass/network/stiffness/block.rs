//! The stiffness pass at up to so many frequencies, in the lanes of the widest vectors that the machine has.

#[cfg(all(feature = "std", target_arch = "x86_64"))]
use crate::number::InLanes;
use crate::number::{Packed, Size, Task, run};
#[cfg(feature = "std")]
use crate::pass::network::stiffness::front::IN_SPACE;
use crate::pass::network::stiffness::front::{IN_PLANE, StiffnessFront};
use crate::pass::network::stiffness::group::MOST;
#[cfg(feature = "std")]
use crate::pass::network::stiffness::in_space::eliminate_all_in_space;
use crate::pass::network::stiffness::joined::Joins;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::pass::eliminate_all;
#[cfg(feature = "std")]
use crate::pass::network::stiffness::spatial_room::SpatialRoom;
use crate::pass::network::stiffness::total::StiffnessTotal;
use crate::structure::triangle::row;

/// Some frequencies with what was computed there.
pub(crate) struct StiffnessBlock<'a> {
    pub(crate) omega: &'a [f64],
    /// Δ over `2^exponent`.
    pub(crate) value: &'a mut [f64],
    pub(crate) below: &'a mut [f64],
    /// A bit per frequency: whether Δ is not known, or zero.
    pub(crate) unknown: u32,
    /// The power of two of all values; that of the first one, if there is none yet.
    pub(crate) exponent: Option<i64>,
}

impl StiffnessModel<'_> {
    /// Δ at some frequencies over one power of two, and the counts there, in the lanes of the widest vectors in use: what searches ask for.
    pub fn evaluate(&self, omega: &[f64], value: &mut [f64], below: &mut [f64]) {
        StiffnessBlock { omega, value, below, unknown: 0, exponent: None }.evaluate(self, omega.len() > 1);
    }
}

impl StiffnessBlock<'_> {
    /// Evaluates a network at all frequencies, in memory for as many variables as it has at once: of few, as of a chain, in lanes where no wave
    /// has to be scaled, of many one frequency at a time.
    pub(crate) fn evaluate(&mut self, model: &StiffnessModel<'_>, in_lanes: bool) {
        #[cfg(feature = "std")]
        if model.space.is_some() {
            return match model.width {
                0..=24 => self.in_memory::<24, 300, IN_SPACE>(model, in_lanes),
                25..=36 => self.in_memory::<36, 666, IN_SPACE>(model, in_lanes),
                _ => self.in_memory::<MOST, 1176, IN_SPACE>(model, in_lanes),
            };
        }
        match model.width {
            0..=8 => self.in_memory::<8, 36, IN_PLANE>(model, in_lanes),
            9..=24 => self.in_memory::<24, 300, IN_PLANE>(model, in_lanes),
            _ => self.in_memory::<MOST, 1176, IN_PLANE>(model, false),
        }
    }

    /// Evaluates a network in memory for a front: a call, since the stack has room for no more than is needed.
    #[inline(never)]
    fn in_memory<const W: usize, const ENTRIES: usize, const G: usize>(
        &mut self,
        model: &StiffnessModel<'_>,
        in_lanes: bool,
    ) {
        let evaluation = Evaluation::<W, ENTRIES, G> { model, block: self };
        if in_lanes { run(evaluation) } else { evaluation.alone() }
    }

    /// Evaluates a network in the lanes of a number.
    #[inline(always)]
    fn in_lanes<S: Packed<f64> + StiffnessScalar, const W: usize, const ENTRIES: usize, const G: usize>(
        &mut self,
        model: &StiffnessModel<'_>,
    ) {
        const { assert!(ENTRIES == row(W)) };
        let (mut entries, mut places, mut solved) = ([S::zero(); ENTRIES], [0; W], [[S::zero(); G]; W]);
        self.unknown = 0;
        let mut from = 0;
        while from < self.omega.len() {
            let lanes = from..self.omega.len().min(from + S::LANES);
            let omega = S::load(&self.omega[lanes.clone()]);
            let mut front = StiffnessFront::new(model.width, &mut entries, &mut places, solved.as_flattened_mut());
            eliminate::<S, G>(model, &mut front, &omega);
            let StiffnessTotal { product, exponent, below } = front.total;
            let value = product
                .times_power_of_two((exponent - *self.exponent.get_or_insert(exponent)).clamp(-4000, 4000) as i32);
            // neither a NaN nor zero nor beyond the range
            let is_known = value.size().is_below(S::Size::of(f64::INFINITY)) & !value.vanishes();
            let all = (1u32 << lanes.len()) - 1;
            self.unknown |= (u32::from(S::bits(!is_known)) & all) << from;
            value.store(&mut self.value[lanes.clone()]);
            S::store_size(below, &mut self.below[lanes]);
            from += S::LANES;
        }
    }
}

/// Eliminates all nodes, of which up to `G` variables leave together.
#[inline(always)]
fn eliminate<S: StiffnessScalar, const G: usize>(
    model: &StiffnessModel<'_>,
    front: &mut StiffnessFront<'_, S>,
    omega: &S,
) {
    #[cfg(feature = "std")]
    if let (IN_SPACE, Some(space)) = (G, model.space) {
        return S::eliminate_all_in_space(model, space, front, omega);
    }
    S::eliminate_all(model, front, omega);
}

/// A number at which networks are evaluated by stiffnesses, compiled with this library.
trait StiffnessScalar: Joins {
    /// Eliminates all nodes.
    fn eliminate_all(model: &StiffnessModel<'_>, front: &mut StiffnessFront<'_, Self>, omega: &Self);

    /// Eliminates all nodes of a structure in space.
    #[cfg(feature = "std")]
    fn eliminate_all_in_space(
        model: &StiffnessModel<'_>,
        space: &SpatialRoom,
        front: &mut StiffnessFront<'_, Self>,
        omega: &Self,
    );
}

impl StiffnessScalar for f64 {
    #[inline(never)]
    fn eliminate_all(model: &StiffnessModel<'_>, front: &mut StiffnessFront<'_, Self>, omega: &Self) {
        eliminate_all(model, front, *omega);
    }

    #[cfg(feature = "std")]
    #[inline(never)]
    fn eliminate_all_in_space(
        model: &StiffnessModel<'_>,
        space: &SpatialRoom,
        front: &mut StiffnessFront<'_, Self>,
        omega: &Self,
    ) {
        eliminate_all_in_space(model, space, front, *omega);
    }
}

/// The evaluation of a block in memory for a front of up to `W` variables.
struct Evaluation<'a, 'b, 'm, const W: usize, const ENTRIES: usize, const G: usize> {
    model: &'a StiffnessModel<'m>,
    block: &'a mut StiffnessBlock<'b>,
}

impl<const W: usize, const ENTRIES: usize, const G: usize> Task for Evaluation<'_, '_, '_, W, ENTRIES, G> {
    type Output = ();

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.block.in_lanes::<<f64 as InLanes>::OnAvx512, W, ENTRIES, G>(self.model);
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) {
        self.block.in_lanes::<<f64 as InLanes>::OnAvx2, W, ENTRIES, G>(self.model);
    }

    fn alone(self) {
        self.block.in_lanes::<f64, W, ENTRIES, G>(self.model);
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
mod in_vectors {
    use super::{
        Joins, SpatialRoom, StiffnessFront, StiffnessModel, StiffnessScalar, eliminate_all, eliminate_all_in_space,
    };
    use crate::number::lanes::Waving;
    use mstmm_lanes::{Eight, Four, Lanes, Part, Vector};

    /// The elimination of all nodes.
    struct Elimination<'a, 'm, 'r, V: Waving> {
        model: &'a StiffnessModel<'m>,
        front: &'a mut StiffnessFront<'r, Lanes<V>>,
        omega: &'a Lanes<V>,
    }

    impl<V: Waving> Part for Elimination<'_, '_, '_, V>
    where
        Lanes<V>: Joins,
    {
        type Output = ();

        #[inline(always)]
        fn run(self) {
            eliminate_all(self.model, self.front, *self.omega);
        }
    }

    /// The elimination of all nodes of a structure in space.
    struct EliminationInSpace<'a, 'm, 'r, V: Waving> {
        model: &'a StiffnessModel<'m>,
        space: &'a SpatialRoom,
        front: &'a mut StiffnessFront<'r, Lanes<V>>,
        omega: &'a Lanes<V>,
    }

    impl<V: Waving> Part for EliminationInSpace<'_, '_, '_, V>
    where
        Lanes<V>: Joins,
    {
        type Output = ();

        #[inline(always)]
        fn run(self) {
            eliminate_all_in_space(self.model, self.space, self.front, *self.omega);
        }
    }

    macro_rules! vectors {
        ($($vector:ty),*) => {$(
            impl StiffnessScalar for Lanes<$vector> {
                #[inline(never)]
                fn eliminate_all(
                    model: &StiffnessModel<'_>,
                    front: &mut StiffnessFront<'_, Self>,
                    omega: &Self,
                ) {
                    <$vector>::call(Elimination { model, front, omega });
                }

                #[inline(never)]
                fn eliminate_all_in_space(
                    model: &StiffnessModel<'_>,
                    space: &SpatialRoom,
                    front: &mut StiffnessFront<'_, Self>,
                    omega: &Self,
                ) {
                    <$vector>::call(EliminationInSpace { model, space, front, omega });
                }
            }
        )*};
    }
    vectors!(Eight, Four);
}
