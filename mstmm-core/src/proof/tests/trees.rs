//! Counts of small trees with closed forms.

use crate::elements::{Beam, Mass, Spring};
use crate::pass::searched::Undamped;
use crate::proof::count::Side;
use crate::proof::memory::{Memory, Question};
use crate::proof::number::TwoWords;
use crate::proof::prover::Prover;
use crate::search::NaturalFrequencies;
use crate::search::undamped::proven::Parts;
use crate::{AnyUndamped, ListStep, StepList, Support};

fn bounds<Y: Undamped>(system: &Y, omega: f64) -> [f64; 2] {
    [Side::AtLeast, Side::AtMost].map(|side| {
        let question = Question { model: &Parts(system), places: &[([omega, 0.0], side)], sign: 1.0 };
        Memory::default().run::<TwoWords<f64>>(question).unwrap()[0].count
    })
}

/// A mass on a spring, of 2 rad/s.
fn oscillator() -> [ListStep<AnyUndamped<f64>>; 4] {
    [
        ListStep::Tip(Support::Fixed),
        ListStep::Element(AnyUndamped::try_from(Spring { stiffness: 8.0_f64 }).unwrap()),
        ListStep::Element(Mass { mass: 2.0 }.try_into().unwrap()),
        ListStep::Root(Support::Free),
    ]
}

#[test]
fn an_oscillator() {
    let steps = oscillator();
    let list = StepList::new(&steps).unwrap();
    assert_eq!(bounds(&list, 2.0_f64.next_down()), [0.0, 0.0]);
    assert_eq!(bounds(&list, 2.0), [0.0, 1.0]);
    assert_eq!(bounds(&list, 2.0_f64.next_up()), [1.0, 1.0]);
}

#[test]
fn a_pinned_beam() {
    let steps = [
        ListStep::Tip(Support::Pinned),
        ListStep::Element(
            AnyUndamped::try_from(Beam { length: 1.0_f64, bending_stiffness: 1.0, mass_per_length: 1.0 }).unwrap(),
        ),
        ListStep::Root(Support::Pinned),
    ];
    let list = StepList::new(&steps).unwrap();
    for k in 1..40 {
        let root = (f64::from(k) * std::f64::consts::PI).powi(2);
        let wide = [root * (1.0 - 1e-15), root * (1.0 + 1e-15)].map(|x| bounds(&list, x));
        let k = f64::from(k);
        assert_eq!(wide, [[k - 1.0; 2], [k; 2]]);
    }
}

/// A beam with a free end on what lets an end turn or slide has the frequencies of one with that end clamped: the pivot of its first end vanishes
/// at those of the system.
#[test]
fn free_beams_are_proven_between_neighbouring_numbers() {
    for (tip, root) in
        [(Support::Pinned, Support::Free), (Support::Guided, Support::Free), (Support::Free, Support::Free)]
    {
        let beam = Beam { length: 1.3_f64, bending_stiffness: 0.385, mass_per_length: 0.105 };
        let steps = [ListStep::Tip(tip), ListStep::Element(AnyUndamped::try_from(beam).unwrap()), ListStep::Root(root)];
        let list = StepList::new(&steps).unwrap();
        let roots = list.first_frequencies::<12>().unwrap();
        for root in roots.iter().filter(|root| root.omega > 0.0) {
            assert!(root.is_proven && root.upper == root.lower.next_up(), "{tip:?}: {root:?}");
        }
    }
}

/// A search from a number above the frequency, which has a count of one already, says that it proves nothing there.
#[test]
fn a_lower_end_above_the_frequency_is_not_proven() {
    let steps = oscillator();
    let list = StepList::new(&steps).unwrap();
    let parts = Parts(&list);
    let mut prover = Prover::new(&parts);
    let beyond = prover.bisected(1, 2.5, 3.0, 1e6).unwrap();
    assert!(!beyond.is_apart && beyond.lower == 2.5, "{beyond:?}");
    let found = prover.bisected(1, 1.5, 3.0, 1e6).unwrap();
    assert!(found.is_apart && found.lower <= 2.0 && 2.0 <= found.upper && found.multiplicity == 1, "{found:?}");
}
