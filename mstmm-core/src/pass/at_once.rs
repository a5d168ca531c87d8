//! Δ, counts and phases at several frequencies at once, in the lanes of the widest vectors that the machine has.

use crate::number::{InLanes, Packed, Real, Scaled, Size, Task, Truth, run};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::pass::phase::PhaseCounter;
use crate::subspace::NoCount;

/// Most frequencies of a block.
pub(crate) const MOST: usize = 16;

/// Whether a system is evaluated in lanes at numbers of a type. Else its pass is compiled once, for one number.
const fn has_lanes<S: InLanes, Y: System + ?Sized>() -> bool {
    Y::STANDS_IN_LINE && S::OnAvx512::LANES > 1
}

/// Number of lanes of the instruction set in use, in which a system is evaluated.
#[inline]
pub(crate) fn lanes<T: InLanes, Y: System + ?Sized>() -> usize {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    match mstmm_lanes::InstructionSet::in_use() {
        _ if !const { has_lanes::<T, Y>() } => {}
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

    /// Evaluates the first so many frequencies; `is_at_root` tells that they are so close to roots that the terms of Δ are examined.
    ///
    /// Counts and phases are computed even where Δ alone is wanted: that costs a tenth, a second piece of code as much again to compile.
    #[inline]
    pub(crate) fn evaluate<Y>(&mut self, system: &Y, count: usize, is_at_root: bool)
    where
        Y: Characteristic<T> + Characteristic<T::OnAvx512> + Characteristic<T::OnAvx2> + ?Sized,
    {
        let evaluation = Evaluation { system, block: self, count: count.min(MOST), is_at_root };
        if const { has_lanes::<T, Y>() } {
            run(evaluation);
        } else {
            evaluation.alone();
        }
    }

    /// The count on which a lane and the next one agree, if they are neither at a root nor doubtful.
    #[inline]
    pub(crate) fn agreed_count(&self, lane: usize) -> Option<u64> {
        let agree = self.unknown >> lane & 0b11 == 0 && self.below[lane] == self.below[lane + 1];
        agree.then_some(self.below[lane] as u64)
    }
}

/// The evaluation of a block.
struct Evaluation<'a, Y: ?Sized, T> {
    system: &'a Y,
    block: &'a mut Block<T>,
    count: usize,
    is_at_root: bool,
}

impl<Y: ?Sized, T: InLanes + Real> Evaluation<'_, Y, T> {
    #[inline(always)]
    fn in_lanes<S: Packed<T>>(self)
    where
        Y: Characteristic<S>,
    {
        let Evaluation { system, block, count, is_at_root } = self;
        block.unknown = 0;
        let mut from = 0;
        while from < count {
            let lanes = from..count.min(from + S::LANES);
            let mut counter = PhaseCounter::new(is_at_root);
            let delta = system.pass(S::load(&block.omega[lanes.clone()]), &mut counter);
            let cancelled = counter.counter().cancelled();
            S::store_size(counter.counter().count(), &mut block.below[lanes.clone()]);
            S::store_size(counter.phase(delta), &mut block.phase[lanes.clone()]);
            let value = delta.over_power(*block.exponent.get_or_insert(delta.exponent()));
            let is_known = value.size().is_below(S::Size::of(f64::INFINITY)) & !value.vanishes();
            let is_doubtful = cancelled.at_root | S::Truth::of(cancelled.any());
            block.unknown |= u32::from(S::bits(is_doubtful | !is_known)) << from;
            value.store(&mut block.value[lanes]);
            from += S::LANES;
        }
    }
}

impl<T, Y> Task for Evaluation<'_, Y, T>
where
    T: InLanes + Real,
    Y: Characteristic<T> + Characteristic<T::OnAvx512> + Characteristic<T::OnAvx2> + ?Sized,
{
    type Output = ();

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.in_lanes::<T::OnAvx512>();
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
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
#[cfg(feature = "std")]
const TAKEN: (f64, f64) = (1e-250, 1e250);

/// Δ at each of some frequencies, with the bits that it has alone.
pub(crate) fn characteristics<S: InLanes, Y: InBlocks<S> + ?Sized>(
    system: &Y,
    frequencies: &[S],
    values: &mut [Scaled<S>],
) {
    let evaluation = Characteristics { system, frequencies, values };
    if const { has_lanes::<S, Y>() } {
        run(evaluation);
    } else {
        evaluation.alone();
    }
}

/// The evaluation of Δ at many frequencies.
struct Characteristics<'a, Y: ?Sized, S> {
    system: &'a Y,
    frequencies: &'a [S],
    values: &'a mut [Scaled<S>],
}

#[cfg(feature = "std")]
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

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.in_lanes::<S::OnAvx512>();
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
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
