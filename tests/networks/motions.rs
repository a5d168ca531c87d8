//! Shapes and responses of plane structures.

use crate::reference_cases::reference_cases;
use crate::through_library::asked_to_move;
use mstmm::motion::PlanePoint;
use mstmm::prelude::*;

#[test]
fn quick() {
    for case in reference_cases() {
        if case.name != "l_frame" {
            continue;
        }
        asked_to_move(&case.structure, |network| {
            let roots = network.first_frequencies::<8>().unwrap();
            for root in roots.iter().take(2) {
                let shape = network.mode_shape(root).unwrap();
                println!("{:?}", [0, 1, 2].map(|node| shape.node(node).unwrap()));
                println!("{:?}", shape.modal_mass());
            }
            let point = PlanePoint::node(2);
            for omega in [0.0, 5.0, 50.0] {
                let states =
                    network.frequency_response(point.force_y(), point.displacement_y()).unwrap().states(omega).unwrap();
                println!("{:?}", [0, 1, 2].map(|node| states.node(node).unwrap()));
                println!("{:?}", states.value(PlanePoint::node(0).reaction_z()));
            }
            Ok(())
        })
        .unwrap();
    }
}
