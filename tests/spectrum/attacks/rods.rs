//! Rods and strings between heavy masses, on a stiff foundation.

use super::exact::double;
use super::in_full;
use crate::oracles::wave_lines::{Link, Web};
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, Mass, Rod, TautString};
use mstmm::list::{ListStep, StepList};
use mstmm::prelude::*;

fn line(
    is_rod: bool,
    [length, stiffness, mass_per_length, foundation_stiffness]: [f64; 4],
) -> ListStep<AnyUndamped<f64>> {
    ListStep::Element(if is_rod {
        Rod { length, axial_stiffness: stiffness, mass_per_length, foundation_stiffness }.try_into().unwrap()
    } else {
        TautString { length, tension: stiffness, mass_per_length, foundation_stiffness }.try_into().unwrap()
    })
}

/// Oracle: the dynamic stiffness in two words, at both ends of each interval and on both sides of it.
fn heavy_rods(models: usize) {
    let random = &mut Random(0xb6);
    let mut entries = 0;
    for _ in 0..models {
        let is_rod = random.chance(0.5);
        let mut number = || (1.0 + 3.0 * random.unit()) * 0.5;
        let [mut first, mut second] = [0, 1].map(|_| [number(), number(), number(), 0.0]);
        second[3] = 1e4 * number();
        let mut mass = || 10_f64.powf(3.0 + 4.3 * random.unit());
        let mut masses = vec![mass(), mass()];
        if random.chance(0.5) {
            // as equal as they can be
            (first, masses[1]) = ([second[0], second[1], second[2], 0.0], masses[0]);
        }
        let is_held = random.chance(0.3);
        let mut steps = vec![ListStep::Tip(Support::Fixed), line(is_rod, first)];
        steps.push(ListStep::Element(Mass { mass: masses[0] }.try_into().unwrap()));
        steps.push(line(is_rod, second));
        steps.push(ListStep::Element(Mass { mass: masses[1] }.try_into().unwrap()));
        let mut links = vec![([0, 1], Link::Line(first)), ([1, 2], Link::Line(second))];
        if is_held {
            steps.extend([line(is_rod, first), ListStep::Root(Support::Fixed)]);
            links.push(([2, 0], Link::Line(first)));
        } else {
            steps.push(ListStep::Root(Support::Free));
        }
        let web = Web { masses, links };
        let found = StepList::new(&steps).unwrap().first_frequencies::<12>().unwrap();
        let mut below = 0;
        for root in &found {
            let counts = [root.lower, root.upper].map(|end| web.count_below(double(end)));
            // the theorem of an entry
            let holds = counts[0] < root.index && counts[1] >= root.index + root.multiplicity - 1;
            assert!(holds && root.is_proven && root.index == below + 1, "{counts:?} {root:?} {web:?}");
            below += root.multiplicity;
            entries += 1;
        }
    }
    println!("| heavy rods | {models} | {entries} |");
}

in_full! {
    heavy_rods(40, 2000) = some_rods_between_heavy_masses, all_rods_between_heavy_masses;
}
