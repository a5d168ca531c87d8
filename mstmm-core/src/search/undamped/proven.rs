//! What a search proposes is proven, and what is not proven is bisected by proven counts: nobody has to trust the search.

use crate::element::OwnPart;
use crate::model::{FrequencyEstimates, SearchError, Spot};
use crate::number::{Real, Store};
use crate::pass::searched::Undamped;
use crate::proof::beside::{AT_ONCE, Beside, Evidence, ONE_ENTRY};
use crate::proof::bisection::Refusal;
use crate::proof::certificate::{Claim, Proven};
use crate::proof::count::Side;
use crate::proof::join::Failure;
use crate::proof::prover::{Bound, Precision, Prover};
use crate::proof::visit::{Knowledge, Visited, Visitor, knowledge_of};
use crate::search::room::add;
use crate::search::undamped::found::{Found, NaturalFrequency};

/// Steps of one number by which the end of a range moves outward where rounding decides the count at it.
const OUTWARD: usize = 8;

/// Frequencies far from each other at which no count is decided where something is held twice, or by nothing.
const FAR_APART: [f64; 5] = [0.037, 0.31, 1.7, 5.3, 23.0];

/// Binary exponents above the highest estimate of a model without waves beyond which it has no frequency.
const BEYOND: i32 = 30;

/// The parts of a system.
pub(crate) struct Parts<'a, Y: ?Sized>(pub(crate) &'a Y);

impl<Y: Undamped + ?Sized> Visited for Parts<'_, Y> {
    fn visit(&self, visitor: &mut dyn Visitor) {
        self.0.name_parts(visitor);
    }

    fn is_flat(&self) -> bool {
        self.0.is_flat()
    }

    fn spot(&self, place: usize) -> Spot {
        self.0.spot_of(place)
    }

    fn own_part(&self, step: usize, omega: [f64; 2]) -> Option<OwnPart> {
        self.0.own_part(step, omega)
    }
}

/// What a search is asked for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sought<T> {
    /// All frequencies between two ends.
    Range([T; 2]),
    /// So many of the lowest.
    Lowest(u64),
}

/// What a search proposes, in ascending order, and what is known beside the next few.
struct Proposals<'p, T> {
    /// Those about which nothing is known.
    rest: &'p [NaturalFrequency<T>],
    known: Beside<T>,
    /// The places of those that are known and not dropped.
    places: core::ops::Range<usize>,
}

/// Proofs of what is proposed for a system.
pub(crate) struct Certification<'a, T> {
    pub(crate) prover: Prover<'a>,
    pub(super) estimates: FrequencyEstimates,
    /// The frequency beyond which a search gives up.
    limit: T,
    /// Whether all parts are known in numbers.
    is_proven: bool,
}

impl<'a, T: Real> Certification<'a, T> {
    /// Proofs for a system; none where a part is not known in numbers.
    pub(crate) fn new(parts: &'a dyn Visited, estimates: FrequencyEstimates) -> Option<Self> {
        let knowledge = knowledge_of(parts);
        if knowledge == Knowledge::Nothing {
            return None;
        }
        let power = |exponent| T::one().times_power_of_two(exponent);
        let limit =
            if estimates.is_continuous() { T::from_f64(1e150) } else { power(estimates.highest_exponent() + BEYOND) };
        let is_proven = knowledge == Knowledge::Numbers;
        Some(Certification { prover: Prover::new(parts), estimates, limit, is_proven })
    }

    /// Runs of the proof so far, in two words and in four.
    pub(crate) fn runs(&self) -> [usize; 2] {
        [self.prover.runs, self.prover.long_runs]
    }

    /// Refuses a model with motions that grow.
    pub(crate) fn check_stability(&mut self) -> Result<(), SearchError> {
        match self.unstable_modes()? {
            0 => Ok(()),
            modes => Err(SearchError::Unstable { modes }),
        }
    }

    /// The count at a frequency.
    pub(crate) fn count(&mut self, omega: T) -> Result<u64, SearchError> {
        self.prover.count(omega, 1.0).map_err(|_| self.refused(omega))
    }

    /// Why a count near a frequency is not proven: something is held twice, or rounding decides it.
    #[cold]
    pub(crate) fn refused(&mut self, near: T) -> SearchError {
        if let Some(Failure::Redundant(step)) = self.prover.failure {
            return SearchError::Zero { points: FAR_APART.len(), at: Some(self.prover.spot(step)) };
        }
        // about the lowest frequencies all parts are known, whatever is asked for
        let scale = T::one().times_power_of_two(self.estimates.lowest_exponent());
        let is_nowhere_decided = FAR_APART.iter().all(|part| self.prover.is_open(scale * T::from_f64(*part)));
        if is_nowhere_decided && self.prover.failure.is_none() {
            let at = self.prover.spot(self.prover.smallest_at);
            return SearchError::Zero { points: FAR_APART.len(), at: Some(at) };
        }
        let [at_least, at_most] = self.prover.bounds(near, 1.0);
        SearchError::Unproven {
            near: near.to_f64(),
            at_least: at_least.unwrap_or(0),
            at_most: at_most.unwrap_or(u64::MAX),
        }
    }

    /// The proven list of what is sought, given what a search proposes, in ascending order.
    pub(super) fn certified<L: Store<NaturalFrequency<T>>>(
        &mut self,
        proposals: &[NaturalFrequency<T>],
        sought: Sought<T>,
    ) -> Result<L, SearchError> {
        let mut found = L::empty();
        let starts_at_rest = !matches!(sought, Sought::Range([start, _]) if !start.is_zero());
        let (mut settled, mut floor) = match sought {
            Sought::Range([start, _]) if !starts_at_rest => self.end(start, false)?,
            _ => (0, T::zero()),
        };
        let last = match sought {
            Sought::Range([_, end]) => match self.end(end, true) {
                Ok((last, _)) => last,
                // below what rests nothing tells frequencies from zero
                Err(error) => match self.at_rest(None).filter(|(_, upper)| starts_at_rest && *upper >= end) {
                    Some((modes, _)) => modes,
                    None => return Err(error),
                },
            },
            Sought::Lowest(wanted) => wanted,
        };
        let rests = proposals.first().is_some_and(|root| root.omega.is_zero());
        let mut proposals = Proposals::new(proposals);
        if starts_at_rest && settled < last {
            // what is proposed is the first frequency, unless something rests
            let first = proposals.first(&mut self.prover);
            let claim = first.filter(|_| !rests).map(|first| self.prover.claim(1, first, floor));
            if let Some(Claim::Proven(proven)) = claim {
                proposals.drop_first();
                (settled, floor) = (proven.multiplicity, proven.upper);
                self.push(&mut found, proven)?;
            } else if let Some((modes, upper)) = self.at_rest(first.map(|first| first.omega())) {
                let rest =
                    Proven { omega: T::zero(), lower: T::zero(), upper, index: 1, multiplicity: modes, is_apart: true };
                (settled, floor) = (modes, upper);
                self.push(&mut found, rest)?;
            }
        }
        while settled < last {
            let next = self.next(settled + 1, floor, &mut proposals);
            let proven = next.map_err(|refusal| self.error(refusal, last))?;
            (settled, floor) = (proven.index + proven.multiplicity - 1, proven.upper);
            self.push(&mut found, proven)?;
        }
        self.include_twins(found.values(), proposals.known.beyond);
        if let (true, Some(rest)) =
            (starts_at_rest, found.values().first().copied().filter(|root| root.omega.is_zero()))
        {
            let next = found.values().get(1).map(|root| root.lower);
            found.values()[0].upper = self.upper_of_rest(rest, next);
        }
        Ok(found)
    }

    /// The frequency of an index at `floor` or above, by what is proposed or by bisection.
    fn next(&mut self, index: u64, floor: T, proposals: &mut Proposals<'_, T>) -> Result<Proven<T>, Refusal> {
        let mut lower = floor;
        let mut guess = T::one().times_power_of_two(self.estimates.lowest_exponent());
        while let Some(proposal) = proposals.first(&mut self.prover) {
            if proposal.ends[1] <= floor {
                proposals.drop_first();
                continue;
            }
            guess = proposal.omega();
            match self.prover.claim(index, proposal, floor) {
                Claim::Proven(proven) => {
                    proposals.drop_first();
                    return Ok(proven);
                }
                // a frequency that was not proposed: what is proposed may be a later one
                Claim::Below(end) => return self.prover.bisected(index, lower, end, self.limit),
                Claim::Above(end) => {
                    proposals.drop_first();
                    lower = end;
                }
                Claim::Undecided => proposals.drop_first(),
            }
        }
        let guess = if guess > lower { guess } else { lower * T::from_f64(1.5) };
        self.prover.bisected(index, lower, guess, self.limit)
    }

    /// Adds to the last entry those frequencies behind it that are within the width of one entry.
    fn include_twins(&mut self, found: &mut [NaturalFrequency<T>], known: Option<(T, Bound)>) {
        let Some(last) = found.last_mut().filter(|last| !last.omega.is_zero()) else { return };
        let upper = last.lower + last.lower * T::from_f64(ONE_ENTRY * T::EPSILON);
        let known = known.filter(|(end, _)| *end == upper).map(|(_, bound)| bound);
        let bound = known.unwrap_or_else(|| self.prover.bound_at(upper, 1.0, Side::AtLeast, Precision::Two));
        let count = bound.count;
        if let Some(count) = count.filter(|count| *count > last.index + last.multiplicity - 1) {
            (last.upper, last.multiplicity) = (upper, count - (last.index - 1));
            last.omega = last.lower + (upper - last.lower) * T::from_f64(0.5);
        }
    }

    /// The count at the end of a range, which moves outward where rounding decides it, and that end.
    fn end(&mut self, end: T, is_upper: bool) -> Result<(u64, T), SearchError> {
        let away = end * T::from_f64(ONE_ENTRY * T::EPSILON);
        let mut omega = if is_upper { end + away } else { end - away };
        for _ in 0..OUTWARD {
            if let Ok(count) = self.prover.count(omega, 1.0) {
                return Ok((count, omega));
            }
            if self.prover.is_beyond() {
                break;
            }
            omega = if is_upper { omega.next_above() } else { omega.next_below() };
        }
        Err(self.refused(end))
    }

    /// Adds a proven entry. Frequencies within a few units in the last place are one entry with the one before, and so are those that nothing proves to
    /// be above it.
    fn push<L: Store<NaturalFrequency<T>>>(&mut self, found: &mut L, proven: Proven<T>) -> Result<(), SearchError> {
        let Proven { omega, lower, upper, index, multiplicity, is_apart } = proven;
        let last = found.values().last_mut().filter(|last| !last.omega.is_zero());
        if !is_apart && last.is_none() {
            return Err(self.refused(lower));
        }
        if let Some(last) = last
            && (!is_apart || upper - last.lower <= upper * T::from_f64(ONE_ENTRY * T::EPSILON))
        {
            last.omega = last.lower + (upper - last.lower) * T::from_f64(0.5);
            (last.upper, last.multiplicity) = (upper, last.multiplicity + multiplicity);
            return Ok(());
        }
        add(found, NaturalFrequency { omega, lower, upper, multiplicity, index, is_proven: self.is_proven })
    }

    /// What a refusal means to a search for so many frequencies.
    #[cold]
    fn error(&mut self, refusal: Refusal, wanted: u64) -> SearchError {
        match refusal {
            Refusal::Fewer(found) => SearchError::TooFewRoots { found, wanted },
            Refusal::Undecided { near } => self.refused(T::from_f64(near)),
        }
    }
}

impl<L> Found<L> {
    /// The entries that meet a range.
    pub(super) fn meeting<T: Real>(self, [start, end]: [T; 2]) -> Result<Self, SearchError>
    where
        L: Store<NaturalFrequency<T>>,
    {
        let mut frequencies = L::empty();
        for root in self.frequencies.iter().filter(|root| root.upper >= start && root.lower <= end) {
            add(&mut frequencies, *root)?;
        }
        Ok(Found { frequencies, ..self })
    }
}

impl<'p, T: Real> Proposals<'p, T> {
    /// All that are not at rest.
    fn new(proposals: &'p [NaturalFrequency<T>]) -> Self {
        let at_rest = proposals.iter().take_while(|root| root.omega.is_zero()).count();
        Proposals { rest: &proposals[at_rest..], known: Beside::nothing(), places: 0..0 }
    }

    /// What is known beside the first one.
    fn first(&mut self, prover: &mut Prover<'_>) -> Option<Evidence<T>> {
        if self.places.is_empty() {
            let (next, rest) = self.rest.split_at(self.rest.len().min(AT_ONCE));
            let [first, ..] = next else { return None };
            let mut estimates = [first.omega; AT_ONCE];
            for (estimate, root) in estimates.iter_mut().zip(next) {
                *estimate = root.omega;
            }
            self.known.find(prover, &estimates[..next.len()], Precision::Two, rest.is_empty());
            (self.rest, self.places) = (rest, 0..next.len());
        }
        self.known.found.get(self.places.start).copied()
    }

    /// Drops the first one.
    fn drop_first(&mut self) {
        self.places.next();
    }
}
