//! Damped networks against the independent determinant: discs, counts in regions, and undamped ones beside certified frequencies.

use crate::equivalents::in_halves;
use crate::families::Named;
use crate::families::damped::damped_structure;
use crate::families::random::Spread;
use crate::families::{named_structures, random_structures};
use crate::oracle::Oracle;
use crate::stiffness_matrix::discs::Verdict;
use crate::structure::Structure;
use crate::through_library::{eigenvalues, first};
use mstmm::search::{Eigenvalue, Region};

/// What was compared.
#[derive(Debug, Default)]
struct Report {
    structures: usize,
    discs: usize,
    regions: usize,
    unsure: usize,
    /// Discs that are proven.
    proven: usize,
    /// The largest radius in units of eps.
    widest: f64,
    refused: Vec<String>,
    wrong: Vec<String>,
}

fn is_zero(root: &Eigenvalue) -> bool {
    root.lambda.norm() <= root.error
}

impl Report {
    fn discs(&mut self, name: &str, oracle: &Oracle, roots: &[Eigenvalue]) {
        for root in roots.iter().filter(|root| !is_zero(root)) {
            self.discs += 1;
            self.proven += usize::from(root.is_proven);
            self.widest = self.widest.max(root.error / (root.lambda.norm() * f64::EPSILON));
            match oracle.judge_disc(root) {
                Verdict::Holds => {}
                Verdict::CannotTell => self.unsure += 1,
                Verdict::Misses(by) => self.wrong.push(format!("{name}: {by} radii off: {root:?}")),
            }
        }
    }

    /// Whether a region around the first roots has as many as it says.
    fn region(&mut self, name: &str, structure: &Structure, roots: &[Eigenvalue]) {
        let pieces = in_halves(structure);
        let oracle = Oracle::damped(&pieces);
        let limit = 0.8 * oracle.first_held_frequency();
        let moduli: Vec<f64> = roots.iter().map(|root| root.lambda.norm()).filter(|size| *size < limit).collect();
        let size = match moduli[..] {
            [.., before, last] if moduli.len() == roots.len() => 0.5 * (before + last),
            [.., last] => (1.01 * last).midpoint(limit),
            [] => return,
        };
        let (re, im) = ([-1.07 * size, 0.0371 * size], [-0.0173 * size, size]);
        let Some(zeros) = oracle.zeros_in(re, im) else {
            self.unsure += 1;
            return;
        };
        self.regions += 1;
        match eigenvalues(structure, Some(Region { re: re[0]..=re[1], im: im[0]..=im[1] })) {
            Ok((found, count)) => {
                let sum: u64 = found.iter().map(|root| root.multiplicity).sum();
                if count != Some(zeros) || sum != zeros {
                    self.wrong.push(format!("{name}: {zeros} zeros, count {count:?}, list {sum} in {re:?}, {im:?}"));
                }
                self.discs(&format!("{name} in its region"), &Oracle::damped(structure), &found);
            }
            Err(error) => self.refused.push(format!("{name} in {re:?}, {im:?}: {error}")),
        }
    }

    fn damped(&mut self, name: &str, structure: &Structure) {
        self.structures += 1;
        match eigenvalues(structure, None) {
            Ok((found, _)) => {
                self.discs(name, &Oracle::damped(structure), &found);
                self.region(name, structure, &found);
            }
            Err(error) => self.refused.push(format!("{name}: {error}")),
        }
    }

    /// Eigenvalues of an undamped structure are ±iω.
    fn undamped(&mut self, name: &str, structure: &Structure) {
        let (found, frequencies) = match (eigenvalues(structure, None), first(structure)) {
            (Ok((found, _)), Ok(frequencies)) => (found, frequencies),
            (found, frequencies) => {
                let errors = [found.err(), frequencies.err()];
                return self.refused.push(format!("{name}: {errors:?}"));
            }
        };
        self.structures += 1;
        let one_by_one = |multiplicity: u64| 0..multiplicity as usize;
        let roots = found.iter().filter(|root| !is_zero(root));
        let roots = roots.flat_map(|root| one_by_one(root.multiplicity).map(move |_| root));
        let rest: u64 = found.iter().filter(|root| is_zero(root)).map(|root| root.multiplicity).sum();
        let held: u64 = frequencies.iter().filter(|root| root.omega == 0.0).map(|root| root.multiplicity).sum();
        if rest != 2 * held {
            self.wrong.push(format!("{name}: {rest} eigenvalues at rest, {held} frequencies"));
        }
        let moving = frequencies.iter().filter(|root| root.omega > 0.0);
        let moving = moving.flat_map(|root| one_by_one(root.multiplicity).map(move |_| root));
        for (root, frequency) in roots.zip(moving) {
            self.discs += 1;
            self.proven += usize::from(root.is_proven);
            self.widest = self.widest.max(root.error / (root.lambda.norm() * f64::EPSILON));
            let (below, above) = (root.lambda.im - root.error, root.lambda.im + root.error);
            if root.lambda.re.abs() > root.error || above < frequency.lower || below > frequency.upper {
                self.wrong.push(format!("{name}: {root:?} {frequency:?}"));
            }
        }
    }

    fn judge(self, name: &str) {
        let Report { structures, discs, regions, unsure, proven, widest, refused, wrong } = &self;
        println!(
            "{name}: {structures} structures, {discs} discs, {proven} proven, {regions} regions, {unsure} unsure, widest {widest:.0} eps"
        );
        refused.iter().for_each(|why| println!("  refused {why}"));
        wrong.iter().for_each(|why| println!("  wrong {why}"));
        assert!(wrong.is_empty(), "{wrong:#?}");
    }
}

fn judge_damped(seeds: core::ops::Range<u64>) {
    let mut report = Report::default();
    seeds.for_each(|seed| report.damped(&format!("damped_structure({seed})"), &damped_structure(seed)));
    assert!(report.proven == report.discs && report.widest <= 2.0, "{report:?}");
    report.judge("damped");
}

fn judge_undamped(structures: impl Iterator<Item = Named>) {
    let mut report = Report::default();
    structures.for_each(|(name, structure)| report.undamped(&name, &structure));
    report.judge("undamped as damped");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: .ci/long")]
fn discs_and_regions_of_damped_structures_hold_the_zeros_of_the_determinant() {
    judge_damped(0..1);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn discs_and_regions_of_many_damped_structures_hold_the_zeros_of_the_determinant() {
    judge_damped(0..100);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: .ci/long")]
fn eigenvalues_of_undamped_structures_are_their_frequencies() {
    judge_undamped(random_structures(0..1, Spread::Moderate));
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn eigenvalues_of_many_undamped_structures_are_their_frequencies() {
    judge_undamped(random_structures(0..60, Spread::Moderate));
    judge_undamped(random_structures(0..60, Spread::Stiff));
    judge_undamped(named_structures().into_iter());
}
