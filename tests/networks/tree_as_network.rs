//! A tree, as the plane method takes it, as a network along the x axis whose nodes hold x.

use crate::structure::{End, Freedoms, Node, Section, Structure};
use crate::support::tree::{Part, Tree};
use mstmm::element::{Space, Support};
use mstmm::list::ListStep;

/// A node on the way: what its supports hold, and which freedoms its paths have.
#[derive(Clone, Copy)]
struct Place {
    node: usize,
    held: Freedoms,
    has: Freedoms,
}

/// A path that is open: its last place, and all of its nodes.
struct Path {
    place: Place,
    nodes: Vec<usize>,
}

struct Builder {
    structure: Structure,
    /// In units of the mass per length of each beam.
    axial_stiffness: f64,
    open: Vec<Path>,
}

/// The network of a tree, whose beams have so much axial stiffness over mass per length.
pub(crate) fn network_of(tree: &Tree, axial_stiffness: f64) -> Structure {
    let mut builder = Builder { structure: Structure::default(), axial_stiffness, open: Vec::new() };
    for (index, step) in tree.iter().enumerate() {
        match *step {
            ListStep::Tip(support) => builder.tip(support, &tree[index + 1..]),
            ListStep::Element(part) => builder.element(part),
            ListStep::Connection(inputs) => builder.connection(inputs),
            ListStep::Root(support) => builder.root(support),
        }
    }
    builder.structure
}

fn freedoms(space: Space) -> Freedoms {
    match (space.is(Space::Translation), space.is(Space::Rotation)) {
        (true, _) => Freedoms::Y,
        (_, true) => Freedoms::RZ,
        _ => Freedoms::Y.union(Freedoms::RZ),
    }
}

fn both(a: Freedoms, b: Freedoms) -> Freedoms {
    Freedoms { x: a.x && b.x, y: a.y && b.y, rz: a.rz && b.rz }
}

fn held_by(support: Support, has: Freedoms) -> Freedoms {
    let held = match support {
        Support::Fixed => Freedoms::ALL,
        Support::Pinned => Freedoms::PIN,
        Support::Guided => Freedoms::RZ,
        _ => Freedoms::NONE,
    };
    both(held, has)
}

impl Builder {
    /// What a node holds: x, its supports, and what its paths do not have.
    fn settle(&mut self, place: Place) {
        let Place { node, held, has } = place;
        let held = Freedoms { x: true, y: held.y || !has.y, rz: held.rz || !has.rz };
        self.structure.nodes[node].held = held;
    }

    /// A node at a place along the axis.
    fn place(&mut self, x: f64, has: Freedoms) -> Place {
        let node = self.structure.node(Node::at([x, 0.0]));
        let place = Place { node, held: Freedoms::NONE, has };
        self.settle(place);
        place
    }

    /// The space of a tip is that of the next element; before a connection, that of all, which a free tip does not change.
    fn tip(&mut self, support: Support, rest: &[ListStep<Part>]) {
        let has = match rest.first() {
            Some(ListStep::Element(part)) => freedoms(part.space()),
            _ if support == Support::Free => Freedoms::NONE,
            _ => Freedoms::Y.union(Freedoms::RZ),
        };
        let mut place = self.place(0.0, has);
        place.held = held_by(support, has);
        self.settle(place);
        self.open.push(Path { place, nodes: vec![place.node] });
    }

    fn element(&mut self, part: Part) {
        let Some(mut path) = self.open.pop() else { return };
        let from = path.place.node;
        let [x, _] = self.structure.nodes[from].position;
        let has = freedoms(part.space());
        // a connection of lines may lead on to a plane
        path.place.has = path.place.has.union(has);
        self.settle(path.place);
        let length = match part {
            Part::Beam(beam) => beam.length,
            Part::Body(body) => body.output_x,
            _ => 0.0,
        };
        let mut next = path.place;
        let is_empty = self.structure.nodes[from].mass == 0.0 && self.structure.nodes[from].inertia == 0.0;
        // behind a connection that narrows, what goes on is less than the node
        let adds = is_empty && path.place.has == has;
        match part {
            Part::Mass(mass) if adds => self.structure.nodes[from].mass = mass.mass,
            Part::Inertia(inertia) if adds => self.structure.nodes[from].inertia = inertia.inertia,
            _ => {
                next = self.place(x + length, has);
                path.nodes.push(next.node);
            }
        }
        let ([to, place], y) = ([next.node, from], [0.0, 1.0]);
        let structure = &mut self.structure;
        match part {
            Part::Beam(beam) => {
                let (bending_stiffness, mass_per_length) = (beam.bending_stiffness, beam.mass_per_length);
                let axial_stiffness = self.axial_stiffness * mass_per_length;
                structure.beam(place, to, Section { axial_stiffness, bending_stiffness, mass_per_length });
            }
            Part::Body(body) => {
                let about_centre = body.inertia - body.mass * body.centre_x * body.centre_x;
                let node = structure.nodes[to].body(body.mass, about_centre, [x + body.centre_x, 0.0]);
                structure.nodes[to] = node;
                structure.weld(place, End::from(to).at([x, 0.0]), has);
            }
            Part::ElasticHinge(hinge) => {
                structure.hinge(place, to, [1.0, 0.0], [1.0, hinge.stiffness_y, hinge.stiffness_theta]);
            }
            Part::Spring(spring) => structure.spring_along(place, to, y, spring.stiffness),
            Part::TorsionSpring(spring) => structure.torsion_spring(place, to, spring.stiffness),
            Part::PointMass(mass) => {
                (structure.nodes[to].mass, structure.nodes[to].inertia) = (mass.mass, mass.inertia);
                structure.weld(place, to, has);
            }
            Part::Mass(mass) if to != place => {
                structure.nodes[to].mass = mass.mass;
                structure.weld(place, to, has);
            }
            Part::Inertia(inertia) if to != place => {
                structure.nodes[to].inertia = inertia.inertia;
                structure.weld(place, to, has);
            }
            _ => {}
        }
        path.place = next;
        self.open.push(path);
    }

    /// Moves the paths to one place, and makes one node of their last ones.
    fn connection(&mut self, inputs: usize) {
        let mut paths = self.open.split_off(self.open.len() - inputs).into_iter();
        let Some(mut path) = paths.next() else { return };
        for other in paths {
            let [one, two] = [path.place.node, other.place.node];
            let shift = self.structure.nodes[one].position[0] - self.structure.nodes[two].position[0];
            for &node in &other.nodes {
                let node = &mut self.structure.nodes[node];
                (node.position[0], node.centre[0]) = (node.position[0] + shift, node.centre[0] + shift);
            }
            for end in self.structure.members.iter_mut().flat_map(|member| &mut member.ends) {
                if let (true, Some(position)) = (other.nodes.contains(&end.node), &mut end.position) {
                    position[0] += shift;
                }
            }
            path.nodes.extend(other.nodes);
            path.place = self.merged(path.place, other.place);
        }
        self.open.push(path);
    }

    fn merged(&mut self, one: Place, two: Place) -> Place {
        let place = |node: usize| Place { node, held: one.held.union(two.held), has: one.has.union(two.has) };
        let [first, second] = [one, two].map(|place| self.structure.nodes[place.node]);
        let is_empty = |node: &Node| node.mass == 0.0 && node.inertia == 0.0;
        let (kept, gone) = if is_empty(&second) { (one.node, two.node) } else { (two.node, one.node) };
        let merged = place(kept);
        self.settle(merged);
        if !is_empty(&first) && !is_empty(&second) {
            // each has a body of its own
            self.settle(Place { node: gone, ..merged });
            let free = Freedoms { x: false, y: !merged.held.y && merged.has.y, rz: !merged.held.rz && merged.has.rz };
            self.structure.weld(kept, gone, free);
            return merged;
        }
        for end in self.structure.members.iter_mut().flat_map(|member| &mut member.ends) {
            if end.node == gone {
                *end = End { node: kept, position: end.position.or(Some(first.position)), ..*end };
            }
        }
        merged
    }

    fn root(&mut self, support: Support) {
        let Some(path) = self.open.pop() else { return };
        let place = path.place;
        self.settle(Place { held: place.held.union(held_by(support, place.has)), ..place });
        self.drop_unused();
    }

    /// Takes out nodes that were merged with others.
    fn drop_unused(&mut self) {
        let is_used = |node: usize, structure: &Structure| {
            structure.members.iter().any(|member| member.ends.iter().any(|end| end.node == node))
        };
        for node in (0..self.structure.nodes.len()).rev() {
            if !is_used(node, &self.structure) {
                self.structure.nodes.remove(node);
                for end in self.structure.members.iter_mut().flat_map(|member| &mut member.ends) {
                    end.node -= usize::from(end.node > node);
                }
            }
        }
    }
}
