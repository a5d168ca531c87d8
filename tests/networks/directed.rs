//! The library against the oracle over families of structures in which stiffnesses differ by many decades.

use crate::checks::{Found, wrong_count};
use crate::equivalents::{reversed, shuffled_structure};
use crate::families::directed::{Family, families};
use crate::families::{Named, named_structures};
use crate::oracle::Oracle;
use crate::structure::{Element, End, Freedoms, Member, Structure};
use crate::support::shares::Shares;
use crate::through_library::{entries, first, first_list};

/// What was compared over a family.
#[derive(Debug, Default)]
pub(crate) struct Report {
    pub(crate) structures: usize,
    pub(crate) roots: usize,
    /// Widths of the intervals, and what was not proven.
    pub(crate) shares: Shares,
    pub(crate) ends: usize,
    pub(crate) unsure: usize,
    /// The widest interval in units of eps.
    pub(crate) widest: f64,
    pub(crate) wide: String,
    pub(crate) refused: Vec<String>,
    pub(crate) wrong: Vec<String>,
}

/// Part of a frequency that the width of its interval is, in units of eps.
pub(crate) fn width(found: &Found) -> f64 {
    if found.omega > 0.0 { (found.upper - found.lower) / (found.omega * f64::EPSILON) } else { 0.0 }
}

impl Report {
    /// Compares what was found of a structure, so many frequencies being below.
    pub(crate) fn compare(&mut self, name: &str, structure: &Structure, below: u64, found: &[Found]) {
        self.structures += 1;
        self.roots += found.len();
        self.ends += 2 * found.len();
        for root in found {
            if width(root) > self.widest {
                (self.widest, self.wide) = (width(root), format!("{name} {root:?}"));
            }
        }
        match wrong_count(&Oracle::of(structure), below, found) {
            Ok(unsure) => self.unsure += unsure,
            Err(message) => self.wrong.push(format!("{name}: {message}")),
        }
    }

    pub(crate) fn search(&mut self, (name, structure): &Named) {
        let found = first_list(structure).and_then(|found| {
            self.shares.search(&found, &|| name.clone());
            found.map_err(|error| error.to_string())
        });
        match found {
            Ok(list) => self.compare(name, structure, 0, &entries(&list)),
            Err(error) => {
                self.structures += 1;
                self.refused.push(format!("{name}: {error}"));
            }
        }
    }

    pub(crate) fn show(&self, name: &str) {
        let Report { structures, roots, shares, ends, unsure, widest, wide, refused, wrong } = self;
        let unsure = *unsure as f64 / (*ends).max(1) as f64;
        println!(
            "{name}: {structures} structures, {roots} roots, widest {widest:.0} eps, {} refused, {} wrong, unsure {unsure:.3}",
            refused.len(),
            wrong.len()
        );
        if shares.searches > 0 {
            shares.show(&format!("  widths, {name}"));
        }
        if *widest > 64.0 {
            println!("  widest {wide}");
        }
        refused.iter().for_each(|why| println!("  refused {why}"));
        wrong.iter().for_each(|why| println!("  wrong {why}"));
    }
}

fn judge(families: impl Iterator<Item = Family>) {
    let mut all = Report::default();
    for Family { name, structures } in families {
        let mut report = Report::default();
        structures.iter().for_each(|structure| report.search(structure));
        report.show(name);
        all.shares.and(&report.shares);
        all.refused.extend(report.refused);
        all.wrong.extend(report.wrong);
    }
    Shares::head("directed structures");
    all.shares.show("all families");
    assert_eq!(all.shares.not_proven, 0, "{:?}", all.shares.first);
    assert!(all.wrong.is_empty() && all.refused.is_empty(), "{:#?} {:#?}", all.wrong, all.refused);
}

#[test]
fn families_have_their_frequencies_where_they_belong() {
    let small = |structures: Vec<Named>| structures.into_iter().filter(|(_, it)| it.members.len() < 13).collect();
    judge(families(12).into_iter().map(|family| Family { structures: small(family.structures), ..family }));
}

#[test]
#[ignore = "all decades: in .ci/long"]
fn families_have_their_frequencies_where_they_belong_at_every_decade() {
    judge(families(1).into_iter());
}

/// A structure that is searched by charts from the beginning, since a joint that an end does not share in whole is not known in numbers: with
/// one between a node at rest and a clamp at its place, which changes no frequency.
pub(crate) fn by_charts(mut structure: Structure, rests: usize) -> Structure {
    let clamp = structure.clamp(structure.nodes[rests].position);
    let ends = [End::from(rests).releasing(Freedoms::RZ), End::from(clamp)];
    structure.members.push(Member { ends, along: None, element: Element::Hinge { stiffness: [1e3; 3] } });
    structure
}

/// Intervals of one frequency that two orders of the same structure give.
fn assert_meet(name: &str, one: &[Found], other: &[Found], wrong: &mut Vec<String>) {
    // of one interval with two frequencies the other order may make two
    let each = |found: &[Found]| -> Vec<Found> {
        found.iter().flat_map(|root| (0..root.multiplicity).map(|_| *root)).collect()
    };
    for (one, other) in each(one).into_iter().zip(each(other)) {
        if one.lower > other.upper || other.lower > one.upper {
            wrong.push(format!("{name}: {one:?} {other:?}"));
        }
    }
}

#[test]
#[ignore = "many orders: in .ci/long"]
fn families_do_not_depend_on_order_and_direction() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    let structures = families(3).into_iter().flat_map(|family| family.structures).chain(named_structures());
    for (name, structure) in structures {
        let Ok(one) = first(&structure) else { continue };
        for seed in 0..8 {
            let other = if seed == 0 { reversed(&structure) } else { shuffled_structure(&structure, seed) };
            compared += 1;
            match first(&other) {
                Ok(other) => assert_meet(&format!("{name}, order {seed}"), &one, &other, &mut wrong),
                Err(error) => wrong.push(format!("{name}, order {seed}: {error}")),
            }
        }
    }
    println!("{compared} orders");
    assert!(wrong.is_empty(), "{wrong:#?}");
}
