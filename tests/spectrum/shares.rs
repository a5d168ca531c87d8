//! How many frequencies of random models are proven between neighbouring numbers, and how many need more.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::support::random_tree::Random;
use mstmm::prelude::*;
use mstmm::search::FrequencyList;

system! {
    struct Spans { first: f64, second: f64, stiff: f64, soft: f64, line: f64, spring: f64, mass: f64 }
    pinned -> beam 1 { length: first, bending_stiffness: stiff, mass_per_length: 1.0 } -> conn 2
        -> beam 3 { length: second, bending_stiffness: soft, mass_per_length: line }
        -> body 5 { mass, inertia: mass, output_x: 0.3, centre_x: 0.1 } -> free;
    conn 2 <- spring 4 { stiffness: spring } <- fixed
}

system! {
    struct Portal { stiff: f64, soft: f64, line: f64, ea: f64, brace: f64 }
    fixed at (0.0, 0.0)
        -> planar_beam 1 { bending_stiffness: stiff, mass_per_length: line, axial_stiffness: ea } -> conn b at (0.0, 1.0)
        -> planar_beam 2 { bending_stiffness: soft, mass_per_length: 1.0, axial_stiffness: ea } -> conn c at (2.0, 1.0)
        -> planar_beam 3 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_stiffness: ea } -> fixed at (2.0, 0.0);
    conn b -> spring 4 { stiffness: brace } -> fixed at (2.0, 0.0)
}

/// Entries of lists by the widths of their intervals, and runs of the proof in two words and in four.
#[derive(Default)]
struct Shares {
    neighbouring: usize,
    to_eight_eps: usize,
    wider: usize,
    runs: [usize; 2],
}

impl Shares {
    fn add(&mut self, list: &FrequencyList<f64, 6>) {
        for root in list.iter() {
            assert!(root.is_proven, "{root:?}");
            match (root.upper - root.lower) / (f64::EPSILON * root.omega) {
                width if width <= 1.001 => self.neighbouring += 1,
                width if width <= 8.001 => self.to_eight_eps += 1,
                _ => self.wider += 1,
            }
        }
        let runs = list.proof_runs();
        self.runs = [self.runs[0] + runs[0], self.runs[1] + runs[1]];
    }

    /// That all are proven, and a table's row.
    fn tell(&self, name: &str, powers: f64, models: usize) {
        let Shares { neighbouring, to_eight_eps, wider, runs } = self;
        println!("| {name} | 1e±{powers} | {models} | {neighbouring} | {to_eight_eps} | {wider} | {runs:?} |");
        assert!(neighbouring + to_eight_eps + wider >= 6 * models * 99 / 100);
    }
}

/// A property: no model is refused, and of parameters in 1e±4 all frequencies are proven between neighbouring numbers.
fn check(models: usize, widest: &[f64]) {
    println!("| model | parameters | models | neighbouring numbers | to 8 eps | wider | runs in two words, four |");
    let mut random = Random(1);
    for &powers in widest {
        let mut next = || 10.0_f64.powf(powers * (2.0 * random.unit() - 1.0));
        let (mut spans, mut portals) = (Shares::default(), Shares::default());
        for _ in 0..models {
            let (first, second) = (next().powf(0.1), next().powf(0.1));
            let (stiff, soft, line, spring, mass) = (next(), next(), next(), next(), next());
            let model = Spans { first, second, stiff, soft, line, spring, mass };
            spans.add(&model.build().unwrap().first_frequencies().unwrap());
            let model = Portal { stiff, soft, line, ea: next(), brace: spring };
            portals.add(&model.build().unwrap().first_frequencies().unwrap());
        }
        spans.tell("spans", powers, models);
        portals.tell("portal", powers, models);
        let narrow = spans.neighbouring + portals.neighbouring;
        assert!(powers > 4.0 || narrow * 1000 >= 12 * models * 999, "{narrow}");
    }
}

#[test]
fn usual_frequencies_are_proven_between_neighbouring_numbers() {
    check(30, &[1.0, 4.0]);
}

#[test]
#[ignore = "long: .ci/long"]
fn shares_of_intervals() {
    check(500, &[1.0, 4.0, 6.0, 8.0]);
}
