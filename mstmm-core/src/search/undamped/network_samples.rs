//! The samples of a window of a network, between which no more than one root is left.

use crate::number::{Dual, InLanes, List, Real, sort_by};
use crate::pass::at_once::{InBlocks, MOST};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::together::Together;
use crate::subspace::Purpose;

/// Rounds in which samples are added between others of several roots.
const ROUNDS: usize = 8;

impl<T, Y> Together<'_, '_, Y, T>
where
    T: InLanes + Real,
    Y: System<Parameter = T> + InBlocks<T> + Characteristic<Dual<T>> + ?Sized,
{
    /// Samples a window at the first so many frequencies of the block, and between those where several roots are.
    pub(super) fn sample_network(&mut self, points: usize) -> Option<()> {
        self.samples = List::new();
        self.sample(points, Purpose::Phases)?;
        for _ in 0..ROUNDS {
            let several = self.samples.windows(2).filter(|pair| pair[1].below > pair[0].below + 1.0).count();
            if several == 0 {
                return Some(());
            }
            let inside = (MOST / several).clamp(1, 2);
            let mut count = 0;
            for pair in self.samples.windows(2).filter(|pair| pair[1].below > pair[0].below + 1.0) {
                let [from, to] = [pair[0].point.s, pair[1].point.s];
                for k in 1..=inside {
                    let s = from + (to - from) * k as f64 / (inside + 1) as f64;
                    *self.block.omega.get_mut(count)? = T::from_f64(s * s);
                    count += 1;
                }
            }
            self.sample(count, Purpose::Counts)?;
            sort_by(self.samples.as_mut_slice(), |one, other| one.point.s < other.point.s);
            if self.samples.windows(2).any(|pair| pair[1].below < pair[0].below) {
                return None;
            }
        }
        None
    }

    /// Adds samples at the first so many frequencies of the block.
    fn sample(&mut self, points: usize, purpose: Purpose) -> Option<()> {
        self.compute(points, purpose);
        // phases are none
        self.block.phase = [f64::NAN; MOST];
        self.push_samples(points)
    }
}
