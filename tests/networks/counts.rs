//! Counts at frequencies that are no roots, where rounding decides the sign of a pivot.

use mstmm::network::{Freedoms, Member, Network, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;

/// Far stiffer beams along than others across: a thousandth of a frequency away from the first one pivots in `f64` do not tell on which side it is.
#[test]
fn a_count_that_rounding_decides_is_left_to_the_judge() {
    let (clamp, pin) = (Support::Fixed.holds(), Support::Pinned.holds());
    let across = Freedoms::X.union(Freedoms::RZ);
    let nodes = [
        Node::at([0.502875173232335, 0.0]).held(clamp),
        Node::at([3.504954937310994, 1.5]).held(across),
        Node::at([3.5028344659967723, 4.0]).held(pin),
        Node::at([3.0047486094411826, 3.5]).held(pin),
        Node::at([2.0089247861350086, 3.0]),
        Node::at([3.5021325791876503, 3.0]).held(Freedoms::Y),
    ];
    let beams = [
        ([0, 1], 109193705.5142772, 1.8608288998298782e-9),
        ([1, 2], 138720910.44466016, 1.2303708157890105e-8),
        ([0, 3], 918068.7215298257, 2.85471027265785e-10),
        ([3, 4], 1185213.3409159486, 81947.49505470248),
        ([3, 5], 1677929647.9249742, 201.4848395876933),
    ];
    let members = beams.map(|([from, to], axial_stiffness, bending_stiffness)| {
        Member::<UndampedMember<f64>>::new(
            from,
            to,
            Section { axial_stiffness, bending_stiffness, mass_per_length: 1.0 },
        )
    });
    let network = Network::new(&nodes, &members).unwrap();
    // on both sides of 2.0422980811199245e-5
    let counts = [2.0402556830e-5, 2.0443403792010524e-5].map(|omega| network.count_below(omega));
    assert_eq!(counts, [Ok(0), Ok(1)]);
    let in_range = |end: f64| network.natural_frequencies::<2>(1e-6..=end).map(|list| list.len());
    assert_eq!([in_range(2.0402556830e-5), in_range(2.0443403792010524e-5)], [Ok(0), Ok(1)]);
}
