//! Structures that searches find hard, and random ones from a seed.

pub(crate) mod damped;
pub(crate) mod directed;
pub(crate) mod line;
pub(crate) mod named;
pub(crate) mod random;

use crate::structure::{Section, Structure};
use named::{
    free_square, hinged_zigzag, ladder, mass_on_springs, portal, portal_on_sliders, portal_with_ties, ring, star,
    storeys, zigzag,
};
use random::{Spread, random_structure};

/// A structure with a name that tells how to make it again.
pub(crate) type Named = (String, Structure);

/// The section that is stiffer along its axis by a factor.
pub(crate) fn section(axial_stiffness: f64) -> Section {
    Section { axial_stiffness, bending_stiffness: 1.0, mass_per_length: 1.0 }
}

/// The named structures with the parameters at which searches lose digits first.
pub(crate) fn named_structures() -> Vec<Named> {
    let mut all = Vec::new();
    let mut add = |name: String, structure: Structure| all.push((name, structure));
    for ea in [1e-9, 1e-6, 1e-3, 1.0, 1e4, 1e8, 1e12] {
        add(format!("portal({ea:e}, 1)"), portal(ea, 1.0));
    }
    for girder in [1e-12, 1e-6, 1e6, 1e12] {
        add(format!("portal(1e4, {girder:e})"), portal(1e4, girder));
    }
    for k in [1e-12, 1e-8, 1e-4, 1.0, 1e4] {
        add(format!("portal_on_sliders({k:e})"), portal_on_sliders(k));
    }
    for (members, k) in [(6, 1e-8), (6, 1e-4), (6, 1e4), (20, 1e-4)] {
        add(format!("hinged_zigzag({members}, {k:e})"), hinged_zigzag(members, k));
    }
    for k in [1e-8, 1.0, 1e8, 1e12, 1e16, 1e20] {
        add(format!("mass_on_springs({k:e})"), mass_on_springs(k));
    }
    for (bays, rungs) in [(5, 1.0), (5, 1e6), (5, 1e-6), (10, 1.0)] {
        add(format!("ladder({bays}, {rungs:e})"), ladder(bays, rungs));
    }
    add("storeys(2, 3)".to_owned(), storeys(2, 3));
    add("zigzag(20)".to_owned(), zigzag(20));
    add("star(1e4)".to_owned(), star(1e4));
    add("ring(4)".to_owned(), ring(4));
    add("ring(7)".to_owned(), ring(7));
    add("free_square(1e4)".to_owned(), free_square(1e4));
    for ei in [1e-12, 1e-8, 1e-4] {
        for is_hinged in [false, true] {
            add(format!("portal_with_ties({ei:e}, {is_hinged})"), portal_with_ties(ei, is_hinged));
        }
    }
    all
}

/// Random structures of consecutive seeds.
pub(crate) fn random_structures(seeds: core::ops::Range<u64>, spread: Spread) -> impl Iterator<Item = Named> {
    seeds.map(move |seed| (format!("random_structure({seed}, {spread:?})"), random_structure(seed, spread)))
}
