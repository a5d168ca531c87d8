//! Counts and searches of chains beside counts of many digits.

use super::chain::Chain;
use crate::oracles::many_digits::{Exact, exact};
use crate::oracles::short_pieces::roots_below;
use crate::support::random_tree::Random;
use mstmm::list::{AnyUndamped, StepList};
use mstmm::prelude::*;
use mstmm::search::SearchError;
use std::collections::BTreeMap;

const BITS: usize = 320;

/// Relative change of a parameter in a difference quotient.
const CHANGE: f64 = 1.0 / (1_u64 << 36) as f64;

/// Eps of a root that its interval may lie off, times the condition of the root.
const ROOM: f64 = 2.0;

/// What was compared of a family.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) models: usize,
    pub(crate) unstable: usize,
    pub(crate) roots: usize,
    pub(crate) counts: usize,
    /// Ends of intervals that a change of the parameters by less than the room explains.
    pub(crate) conditioned: usize,
    pub(crate) worst: f64,
    /// Without enough pieces for the oracle.
    pub(crate) unsure: usize,
    pub(crate) misses: Vec<String>,
    pub(crate) refusals: BTreeMap<String, (usize, String)>,
}

/// The square of a frequency.
fn square(omega: f64) -> Exact {
    let omega = exact(omega, BITS);
    &omega * &omega
}

/// The root that leads from a count to the next one, between two frequencies.
fn root_between(chain: &Chain, count: u64, lower: f64, upper: f64) -> Option<Exact> {
    let (mut lower, mut upper) = (exact(lower, BITS), exact(upper, BITS));
    if roots_below(chain, &(&lower * &lower))? > count || roots_below(chain, &(&upper * &upper))? <= count {
        return None;
    }
    for _ in 0..70 {
        let middle = (&lower + &upper) * exact(0.5, BITS);
        if roots_below(chain, &(&middle * &middle))? > count { upper = middle } else { lower = middle }
    }
    Some(upper)
}

/// The root, and the sum of its relative changes with each parameter.
fn exact_root(chain: &Chain, count: u64, near: f64) -> Option<(Exact, f64)> {
    for wide in [1e-9, 1e-6, 1e-3, 0.1, 0.9] {
        if let Some(root) = root_between(chain, count, near * (1.0 - wide), near / (1.0 - wide)) {
            let mut condition = 0.0;
            let values: Vec<f64> = chain.clone().parameters().into_iter().map(|value| *value).collect();
            for (index, &value) in values.iter().enumerate() {
                if value == 0.0 || values[..index].contains(&value) {
                    continue;
                }
                let mut changed = chain.clone();
                let other = value * (1.0 + CHANGE);
                changed.parameters().into_iter().filter(|entry| **entry == value).for_each(|entry| *entry = other);
                let share = (other - value) / value;
                let other = [1e-6, 1e-3, 0.1, 0.9]
                    .into_iter()
                    .find_map(|wide| root_between(&changed, count, near * (1.0 - wide), near / (1.0 - wide)))?;
                condition += ((other - &root) / &root).to_f64().value().abs() / share;
            }
            return Some((root, condition));
        }
    }
    None
}

impl Tally {
    fn refuse(&mut self, chain: &Chain, what: &str, error: &SearchError) {
        let of_kind = format!("{what} {}", error.kind());
        let entry = self.refusals.entry(of_kind).or_insert_with(|| (0, format!("{error} {chain:?}")));
        entry.0 += 1;
    }

    fn miss(&mut self, chain: &Chain, what: String) {
        self.misses.push(format!("{what}: {chain:?}"));
    }

    /// Whether an interval holds the roots that it should.
    fn interval(&mut self, chain: &Chain, below: u64, root: &NaturalFrequency) {
        self.roots += 1;
        let counts = [root.lower, root.upper].map(|end| roots_below(chain, &square(end)));
        let [Some(lower), Some(upper)] = counts else {
            self.unsure += 1;
            return;
        };
        if (lower, upper) == (below, below + root.multiplicity) {
            return;
        }
        for number in below..below + root.multiplicity {
            let Some((exact_root, condition)) = exact_root(chain, number, root.omega) else {
                return self.miss(chain, format!("no root near {root:?}, {below} below, {counts:?}"));
            };
            let omega = exact(root.omega, BITS);
            let away = ((exact_root - &omega) / omega).to_f64().value().abs() / f64::EPSILON;
            let beyond = (away - 16.0).max(0.0) / condition.max(1.0);
            self.worst = self.worst.max(beyond);
            if beyond > ROOM {
                return self
                    .miss(chain, format!("{away:.1} eps off, condition {condition:.1e}: {root:?}, {below} below"));
            }
        }
        self.conditioned += 1;
    }

    fn intervals<'a>(&mut self, chain: &Chain, mut below: u64, found: impl Iterator<Item = &'a NaturalFrequency>) {
        for root in found.filter(|root| root.omega > 0.0) {
            self.interval(chain, below, root);
            below += root.multiplicity;
        }
    }

    /// Stability, the first frequencies, those in the middle, counts at random frequencies.
    pub(crate) fn judge(&mut self, chain: &Chain, high: u64, at: &[f64], random: &mut Random) {
        self.models += 1;
        let steps = chain.steps();
        let list: StepList<'_, AnyUndamped<f64>> = StepList::new(&steps).unwrap();
        let tiny = exact(1e-60, BITS);
        let [Some(growing), Some(lowest)] = [-tiny.clone(), tiny].map(|square| roots_below(chain, &square)) else {
            self.unsure += 1;
            return;
        };
        match list.unstable_modes() {
            Ok(modes) if modes == growing => {}
            Ok(modes) => return self.miss(chain, format!("{modes} grow, and not {growing}")),
            Err(error) => return self.refuse(chain, "stability", &error),
        }
        if growing > 0 {
            self.unstable += 1;
            return;
        }
        match list.first_frequencies::<6>() {
            Err(error) => self.refuse(chain, "first", &error),
            Ok(found) => {
                let resting: u64 = found.iter().filter(|root| root.omega == 0.0).map(|root| root.multiplicity).sum();
                if resting != lowest && found.iter().any(|root| root.omega > 0.0) {
                    self.miss(chain, format!("{resting} at rest, and not {lowest}"));
                }
                self.intervals(chain, lowest, found.iter());
                if let Some(last) = found.iter().next_back() {
                    for _ in 0..2 {
                        self.count(chain, &list, last.omega * (0.01 + 3.0 * random.unit()));
                    }
                    if let Some(window) = self.window(chain, &list, high, last.omega) {
                        self.search(chain, &list, window);
                    }
                }
            }
        }
        for &omega in at {
            self.count(chain, &list, omega);
            self.search(chain, &list, [omega * (1.0 - 1e-3), omega * (1.0 + 1e-3)]);
            self.search(chain, &list, [omega * (1.0 - 1e-9), omega * (1.0 + 1e-9)]);
        }
    }

    /// A window of about eight frequencies above so many.
    fn window(
        &mut self,
        chain: &Chain,
        list: &StepList<'_, AnyUndamped<f64>>,
        high: u64,
        from: f64,
    ) -> Option<[f64; 2]> {
        let count = |omega: f64| list.count_below(omega).or_else(|_| list.count_below(omega * 1.000_003));
        let (mut lower, mut upper) = (from, from);
        for _ in 0..40 {
            match count(upper) {
                Ok(below) if below >= high + 6 => break,
                Ok(_) => upper *= 2.0,
                Err(error) => {
                    self.refuse(chain, "window", &error);
                    return None;
                }
            }
        }
        for _ in 0..60 {
            let middle = 0.5 * (lower + upper);
            let below = count(middle).ok()?;
            if below < high {
                lower = middle;
            } else if below > high + 8 {
                upper = middle;
            } else {
                break;
            }
        }
        let width = upper - lower;
        if width < 1e-9 * upper { None } else { Some([lower.max(0.9 * upper), upper]) }
    }

    fn search(&mut self, chain: &Chain, list: &StepList<'_, AnyUndamped<f64>>, [lower, upper]: [f64; 2]) {
        let [Some(below), Some(above)] = [lower, upper].map(|end| roots_below(chain, &square(end))) else {
            self.unsure += 1;
            return;
        };
        match list.natural_frequencies::<64>(lower..=upper) {
            Err(SearchError::Capacity { .. }) if above - below > 64 => {}
            Err(error) => self.refuse(chain, "range", &error),
            Ok(found) => {
                let number: u64 = found.iter().map(|root| root.multiplicity).sum();
                let inside = found.iter().filter(|root| root.lower > lower && root.upper < upper);
                let sure: u64 = inside.map(|root| root.multiplicity).sum();
                if number < above - below || sure > above - below {
                    self.miss(chain, format!("{number} in {lower}..={upper}, and not {}", above - below));
                } else {
                    let mut start = below;
                    for root in &found {
                        if root.lower <= lower {
                            // the end is in its interval: the root may be on either side
                            start = roots_below(chain, &square(root.upper)).unwrap_or(start);
                        } else if root.upper < upper {
                            self.interval(chain, start, root);
                            start += root.multiplicity;
                        }
                    }
                }
            }
        }
    }

    fn count(&mut self, chain: &Chain, list: &StepList<'_, AnyUndamped<f64>>, omega: f64) {
        let Some(expected) = roots_below(chain, &square(omega)) else {
            self.unsure += 1;
            return;
        };
        self.counts += 1;
        match list.count_below(omega) {
            Ok(count) if count == expected => {}
            Ok(count) => {
                // that of a neighbour by the condition of a root
                let is_explained = (expected.min(count)..expected.max(count)).all(|number| {
                    exact_root(chain, number, omega).is_some_and(|(root, condition)| {
                        let omega = exact(omega, BITS);
                        let away = ((root - &omega) / omega).to_f64().value().abs() / f64::EPSILON;
                        away / condition.max(1.0) <= ROOM + 16.0
                    })
                });
                if is_explained {
                    self.conditioned += 1;
                } else {
                    self.miss(chain, format!("{count} below {omega}, and not {expected}"));
                }
            }
            Err(error) => self.refuse(chain, "count", &error),
        }
    }

    pub(crate) fn show(&self, name: &str) {
        let Tally { models, unstable, roots, counts, conditioned, worst, unsure, .. } = self;
        println!(
            "{name}: {models} models, {unstable} unstable, {roots} roots, {counts} counts, {conditioned} by condition (worst {worst:.2}), {unsure} unsure, {} missed",
            self.misses.len()
        );
        for (kind, (number, first)) in &self.refusals {
            println!("   refused {kind} {number}: {first}");
        }
        for miss in self.misses.iter().take(3) {
            println!("   MISS {miss}");
        }
    }
}
