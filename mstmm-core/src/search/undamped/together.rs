//! All roots of a window of frequencies at once: isolated by one block of counts, and polished side by side.
//!
//! Evaluations that do not wait for each other share the lanes of a vector. What does not hold here, since roots coincide or waves have to be
//! scaled, is left to the search that goes from root to root.

use crate::number::{Dual, InLanes, List, Real, Store};
use crate::pass::at_once::{Block, InBlocks, MOST, lanes};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::approach::{Approaches, GoesOn, ROOTS};
use crate::search::undamped::found::{Found, NaturalFrequency};
use crate::search::undamped::interpolation::{Point, Sample};
use crate::search::undamped::sampling::Isolation;
use crate::subspace::Purpose;
use core::f64::consts::PI;

/// Roots that are sought in one window.
const ROOTS_PER_WINDOW: f64 = 6.0;

/// Roots by which a window reaches beyond those that are wanted, since supports and masses move them by about one.
pub(super) const BEYOND: f64 = 0.75;

/// The largest ratio of the first frequency of waves to the lowest estimate. It is 2²⁰: ten halvings of a bracket, which are halvings of the root of the frequency, span it. Beyond it the search from root to
/// root proposes. No result depends on it.
const WIDEST: f64 = 1e6;

/// Samples of a window at most, with those that are taken between others of several roots.
pub(super) const SAMPLES: usize = 48;

/// Rounds within which roots settle.
const ROUNDS: usize = 8;

/// The square root of a frequency.
fn root<T: Real>(omega: T) -> f64 {
    omega.sqrt().to_f64()
}

/// A search for all roots of a window at once.
pub(super) struct Together<'a, 's, Y: System + ?Sized, T: Real> {
    /// The search that goes from root to root, with its tolerances and its number of evaluations.
    pub(super) single: &'s mut Isolation<'a, Y, T>,
    pub(super) block: Block<T>,
    /// The samples of the window in ascending order.
    pub(super) samples: List<Sample, SAMPLES>,
    /// Sum of `z/sqrt(ω)` of all waves.
    waves: f64,
    /// Numbers that are evaluated at once in the window: one where waves have to be scaled.
    lanes: usize,
}

impl<'a, 's, T, Y> Together<'a, 's, Y, T>
where
    T: InLanes + Real,
    Y: System<Parameter = T> + InBlocks<T> + Characteristic<Dual<T>> + ?Sized,
{
    /// A search beside another; none for numbers that are no `f64`, without waves, which space roots evenly, and without `std`, where
    /// there are no vectors and size counts.
    #[inline]
    pub(super) fn new(single: &'s mut Isolation<'a, Y, T>) -> Option<Self> {
        let waves = single.estimates.wave_sum();
        let suits = cfg!(feature = "std") && T::IS_DOUBLE && waves > 0.0;
        // where waves begin far above what else vibrates, a window would have all of that between two samples
        let of_waves = (PI / waves) * (PI / waves);
        let suits =
            suits && of_waves < WIDEST * T::one().times_power_of_two(single.estimates.lowest_exponent()).to_f64();
        let suits = suits && if Y::IS_NETWORK { single.system.in_numbers().is_some() } else { Y::HAS_PHASES };
        suits.then(|| Together { single, block: Block::new(), samples: List::new(), waves, lanes: 1 })
    }

    /// Estimates of the lowest frequencies, if all of them are single.
    pub(super) fn first<L: Store<NaturalFrequency<T>>>(mut self, wanted: u64) -> Option<Found<L>> {
        let wanted = wanted as f64;
        let mut found = L::empty();
        let zero = self.single.just_above_zero;
        let (mut from, mut below) = (root(zero), 0.0);
        while below < wanted {
            let missing = (wanted - below).min(ROOTS_PER_WINDOW);
            self.window(from, from + (missing + BEYOND) * PI / self.waves, missing)?;
            if below == 0.0 {
                self.push_rigid_body_modes(&mut found)?;
            }
            self.roots(wanted, &mut found)?;
            let last = self.samples.last()?;
            (from, below) = (last.point.s, last.below);
        }
        Some(Found { frequencies: found, evaluations: self.single.evaluations, runs: [0; 2] })
    }

    /// Estimates of the frequencies of a range, if all of them are single.
    pub(super) fn in_range<L>(mut self, [start, end]: [T; 2]) -> Option<Found<L>>
    where
        L: Store<NaturalFrequency<T>>,
    {
        let [mut from, last] = self.single.enclosing(start, end).map(root);
        if from >= last {
            // nothing but what is zero
            return None;
        }
        let mut found = L::empty();
        let mut is_first = start.is_zero();
        while from < last {
            let roots = ((last - from) * self.waves / PI + BEYOND).min(ROOTS_PER_WINDOW);
            let to = (from + roots * PI / self.waves).min(last);
            self.window(from, to, roots)?;
            if core::mem::take(&mut is_first) {
                self.push_rigid_body_modes(&mut found)?;
            }
            self.roots(f64::INFINITY, &mut found)?;
            from = self.samples.last()?.point.s;
        }
        Some(Found { frequencies: found, evaluations: self.single.evaluations, runs: [0; 2] })
    }

    /// The entry of frequencies that are zero, if there are any.
    fn push_rigid_body_modes<L: Store<NaturalFrequency<T>>>(&self, found: &mut L) -> Option<()> {
        let modes = self.single.at_rest(self.samples.first()?.below as u64);
        self.single.push(found, modes).ok()
    }

    /// Evaluates the first so many frequencies of the block.
    #[inline]
    pub(super) fn compute(&mut self, count: usize, purpose: Purpose) {
        self.single.evaluations += count;
        self.block.counts(self.single.system, count, self.lanes, purpose);
    }

    /// Evaluates the first so many frequencies of the block; none where one has to be evaluated alone.
    #[inline]
    fn evaluate(&mut self, count: usize, purpose: Purpose) -> Option<()> {
        self.compute(count, purpose);
        (self.block.unknown == 0).then_some(())
    }

    /// Samples a window evenly in the square root of the frequency.
    fn window(&mut self, from: f64, to: f64, roots: f64) -> Option<()> {
        let is_scaled = to * self.single.estimates.longest_wave() >= T::WAVE_LIMIT;
        let lanes = if is_scaled { 1 } else { lanes::<T, Y>() };
        self.lanes = lanes;
        // a sample costs little beside others in the lanes of a vector
        let per_root = if lanes > 1 { 3.0 } else { 2.0 };
        let points = ((per_root * roots) as usize + 2).next_multiple_of(lanes).clamp(4, MOST);
        let step = (to - from) / (points - 1) as f64;
        for (k, omega) in self.block.omega[..points].iter_mut().enumerate() {
            let s = from + step * k as f64;
            *omega = T::from_f64(s * s);
        }
        if Y::IS_NETWORK {
            return self.sample_network(points);
        }
        self.evaluate(points, Purpose::Phases)?;
        self.samples = List::new();
        self.push_samples(points)
    }

    /// Adds samples at the first so many frequencies of the block, with counts that do not fall.
    pub(super) fn push_samples(&mut self, points: usize) -> Option<()> {
        let mut last = 0.0;
        for lane in 0..points {
            let (value, below) = (self.block.value[lane].to_f64(), self.block.below[lane]);
            if below < last {
                return None;
            }
            let point = Point { s: root(self.block.omega[lane]), value };
            self.samples.push(Sample { point, below, phase: self.block.phase[lane] }).ok()?;
            last = below;
        }
        Some(())
    }

    /// Finds the roots of the window below a number of them.
    fn roots<L: Store<NaturalFrequency<T>>>(&mut self, wanted: f64, found: &mut L) -> Option<()> {
        let most = if Y::IS_NETWORK { MOST / 3 } else { ROOTS };
        let mut lower = 0;
        while lower + 1 < self.samples.len() {
            let mut brackets = List::<usize, ROOTS>::new();
            while lower + 1 < self.samples.len() && brackets.len() < most {
                let (below, above) = (self.samples[lower].below, self.samples[lower + 1].below);
                if below >= wanted {
                    lower = self.samples.len();
                    break;
                }
                if above > below + 1.0 {
                    return None;
                }
                if above > below {
                    brackets.push(lower).ok()?;
                }
                lower += 1;
            }
            // lanes that would be idle take a third point of each root; roots of networks start from anywhere in their brackets
            let vectors = |points: usize| (points * brackets.len()).div_ceil(self.lanes);
            if Y::IS_NETWORK || vectors(3) == vectors(2) {
                self.polish::<3, L>(&brackets, found)?;
            } else {
                self.polish::<2, L>(&brackets, found)?;
            }
        }
        Some(())
    }

    /// Takes the roots of some brackets to their last digits, with so many points each in a round.
    fn polish<const POINTS: usize, L: Store<NaturalFrequency<T>>>(
        &mut self,
        brackets: &[usize],
        found: &mut L,
    ) -> Option<()>
    where
        Approaches<POINTS>: GoesOn,
    {
        let mut approaches = Approaches::<POINTS>::new(self.waves);
        for (k, &lower) in brackets.iter().enumerate() {
            let first = lower.saturating_sub(1).min(self.samples.len().checked_sub(4)?);
            let near = self.samples[first..].first_chunk()?;
            approaches.start(k, near, [self.samples[lower], self.samples[lower + 1]], lower == 0);
        }
        for _ in 0..ROUNDS {
            let mut count = 0;
            for root in (0..approaches.count).filter(|root| approaches.settled[*root] == 0.0) {
                for s in &approaches.s {
                    self.block.omega[count] = T::from_f64(s[root] * s[root]);
                    count += 1;
                }
            }
            if count == 0 {
                return self.list(&approaches, found);
            }
            // of the same code as counts: another one would take as long to compile
            self.evaluate(count, Purpose::Values)?;
            let mut values = self.block.value.iter();
            for root in 0..approaches.count {
                if approaches.settled[root] == 0.0 {
                    for (place, value) in approaches.values.iter_mut().zip(&mut values) {
                        place[root] = value.to_f64();
                    }
                }
            }
            approaches.go_on();
        }
        self.list(&approaches, found)
    }

    /// Lists the estimates of all approaches.
    fn list<const POINTS: usize, L: Store<NaturalFrequency<T>>>(
        &mut self,
        approaches: &Approaches<POINTS>,
        found: &mut L,
    ) -> Option<()> {
        for estimate in &approaches.estimate[..approaches.count] {
            let root = self.single.estimate(T::from_f64(estimate * estimate), 1);
            self.single.push(found, Some(root)).ok()?;
        }
        Some(())
    }
}
