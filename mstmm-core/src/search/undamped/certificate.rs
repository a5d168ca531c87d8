//! The certificate of a root that was approached: the counts on both its sides.

use crate::number::{Real, is_straight};
use crate::search::undamped::approach::Approaches;
use crate::search::undamped::found::NaturalFrequency;

/// Distance of the zero of Δ beside a certificate that failed, in its half widths, within which another one is tried.
pub(super) const NEARBY: f64 = 8.0;

/// What was evaluated below and above a root.
pub(super) struct Sides<T> {
    pub(super) omega: [T; 2],
    pub(super) value: [T; 2],
    pub(super) below: [f64; 2],
}

impl<T: Real> Sides<T> {
    /// The root of an approach with its interval, if it is counted between both sides; else the zero of Δ beside them without one. None
    /// where neither is near. `inner` is the distance of the sides from the root.
    #[inline]
    pub(super) fn certificate<const POINTS: usize>(
        &self,
        approaches: &Approaches<POINTS>,
        k: usize,
        omega: T,
        inner: T,
    ) -> Option<NaturalFrequency<T>> {
        let ([start, end], [below, above]) = (self.omega, self.value);
        if self.below == [approaches.below[k], approaches.below[k] + 1.0] {
            let root = NaturalFrequency { omega, lower: start - inner, upper: end + inner, multiplicity: 1 };
            // dω = 2s ds
            let growth = ((above - below) / (end - start)).to_f64() * 2.0 * approaches.estimate[k];
            return is_straight(growth / approaches.slope(k)).then_some(root);
        }
        let zero = start + (end - start) * (below / (below - above));
        let is_near = (zero - omega).abs() < inner * T::from_f64(NEARBY);
        is_near.then_some(NaturalFrequency { omega: zero, ..NaturalFrequency::default() })
    }
}
