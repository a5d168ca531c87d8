//! Δ and the count at many frequencies: the trait that users call.

use crate::model::SearchError;
use crate::number::{Frequency, InLanes, Scaled};
use crate::pass::at_once::{InBlocks, characteristics};
use crate::pass::characteristic::System;
use crate::pass::searched::Undamped;
use crate::search::undamped::natural::NaturalFrequencies;

/// Evaluations at many frequencies: each value takes a fraction of the time.
///
/// Each value has the bits of a single evaluation. With `std`, in release builds on x86-64, real frequencies stand in the lanes of AVX-512
/// or AVX2, of the widest that the machine has; all others are evaluated one by one. A thread of 256 kB is enough, of 512 kB in debug builds.
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
    /// Δ at each frequency, as [`characteristic`](crate::pass::characteristic::Characteristic::characteristic) returns it.
    ///
    /// # Errors
    /// [`SearchError::Capacity`] where `values` is shorter than `frequencies`.
    fn characteristics<S>(&self, frequencies: &[S], values: &mut [Scaled<S>]) -> Result<(), SearchError>
    where
        S: Frequency<Self::Parameter> + InLanes,
        Self: InBlocks<S>,
    {
        check_room(frequencies, values)?;
        characteristics(self, frequencies, values);
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
        Self: Undamped,
    {
        check_room(omegas, counts)?;
        for (count, &omega) in counts.iter_mut().zip(omegas) {
            *count = self.count_below(omega);
        }
        Ok(())
    }
}

impl<Y: System + ?Sized> ManyFrequencies for Y {}

fn check_room<X, V>(frequencies: &[X], values: &[V]) -> Result<(), SearchError> {
    if values.len() < frequencies.len() { Err(SearchError::Capacity { capacity: values.len() }) } else { Ok(()) }
}
