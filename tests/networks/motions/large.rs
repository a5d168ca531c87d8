//! The motion of a chain of ten thousand members: time and memory per member.

use crate::structure::Section;
use mstmm::motion::PlanePoint;
use mstmm::network::{self, Freedoms, Member, Network, Node, UndampedMember};
use mstmm::prelude::*;
use std::time::Instant;

const MEMBERS: usize = 10_000;
const NODES: usize = MEMBERS + 1;

/// On the stack of a test, of two megabytes.
#[test]
#[ignore = "large: in .ci/long"]
fn a_chain_of_ten_thousand_members_moves() {
    let Section { axial_stiffness, bending_stiffness, mass_per_length } = crate::families::section(1e4);
    let section = network::Section { axial_stiffness, bending_stiffness, mass_per_length };
    let place = |k: usize| [0.8 * k as f64, if k.is_multiple_of(2) { 0.0 } else { 0.6 }];
    let held = |k: usize| if k == 0 || k == MEMBERS { Freedoms::PLANE } else { Freedoms::NONE };
    let nodes: Vec<Node<f64>> = (0..NODES).map(|k| Node::at(place(k)).held(held(k))).collect();
    let members: Vec<Member<UndampedMember<f64>>> = (0..MEMBERS).map(|k| Member::new(k, k + 1, section)).collect();
    let per_member = |start: Instant| start.elapsed().as_secs_f64() * 1e6 / MEMBERS as f64;
    let start = Instant::now();
    let chain = Network::new(&nodes, &members).unwrap();
    println!("built: {:.1} µs per member", per_member(start));
    let start = Instant::now();
    let roots = chain.first_frequencies::<3>().unwrap();
    println!("three frequencies: {:.1} µs per member", per_member(start));
    for (mode, root) in roots.iter().enumerate() {
        let start = Instant::now();
        let shape = chain.mode_shape(root).unwrap();
        println!("mode {mode}: {:.1} µs per member", per_member(start));
        assert!((shape.modal_mass() - 1.0).abs() < 1e-11);
    }
    let middle = PlanePoint::node(MEMBERS / 2);
    let response = chain.frequency_response(middle.force_y(), middle.displacement_y()).unwrap();
    let start = Instant::now();
    assert!(response.at(1.0).unwrap().is_finite());
    println!("response: {:.1} µs per member", per_member(start));
}
