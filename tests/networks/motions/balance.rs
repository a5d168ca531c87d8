//! Shapes fit together: forces balance at every node, ends move as their nodes do, and shapes are orthogonal.
#![expect(clippy::unwrap_used, reason = "the structure has the nodes and members that are asked for")]

use crate::families::line::line_structures;
use crate::families::random::Spread;
use crate::families::{Named, named_structures, random_structures};
use crate::large::around;
use crate::structure::{Element, Structure};
use crate::through_library::{Undamped, asked};
use mstmm::motion::{MotionError, MovingNetwork, PlaneFrequency, PlaneShape, PlaneStates};
use mstmm::prelude::*;
use mstmm::search::System;

/// Part of the largest force or displacement by which nothing may differ.
const PART: f64 = 1e-11;

type Shape<'a> = PlaneShape<'a, Undamped, f64>;

/// What was seen of a number of shapes.
#[derive(Debug, Default)]
struct Tally {
    structures: usize,
    shapes: usize,
    products: usize,
    unresolved: usize,
    /// The worst sum of forces, the worst difference of displacements and the worst product.
    worst: [f64; 3],
    wrong: Vec<String>,
}

impl Tally {
    fn note(&mut self, kind: usize, error: f64, limit: f64, what: impl FnOnce() -> String) {
        self.worst[kind] = self.worst[kind].max(error);
        if error > limit || error.is_nan() {
            self.wrong.push(what());
        }
    }

    fn show(self, name: &str) {
        let Tally { structures, shapes, products, unresolved, worst: [force, displacement, product], wrong } = self;
        println!(
            "{name}: {structures} structures, {shapes} shapes, {unresolved} unresolved; sums of forces {force:.1e}, \
             differences of displacements {displacement:.1e}, {products} products {product:.1e}"
        );
        assert!(wrong.is_empty(), "{name}: {wrong:#?}");
        assert!(shapes > 100 * unresolved, "{name}: too many shapes cannot be told apart");
    }
}

/// The largest of a member's forces, with a moment by its length, or of the inertia of a member or a body.
pub(super) fn largest_force<Y, S>(structure: &Structure, states: &PlaneStates<'_, Y, S>, omega: f64) -> f64
where
    Y: MovingNetwork<S> + System<Parameter = f64>,
    S: PlaneFrequency<f64>,
{
    let far = |node: usize| states.node(node).unwrap().into_iter().map(S::modulus).fold(0.0, f64::max);
    let of_members = structure.members.iter().enumerate().map(|(index, member)| {
        let forces =
            states.member(index).unwrap().iter().flat_map(|end| end.forces).map(S::modulus).fold(0.0, f64::max);
        let [[x, y], [to_x, to_y]] = member.ends.map(|end| structure.position(&end));
        let inertia = match &member.element {
            Element::Beam(section) => section.mass_per_length * (to_x - x).hypot(to_y - y) * omega * omega,
            _ => 0.0,
        };
        let [from, to] = member.ends.map(|end| far(end.node));
        forces.max(inertia * from.max(to).max(1.0 / mass(structure).sqrt()))
    });
    let bodies = structure.nodes.iter().enumerate();
    let of_bodies = bodies.map(|(index, node)| {
        let arm = (node.centre[0] - node.position[0]).hypot(node.centre[1] - node.position[1]).max(1.0);
        node.mass.max(node.inertia) * arm * arm * omega * omega * far(index)
    });
    of_members.chain(of_bodies).fold(0.0, f64::max)
}

/// The largest sum of forces on a motion of a node.
pub(super) fn largest_sum<Y, S>(structure: &Structure, states: &PlaneStates<'_, Y, S>) -> f64
where
    Y: MovingNetwork<S> + System<Parameter = f64>,
    S: PlaneFrequency<f64>,
{
    let of_node = |(index, node): (usize, &crate::structure::Node)| {
        let [x, y, moment] = states.reaction(index).unwrap();
        let turn = if node.held.rz { 0.0 } else { moment.modulus() };
        let forces = match node.along {
            Some([c, s]) => (x * c + y * s).modulus() / c.hypot(s),
            None => f64::max(if node.held.x { 0.0 } else { x.modulus() }, if node.held.y { 0.0 } else { y.modulus() }),
        };
        turn.max(forces)
    };
    structure.nodes.iter().enumerate().map(of_node).fold(0.0, f64::max)
}

/// The mass of members and bodies.
fn mass(structure: &Structure) -> f64 {
    let of_members = structure.members.iter().map(|member| match &member.element {
        Element::Beam(section) => {
            let [[x, y], [to_x, to_y]] = member.ends.map(|end| structure.position(&end));
            section.mass_per_length * (to_x - x).hypot(to_y - y)
        }
        _ => 0.0,
    });
    of_members.chain(structure.nodes.iter().map(|node| node.mass + node.inertia)).sum()
}

/// The largest difference of the displacements of the end of a beam from those of its node, of the largest displacement.
pub(super) fn largest_gap<Y, S>(structure: &Structure, states: &PlaneStates<'_, Y, S>) -> f64
where
    Y: MovingNetwork<S> + System<Parameter = f64>,
    S: PlaneFrequency<f64>,
{
    // a shape of unit modal mass moves that far somewhere, if not at a node
    let (mut worst, mut largest) = (0.0_f64, 1.0 / mass(structure).sqrt());
    for (index, member) in structure.members.iter().enumerate() {
        if !matches!(member.element, Element::Beam(_)) {
            continue;
        }
        let [[x, y], [to_x, to_y]] = member.ends.map(|end| structure.position(&end));
        let length = (to_x - x).hypot(to_y - y);
        let [c, s] = [(to_x - x) / length, (to_y - y) / length];
        for (end, motion) in member.ends.iter().zip(states.member(index).unwrap()) {
            let [u, v, rotation] = states.node(end.node).unwrap();
            let ([x, y], [own_x, own_y]) = (structure.position(end), structure.nodes[end.node].position);
            let [u, v] = [u - rotation * (y - own_y), v + rotation * (x - own_x)];
            let tied = [u * c + v * s, v * c - u * s, rotation];
            let released = [end.released.x, end.released.y, end.released.rz];
            for k in 0..3 {
                largest = largest.max(tied[k].modulus()).max(motion.displacements[k].modulus());
                if !released[k] {
                    worst = worst.max((motion.displacements[k] - tied[k]).modulus());
                }
            }
        }
    }
    if worst > 0.0 { worst / largest } else { 0.0 }
}

fn look_at(name: &str, structure: &Structure, root: &NaturalFrequency<f64>, shape: &Shape<'_>, tally: &mut Tally) {
    tally.shapes += 1;
    tally.note(1, largest_gap(structure, shape), PART, || format!("{name}: gap at {root:?}"));
    // a rigid-body motion at rest has no forces but rounding
    if root.omega > 0.0 {
        let sum = largest_sum(structure, shape);
        let part = if sum > 0.0 { sum / largest_force(structure, shape, root.omega) } else { 0.0 };
        tally.note(0, part, PART, || format!("{name}: forces at {root:?}: {part:e}"));
    }
    let mass = (shape.modal_mass() - 1.0).abs();
    tally.note(2, mass, PART, || format!("{name}: modal mass at {root:?}: {mass:e}"));
}

/// Looks at all shapes of some roots.
fn look(
    name: &str,
    structure: &Structure,
    tally: &mut Tally,
    ask: impl FnOnce(&Undamped) -> Result<Vec<NaturalFrequency<f64>>, String> + Send,
) {
    if structure.nodes.len() > 60 || structure.members.len() > 80 {
        return;
    }
    let seen = asked(structure, |network| {
        let mut tally = Tally { structures: 1, ..Tally::default() };
        let mut shapes: Vec<Shape<'_>> = Vec::new();
        for root in ask(network)? {
            match network.mode_shapes::<8, _>(&root) {
                Ok(found) => {
                    found.iter().for_each(|shape| look_at(name, structure, &root, shape, &mut tally));
                    shapes.extend(found.iter().cloned());
                }
                Err(MotionError::Capacity { .. }) => {}
                Err(MotionError::Unresolved { .. }) => tally.unresolved += 1,
                Err(error) => tally.wrong.push(format!("{name}: {root:?}: {error}")),
            }
        }
        for (k, one) in shapes.iter().take(10).enumerate() {
            for other in &shapes[..k] {
                let product = one.product(other).abs();
                tally.products += 1;
                tally.note(2, product, 1e-10, || format!("{name}: product {product:e}"));
            }
        }
        Ok(tally)
    });
    match seen {
        Ok(seen) => {
            tally.structures += seen.structures;
            tally.shapes += seen.shapes;
            tally.products += seen.products;
            tally.unresolved += seen.unresolved;
            tally.wrong.extend(seen.wrong);
            for (worst, seen) in tally.worst.iter_mut().zip(seen.worst) {
                *worst = worst.max(seen);
            }
        }
        Err(error) => tally.wrong.push(format!("{name}: {error}")),
    }
}

fn first(network: &Undamped) -> Result<Vec<NaturalFrequency<f64>>, String> {
    network.first_frequencies::<10>().map(|found| found.to_vec()).map_err(|error| error.to_string())
}

fn judge(what: &str, structures: impl Iterator<Item = Named>) {
    let mut tally = Tally::default();
    for (name, structure) in structures {
        look(&name, &structure, &mut tally, first);
    }
    tally.show(what);
}

#[test]
fn shapes_of_hard_structures_fit_together() {
    judge("named", named_structures().into_iter());
}

#[test]
fn shapes_of_random_structures_fit_together() {
    judge("moderate", random_structures(0..30, Spread::Moderate));
    judge("stiff", random_structures(0..30, Spread::Stiff));
    // a spring is 1e26 times as stiff as the inertia of the first ten modes, in a skew direction
    judge("a stiff spring", random_structures(141..142, Spread::Stiff));
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn shapes_of_hundreds_of_random_structures_fit_together() {
    judge("moderate", random_structures(0..300, Spread::Moderate));
    judge("stiff", random_structures(0..300, Spread::Stiff));
    judge("in a line", line_structures(0..100));
}

#[test]
#[ignore = "many modes: in .ci/long"]
fn shapes_of_modes_up_to_300_fit_together() {
    let mut tally = Tally::default();
    for (name, structure) in random_structures(0..12, Spread::Moderate) {
        let Ok(([_, bound], _)) = around(&structure, 290) else { continue };
        look(&name, &structure, &mut tally, |network| {
            let found = network.natural_frequencies::<400>(0.0..=bound).map_err(|error| error.to_string())?;
            Ok(found.iter().copied().collect())
        });
    }
    tally.show("modes 1 to 300");
}
