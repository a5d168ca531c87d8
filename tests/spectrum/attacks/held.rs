//! Equal beams whose joints stiff springs all but hold: entries of one frequency each, as often as there are beams.

use super::exact::{double, fault, sorted, wave_of_mode};
use super::in_full;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, Beam, Spring, TorsionSpring};
use mstmm::list::{ListStep, StepList};
use mstmm::prelude::*;

/// Beams of one length in a row between clamps, their joints on a spring and a torsion spring.
fn nearly_held(beams: usize, length: f64, [stiffness, turning]: [f64; 2]) -> Vec<ListStep<AnyUndamped<f64>>> {
    let element = |element: AnyUndamped<f64>| ListStep::Element(element);
    let beam = element(Beam { length, bending_stiffness: 1.0, mass_per_length: 1.0 }.try_into().unwrap());
    let spring = element(Spring { stiffness }.try_into().unwrap());
    let torsion = element(TorsionSpring { stiffness: turning }.try_into().unwrap());
    let mut steps = vec![ListStep::Tip(Support::Fixed), beam];
    for _ in 1..beams {
        let hold = ListStep::Tip(Support::Fixed);
        steps.extend([hold, spring, hold, torsion, ListStep::Connection(3), beam]);
    }
    steps.push(ListStep::Root(Support::Fixed));
    steps
}

/// Held frequencies are bounds from above; below them by less than one in 1e6, since the springs are that stiff.
fn nearly_held_beams(models: usize) {
    let random = &mut Random(0xb7);
    for _ in 0..models {
        let (beams, length) = (2 + random.below(5), 0.2 + 1.8 * random.unit());
        let springs = [0, 1].map(|_| 10_f64.powf(14.0 + 6.0 * random.unit()));
        let steps = nearly_held(beams, length, springs);
        let list = StepList::new(&steps).unwrap();
        let found = list.first_frequencies::<12>().unwrap();
        let square = |mode: u32| {
            let wave = wave_of_mode(mode, true) / double(length);
            wave * wave * wave * wave
        };
        let squares = sorted((1..=8).flat_map(|mode| vec![square(mode); beams]).collect());
        let bounds: Vec<_> = squares.iter().map(|square| [*square * double(1.0 - 1e-6), *square]).collect();
        let model = (beams, length, springs);
        assert_eq!(fault(&found, &bounds), None, "{model:?}");
        // modes all of whose beams are listed
        for mode in 1..=(12 / beams) as u32 {
            let omega = square(mode).parts().0.sqrt();
            let near = found.iter().filter(|root| (root.omega / omega - 1.0).abs() < 1e-6);
            let total: u64 = near.map(|root| root.multiplicity).sum();
            let is_last = mode as usize * beams == 12 || mode as usize == 12 / beams;
            assert!(total == beams as u64 || is_last && total >= beams as u64, "{model:?}: {mode}, {found:?}");
        }
    }
}

in_full! {
    nearly_held_beams(20, 900) = some_nearly_held_beams, all_nearly_held_beams;
}
