//! Numbers of nodes: Sturm's theorem.

use crate::mode_shapes::checks::first;
use crate::mode_shapes::single_beams::*;
use crate::support::list_of_tree::undamped;
use crate::support::tree::Part;
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::ListStep;
use mstmm::prelude::*;

/// Oracle: mode n of a beam on its own supports has n - 1 nodes between its ends, rigid-body modes counted.
#[test]
fn nodes_of_a_beam_between_two_supports() {
    let supports = [Support::Fixed, Support::Pinned, Support::Guided, Support::Free];
    let beam = Part::Beam(Beam { length: 1.3, bending_stiffness: 2.0, mass_per_length: 0.7 });
    for (place, &tip) in supports.iter().enumerate() {
        for &root in &supports[place..] {
            let beam = undamped(&vec![ListStep::Tip(tip), ListStep::Element(beam), ListStep::Root(root)]);
            let mut mode = 0;
            for found in &first::<60>(&beam) {
                if found.multiplicity == 1 {
                    let shape = beam.mode_shape(found).unwrap();
                    assert_eq!(shape.nodes(beam.label(1).unwrap()), mode, "{tip:?} {root:?} {found:?}");
                }
                mode += found.multiplicity as usize;
            }
        }
    }
}

/// Oracle: as above, for the first modes and some of the rest, whose samples are many.
#[test]
fn nodes_of_a_cantilever_up_to_mode_1000() {
    let system = Cantilever { l: 1.3, ei: 2.0, m: 0.7 }.build().unwrap();
    for (mode, root) in first::<1000>(&system).iter().enumerate() {
        if mode < 60 || mode % 50 > 48 {
            let shape = system.mode_shape(root).unwrap();
            assert_eq!(shape.nodes(Cantilever::beam_1), mode, "{root:?}");
        }
    }
}

/// Oracle: the same of a chain, for parts alike, different, and very different.
#[test]
fn nodes_of_a_stepped_chain_add_up() {
    for (l1, ei1, l2, ei2) in [(1.0, 1.0, 0.7, 2.0), (0.31, 40.0, 1.7, 0.3), (2.1, 0.02, 0.4, 5.0)] {
        let system = Stepped { l1, ei1, l2, ei2 }.build().unwrap();
        for (mode, root) in first::<60>(&system).iter().enumerate() {
            let shape = system.mode_shape(root).unwrap();
            assert_eq!(shape.nodes(Stepped::beam_1) + shape.nodes(Stepped::beam_2), mode, "{root:?}");
        }
    }
}
