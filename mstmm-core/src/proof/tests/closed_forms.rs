//! False claims about beams and lines of which many digits tell all frequencies: [the campaign](super::campaign) without any count behind it.

use crate::elements::{Beam, BeamColumn, FoundationBeam, Mass, RayleighBeam, Rod, Shaft, Spring, TautString};
use crate::proof::prover::Prover;
use crate::proof::tests::campaign::{Tally, try_all};
use crate::proof::tests::exact::{Exact, exact, pi, word};
use crate::proof::tests::models::Asked;
use crate::proof::tests::random::Random;
use crate::proof::tests::truth::Truth;
use crate::search::NaturalFrequency;
use crate::{AnyUndamped, ListStep, StepList, Support};
use std::vec::Vec;

/// A model with the squares of its frequencies by their index.
struct Closed {
    tip: Support,
    elements: Vec<AnyUndamped<f64>>,
    root: Support,
    square: std::boxed::Box<dyn Fn(u64) -> Exact>,
    /// The number of its frequencies.
    count: u64,
}

/// The squares of waves between two ends, of so many half waves less `less`: `(stiff q⁴ + tension q² + ground)/(mass + rotary q²)`.
fn of_waves(length: f64, less: f64, [stiff, tension, ground, mass, rotary]: [f64; 5]) -> impl Fn(u64) -> Exact {
    move |index| {
        let q = pi() * exact(index as f64 - less) / exact(length);
        let square = &q * &q;
        let stiffness = &square * &square * exact(stiff) + &square * exact(tension) + exact(ground);
        stiffness / (exact(mass) + &square * exact(rotary))
    }
}

/// A beam between pins, a string, a rod or a shaft, or one mass.
fn model(random: &mut Random, kind: usize) -> Closed {
    let decades = 1.0 + random.below(4) as f64;
    let mut size = || 10f64.powf(decades * random.signed());
    let [stiff, mass, other, more] = [(); 4].map(|()| size());
    let length = size().powf(0.25);
    let (pinned, held) = ([Support::Pinned; 2], [Support::Fixed, Support::Free]);
    let (bending_stiffness, mass_per_length) = (stiff, mass);
    let foundation_stiffness = other;
    let (element, [tip, root], less, numbers): (Result<AnyUndamped<f64>, _>, _, _, _) = match kind {
        0 => {
            let beam = Beam { length, bending_stiffness, mass_per_length };
            (beam.try_into(), pinned, 0.0, [stiff, 0.0, 0.0, mass, 0.0])
        }
        1 => {
            let beam = BeamColumn { length, bending_stiffness, mass_per_length, axial_force: other };
            (beam.try_into(), pinned, 0.0, [stiff, other, 0.0, mass, 0.0])
        }
        2 => {
            let foundation_shear_stiffness = more;
            let beam = FoundationBeam {
                length,
                bending_stiffness,
                mass_per_length,
                foundation_stiffness,
                foundation_shear_stiffness,
            };
            (beam.try_into(), pinned, 0.0, [stiff, more, other, mass, 0.0])
        }
        3 => {
            let beam = RayleighBeam { length, bending_stiffness, mass_per_length, rotary_inertia: other };
            (beam.try_into(), pinned, 0.0, [stiff, 0.0, 0.0, mass, other])
        }
        4 => {
            let string = TautString { length, tension: stiff, mass_per_length, foundation_stiffness };
            (string.try_into(), [Support::Fixed; 2], 0.0, [0.0, stiff, other, mass, 0.0])
        }
        5 => {
            let rod = Rod { length, axial_stiffness: stiff, mass_per_length, foundation_stiffness };
            (rod.try_into(), held, 0.5, [0.0, stiff, other, mass, 0.0])
        }
        6 => {
            let shaft = Shaft { length, torsional_stiffness: stiff, inertia_per_length: mass };
            (shaft.try_into(), held, 0.5, [0.0, stiff, 0.0, mass, 0.0])
        }
        _ => return oscillator(stiff, mass),
    };
    let square = std::boxed::Box::new(of_waves(length, less, numbers));
    Closed { tip, elements: [element.unwrap()].into(), root, square, count: u64::MAX }
}

/// A mass at a spring.
fn oscillator(stiffness: f64, mass: f64) -> Closed {
    let elements = [Spring { stiffness }.try_into().unwrap(), Mass { mass }.try_into().unwrap()].into();
    let square = std::boxed::Box::new(move |_| exact(stiffness) / exact(mass));
    Closed { tip: Support::Fixed, elements, root: Support::Free, square, count: 1 }
}

impl Closed {
    /// The frequency of an index between two neighbouring numbers; none where it is a number.
    fn root(&self, index: u64) -> Option<NaturalFrequency<f64>> {
        let omega = (self.square)(index).sqrt();
        let near = word(&omega);
        let [lower, upper] = match exact(near).partial_cmp(&omega)? {
            core::cmp::Ordering::Less => [near, near.next_up()],
            core::cmp::Ordering::Greater => [near.next_down(), near],
            core::cmp::Ordering::Equal => return None,
        };
        Some(NaturalFrequency { omega: near, lower, upper, multiplicity: 1, index, is_proven: true })
    }

    /// Tries false claims about some of its frequencies.
    fn check(&self, random: &mut Random, tally: &mut Tally) {
        let mut steps = Vec::from([ListStep::Tip(self.tip)]);
        steps.extend(self.elements.iter().copied().map(ListStep::Element));
        steps.push(ListStep::Root(self.root));
        let list = StepList::new(&steps).unwrap();
        let parts = list.parts();
        let mut prover = Prover::new(&*parts);
        tally.models += 1;
        let first = if self.count == 1 { 1 } else { [1, 2, 3, 30, 300][random.below(5)] };
        let indices = first.max(2) - 1..=(first + 1).min(self.count);
        let roots: Vec<_> = indices.filter_map(|index| self.root(index)).collect();
        let truth = Truth { roots };
        if let Some(root) = truth.roots.iter().find(|root| root.index == first) {
            try_all(root, &list, &truth, &mut prover, tally);
        }
    }
}

fn check(runs: usize, enough: usize) {
    let (mut random, mut tally) = (Random::new(31), Tally::default());
    for run in 0..runs {
        model(&mut random, run % 8).check(&mut random, &mut tally);
    }
    tally.hold(enough);
}

#[test]
fn no_false_claim_beside_a_closed_form_is_proven() {
    check(32, 900);
}

#[test]
#[ignore = "long: .ci/long"]
fn no_false_claim_of_many_beside_closed_forms_is_proven() {
    check(3_000, 90_000);
}
