//! Δ, counts and phases at several frequencies at once, in the lanes of the widest vectors that the machine has.

use crate::number::{InLanes, Packed, Real, Scaled, Size, Task, Truth, run};
use crate::pass::characteristic::{Characteristic, counted_pass};
use crate::pass::phase::PhaseCounter;
use crate::subspace::{NoCount, WittrickWilliams};
use core::ops::Range;

/// Most frequencies of a block.
pub(crate) const MOST: usize = 16;

/// Number of lanes of the instruction set in use.
#[inline]
pub(crate) fn lanes<T: InLanes>() -> usize {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    match mstmm_lanes::InstructionSet::in_use() {
        mstmm_lanes::InstructionSet::Avx512 => return T::OnAvx512::LANES,
        mstmm_lanes::InstructionSet::Avx2 => return T::OnAvx2::LANES,
        mstmm_lanes::InstructionSet::Target => {}
    }
    <T as Packed<T>>::LANES
}

/// Several frequencies with what was computed there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block<T> {
    /// The frequencies [rad/s].
    pub(crate) omega: [T; MOST],
    /// Δ over a power of two that is the same for all; NaN where the frequency has to be evaluated alone.
    pub(crate) value: [T; MOST],
    /// The number of natural frequencies below.
    pub(crate) below: [f64; MOST],
    /// That number with a share of the next frequency.
    pub(crate) phase: [f64; MOST],
    /// A bit per lane: whether Δ is not known, or zero, or smaller, compared with its terms, than near a well-conditioned root.
    pub(crate) unknown: u32,
    /// The power of two of all values; none before the first evaluation.
    exponent: Option<i64>,
}

impl<T: InLanes + Real> Block<T> {
    /// Room for frequencies.
    #[inline]
    pub(crate) fn new() -> Self {
        Block {
            omega: [T::one(); MOST],
            value: [T::zero(); MOST],
            below: [0.0; MOST],
            phase: [0.0; MOST],
            unknown: 0,
            exponent: None,
        }
    }

    /// Evaluates the first so many frequencies.
    #[inline]
    pub(crate) fn evaluate<P: Purpose, Y>(&mut self, purpose: P, system: &Y, count: usize)
    where
        Y: Characteristic<T> + Characteristic<T::OnAvx512> + Characteristic<T::OnAvx2> + ?Sized,
    {
        run(Evaluation { purpose, system, block: self, count: count.min(MOST) });
    }

    /// The count on which a lane and the next one agree, if they are neither at a root nor doubtful.
    #[inline]
    pub(crate) fn agreed_count(&self, lane: usize) -> Option<u64> {
        let agree = self.unknown >> lane & 0b11 == 0 && self.below[lane] == self.below[lane + 1];
        agree.then_some(self.below[lane] as u64)
    }

    /// Writes Δ to some lanes. Numbers in lanes have all the same power of two.
    #[inline(always)]
    fn set_values<S: Packed<T>>(&mut self, lanes: Range<usize>, delta: Scaled<S>, is_doubtful: S::Truth) {
        let common = *self.exponent.get_or_insert(delta.exponent());
        let shift = (delta.exponent() - common).clamp(-3000, 3000) as i32;
        let value = if shift == 0 { delta.mantissa() } else { delta.mantissa().times_power_of_two(shift) };
        let is_known = value.size().is_below(S::Size::of(f64::INFINITY)) & !value.vanishes();
        self.unknown |= u32::from(S::bits(is_doubtful | !is_known)) << lanes.start;
        value.store(&mut self.value[lanes]);
    }

    /// Writes counts to some lanes.
    #[inline(always)]
    fn set_counts<S: Packed<T>>(&mut self, lanes: Range<usize>, delta: Scaled<S>, counter: &WittrickWilliams<S::Size>) {
        let cancelled = counter.cancelled();
        S::store_size(counter.count(), &mut self.below[lanes.clone()]);
        self.set_values(lanes, delta, cancelled.at_root | S::Truth::of(cancelled.any()));
    }
}

/// What a block is evaluated for.
pub(crate) trait Purpose: Copy {
    /// Evaluates some lanes.
    fn evaluate<T: InLanes + Real, S: Packed<T>, Y: Characteristic<S> + ?Sized>(
        self,
        system: &Y,
        block: &mut Block<T>,
        lanes: Range<usize>,
    );
}

/// Δ alone.
#[derive(Clone, Copy)]
pub(crate) struct Values;

/// Δ and counts.
#[derive(Clone, Copy)]
pub(crate) struct Counts {
    /// Whether frequencies are so close to roots that the terms of Δ are examined.
    pub(crate) is_at_root: bool,
}

/// Δ, counts and phases.
#[derive(Clone, Copy)]
pub(crate) struct Phases;

impl Purpose for Values {
    #[inline(always)]
    fn evaluate<T: InLanes + Real, S: Packed<T>, Y: Characteristic<S> + ?Sized>(
        self,
        system: &Y,
        block: &mut Block<T>,
        lanes: Range<usize>,
    ) {
        let delta = system.pass(S::load(&block.omega[lanes.clone()]), &mut NoCount);
        block.set_values(lanes, delta, S::Truth::of(false));
    }
}

impl Purpose for Counts {
    #[inline(always)]
    fn evaluate<T: InLanes + Real, S: Packed<T>, Y: Characteristic<S> + ?Sized>(
        self,
        system: &Y,
        block: &mut Block<T>,
        lanes: Range<usize>,
    ) {
        let mut counter = WittrickWilliams::<S::Size>::new(self.is_at_root);
        let delta = system.pass(S::load(&block.omega[lanes.clone()]), &mut counter);
        block.set_counts(lanes, delta, &counter);
    }
}

impl Purpose for Phases {
    #[inline(always)]
    fn evaluate<T: InLanes + Real, S: Packed<T>, Y: Characteristic<S> + ?Sized>(
        self,
        system: &Y,
        block: &mut Block<T>,
        lanes: Range<usize>,
    ) {
        let mut counter = PhaseCounter::new();
        let delta = system.pass(S::load(&block.omega[lanes.clone()]), &mut counter);
        S::store_size(counter.phase(delta), &mut block.phase[lanes.clone()]);
        block.set_counts(lanes, delta, counter.counter());
    }
}

/// The evaluation of a block.
struct Evaluation<'a, P, Y: ?Sized, T> {
    purpose: P,
    system: &'a Y,
    block: &'a mut Block<T>,
    count: usize,
}

impl<P: Purpose, Y: ?Sized, T: InLanes + Real> Evaluation<'_, P, Y, T> {
    #[inline(always)]
    fn in_lanes<S: Packed<T>>(self)
    where
        Y: Characteristic<S>,
    {
        let Evaluation { purpose, system, block, count } = self;
        block.unknown = 0;
        let mut from = 0;
        while from < count {
            let to = count.min(from + S::LANES);
            purpose.evaluate::<T, S, Y>(system, block, from..to);
            from = to;
        }
    }
}

impl<P: Purpose, T, Y> Task for Evaluation<'_, P, Y, T>
where
    T: InLanes + Real,
    Y: Characteristic<T> + Characteristic<T::OnAvx512> + Characteristic<T::OnAvx2> + ?Sized,
{
    type Output = ();

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn on_avx512(self) {
        self.in_lanes::<T::OnAvx512>();
    }

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn on_avx2(self) {
        self.in_lanes::<T::OnAvx2>();
    }

    #[inline(never)]
    fn alone(self) {
        self.in_lanes::<T>();
    }
}

/// A system that can be evaluated at a frequency of type `S`, and at several of them at once.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be evaluated at many frequencies of type `{S}`",
    note = "a real ω is a frequency of undamped systems only; planar elements take no part in the plane method; an element of your \
            own implements `mstmm::element::PlaneStep<S>` for every `S`"
)]
pub trait InBlocks<S: InLanes>: Characteristic<S> + Characteristic<S::OnAvx512> + Characteristic<S::OnAvx2> {}

impl<S, Y> InBlocks<S> for Y
where
    S: InLanes,
    Y: Characteristic<S> + Characteristic<S::OnAvx512> + Characteristic<S::OnAvx2> + ?Sized,
{
}

/// Least and largest size of Δ in a lane that is taken: beyond, entries may have left the range.
const TAKEN: (f64, f64) = (1e-250, 1e250);

/// Δ at each of some frequencies, with the bits that it has alone.
pub(crate) fn characteristics<S: InLanes, Y: InBlocks<S> + ?Sized>(
    system: &Y,
    frequencies: &[S],
    values: &mut [Scaled<S>],
) {
    run(Characteristics { system, frequencies, values });
}

/// The evaluation of Δ at many frequencies.
struct Characteristics<'a, Y: ?Sized, S> {
    system: &'a Y,
    frequencies: &'a [S],
    values: &'a mut [Scaled<S>],
}

impl<S: InLanes, Y: Characteristic<S> + ?Sized> Characteristics<'_, Y, S> {
    #[inline(always)]
    fn in_lanes<L: Packed<S>>(self)
    where
        Y: Characteristic<L>,
    {
        for (some, values) in self.frequencies.chunks(L::LANES).zip(self.values.chunks_mut(L::LANES)) {
            let delta = self.system.pass(L::load(some), &mut NoCount);
            let mut lanes = [S::zero(); 8];
            delta.mantissa().store(&mut lanes[..some.len()]);
            for ((value, &lane), &x) in values.iter_mut().zip(&lanes).zip(some) {
                let is_taken = lane.size() > TAKEN.0 && lane.size() < TAKEN.1;
                *value = if is_taken {
                    Scaled::new(lane, delta.exponent())
                } else {
                    counted_pass(self.system, x, NoCount).1
                };
            }
        }
    }
}

impl<S: InLanes, Y: InBlocks<S> + ?Sized> Task for Characteristics<'_, Y, S> {
    type Output = ();

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn on_avx512(self) {
        self.in_lanes::<S::OnAvx512>();
    }

    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn on_avx2(self) {
        self.in_lanes::<S::OnAvx2>();
    }

    fn alone(self) {
        for (value, &x) in self.values.iter_mut().zip(self.frequencies) {
            *value = counted_pass(self.system, x, NoCount).1;
        }
    }
}
