//! Roots of networks that stiffnesses do not certify: by fronts, and in extended precision.

use crate::number::{Dual, Real};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::polish::share_of_zero;
use crate::search::undamped::sampling::Isolation;

/// Distance of a root from its estimate, in its own size, within which Δ is straight.
const STRAIGHT: f64 = 1e-9;

impl<T, Y> Isolation<'_, Y, T>
where
    T: Real,
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + ?Sized,
{
    /// Certifies the single root between two frequencies, given an estimate and how many are below. The first one that fronts doubt leaves
    /// those behind it to extended precision: what has doubted one will doubt others, since all have the same members.
    #[cold]
    pub(super) fn certify_beyond_doubt(
        &mut self,
        mut omega: T,
        below: u64,
        ends: [T; 2],
    ) -> Option<NaturalFrequency<T>> {
        if !self.fronts_doubt {
            match self.certify_near(omega, below) {
                Ok(root) => return Some(root),
                Err(found) => omega = found.unwrap_or(omega),
            }
            self.fronts_doubt = true;
        }
        self.certify_precisely(omega, below)
            .or_else(|| self.certify_extended(omega, below))
            .or_else(|| self.certify_between(ends, below))
    }

    /// The single root beside an estimate, above so many others, by counts of stiffnesses in extended precision, where these do; from farther
    /// away by the zero of Δ, of which they have digits enough.
    fn certify_precisely(&mut self, mut omega: T, below: u64) -> Option<NaturalFrequency<T>> {
        for _ in 0..if T::HAS_EXTENDED { 2 } else { 0 } {
            let inner = omega * self.half_width * T::from_f64(0.5);
            let (start, end) = (omega - inner, omega + inner);
            (self.evaluations, self.extended) = (self.evaluations + 2, self.extended + 2);
            let [Some(lower), Some(upper)] = self.system.precise_counts([start, end].map(T::to_f64)) else {
                return None;
            };
            if (lower.below, upper.below) == (below, below + 1) {
                return Some(NaturalFrequency { omega, lower: start - inner, upper: end + inner, multiplicity: 1 });
            }
            let step = (end - start) * T::from_f64(share_of_zero(lower.delta, upper.delta));
            if step.to_f64().abs() >= STRAIGHT * omega.to_f64() {
                return None;
            }
            omega = start + step;
        }
        None
    }
}
