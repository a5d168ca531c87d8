//! Structures with dashpots.

use super::random::{Spread, random_structure};
use crate::structure::{Element, End, Freedoms, Member, Structure};
use crate::support::random_tree::Random;

/// A structure with dashpots to the ground and between its nodes, of the size of a damping.
pub(crate) fn with_dashpots(mut structure: Structure, seed: u64, damping: f64) -> Structure {
    let mut random = Random(seed.wrapping_add(0x1234_5678));
    let nodes: Vec<usize> =
        (0..structure.nodes.len()).filter(|&node| structure.nodes[node].held != Freedoms::ALL).collect();
    let Some(&last) = nodes.last() else { return structure };
    for _ in 0..=random.below(3) {
        let node = nodes[random.below(nodes.len())];
        let size = damping * random.value();
        let ground = structure.clamp(structure.nodes[node].position);
        let (other, direction) =
            if random.chance(0.4) && node != last { (last, [3.0, 4.0]) } else { (ground, [-5.0, 12.0]) };
        let (element, along) = match random.chance(0.3) {
            true => (Element::TorsionDamper { damping: size }, None),
            false => (Element::Damper { damping: size }, Some(direction)),
        };
        structure.members.push(Member { ends: [End::from(node), End::from(other)], along, element });
        // what is not used joins nothing
        if other != ground {
            structure.nodes.pop();
        }
    }
    structure
}

/// A random structure with dashpots of any size.
pub(crate) fn damped_structure(seed: u64) -> Structure {
    let size = [1e-3, 0.1, 1.0, 30.0][(seed % 4) as usize];
    with_dashpots(random_structure(seed, Spread::Moderate), seed, size)
}
