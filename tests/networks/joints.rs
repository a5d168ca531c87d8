//! Joints of two nodes at one place beside the same structures with released ends, and points that a joint ties to the ground.
#![expect(clippy::unwrap_used, reason = "a network that cannot be built fails the test")]

use mstmm::elements::PlanarHinge;
use mstmm::network::{End, Freedoms, Joint, Member, Network, NetworkError, Node, Section, UndampedMember};
use mstmm::prelude::*;

type Frame = Member<UndampedMember<f64>>;

const SECTION: Section<f64> = Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };

fn frequencies(nodes: &[Node<f64>], members: &[Frame]) -> Vec<f64> {
    let network = Network::new(nodes, members).unwrap();
    network.first_frequencies::<6>().unwrap().iter().map(|root| root.omega).collect()
}

fn clamped(place: [f64; 2]) -> Node<f64> {
    Node::at(place).held(Freedoms::PLANE)
}

/// A leg, a girder from its head to a second one with some ends, and what stands beside them.
fn portal(head: End<f64>, joint: Option<(Node<f64>, Frame)>) -> Vec<f64> {
    let mut nodes = vec![clamped([0.0, 0.0]), Node::at([0.0, 3.0]), Node::at([4.0, 3.5]), clamped([4.2, 0.0])];
    let mut members = vec![Frame::new(0, 1, SECTION), Frame::new(1, head, SECTION), Frame::new(2, 3, SECTION)];
    if let Some((node, member)) = joint {
        nodes.push(node);
        members.push(member);
    }
    frequencies(&nodes, &members)
}

fn assert_agree(one: &[f64], other: &[f64]) {
    for (a, b) in one.iter().zip(other) {
        assert!((a / b - 1.0).abs() < 1e-14, "{one:?} {other:?}");
    }
}

#[test]
fn a_pin_and_a_slider_are_released_ends() {
    let beside = Node::at([4.0, 3.5]);
    let pin = Joint::rigid(Freedoms::X.union(Freedoms::Y));
    assert_agree(
        &portal(End::of(4), Some((beside, Frame::new(4, 2, pin)))),
        &portal(End::of(2).releasing(Freedoms::RZ), None),
    );
    let slider = Joint::rigid(Freedoms::Y.union(Freedoms::RZ));
    for (released, direction) in [(Freedoms::X, [8.0, 1.0]), (Freedoms::Y, [-1.0, 8.0])] {
        assert_agree(
            &portal(End::of(4), Some((beside, Frame::new(4, 2, slider).along(direction)))),
            &portal(End::of(2).releasing(released), None),
        );
    }
}

#[test]
fn a_rigid_joint_makes_one_node_of_two() {
    let joint = Frame::new(2, 4, Joint::rigid(Freedoms::PLANE)).along([0.3, -0.7]);
    assert_agree(&portal(End::of(4), Some((Node::at([4.0, 3.5]), joint))), &portal(End::of(2), None));
}

#[test]
fn hinges_lie_between_free_and_rigid() {
    let hinge = |stiffness| PlanarHinge { stiffness_x: stiffness, stiffness_y: stiffness, stiffness_theta: stiffness };
    let with = |stiffness| {
        let joint = Frame::new(2, 4, Joint::from(hinge(stiffness)));
        portal(End::of(4), Some((Node::at([4.0, 3.5]), joint)))
    };
    assert_agree(&with(1e25), &portal(End::of(2), None));
    let (soft, stiff) = (with(1e3), with(1e6));
    assert!(soft.iter().zip(&stiff).all(|(soft, stiff)| soft < stiff), "{soft:?} {stiff:?}");
}

#[test]
fn a_bar_between_sliders_on_the_ground_moves_along_them() {
    // both ends slide along y, the rotation is held: a rigid motion, then bending of a guided beam, cos and sin of half waves
    let nodes = [clamped([0.0, 0.0]), Node::at([0.0, 0.0]), Node::at([2.0, 0.0]), clamped([2.0, 0.0])];
    let slider = Joint::rigid(Freedoms::Y.union(Freedoms::RZ));
    let members = [
        Frame::new(0, 1, slider).along([0.0, 1.0]),
        Frame::new(1, 2, SECTION),
        Frame::new(2, 3, slider).along([0.0, -1.0]),
    ];
    let found = frequencies(&nodes, &members);
    assert!(found[0] == 0.0, "{found:?}");
    let exact = (core::f64::consts::PI / 2.0).powi(2) * (1e6_f64 / 20.0).sqrt();
    assert!((found[1] / exact - 1.0).abs() < 1e-15, "{found:?} {exact}");
}

#[test]
fn a_joint_of_two_places_is_refused() {
    let nodes = [clamped([0.0, 0.0]), Node::at([0.0, 3.0])];
    let members = [Frame::new(0, 1, Joint::rigid(Freedoms::PLANE))];
    let refused = Network::new(&nodes, &members).map(|_| ());
    assert_eq!(refused, Err(NetworkError::TwoPlaces { member: 0, nodes: [0, 1] }));
}
