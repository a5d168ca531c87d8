//! Paths of one motion in a skeleton.

use super::assemble::Assembly;
use super::{Axis, Body, End, Member, Node, Plane, Seat, What};
use crate::keywords::Dimension;
use crate::network::{Classes, Direction, FreedomSet, PathContact, PathElement, TransferPath};
use mstmm_plan::Freedoms;

/// Motions of a path that are one: masses have the same at both ends.
struct Motion<'a> {
    contacts: Vec<&'a PathContact<'a>>,
    masses: Vec<&'a PathElement<'a>>,
    is_held: bool,
}

impl Motion<'_> {
    /// Whether elements that end here can act on the point at once.
    fn is_that_of_a_point(&self) -> bool {
        self.contacts.len() == 1 && self.masses.is_empty() && !self.is_held
    }
}

impl<'a> Assembly<'a> {
    /// The nodes of a path, where it needs some, its masses there, and its elements.
    pub(super) fn path(&mut self, path: &'a TransferPath<'a>) {
        let (masses, elements): (Vec<_>, Vec<_>) = path.elements.iter().partition(|element| is_mass(element));
        let mut classes = Classes::new(path.nodes.len());
        masses.iter().for_each(|mass| classes.join(mass.ends[0], mass.ends[1]));
        let mut ends = vec![None; path.nodes.len()];
        for first in (0..path.nodes.len()).filter(|&node| classes.of(node) == node) {
            let motion = Motion {
                contacts: path.contacts.iter().filter(|contact| classes.of(contact.node) == first).collect(),
                masses: masses.iter().filter(|mass| classes.of(mass.ends[0]) == first).copied().collect(),
                is_held: (0..path.nodes.len()).any(|node| classes.of(node) == first && path.nodes[node].is_held),
            };
            let end = if motion.is_that_of_a_point() {
                self.contact(path, motion.contacts[0])
            } else {
                self.motion(path, first, &motion)
            };
            ends[first] = Some(end);
        }
        for element in elements {
            let both = element.ends.map(|node| ends[classes.of(node)]);
            let [Some(from), Some(to)] = both else { continue };
            self.element(element.element, FreedomSet::along(path.motion), self.plane(), along_itself([from, to]));
        }
    }

    /// A node of the path's own, with its masses, tied to the points whose motion it is.
    fn motion(&mut self, path: &'a TransferPath<'a>, first: usize, motion: &Motion<'a>) -> End {
        let node = self.skeleton.nodes.len();
        let own = path.nodes[first].connections.first().map(ToString::to_string);
        let of_mass = || motion.masses.first().map(|mass| mass.element.to_string());
        let name = own.or_else(of_mass).unwrap_or_else(|| {
            let ends_here = |element: &&PathElement<'_>| element.ends.contains(&first);
            let element = path.elements.iter().find(ends_here).map(|element| element.element.to_string());
            format!("the end of {}", element.unwrap_or_default())
        });
        let all = self.all();
        let held = if motion.is_held { all } else { Freedoms::NONE };
        let freedoms = FreedomSet::along(path.motion);
        self.skeleton.nodes.push(Node { name, place: None, freedoms: freedoms.clone(), held, skew: None, all });
        let body = |mass: &&'a PathElement<'a>| Body { element: mass.element, node, centre: Vec::new() };
        self.skeleton.bodies.extend(motion.masses.iter().map(body));
        let end = End { seat: Seat::Node(node), axis: Axis::X };
        for contact in &motion.contacts {
            let ends = [end, self.contact(path, contact)];
            let name = self.skeleton.nodes[node].name.clone();
            let (kind, freedoms, plane) = (Some("tie".to_owned()), freedoms.clone(), self.plane());
            let what = What::Rigid;
            self.skeleton.members.push(Member { what, name, kind, freedoms, plane, is_further: false, ends });
        }
        end
    }

    /// The plane of what has one motion.
    fn plane(&self) -> Plane {
        if self.skeleton.dimension == Dimension::Space { Plane::OneMotion } else { Plane::Structure }
    }

    /// The end of an element, or of a joint, at a point on which the path acts.
    fn contact(&mut self, path: &'a TransferPath<'a>, contact: &'a PathContact<'a>) -> End {
        let axis = match contact.direction {
            Direction::Y => Axis::Y,
            Direction::Z => Axis::X,
            Direction::FromTo(points) => Axis::FromTo(points.map(|point| self.network.points[point].place)),
            Direction::Along(along) => {
                let at = |element: &&PathElement<'_>| element.ends.contains(&contact.node);
                let element = path.elements.iter().find(at).or(path.elements.first());
                let name = element.map(|element| element.element.to_string()).unwrap_or_default();
                Axis::Along(self.direction(name, &along.keyword.to_string(), &along.parts))
            }
        };
        End { seat: Seat::Point(contact.point), axis }
    }
}

/// Whether an element of a path is a mass or an inertia.
fn is_mass(element: &PathElement<'_>) -> bool {
    let row = element.element.located();
    row.is_some_and(|row| row.name == "mass" || row.name == "inertia")
}

/// An element between the two points along whose line it acts needs no direction but its own.
fn along_itself(ends: [End; 2]) -> [End; 2] {
    match ends.map(|end| end.axis) {
        [Axis::FromTo(_), Axis::FromTo(_)] => ends.map(|end| End { axis: Axis::Member, ..end }),
        _ => ends,
    }
}
