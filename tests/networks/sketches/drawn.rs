//! What `sketch()` says of built systems: names, coordinates that are exact, what moves together.

use super::frames::{InclinedRoller, ThreePorts};
use crate::portal;
use mstmm::elements::Spring;
use mstmm::motion::{Drawn, DrawnEnd, Skew};
use mstmm::network::{End, Freedoms, Member, Network, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;

/// The freedoms of the plane without the rotation.
const XY: Freedoms = Freedoms::X.union(Freedoms::Y);

/// Name and coordinates of the points.
fn points<Y: Drawn<Parameter = f64>>(system: &Y) -> Vec<(String, [f64; 3])> {
    system.sketch().points().map(|point| (point.name.to_string(), point.position)).collect()
}

/// Name, kind, and the points of both ends of the members.
fn members<Y: Drawn<Parameter = f64>>(system: &Y) -> Vec<(String, &'static str, [Option<usize>; 2])> {
    let ends = |ends: [DrawnEnd<Y::Model, f64>; 2]| ends.map(|end| end.point);
    system.sketch().members().map(|member| (member.name.to_string(), member.kind, ends(member.ends))).collect()
}

/// Name, point, held freedoms and skew of the supports.
fn supports<Y: Drawn<Parameter = f64>>(system: &Y) -> Vec<(String, usize, Freedoms, Option<Skew<f64>>)> {
    let support = |support: mstmm::motion::DrawnSupport<f64>| {
        let of_point = system.sketch().points().nth(support.point).map(|point| point.position);
        assert_eq!(of_point, Some(support.position));
        (support.name.to_string(), support.point, support.held, support.skew)
    };
    system.sketch().supports().map(support).collect()
}

/// Both ends of a member by its name.
fn ends<Y: Drawn<Parameter = f64>>(system: &Y, name: &str) -> [DrawnEnd<Y::Model, f64>; 2] {
    system.sketch().members().find(|member| member.name.to_string() == name).unwrap().ends
}

fn named<T>(list: Vec<(&str, T)>) -> Vec<(String, T)> {
    list.into_iter().map(|(name, rest)| (name.to_owned(), rest)).collect()
}

#[test]
fn the_portal_is_as_it_is_written() {
    let portal = portal::steel().build().unwrap();
    let expected = vec![
        ("fixed at beam 1", [0.0, 0.0, 0.0]),
        ("conn b", [0.0, 3.0, 0.0]),
        ("conn girder", [2.0, 3.0, 0.0]),
        ("conn c", [4.0, 3.0, 0.0]),
        ("conn foot", [4.0, 0.0, 0.0]),
        ("the point at beam 5", [4.0, 3.0, 0.0]),
    ];
    assert_eq!(points(&portal), named(expected));
    let expected = [
        ("beam 1", "Beam", [0, 1]),
        ("beam 2", "Beam", [1, 2]),
        ("beam 3", "Beam", [2, 3]),
        ("beam 5", "Beam", [5, 4]),
        ("pin 4", "pin", [3, 5]),
        ("spring 7", "Spring", [1, 4]),
    ];
    let expected = expected.map(|(name, kind, ends)| (name.to_owned(), kind, ends.map(Some)));
    assert_eq!(members(&portal), expected);
    assert!(portal.sketch().members().all(|member| {
        let [from, to] = member.ends;
        let at_points = [from, to].map(|end| points(&portal)[end.point.unwrap()].1 == end.position.unwrap());
        at_points == [true; 2] && (member.kind == "pin" || from.along.is_none() && to.along.is_none())
    }));
    let expected = [("fixed at beam 1", 0, Freedoms::PLANE, None), ("pinned at conn foot", 4, XY, None)];
    assert_eq!(supports(&portal), expected.map(|(name, point, held, along)| (name.to_owned(), point, held, along)));
    let bodies: Vec<_> = portal.sketch().bodies().collect();
    assert_eq!(bodies.len(), 1);
    assert_eq!(bodies[0].name.to_string(), "rigid_body 6");
    assert_eq!((bodies[0].mass, bodies[0].inertia, bodies[0].centre), (500.0, 40.0, Some([2.0, 3.4, 0.0])));
    let tied: Vec<String> = portal.sketch().points_of(bodies[0].node).map(|point| point.name.to_string()).collect();
    assert_eq!(tied, ["conn girder"]);
}

#[test]
fn a_body_ties_its_ports() {
    let system = ThreePorts { ea: 1e6, ei: 150.0, m: 1.2, stiffness: 900.0 }.build().unwrap();
    let body = system.sketch().bodies().next().unwrap();
    assert_eq!((body.mass, body.inertia, body.centre), (4.0, 0.2, Some([1.2, 0.05, 0.0])));
    let ports: Vec<_> =
        system.sketch().points_of(body.node).map(|port| (port.name.to_string(), port.position)).collect();
    assert_eq!(
        ports,
        named(vec![("conn a", [1.0, 0.0, 0.0]), ("conn b", [1.4, 0.3, 0.0]), ("conn c", [1.2, -0.2, 0.0])])
    );
    let [from, to] = ends(&system, "spring 4");
    // the input of the spring is at the ground, which has no place
    assert_eq!((from.point, from.position, from.along, from.rests), (None, None, None, true));
    assert_eq!(
        (to.position, to.along, to.rests, to.node),
        (Some([1.2, -0.2, 0.0]), Some([0.0, 1.0, 0.0]), false, body.node)
    );
}

#[test]
fn a_skew_roller_has_its_direction() {
    let system = InclinedRoller { length: 2.0, ea: 3e6, ei: 500.0, m: 2.0 }.build().unwrap();
    let roller = system.sketch().supports().nth(1).unwrap();
    assert_eq!((roller.name.to_string().as_str(), roller.position), ("roller at beam 1", [2.0, 0.0, 0.0]));
    assert_eq!((roller.held, roller.skew), (Freedoms::NONE, Some(Skew::Along([12.0, 5.0, 0.0]))));
}

system! {
    /// A body on two supports, the second one skew, with a mass of a path that hangs on it and a spring between two places.
    struct Cart { x: f64, mass: f64 }

    pinned at (0.0, 0.0) -> rigid_body 1 { mass: 3.0, inertia: 0.5, centre: (0.5 * x, 1.0) } -> conn b at (x, 0.0)
        <- guided along (1.0, 2.0);
    conn b <- along (3.0, -4.0) <- mass 2 { mass } <- spring 3 { stiffness: 2.0 } <- fixed;
    rigid_body 1 <- conn top at (x, 2.0) -> spring 4 { stiffness: 5.0 } -> conn anchor at (3.0 * x, 2.5) <- fixed;
    conn top -> point_mass 5 { mass: 0.25 };
    conn top <- torsion_spring 6 { stiffness: 1.0 } <- fixed;
}

#[test]
fn paths_have_directions_and_a_second_support_is_no_member() {
    let system = Cart { x: 4.0, mass: 0.75 }.build().unwrap();
    let expected = [
        ("pinned at rigid_body 1", [0.0, 0.0, 0.0], XY, None),
        ("guided at conn b", [4.0, 0.0, 0.0], Freedoms::RZ, Some(Skew::Along([1.0, 2.0, 0.0]))),
        ("fixed at conn anchor", [12.0, 2.5, 0.0], XY, None),
    ];
    let found = system.sketch().supports().map(|support| (support.name, support.position, support.held, support.skew));
    assert_eq!(
        found.map(|(name, position, held, along)| (name.to_string(), position, held, along)).collect::<Vec<_>>(),
        expected.map(|(name, position, held, along)| (name.to_owned(), position, held, along))
    );
    let kinds: Vec<_> = members(&system).into_iter().map(|(name, kind, _)| (name, kind)).collect();
    let expected =
        vec![("mass 2", "tie"), ("spring 3", "Spring"), ("spring 4", "Spring"), ("torsion_spring 6", "TorsionSpring")];
    assert_eq!(kinds, named(expected));
    let [motion, contact] = ends(&system, "mass 2");
    assert_eq!(
        (motion.position, contact.position, contact.along),
        (None, Some([4.0, 0.0, 0.0]), Some([3.0, -4.0, 0.0]))
    );
    let [from, to] = ends(&system, "spring 4");
    assert_eq!(
        [from.position, to.position, from.along, to.along],
        [Some([4.0, 2.0, 0.0]), Some([12.0, 2.5, 0.0]), None, None]
    );
    let [ground, turned] = ends(&system, "torsion_spring 6");
    assert_eq!((ground.point, ground.rests, turned.position, turned.along), (None, true, Some([4.0, 2.0, 0.0]), None));
    let bodies = system.sketch().bodies().map(|body| (body.name.to_string(), (body.mass, body.inertia, body.centre)));
    let expected = vec![
        ("rigid_body 1", (3.0, 0.5, Some([2.0, 1.0, 0.0]))),
        ("point_mass 5", (0.25, 0.0, Some([4.0, 2.0, 0.0]))),
        ("mass 2", (0.75, 0.0, None)),
    ];
    assert_eq!(bodies.collect::<Vec<_>>(), named(expected));
}

system! {
    /// A beam in a line, with no field at all.
    struct Line {}

    fixed at 1.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 3.0 } -> conn tip at 2.5;
    conn tip <- spring 2 { stiffness: 4.0 } <- fixed;
}

#[test]
fn a_line_lies_on_the_axis() {
    let line = Line {}.build().unwrap();
    assert_eq!(points(&line), named(vec![("fixed at beam 1", [1.0, 0.0, 0.0]), ("conn tip", [2.5, 0.0, 0.0])]));
    let bends = Freedoms::Y.union(Freedoms::RZ);
    assert_eq!(supports(&line), [("fixed at beam 1".to_owned(), 0, bends, None)]);
    assert_eq!(ends(&line, "spring 2").map(|end| end.along), [None, Some([0.0, 1.0, 0.0])]);
}

#[test]
fn a_list_has_indices_for_names() {
    let section = Section { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 };
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([2.0, 0.0]).with_body(2.0, 0.5, [2.25, 0.125]),
        Node::at([4.0, 1.0]).held(Freedoms::RZ).along([1.0, 1.0]),
    ];
    type Frame = Member<UndampedMember<f64>>;
    let members_of = [
        Frame::new(0, 1, section),
        Frame::new(End::of(1).at([2.5, 0.5]), End::of(2).releasing(Freedoms::RZ), section),
        Frame::new(1, 0, Spring { stiffness: 3.0 }).along([0.0, 2.0]),
    ];
    let system = Network::new(&nodes, &members_of).unwrap();
    let expected = vec![("node 0", [0.0, 0.0, 0.0]), ("node 1", [2.0, 0.0, 0.0]), ("node 2", [4.0, 1.0, 0.0])];
    assert_eq!(points(&system), named(expected));
    let expected = [("member 0", "beam", [0, 1]), ("member 1", "beam", [1, 2]), ("member 2", "Spring", [1, 0])];
    assert_eq!(members(&system), expected.map(|(name, kind, ends)| (name.to_owned(), kind, ends.map(Some))));
    let [from, to] = ends(&system, "member 1");
    assert_eq!((from.position, to.position), (Some([2.5, 0.5, 0.0]), Some([4.0, 1.0, 0.0])));
    assert_eq!((from.released, to.released), (Freedoms::NONE, Freedoms::RZ));
    assert_eq!(
        ends(&system, "member 2").map(|end| (end.along, end.rests)),
        [false, true].map(|rests| (Some([0.0, 2.0, 0.0]), rests))
    );
    let expected =
        [("node 0", 0, Freedoms::PLANE, None), ("node 2", 2, Freedoms::RZ, Some(Skew::Along([1.0, 1.0, 0.0])))];
    assert_eq!(supports(&system), expected.map(|(name, point, held, along)| (name.to_owned(), point, held, along)));
    let bodies = system.sketch().bodies().map(|body| (body.name.to_string(), (body.mass, body.inertia, body.centre)));
    assert_eq!(bodies.collect::<Vec<_>>(), named(vec![("node 1", (2.0, 0.5, Some([2.25, 0.125, 0.0])))]));
}

/// Oracle: a body turns about any of its points, `u = u₀ - θ (y - y₀)`, and the ends of beams move with their points.
#[test]
fn points_and_ends_move_as_shapes_say() {
    let system = ThreePorts { ea: 1e6, ei: 150.0, m: 1.2, stiffness: 900.0 }.build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let moved = |x, y| [shape.value(x).unwrap(), shape.value(y).unwrap()];
    let of_points: Vec<_> = system
        .sketch()
        .points()
        .map(|point| moved(point.label.displacement_x(), point.label.displacement_y()))
        .collect();
    let size = of_points.iter().flatten().fold(0.0_f64, |most, part| most.max(part.abs()));
    for member in system.sketch().members() {
        for end in member.ends {
            let Some(point) = end.point else { continue };
            let own = moved(end.label.displacement_x(), end.label.displacement_y());
            assert!((0..2).all(|k| (own[k] - of_points[point][k]).abs() <= 1e-14 * size), "{member:?}");
        }
    }
    let body = system.sketch().bodies().next().unwrap();
    let ports: Vec<_> = system.sketch().points_of(body.node).collect();
    let turn = shape.value(ports[0].label.rotation_z()).unwrap();
    let first = moved(ports[0].label.displacement_x(), ports[0].label.displacement_y());
    for port in &ports {
        let [x, y] = [0, 1].map(|k| port.position[k] - ports[0].position[k]);
        let expected = [first[0] - turn * y, first[1] + turn * x];
        let own = moved(port.label.displacement_x(), port.label.displacement_y());
        assert!((0..2).all(|k| (own[k] - expected[k]).abs() <= 1e-14 * size), "{port:?}");
    }
}
