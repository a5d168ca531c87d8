//! Cantilevers that are equal but for rounding, on springs so soft that they join nothing.

use super::exact::{double, fault, moved, sorted, wave_of_mode};
use super::in_full;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, Beam, Mass, Spring};
use mstmm::list::{ListStep, StepList};
use mstmm::prelude::*;

/// Lengths of cantilevers, and the springs from their tips to one joint, which a spring of 1 holds to a mass of 1.
#[derive(Clone, Debug)]
struct Star {
    arms: Vec<[f64; 2]>,
}

impl Star {
    fn random(random: &mut Random) -> Self {
        let length = 0.9 + 0.1 * random.unit();
        let decade = -16.0 + 6.0 * random.unit();
        let spread = random.pick([0, 0, 1, 4, 30, 1000]);
        let arms = 2 + random.below(5);
        let arm = |_| [moved(length, random.below(spread + 1) as i64), 10_f64.powf(decade + random.unit())];
        Star { arms: (0..arms).map(arm).collect() }
    }

    fn steps(&self) -> Vec<ListStep<AnyUndamped<f64>>> {
        let beam = |length: f64| Beam { length, bending_stiffness: 1.0, mass_per_length: 1.0 }.try_into().unwrap();
        let spring = |stiffness: f64| ListStep::Element(Spring { stiffness }.try_into().unwrap());
        let mut steps = Vec::new();
        for &[length, stiffness] in &self.arms {
            steps.extend([ListStep::Tip(Support::Fixed), ListStep::Element(beam(length))]);
            steps.extend([ListStep::Connection(1), spring(stiffness)]);
        }
        steps.extend([ListStep::Connection(self.arms.len()), spring(1.0)]);
        steps.extend([ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap()), ListStep::Root(Support::Free)]);
        steps
    }

    /// Bounds of the squares of the frequencies of three modes of each arm, and of the mass before them: without springs `(z/l)⁴`, and springs add
    /// no more than `2 k (3·4/l)` to an arm, whose tip has `φ² = 4/l`, and `2 Σk` to the mass, for a joint that moves with the mass.
    fn bounds(&self) -> Vec<[mstmm::number::DoubleDouble; 2]> {
        let stiffest = self.arms.iter().map(|arm| arm[1] / arm[0]).fold(0.0, f64::max);
        let more = double(2.0 * (12.0 * stiffest).max(self.arms.iter().map(|arm| arm[1]).sum()));
        let square = |length: f64, mode: u32| {
            let wave = wave_of_mode(mode, false) / double(length);
            wave * wave * wave * wave
        };
        let arms = self.arms.iter().flat_map(|arm| (1..=3).map(move |mode| square(arm[0], mode)));
        sorted(arms.chain([double(0.0)]).collect()).into_iter().map(|square| [square, square + more]).collect()
    }
}

fn searches<const N: usize>(
    list: &StepList<'_, AnyUndamped<f64>>,
    bounds: &[[mstmm::number::DoubleDouble; 2]],
    star: &Star,
) {
    let found = list.first_frequencies::<N>().unwrap();
    let last = found.last().unwrap();
    assert!(found[0].index == 1 && last.index + last.multiplicity > N as u64, "{star:?}: {found:?}");
    assert_eq!(fault(&found, bounds), None, "{star:?}");
}

/// Every search ends, and lists what is there.
fn weak_clusters(models: usize) {
    let random = &mut Random(0xb2);
    for _ in 0..models {
        let star = Star::random(random);
        let (steps, bounds) = (star.steps(), star.bounds());
        let list = StepList::new(&steps).unwrap();
        match random.below(4) {
            0 => searches::<2>(&list, &bounds, &star),
            1 => searches::<3>(&list, &bounds, &star),
            2 => searches::<4>(&list, &bounds, &star),
            _ => searches::<8>(&list, &bounds, &star),
        }
        let arms = star.arms.len() as u64;
        // the second mode of the arms is beyond 22
        let found = list.natural_frequencies::<16>(0.5..=20.0).unwrap();
        assert_eq!(found.iter().map(|root| root.multiplicity).sum::<u64>(), arms, "{star:?}: {found:?}");
        assert_eq!(fault(&found, &bounds), None, "{star:?}");
        let [first, last] = [found[0].lower, found.last().unwrap().upper];
        for away in [1e-12, 1e-9, 1e-6] {
            let [below, above] = [first * (1.0 - away), last * (1.0 + away)].map(|omega| list.count_bounds(omega));
            assert_eq!([below, above], [[1, 1], [arms + 1, arms + 1]], "{star:?} {away}");
        }
    }
}

in_full! {
    weak_clusters(60, 3000) = some_weak_clusters, all_weak_clusters;
}
