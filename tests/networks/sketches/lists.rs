//! Sketches and the same structures as lists.

use super::{assert_near, eigenvalues, frequencies};
use crate::portal;
use mstmm::elements::{Damper, PlanarHinge, Spring, TorsionSpring};
use mstmm::network::{AnyMember, End, Freedoms, Joint, Member, Network, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;

type Frame = Member<UndampedMember<f64>>;

const SECTION: Section<f64> = Section { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 };

/// What moves along a direction and nowhere else.
const ALONG_X: Freedoms = Freedoms::Y.union(Freedoms::RZ);

/// A node of a path with a mass.
fn along_x(mass: f64) -> Node<f64> {
    Node::at([0.0, 0.0]).held(ALONG_X).with_body(mass, 0.0, [0.0, 0.0])
}

#[track_caller]
fn assert_equal(found: &[f64], nodes: &[Node<f64>], members: &[Frame]) {
    let network = Network::new(nodes, members).unwrap();
    assert_near(found, &frequencies(&network), 1e-15);
}

system! {
    /// A cantilever with a chain of springs and masses along a slope to its tip, a spring to the ground, and a turning inertia.
    pub(super) struct Chain { pub(super) k: f64, pub(super) mass: f64, pub(super) x: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (x, 0.5);
    conn a <- along (x, 1.0) <- spring 2 { stiffness: k } <- mass 3 { mass } <- spring 4 { stiffness: 2.0 * k }
        <- mass 5 { mass: 0.5 * mass } <- conn u <- spring 6 { stiffness: 3.0 * k } <- fixed;
    conn a -> spring 7 { stiffness: k } -> conn g at (2.0, 2.0) <- fixed;
    conn a <- torsion_spring 8 { stiffness: k } <- inertia 9 { inertia: 0.1 * mass } <- free;
}

#[test]
fn paths_move_along_their_directions() {
    let (k, mass, x) = (3.0, 0.7, 1.25);
    let sketch = Chain { k, mass, x }.build().unwrap();
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([x, 0.5]),
        along_x(mass),
        along_x(0.5 * mass),
        Node::at([0.0, 0.0]).held(Freedoms::PLANE),
        Node::at([2.0, 2.0]).held(Freedoms::PLANE),
        Node::at([0.0, 0.0]).held(Freedoms::X.union(Freedoms::Y)).with_body(0.0, 0.1 * mass, [0.0, 0.0]),
    ];
    let spring = |stiffness| Spring { stiffness };
    let at = |node| End::of(node).along([1.0, 0.0]);
    let members = [
        Frame::new(0, 1, SECTION),
        Frame::new(at(2), End::of(1).along([x, 1.0]), spring(k)),
        Frame::new(at(3), at(2), spring(2.0 * k)),
        Frame::new(at(4), at(3), spring(3.0 * k)),
        Frame::new(1, 5, spring(k)),
        Frame::new(6, 1, TorsionSpring { stiffness: k }),
    ];
    assert_equal(&frequencies(&sketch), &nodes, &members);
}

system! {
    /// A mass that stands at a contact, a motion with two contacts, and one that is held.
    struct Contacts { mass: f64, k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn b at (2.0, 0.0);
    conn a <- along (1.0, 1.0) <- mass 3 { mass } <- spring 4 { stiffness: k } <- fixed;
    conn u <- spring 5 { stiffness: k } <- fixed;
    conn a <- along (0.0, 1.0) <- conn u -> along (1.0, 3.0) -> conn b;
}

#[test]
fn masses_at_contacts_and_shared_motions_are_tied_rigidly() {
    let (mass, k) = (0.7, 3.0);
    let sketch = Contacts { mass, k }.build().unwrap();
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([1.0, 0.0]),
        Node::at([2.0, 0.0]),
        along_x(mass),
        along_x(0.0),
        Node::at([0.0, 0.0]).held(Freedoms::PLANE),
    ];
    let at = |node| End::of(node).along([1.0, 0.0]);
    let tie = || Joint::rigid(Freedoms::X);
    let spring = Spring { stiffness: k };
    let members = [
        Frame::new(0, 1, SECTION),
        Frame::new(1, 2, SECTION),
        Frame::new(at(3).at([1.0, 0.0]), End::of(1).along([1.0, 1.0]), tie()),
        Frame::new(at(5), at(3), spring),
        Frame::new(at(4).at([1.0, 0.0]), End::of(1).along([0.0, 1.0]), tie()),
        Frame::new(at(4).at([2.0, 0.0]), End::of(2).along([1.0, 3.0]), tie()),
        Frame::new(at(5), at(4), spring),
    ];
    assert_equal(&frequencies(&sketch), &nodes, &members);
}

system! {
    /// A body on two supports between beams, with masses at it, joints in series, and a skew support.
    pub(super) struct Bodies { pub(super) mass: f64, pub(super) k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> rigid_body hub { mass, inertia: 0.2, centre: (1.5, 0.25) } -> conn b at (2.0, 0.5)
        -> hinge 2 { stiffness_x: k, stiffness_y: 2.0 * k, stiffness_rz: 0.1 * k }
        -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn c at (3.0, 1.0)
        -> slider 4 { along: (1.0, 2.0) } -> pin 5 {}
        -> beam 6 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> roller at (4.0, 0.0) along (3.0, 1.0);
    rigid_body hub <- conn d at (1.5, -0.5) <- held(y);
    rigid_body hub <- conn e at (1.75, -0.25) <- roller along (1.0, 5.0);
    conn d <- point_mass 7 { mass: 0.4 };
    conn b <- point_mass 8 { mass: 0.3, inertia: 0.05 };
}

/// The common centre and the moment of inertia about it.
fn together(bodies: &[(f64, f64, [f64; 2])]) -> (f64, f64, [f64; 2]) {
    let mass: f64 = bodies.iter().map(|body| body.0).sum();
    let centre = [0, 1].map(|k| bodies.iter().map(|body| body.0 * body.2[k]).sum::<f64>() / mass);
    let square = |place: [f64; 2]| (place[0] - centre[0]).powi(2) + (place[1] - centre[1]).powi(2);
    (mass, bodies.iter().map(|body| body.1 + body.0 * square(body.2)).sum(), centre)
}

#[test]
fn bodies_joints_and_skew_supports_are_those_of_lists() {
    let (mass, k) = (2.5, 40.0);
    let sketch = Bodies { mass, k }.build().unwrap();
    let hub = together(&[(mass, 0.2, [1.5, 0.25]), (0.4, 0.0, [1.5, -0.5]), (0.3, 0.05, [2.0, 0.5])]);
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([1.5, -0.5]).held(Freedoms::Y).with_body(hub.0, hub.1, hub.2),
        Node::at([2.0, 0.5]),
        Node::at([3.0, 1.0]),
        Node::at([3.0, 1.0]),
        Node::at([3.0, 1.0]),
        Node::at([4.0, 0.0]).along([3.0, 1.0]),
        Node::at([1.75, -0.25]).held(Freedoms::PLANE),
    ];
    let hinge = PlanarHinge { stiffness_x: k, stiffness_y: 2.0 * k, stiffness_theta: 0.1 * k };
    let skew = [1.0, 5.0];
    let members = [
        Frame::new(0, End::of(1).at([1.0, 0.0]), SECTION),
        Frame::new(End::of(1).at([2.0, 0.5]), 2, Joint::from(hinge)),
        Frame::new(2, 3, SECTION),
        Frame::new(3, 4, Joint::rigid(ALONG_X)).along([1.0, 2.0]),
        Frame::new(4, 5, Joint::rigid(Freedoms::X.union(Freedoms::Y))),
        Frame::new(5, 6, SECTION),
        Frame::new(7, End::of(1).at([1.75, -0.25]), Joint::rigid(Freedoms::Y)).along(skew),
    ];
    assert_equal(&frequencies(&sketch), &nodes, &members);
}

system! {
    /// A frame on a damper in its plane.
    pub(super) struct DampedFrame { pub(super) c: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn b at (2.0, 1.0);
    fixed at (2.0, 0.0) -> damper 3 { damping: c } -> conn b;
}

#[test]
fn a_damped_frame_has_the_eigenvalues_of_its_list() {
    let sketch = DampedFrame { c: 0.8 }.build().unwrap();
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([1.0, 0.0]),
        Node::at([2.0, 1.0]),
        Node::at([2.0, 0.0]).held(Support::Fixed.holds()),
    ];
    type Damped = Member<AnyMember<f64>>;
    let members = [Damped::new(0, 1, SECTION), Damped::new(1, 2, SECTION), Damped::new(3, 2, Damper { damping: 0.8 })];
    let network = Network::new(&nodes, &members).unwrap();
    for (one, other) in eigenvalues(&sketch).iter().zip(eigenvalues(&network)) {
        assert!((one - other).norm() < 1e-12 * other.norm(), "{one} and {other}");
    }
}

#[test]
fn the_portal_of_the_example_is_that_of_its_list() {
    let portal = portal::steel();
    let section = Section { axial_stiffness: portal.ea, bending_stiffness: portal.ei, mass_per_length: portal.m };
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([0.0, 3.0]),
        Node::at([2.0, 3.0]).with_body(portal.machine, portal.inertia, [2.0, 3.4]),
        Node::at([4.0, 3.0]),
        Node::at([4.0, 0.0]).held(Support::Pinned.holds()),
    ];
    let members = [
        Frame::new(0, 1, section),
        Frame::new(1, 2, section),
        Frame::new(2, 3, section),
        Frame::new(4, End::of(3).releasing(Freedoms::RZ), section),
        Frame::new(1, 4, Spring { stiffness: portal.brace }),
    ];
    // a pin is a member of its own in the sketch: the order of elimination differs
    let network = Network::new(&nodes, &members).unwrap();
    assert_near(&frequencies(&portal.build().unwrap()), &frequencies(&network), 1e-13);
}
