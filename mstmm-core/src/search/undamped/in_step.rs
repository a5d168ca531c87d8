//! Estimates of the lowest frequencies of several models at once, a lane for each: what one model does in a step, all do.
//!
//! A model that does not keep step, since its roots coincide or waves have to be scaled, is left to the search for one model.

use crate::number::{List, Scalar};
use crate::pass::at_once::Block;
use crate::pass::searched::Undamped;
use crate::pass::side_by_side::{Built, Lanewise, MODELS, SideBySide};
use crate::search::undamped::approach::{Approaches, GoesOn, PerRoot};
use crate::search::undamped::found::{Found, NaturalFrequency};
use crate::search::undamped::interpolation::{Point, Sample};
use crate::search::undamped::sampling::Isolation;
use crate::search::undamped::together::BEYOND;
use crate::subspace::Purpose;
use core::f64::consts::PI;

/// Fewest models that are searched in step: fewer take less time one by one.
const FEWEST: usize = 3;

/// Most samples of a window, and with them most frequencies.
const MOST_SAMPLES: usize = 42;

/// Samples per root.
const PER_ROOT: usize = 4;

/// Points of each root in a round.
const POINTS: usize = 2;

/// Rounds within which roots settle: more would cost all models what one does not repay.
const ROUNDS: usize = 4;

/// The search of a model alone, with its tolerances.
type Alone<'a, M> = Isolation<'a, Built<M>, f64>;

/// The roots of a model.
type Roots<const N: usize> = List<NaturalFrequency<f64>, N>;

/// What is proposed for a model.
pub(super) type Proposals<const N: usize> = Found<Roots<N>>;

/// A search for the lowest frequencies of models in step.
pub(super) struct InStep<'a, M: Lanewise<System<f64>: Undamped>> {
    systems: &'a SideBySide<M>,
    alone: &'a [Option<Alone<'a, M>>; MODELS],
    block: Block<f64>,
    evaluations: usize,
    /// Frequencies at which the models that do not keep step are evaluated beside the others.
    idle: PerRoot,
    /// A bit per model that does not keep step.
    lost: u32,
}

impl<'a, M: Lanewise<System<f64>: Undamped<Parameter = f64>>> InStep<'a, M> {
    /// The lowest frequencies of the models that have a search of their own, but of those that do not keep step. None of them does
    /// without vectors, without waves, which space roots evenly, or if a window has too few samples for so many frequencies.
    pub(super) fn first<const N: usize>(
        models: &[Option<M>; MODELS],
        alone: &'a [Option<Alone<'a, M>>; MODELS],
    ) -> [Option<Proposals<N>>; MODELS] {
        let is_worth_it = alone.iter().flatten().count() >= FEWEST;
        let has_waves = alone.iter().flatten().all(|one| one.estimates.wave_sum() > 0.0);
        if !is_worth_it || !has_waves || PER_ROOT * N + 2 > MOST_SAMPLES {
            return [const { None }; MODELS];
        }
        let mut built = [None; MODELS];
        for ((place, model), alone) in built.iter_mut().zip(models).zip(alone) {
            *place = model.as_ref().filter(|_| alone.is_some());
        }
        let Some(systems) = SideBySide::new(&built) else { return [const { None }; MODELS] };
        InStep { systems: &systems, alone, block: Block::new(), evaluations: 0, idle: [1.0; MODELS], lost: 0 }.search()
    }

    /// The lowest frequencies of each model.
    fn search<const N: usize>(mut self) -> [Option<Proposals<N>>; MODELS] {
        self.idle = self.each(|one| one.just_above_zero);
        for (lane, alone) in self.alone.iter().enumerate() {
            self.lost |= u32::from(alone.is_none()) << lane;
        }
        let mut found = [Roots::<N>::new(); MODELS];
        let mut approaches = self.approaches(&mut found);
        self.polish(&mut approaches);
        for (below, approaches) in approaches.iter().enumerate() {
            self.list(approaches, below as f64, &mut found);
        }
        let mut lists = [const { None }; MODELS];
        for lane in lanes_of(!self.lost) {
            lists[lane] = Some(Found { frequencies: found[lane], evaluations: self.evaluations, runs: [0; 2] });
        }
        lists
    }

    /// What a function makes of each model; lanes beyond the last one follow it.
    fn each(&self, of: impl Fn(&Alone<'a, M>) -> f64) -> PerRoot {
        let (mut numbers, mut last) = ([1.0; MODELS], 1.0);
        for (number, alone) in numbers.iter_mut().zip(self.alone) {
            last = alone.as_ref().map_or(last, &of);
            *number = last;
        }
        numbers
    }

    /// Evaluates each model at its frequency in the block; one that does not keep step at a frequency that does not disturb the others.
    fn evaluate(&mut self, purpose: Purpose) {
        self.evaluations += 1;
        for lane in lanes_of(self.lost) {
            self.block.omega[lane] = self.idle[lane];
        }
        self.systems.evaluate(&mut self.block, purpose);
        self.lost |= self.block.unknown;
    }

    /// Evaluates each model at the square of a number.
    fn evaluate_square(&mut self, s: &PerRoot, purpose: Purpose) {
        for (omega, s) in self.block.omega.iter_mut().zip(s) {
            *omega = s * s;
        }
        self.evaluate(purpose);
    }

    /// Starts the approaches to all roots, from samples of a window that are even in the square root of the frequency, and lists the
    /// roots that are zero.
    fn approaches<const N: usize>(&mut self, found: &mut [Roots<N>; MODELS]) -> [Approaches<POINTS>; N] {
        let waves = self.each(|one| one.estimates.wave_sum());
        let from = self.each(|one| Scalar::sqrt(one.just_above_zero));
        let count = PER_ROOT * N + 2;
        let length = (N as f64 + BEYOND) * PI / (count - 1) as f64;
        let mut samples = [[Sample::default(); MOST_SAMPLES]; MODELS];
        for k in 0..count {
            let mut s = from;
            for (s, waves) in s.iter_mut().zip(&waves) {
                *s += length / waves * k as f64;
            }
            self.evaluate_square(&s, Purpose::Phases);
            for (lane, samples) in samples.iter_mut().enumerate() {
                let point = Point { s: s[lane], value: self.block.value[lane] };
                samples[k] = Sample { point, below: self.block.below[lane], phase: self.block.phase[lane] };
            }
        }
        let mut approaches = [Approaches::new(1.0); N];
        for approaches in &mut approaches {
            (approaches.growth, approaches.count) = (waves, MODELS);
        }
        for lane in lanes_of(!self.lost) {
            if self.start(lane, &samples[lane][..count], &mut approaches, &mut found[lane]).is_none() {
                self.lost |= 1 << lane;
            }
        }
        approaches
    }

    /// Starts the approaches of a model to its roots, and lists those that are zero, if its samples tell them apart.
    fn start<const N: usize>(
        &self,
        lane: usize,
        samples: &[Sample],
        approaches: &mut [Approaches<POINTS>; N],
        found: &mut Roots<N>,
    ) -> Option<()> {
        let zeros = samples.first()?.below;
        let alone = self.alone[lane].as_ref()?;
        alone.push(found, alone.at_rest(zeros as u64)).ok()?;
        let mut lower = 0;
        for (root, approaches) in approaches.iter_mut().enumerate().skip(zeros as usize) {
            let below = root as f64;
            while samples.get(lower + 1)?.below <= below {
                lower += 1;
            }
            let pair = [samples[lower], samples[lower + 1]];
            if [pair[0].below, pair[1].below] != [below, below + 1.0] {
                return None;
            }
            let first = lower.saturating_sub(1).min(samples.len().checked_sub(4)?);
            approaches.start(lane, samples[first..].first_chunk()?, pair, lower == 0);
        }
        Some(())
    }

    /// Takes all roots to their last digits.
    fn polish<const N: usize>(&mut self, approaches: &mut [Approaches<POINTS>; N]) {
        for _ in 0..ROUNDS {
            for approaches in approaches.iter_mut() {
                if self.unsettled(approaches) == 0 {
                    continue;
                }
                for point in 0..POINTS {
                    let s = approaches.s[point];
                    self.evaluate_square(&s, Purpose::Values);
                    approaches.values[point].copy_from_slice(&self.block.value[..MODELS]);
                }
                approaches.go_on();
            }
        }
        for approaches in approaches.iter() {
            self.lost |= self.unsettled(approaches);
        }
    }

    /// A bit per model in step whose root has not settled.
    fn unsettled(&self, approaches: &Approaches<POINTS>) -> u32 {
        let mut open = 0;
        for (lane, settled) in approaches.settled.iter().enumerate() {
            open |= u32::from(*settled == 0.0) << lane;
        }
        open & !self.lost
    }

    /// Lists the estimates of the root above so many others, of all models that have it above zero.
    fn list<const N: usize>(&mut self, approaches: &Approaches<POINTS>, below: f64, found: &mut [Roots<N>; MODELS]) {
        for lane in lanes_of(!self.lost) {
            if approaches.below[lane] != below {
                continue;
            }
            let omega = approaches.estimate[lane] * approaches.estimate[lane];
            let is_listed = self.alone[lane]
                .as_ref()
                .is_some_and(|one| one.push(&mut found[lane], Some(one.estimate(omega, 1))).is_ok());
            self.lost |= u32::from(!is_listed) << lane;
        }
    }
}

/// The lanes whose bits are set.
fn lanes_of(bits: u32) -> impl Iterator<Item = usize> {
    (0..MODELS).filter(move |lane| bits >> lane & 1 == 1)
}
