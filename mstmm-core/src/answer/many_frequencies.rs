//! Δ and the count at many frequencies: the trait that users call.

use crate::model::SearchError;
use crate::number::{Frequency, InColumns, Real, Scaled};
use crate::pass::block::pass::BlockPass;
use crate::pass::block::{WIDTH, WORTHWHILE};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::tree::Steps;
use crate::search::undamped::natural::{NaturalFrequencies, Undamped, agreed, count_margin};
use crate::subspace::{NoCount, WittrickWilliams};
use num_traits::Zero;

/// A system that can be evaluated at one frequency, and at a block of them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no blocks of frequencies of type `{S}`",
    note = "a `StepList` answers this with a plan: `.planned(&mut room)?`"
)]
pub trait InBlocks<S>: Characteristic<S> + Steps<S>
where
    S: Frequency<<Self as System>::Parameter>,
{
}

impl<S, Y> InBlocks<S> for Y
where
    S: Frequency<<Y as System>::Parameter>,
    Y: Characteristic<S> + Steps<S> + ?Sized,
{
}

/// Evaluations at many frequencies, in blocks: each value takes a fraction of the time.
///
/// Each value has the bits of a single evaluation, as long as no minor under- or overflows.
///
/// With `std` the loops over a block are compiled for AVX-512, AVX2 and the target, and the widest that the machine has is
/// used; without it for the target alone. Memory is on the stack: some 25 kB for real frequencies, four times as much for a complex
/// λ with a derivative; a thread of 256 kB is enough, of 512 kB in debug builds.
///
/// ```
/// use mstmm_core::elements::Beam;
/// use mstmm_core::{AnyUndamped, Characteristic, ListStep, ManyFrequencies, Room, Scaled, StepList, Support};
///
/// let beam = Beam { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5 };
/// let steps =
///     [ListStep::Tip(Support::Fixed), ListStep::Element(AnyUndamped::try_from(beam)?), ListStep::Root(Support::Free)];
/// let mut room = Room::<8>::new();
/// let cantilever = StepList::new(&steps)?.planned(&mut room)?;
///
/// let omegas: [f64; 100] = core::array::from_fn(|k| 5.0 * (k + 1) as f64);
/// let mut values = [Scaled::new(0.0, 0); 100];
/// cantilever.characteristics(&omegas, &mut values)?;
/// assert_eq!(values[42], cantilever.characteristic(omegas[42]));
///
/// let mut counts = [Ok(0); 100];
/// cantilever.counts_below(&omegas, &mut counts)?;
/// // modes 1 to 4 are at 7.03, 44.1, 123 and 242 rad/s
/// assert_eq!([counts[0], counts[1], counts[10], counts[50]], [Ok(0), Ok(1), Ok(2), Ok(4)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait ManyFrequencies: System {
    /// Δ at each frequency, as [`characteristic`](Characteristic::characteristic) returns it.
    ///
    /// # Errors
    /// [`SearchError::Capacity`] where `values` is shorter than `frequencies`.
    fn characteristics<S>(&self, frequencies: &[S], values: &mut [Scaled<S>]) -> Result<(), SearchError>
    where
        S: Frequency<Self::Parameter> + InColumns,
        Self: InBlocks<S>,
    {
        check_room(frequencies, values)?;
        let mut pass = BlockPass::<S, NoCount>::new();
        for (some, values) in frequencies.chunks(WIDTH).zip(values.chunks_mut(WIDTH)) {
            if some.len() >= WORTHWHILE && pass.run(self, some) {
                for (lane, (value, &x)) in values.iter_mut().zip(some).enumerate() {
                    *value = pass.values.lane(lane);
                    // where sums cancel, the block has no value for the frequency
                    if !value.mantissa().size().is_finite() {
                        *value = Characteristic::<S>::characteristic(self, x);
                    }
                }
                continue;
            }
            for (value, &x) in values.iter_mut().zip(some) {
                *value = Characteristic::<S>::characteristic(self, x);
            }
        }
        Ok(())
    }

    /// The number of natural frequencies below each `omega` [rad/s]: what
    /// [`count_below`](crate::search::undamped::natural::NaturalFrequencies::count_below) returns for them one by one.
    ///
    /// # Errors
    /// [`SearchError::Capacity`] where `counts` is shorter than `omegas`; each entry has an error of its own.
    fn counts_below(
        &self,
        omegas: &[Self::Parameter],
        counts: &mut [Result<u64, SearchError>],
    ) -> Result<(), SearchError>
    where
        Self: InBlocks<<Self as System>::Parameter> + Undamped,
        Self::Parameter: InColumns,
    {
        check_room(omegas, counts)?;
        let mut pass = BlockPass::<Self::Parameter, WittrickWilliams<true>>::new();
        for (some, counts) in omegas.chunks(WIDTH).zip(counts.chunks_mut(WIDTH)) {
            let margin = count_margin::<Self::Parameter>();
            let both = [-margin, margin].map(|margin| count_block(self, &mut pass, some, margin));
            for (lane, (count, &omega)) in counts.iter_mut().zip(some).enumerate() {
                let pair = both[0].as_ref().zip(both[1].as_ref()).map(|(below, above)| [below[lane], above[lane]]);
                *count = match pair.map(|pair| agreed(omega, pair)) {
                    Some(Ok(Some(below))) if omega > Self::Parameter::zero() => Ok(below),
                    _ => self.count_below(omega),
                };
            }
        }
        Ok(())
    }
}

/// Counts and Δ in the lanes of a block.
type CountsOfBlock<T> = [(WittrickWilliams<true>, Scaled<T>); WIDTH];

/// Counts and Δ at a relative distance from the frequencies of a block; `None` where each has to be evaluated alone.
fn count_block<Y, T>(
    system: &Y,
    pass: &mut BlockPass<T, WittrickWilliams<true>>,
    omegas: &[T],
    margin: T,
) -> Option<CountsOfBlock<T>>
where
    T: Real + InColumns,
    Y: InBlocks<T> + System<Parameter = T> + ?Sized,
{
    let mut beside = [T::zero(); WIDTH];
    let beside = beside.get_mut(..omegas.len())?;
    for (beside, &omega) in beside.iter_mut().zip(omegas) {
        *beside = omega + omega * margin;
    }
    if omegas.len() < WORTHWHILE || !pass.run(system, beside) {
        return None;
    }
    Some(core::array::from_fn(|lane| (pass.counters.committed()[lane], pass.values.lane(lane))))
}

impl<Y: System + ?Sized> ManyFrequencies for Y {}

fn check_room<X, V>(frequencies: &[X], values: &[V]) -> Result<(), SearchError> {
    if values.len() < frequencies.len() { Err(SearchError::Capacity { capacity: values.len() }) } else { Ok(()) }
}
