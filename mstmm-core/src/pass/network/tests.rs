//! Networks that cannot be built or searched: errors name the member or the node, and the number that suffices.

extern crate std;

use crate::elements::Spring;
use crate::pass::network::{Arrays, End, Member, Network, Node};
use crate::search::NaturalFrequencies;
use crate::{Joint, Section, UndampedMember};
use mstmm_plan::{Freedoms, Support};
use std::string::{String, ToString};

type Any = Member<UndampedMember<f64>>;

const SECTION: Section<f64> = Section { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 };

/// What a network of up to four nodes and three members says against being built or searched with room for so many unknowns at once.
fn refused_in<const WIDTH: usize>(nodes: &[Node<f64>], members: &[Any]) -> String {
    match Network::<_, Arrays<WIDTH, 4, 3>>::in_arrays(nodes, members) {
        Err(error) => error.to_string(),
        Ok(network) => network.first_frequencies::<2>().unwrap_err().to_string(),
    }
}

/// What is said of a cantilever from node 0 to node 1 with more nodes and members.
#[track_caller]
fn assert_refused(more_nodes: &[Node<f64>], more_members: &[Any], message: &str) {
    let own = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), Node::at([1.0, 0.0])];
    let nodes = [&own[..], more_nodes].concat();
    let members = [&[Any::new(0, 1, SECTION)], more_members].concat();
    let found = refused_in::<30>(&nodes, &members);
    assert!(found.ends_with(message), "{found}");
}

#[test]
fn capacities_are_refused_with_those_that_suffice() {
    let nodes = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), Node::at([1.0, 0.0])];
    let cantilever = [Any::new(0, 1, SECTION)];
    let narrow = refused_in::<5>(&nodes, &cantilever);
    assert_eq!(narrow, "up to 6 unknowns are there at once: `Arrays::<6, _, _>` has room for them");
    let many = [nodes[1]; 5];
    let crowded = refused_in::<30>(&many, &cantilever);
    assert_eq!(crowded, "the arrays are too small for 5 nodes and 1 members: `Arrays::<_, 5, 1>` has room for them");
    assert_eq!(refused_in::<30>(&nodes, &[]), "the network has no members");
}

#[test]
fn members_are_named_by_their_index() {
    assert_refused(&[], &[Any::new(1, 2, SECTION)], "member 1 has an end at node 2, which is not in the list of nodes");
    assert_refused(
        &[Node::at([1.0, 0.0])],
        &[Any::new(1, 2, Spring { stiffness: 1.0 })],
        "member 1 has both ends at one place, at nodes 1 and 2: \
         a beam needs a length, a spring between such nodes a direction, `.along(..)`",
    );
    assert_refused(
        &[Node::at([1.0, 0.1])],
        &[Any::new(1, 2, Joint::rigid(Freedoms::X))],
        "member 1 is a joint of nodes 1 and 2, which are not at one place",
    );
    assert_refused(
        &[Node::at([2.0, 0.0])],
        &[Any::new(1, 2, SECTION).along([1.0, 0.0])],
        "member 1 has a direction that is zero, not finite, or not its own to choose: \
         springs and dampers of translations take one",
    );
    let nothing = Section { axial_stiffness: f64::NAN, ..SECTION };
    assert_refused(
        &[Node::at([2.0, 0.0])],
        &[Any::new(1, 2, nothing)],
        "member 1, beam: axial_stiffness is NaN, but must be positive and finite",
    );
}

#[test]
fn nodes_are_named_by_their_index() {
    let join = |from: usize| Any::new(from, 2, SECTION);
    assert_refused(
        &[Node::at([2.0, 0.0])],
        &[],
        "nothing joins node 2 to the rest: a network hangs together; search two networks",
    );
    let node = Node::at([2.0, 0.0]);
    assert_refused(&[node.along([0.0, 0.0])], &[join(1)], "node 2: its direction is zero, not finite or beyond 1e±70");
    assert_refused(
        &[node.along([1.0, 0.0]).held(Support::Pinned.holds())],
        &[join(1)],
        "node 2: it moves along a direction, and x or y is held as well: hold rz at most",
    );
    assert_refused(
        &[node.with_body(-1.0, 0.0, [2.0, 0.0])],
        &[join(1)],
        "node 2: mass and inertia must be zero or positive, and finite like the mass centre",
    );
    assert_refused(&[Node::at([f64::NAN, 0.0])], &[join(1)], "node 2: its place is not finite");
}

#[test]
fn what_nothing_holds_or_two_hold_is_named_by_its_node() {
    // a massless node that turns between two hinges, and one welded twice in one freedom
    let hinged = |node: usize| End::of(node).releasing(Freedoms::RZ);
    assert_refused(
        &[Node::at([2.0, 0.0]), Node::at([3.0, 0.0]).held(Support::Fixed.holds())],
        &[Any::new(1, hinged(2), SECTION), Any::new(hinged(2), 3, SECTION)],
        "something is held twice, or a massless part by nothing, as shows at node 2",
    );
    let welds = [Freedoms::PLANE, Freedoms::X].map(|freedoms| Any::new(1, 2, Joint::rigid(freedoms)));
    assert_refused(
        &[Node::at([1.0, 0.0])],
        &welds,
        "something is held twice, or a massless part by nothing, as shows at node 2",
    );
}
