//! Numbers of nodes: Sturm's theorem.

use crate::mode_shapes::checks::first;
use crate::mode_shapes::single_beams::*;
use mstmm::prelude::*;

/// Oracle: mode n of a beam on its own supports has n - 1 nodes between its ends, rigid-body modes counted.
macro_rules! check_nodes {
    ($($test:ident: $model:ident, $modes:expr;)*) => {$(
        #[test]
        fn $test() {
            let system = $model { l: 1.3, ei: 2.0, m: 0.7 }.build().unwrap();
            let mut mode = 0;
            for root in &first::<{ $modes }>(&system) {
                // all of the first, some of the rest: samples are many there
                if root.multiplicity == 1 && (mode < 60 || mode % 50 > 48) {
                    let shape = system.mode_shape(root).unwrap();
                    assert_eq!(shape.nodes($model::beam_1), mode, "{root:?}");
                }
                mode += root.multiplicity as usize;
            }
        }
    )*};
}

check_nodes! {
    cantilever_up_to_mode_1000: Cantilever, 1000;
    pinned_pinned: PinnedPinned, 60;
    clamped_clamped: ClampedClamped, 60;
    free_free: FreeFree, 60;
    guided_guided: GuidedGuided, 60;
    clamped_pinned: ClampedPinned, 60;
    clamped_guided: ClampedGuided, 60;
    pinned_guided: PinnedGuided, 60;
    free_pinned: FreePinned, 60;
    free_guided: FreeGuided, 60;
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
