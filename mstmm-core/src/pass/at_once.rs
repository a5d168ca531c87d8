//! Δ, counts and phases at several frequencies at once, in the lanes of the widest vectors that the machine has.

use crate::number::{InLanes, Packed, Real, Scaled, Size, Task, Truth, run};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::pass::network::stiffness::{StiffnessBlock, StiffnessModel};
use crate::pass::phase::PhaseCounter;
use crate::subspace::{NoCount, Purpose};
use core::marker::PhantomData;

/// Most frequencies of a block.
pub(crate) const MOST: usize = 16;

/// Whether a system is evaluated in lanes at numbers of a type. Else its pass is compiled once, for one number.
const fn has_lanes<S: InLanes, Y: System + ?Sized>() -> bool {
    (Y::STANDS_IN_LINE || Y::IS_NETWORK) && S::OnAvx512::LANES > 1
}

/// Number of lanes of the instruction set in use, in which a system is evaluated.
#[inline]
pub(crate) fn lanes<T: InLanes, Y: System + ?Sized>() -> usize {
    if const { !has_lanes::<T, Y>() } {
        return 1;
    }
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    match mstmm_lanes::InstructionSet::in_use() {
        mstmm_lanes::InstructionSet::Avx512 => return T::OnAvx512::LANES,
        mstmm_lanes::InstructionSet::Avx2 => return T::OnAvx2::LANES,
        mstmm_lanes::InstructionSet::Target => {}
    }
    1
}

/// Several frequencies with what was computed there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block<T> {
    /// The frequencies [rad/s].
    pub(crate) omega: [T; MOST],
    /// Δ over a power of two that is the same for all.
    pub(crate) value: [T; MOST],
    /// The number of natural frequencies below.
    pub(crate) below: [f64; MOST],
    /// That number with a share of the next frequency.
    pub(crate) phase: [f64; MOST],
    /// A bit per lane: whether Δ is not known, or zero.
    pub(crate) unknown: u32,
    /// Whether some lane has no value: it takes a branch that numbers in lanes have not, or Δ is out of the range.
    is_lost: bool,
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
            is_lost: false,
            exponent: None,
        }
    }

    /// Evaluates Δ, counts and for that purpose phases at the first so many frequencies, in lanes if there are several of them; where a
    /// lane has no value all are evaluated one by one.
    #[inline]
    pub(crate) fn counts<Y: InBlocks<T> + ?Sized>(&mut self, system: &Y, count: usize, lanes: usize, purpose: Purpose) {
        let count = count.min(MOST);
        if purpose == Purpose::Phases {
            // a new window: Δ grows along the frequencies
            self.exponent = None;
        }
        if let Some(model) = system.in_numbers() {
            return self.by_stiffnesses(&model, count, lanes);
        }
        if lanes > 1 {
            // idle lanes follow the last one
            let (used, idle) = self.omega.split_at_mut(count);
            idle.fill(used.last().copied().unwrap_or(T::one()));
            self.begin();
            evaluate(Counts { system, block: self, count, purpose });
            if !self.is_lost {
                return;
            }
        }
        self.begin();
        Counts { system, block: self, count, purpose }.alone();
    }

    /// Evaluates Δ and counts of a network by its stiffnesses.
    fn by_stiffnesses(&mut self, model: &StiffnessModel<'_>, count: usize, lanes: usize) {
        let ([mut omega, mut value], below) = ([[0.0; MOST]; 2], &mut self.below);
        for (omega, own) in omega.iter_mut().zip(&self.omega) {
            *omega = own.to_f64();
        }
        let mut block = StiffnessBlock {
            omega: &omega[..count],
            value: &mut value[..count],
            below: &mut below[..count],
            unknown: 0,
            exponent: self.exponent,
        };
        block.evaluate(model, lanes > 1);
        (self.unknown, self.exponent) = (block.unknown, block.exponent);
        for (own, value) in self.value.iter_mut().zip(value) {
            *own = T::from_f64(value);
        }
    }

    /// Forgets what was known of the lanes.
    #[inline]
    pub(crate) fn begin(&mut self) {
        (self.is_lost, self.unknown) = (false, 0);
    }

    /// Evaluates the lanes from one on, as many as a number has.
    #[inline(always)]
    pub(crate) fn evaluate<S: Packed<T>>(
        &mut self,
        system: &(impl Characteristic<S> + ?Sized),
        from: usize,
        purpose: Purpose,
    ) {
        let lanes = from..from + S::LANES;
        let mut counter = PhaseCounter::new(purpose);
        let delta = system.pass(S::load(&self.omega[lanes.clone()]), &mut counter);
        S::store_size(counter.counter().count(), &mut self.below[lanes.clone()]);
        if purpose == Purpose::Phases {
            S::store_size(counter.phase(delta), &mut self.phase[lanes.clone()]);
        }
        self.take(delta, from);
    }

    /// Evaluates Δ alone at a frequency, which takes two thirds of the time of a count.
    #[inline(always)]
    fn value<Y: Characteristic<T> + ?Sized>(&mut self, system: &Y, lane: usize) {
        self.take(counted_pass(system, self.omega[lane], NoCount).1, lane);
    }

    /// Takes Δ of the lanes from one on.
    #[inline(always)]
    fn take<S: Packed<T>>(&mut self, delta: Scaled<S>, from: usize) {
        let value = delta.over_power(*self.exponent.get_or_insert(delta.exponent()));
        let is_known = value.size().is_below(S::Size::of(f64::INFINITY));
        self.is_lost |= !is_known.all();
        self.unknown |= u32::from(S::bits(!is_known | value.vanishes())) << from;
        value.store(&mut self.value[from..from + S::LANES]);
    }
}

/// The evaluation of Δ, counts and phases.
struct Counts<'a, Y: ?Sized, T> {
    system: &'a Y,
    block: &'a mut Block<T>,
    count: usize,
    purpose: Purpose,
}

impl<Y: InBlocks<T> + ?Sized, T: InLanes + Real> ManyAtOnce<T> for Counts<'_, Y, T> {
    type System = Y;

    #[inline(always)]
    fn in_lanes<S: Packed<T>>(self)
    where
        Y: Characteristic<S>,
    {
        let Counts { system, block, count, purpose } = self;
        let mut from = 0;
        while from < count {
            block.evaluate::<S>(system, from, purpose);
            from += S::LANES;
        }
    }

    #[inline(never)]
    fn alone(self) {
        let Counts { system, block, count, purpose } = self;
        for lane in 0..count {
            if purpose == Purpose::Values {
                block.value(system, lane);
            } else {
                block.evaluate::<T>(system, lane, purpose);
            }
        }
    }
}

/// Exponent up to which Δ in a lane is taken: beyond, entries may have left the range.
const TAKEN: u32 = 830;

/// Values of Δ that are evaluated in one task.
const VALUES: usize = 64;

/// Δ at each of some frequencies, with the bits that it has alone.
pub(crate) fn characteristics<S: InLanes, Y: InBlocks<S> + ?Sized>(
    system: &Y,
    frequencies: &[S],
    values: &mut [Scaled<S>],
) {
    for (frequencies, values) in frequencies.chunks(VALUES).zip(values.chunks_mut(VALUES)) {
        // what is not evaluated in lanes stays zero, which is not taken
        let (mut lanes, mut exponents) = ([S::zero(); VALUES], [0; VALUES]);
        evaluate(Values { system, frequencies, lanes: &mut lanes, exponents: &mut exponents });
        for (((value, &x), &lane), &exponent) in values.iter_mut().zip(frequencies).zip(&lanes).zip(&exponents) {
            let is_taken = lane.size().exponent().is_some_and(|own| own.unsigned_abs() < TAKEN);
            *value = if is_taken { Scaled::new(lane, exponent) } else { counted_pass(system, x, NoCount).1 };
        }
    }
}

/// The evaluation of Δ alone at up to so many frequencies.
struct Values<'a, Y: ?Sized, S> {
    system: &'a Y,
    frequencies: &'a [S],
    lanes: &'a mut [S; VALUES],
    exponents: &'a mut [i64; VALUES],
}

impl<S: InLanes, Y: InBlocks<S> + ?Sized> ManyAtOnce<S> for Values<'_, Y, S> {
    type System = Y;

    #[inline(always)]
    fn in_lanes<L: Packed<S>>(self)
    where
        Y: Characteristic<L>,
    {
        let mut from = 0;
        while from < self.frequencies.len() {
            let lanes = from..self.frequencies.len().min(from + L::LANES);
            let delta = self.system.pass(L::load(&self.frequencies[lanes.clone()]), &mut NoCount);
            delta.mantissa().store(&mut self.lanes[lanes.clone()]);
            self.exponents[lanes].fill(delta.exponent());
            from += L::LANES;
        }
    }

    #[inline]
    fn alone(self) {}
}

/// A system that can be evaluated at a frequency of type `S`, and at several of them at once.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be evaluated at many frequencies of type `{S}`",
    note = "a real ω is a frequency of undamped systems only; planar elements take no part in the plane method; an element of your \
            own implements `mstmm::element::PlaneStep<S>` for every `S`"
)]
pub trait InBlocks<S: InLanes>:
    System + Characteristic<S> + Characteristic<S::OnAvx512> + Characteristic<S::OnAvx2>
{
}

impl<S, Y> InBlocks<S> for Y
where
    S: InLanes,
    Y: System + Characteristic<S> + Characteristic<S::OnAvx512> + Characteristic<S::OnAvx2> + ?Sized,
{
}

/// Work at many frequencies in the lanes of a number.
trait ManyAtOnce<T: InLanes> {
    /// The system that is evaluated.
    type System: InBlocks<T> + ?Sized;

    /// The work in lanes.
    #[cfg_attr(not(all(feature = "std", target_arch = "x86_64")), expect(dead_code, reason = "there are no vectors"))]
    fn in_lanes<S: Packed<T>>(self)
    where
        Self::System: Characteristic<S>;

    /// The work one frequency at a time.
    fn alone(self);
}

/// Does work in the lanes of the instruction set in use.
#[inline]
fn evaluate<T: InLanes, W: ManyAtOnce<T>>(work: W) {
    if const { has_lanes::<T, W::System>() && !W::System::IS_NETWORK } {
        run(Dispatch(work, PhantomData));
    } else {
        work.alone();
    }
}

/// Work as a task for each instruction set.
struct Dispatch<W, T>(W, PhantomData<T>);

impl<T: InLanes, W: ManyAtOnce<T>> Task for Dispatch<W, T> {
    type Output = ();

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.0.in_lanes::<T::OnAvx512>();
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) {
        self.0.in_lanes::<T::OnAvx2>();
    }

    #[inline]
    fn alone(self) {
        self.0.alone();
    }
}
