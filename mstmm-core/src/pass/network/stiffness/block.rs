//! The stiffness pass at up to so many frequencies, in the lanes of the widest vectors that the machine has.

#[cfg(all(feature = "std", target_arch = "x86_64"))]
use crate::number::InLanes;
use crate::number::{Packed, Size, Task, run};
use crate::pass::network::stiffness::compiled::StiffnessScalar;
use crate::pass::network::stiffness::fronts::StiffnessRoom;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::total::StiffnessTotal;

/// The memory that an evaluation takes: its fronts are as wide as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Memory {
    /// For up to 8 displacements at once, as of a chain.
    #[default]
    Narrow,
    /// For up to 24.
    Wide,
    /// For up to 48, of one frequency at a time.
    Widest,
}

impl Memory {
    /// The next larger one.
    fn larger(self) -> Option<Self> {
        match self {
            Memory::Narrow => Some(Memory::Wide),
            Memory::Wide => Some(Memory::Widest),
            Memory::Widest => None,
        }
    }
}

/// Some frequencies with what was computed there.
pub(crate) struct StiffnessBlock<'a> {
    pub(crate) omega: &'a [f64],
    /// Whether it is watched where rounding may decide signs.
    pub(crate) watches: bool,
    /// Δ over `2^exponent`.
    pub(crate) value: &'a mut [f64],
    pub(crate) below: &'a mut [f64],
    /// A bit per frequency: whether Δ is not known, or rounding may have decided the sign of a pivot.
    pub(crate) unknown: u32,
    pub(crate) doubtful: u32,
    /// The power of two of all values; that of the first one, if there is none yet.
    pub(crate) exponent: Option<i64>,
    pub(crate) memory: Memory,
}

impl StiffnessBlock<'_> {
    /// Evaluates a network at all frequencies, in lanes where no wave has to be scaled, and in more memory where its fronts need that.
    pub(crate) fn evaluate(&mut self, model: &StiffnessModel<'_>, in_lanes: bool) {
        loop {
            let has_room = match self.memory {
                Memory::Narrow => self.in_memory::<8>(model, in_lanes),
                Memory::Wide => self.in_memory::<24>(model, in_lanes),
                Memory::Widest => self.in_memory::<48>(model, false),
            };
            let Some(larger) = self.memory.larger().filter(|_| !has_room) else { return };
            self.memory = larger;
        }
    }

    /// Evaluates a network in memory for up to `W` displacements at once: a call, since the stack has room for no more than is needed. Returns
    /// whether its fronts have room there.
    #[inline(never)]
    fn in_memory<const W: usize>(&mut self, model: &StiffnessModel<'_>, in_lanes: bool) -> bool {
        let evaluation = Evaluation::<W> { model, block: self };
        if in_lanes { run(evaluation) } else { evaluation.alone() }
    }

    /// Evaluates a network in the lanes of a number.
    #[inline(always)]
    fn in_lanes<S: Packed<f64> + StiffnessScalar, const W: usize>(&mut self, model: &StiffnessModel<'_>) -> bool {
        let mut room = StiffnessRoom::<S, W>::new();
        (self.unknown, self.doubtful) = (0, 0);
        let mut from = 0;
        while from < self.omega.len() {
            let lanes = from..self.omega.len().min(from + S::LANES);
            let omega = S::load(&self.omega[lanes.clone()]);
            let mut fronts = room.fronts(self.watches);
            if !S::eliminate_all(model, &mut fronts, &omega) {
                self.unknown = u32::MAX;
                return false;
            }
            let StiffnessTotal { product, exponent, below, is_doubtful } = fronts.total;
            let value = product
                .times_power_of_two((exponent - *self.exponent.get_or_insert(exponent)).clamp(-4000, 4000) as i32);
            // neither a NaN nor zero nor beyond the range
            let is_known = value.size().is_below(S::Size::of(f64::INFINITY)) & !value.vanishes();
            let all = (1u32 << lanes.len()) - 1;
            self.unknown |= (u32::from(S::bits(!is_known)) & all) << from;
            self.doubtful |= (u32::from(S::bits(is_doubtful)) & all) << from;
            value.store(&mut self.value[lanes.clone()]);
            S::store_size(below, &mut self.below[lanes]);
            from += S::LANES;
        }
        true
    }
}

/// The evaluation of a block in memory for up to `W` displacements at once.
struct Evaluation<'a, 'b, 'm, const W: usize> {
    model: &'a StiffnessModel<'m>,
    block: &'a mut StiffnessBlock<'b>,
}

impl<const W: usize> Task for Evaluation<'_, '_, '_, W> {
    type Output = bool;

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) -> bool {
        self.block.in_lanes::<<f64 as InLanes>::OnAvx512, W>(self.model)
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) -> bool {
        self.block.in_lanes::<<f64 as InLanes>::OnAvx2, W>(self.model)
    }

    fn alone(self) -> bool {
        self.block.in_lanes::<f64, W>(self.model)
    }
}
