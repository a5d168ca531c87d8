//! What rests: frequencies at zero, and motions that grow, which are counted just below zero.

use crate::model::SearchError;
use crate::number::Real;
use crate::proof::count::Side;
use crate::proof::prover::Precision;
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::proven::Certification;

/// Parts of the next frequency below which those at rest are sought, least first.
const AT_REST: [f64; 3] = [1e-9, 1e-6, 1e-3];

impl<T: Real> Certification<'_, T> {
    /// The number of motions that grow: at rest itself, or just below where something rests.
    pub(crate) fn unstable_modes(&mut self) -> Result<u64, SearchError> {
        if let Ok(count) = self.prover.count(T::zero(), 1.0) {
            return Ok(count);
        }
        let scale = T::one().times_power_of_two(self.estimates.least_exponent());
        for part in AT_REST {
            if let Ok(count) = self.prover.count(scale * T::from_f64(part), -1.0) {
                return Ok(count);
            }
        }
        Err(self.refused(T::zero()))
    }

    /// The number of frequencies at rest, and a frequency that is proven to be above them and below all others; none where nothing rests.
    ///
    /// Where a count is decided at zero itself, the stiffness at rest is regular, and nothing rests. Else what is below the lower of two scales rests: of the estimate of the lowest frequency
    /// and of the one that is proposed. Where rounding decides that count, what rests is below each frequency at which a count is decided, down to that estimate.
    pub(super) fn at_rest(&mut self, next: Option<T>) -> Option<(u64, T)> {
        if self.prover.count(T::zero(), 1.0).is_ok() {
            return None;
        }
        let least = T::one().times_power_of_two(self.estimates.least_exponent());
        let next = next.unwrap_or(least);
        let [low, high] = if next < least { [next, least] } else { [least, next] };
        let (mut count, mut upper) = self.resting_beside(low).or_else(|| self.resting_beside(high))?;
        while upper > low {
            let below = upper * T::from_f64(AT_REST[2]);
            match self.resting_below(below) {
                Some(fewer) => (count, upper) = (fewer, below),
                None => break,
            }
        }
        (count > 0).then_some((count, upper))
    }

    /// The number of frequencies at rest beside a scale, and the least part of the scale at which it is decided.
    fn resting_beside(&mut self, scale: T) -> Option<(u64, T)> {
        let parts = AT_REST.map(|part| scale * T::from_f64(part));
        parts.into_iter().find_map(|omega| Some((self.resting_below(omega)?, omega)))
    }

    /// The number of frequencies with `-ω² <= square < ω²` at a frequency ω, if none is below; none where rounding decides it.
    fn resting_below(&mut self, omega: T) -> Option<u64> {
        match (self.prover.count(omega, -1.0), self.prover.count(omega, 1.0)) {
            (Ok(0), Ok(count)) => Some(count),
            _ => None,
        }
    }

    /// The least part of the next frequency below which those at rest are proven to be; no more than what is proven already.
    pub(super) fn upper_of_rest(&mut self, rest: NaturalFrequency<T>, next: Option<T>) -> T {
        let Some(next) = next else { return rest.upper };
        for omega in AT_REST.map(|part| next * T::from_f64(part)).into_iter().filter(|omega| *omega < rest.upper) {
            let at_least = self.prover.bound_at(omega, 1.0, Side::AtLeast, Precision::Two).count;
            let below = self.prover.bound_at(omega, -1.0, Side::AtMost, Precision::Two).count;
            if at_least >= Some(rest.multiplicity) && below == Some(0) {
                return omega;
            }
        }
        rest.upper
    }
}

#[cfg(test)]
mod tests {
    use crate::elements::{Mass, Spring};
    use crate::number::List;
    use crate::search::undamped::found::{Found, NaturalFrequency};
    use crate::search::undamped::natural::proven_list;
    use crate::{AnyUndamped, ListStep, StepList, Support};

    /// Whatever a search proposes, what is not at zero does not rest, and what is at zero does.
    #[test]
    fn frequencies_far_below_a_proposal_do_not_rest() {
        let spring = |stiffness: f64| ListStep::Element(AnyUndamped::try_from(Spring { stiffness }).unwrap());
        let mass = |mass: f64| ListStep::Element(AnyUndamped::try_from(Mass { mass }).unwrap());
        for (tip, rigid) in [(Support::Fixed, 0), (Support::Free, 1)] {
            let steps = [
                ListStep::Tip(tip),
                mass(1.0),
                spring(4.0),
                mass(3.0),
                spring(1e-13),
                mass(5.0),
                spring(2e9),
                mass(7.0),
                ListStep::Root(Support::Free),
            ];
            let system = StepList::new(&steps).unwrap();
            for omega in [1e-9, 1.0, 1e6, 1e12, 1e18, 1e40] {
                let mut frequencies = List::<NaturalFrequency<f64>, 3>::new();
                let (lower, upper) = (omega * (1.0 - 1e-15), omega * (1.0 + 1e-15));
                let made_up = NaturalFrequency { omega, lower, upper, multiplicity: 1, index: 1, is_proven: false };
                frequencies.push(made_up).unwrap();
                let list = proven_list(&system, Found { frequencies, evaluations: 0, runs: [0; 2] }).unwrap();
                let at_zero = list.iter().filter(|root| root.omega == 0.0).count();
                assert_eq!(at_zero, rigid, "{omega} {list:?}");
                assert!(list.iter().all(|root| root.is_proven && root.multiplicity == 1 && root.upper < 1e5));
            }
        }
    }
}
