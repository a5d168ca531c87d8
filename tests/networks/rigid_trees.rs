//! Trees of rigid joints and stiff axes, which a search for zeros once took for mechanisms.

use mstmm::elements::TorsionSpring;
use mstmm::network::{End, Freedoms, Joint, Member, Network, Node, Section, UndampedMember};
use mstmm::prelude::*;

type Frame = Member<UndampedMember<f64>>;

#[test]
fn a_tree_of_rigid_joints_is_no_mechanism() {
    let (x, y, rz) = (Freedoms::X, Freedoms::Y, Freedoms::RZ);
    let held = |place: f64, freedoms: Freedoms| Node::at([place, 0.0]).held(x.union(freedoms));
    let nodes = [
        held(1.921875, y).with_body(0.0, 3.38, [1.921875, 0.0]),
        held(0.21875, y),
        held(1.421875, Freedoms::NONE),
        held(1.921875, Freedoms::PLANE),
        held(1.921875, y),
        held(1.921875, Freedoms::NONE),
        held(1.921875, y),
        held(1.921875, rz),
        held(2.0625, Freedoms::NONE).with_body(1.0, 1.0, [2.015625, 0.0]),
    ];
    let beam = |axial_stiffness, bending_stiffness, mass_per_length| Section {
        axial_stiffness,
        bending_stiffness,
        mass_per_length,
    };
    let members = [
        Frame::new(1, 2, beam(2.01e14, 2.01, 2.01)),
        Frame::new(2, 5, beam(1.82e14, 29.12, 1.82)),
        Frame::new(3, 4, TorsionSpring { stiffness: 0.38 }),
        Frame::new(4, 5, TorsionSpring { stiffness: 0.27 }),
        Frame::new(5, 6, Joint::rigid(rz)),
        Frame::new(6, 0, Joint::rigid(rz)),
        Frame::new(6, 7, Joint::rigid(rz)),
        Frame::new(7, End::of(8).at([1.921875, 0.0]), Joint::rigid(y.union(rz))),
    ];
    let network = Network::new(&nodes, &members).unwrap();
    let found = network.first_frequencies::<4>().unwrap();
    for (root, below) in found.iter().zip(0..) {
        assert_eq!(network.count_below(root.omega * 0.999_999).unwrap(), below);
    }
}
