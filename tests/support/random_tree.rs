//! Random trees from a seed: every kind of element, support, branch, narrowing and widening.

pub(crate) use super::random::Random;
use super::tree::{Part, Tree};
use mstmm::element::{Space, Support};
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Lever, Mass, PointMass, RotationalHinge, ShearHinge, Spring,
    SpringDamper, TorsionDamper, TorsionSpring, TorsionSpringDamper,
};
use mstmm::list::ListStep;

/// Makes one tree.
#[derive(Debug)]
struct Generator {
    random: Random,
    /// Beams that may still be used.
    beams: usize,
    /// Beams of which many in the tree are copies.
    common: [Beam<f64>; 2],
    damped: bool,
}

/// A random tree of up to `beams` beams; it may be one without a spectrum.
pub(crate) fn random_tree(seed: u64, beams: usize, damped: bool) -> Tree {
    let mut random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    let common = [beam(&mut random), beam(&mut random)];
    let beams = 1 + random.below(beams);
    let mut generator = Generator { random, beams, common, damped };
    let kind = generator.random.pick([
        Space::Bending,
        Space::Bending,
        Space::Bending,
        Space::Bending,
        Space::Translation,
        Space::Rotation,
    ]);
    let mut tree = generator.path(kind, 3);
    if kind.is(Space::Bending) && generator.random.chance(0.3) {
        // the root holds a connection
        tree.extend(generator.path(kind, 1));
        tree.push(ListStep::Connection(2));
    }
    let root = generator.support(kind);
    tree.push(ListStep::Root(root));
    tree
}

/// A random tree, damped if its seed is even, whose bodies reach in both directions and whose parameters have 24 bits.
pub(crate) fn varied_tree(seed: u64) -> Tree {
    let mut tree = random_tree(seed, 3, seed.is_multiple_of(2));
    let mut random = Random(seed);
    for step in &mut tree {
        let ListStep::Element(part) = step else { continue };
        if let Part::Body(body) = part {
            for place in [&mut body.output_x, &mut body.centre_x] {
                *place *= if random.unit() < 0.5 { -1.0 } else { 1.0 };
            }
        }
        for parameter in part.parameters() {
            *parameter = f64::from(*parameter as f32);
        }
    }
    tree
}

/// A tree with hinges of one freedom and levers in its bending paths; some of the hinges have no stiffness.
pub(crate) fn jointed(tree: &Tree, seed: u64) -> Tree {
    let random = &mut Random(seed ^ 0x4a4f);
    let mut all = Tree::new();
    for &step in tree {
        all.push(step);
        if matches!(step, ListStep::Element(part) if part.space().is(Space::Bending)) && random.chance(0.6) {
            all.push(ListStep::Element(joint(random)));
        }
    }
    all
}

fn joint(random: &mut Random) -> Part {
    let (value, is_perfect) = (f64::from(random.value() as f32), random.chance(0.3));
    let stiffness = if is_perfect { 0.0 } else { value };
    match random.below(3) {
        0 => Part::RotationalHinge(RotationalHinge { stiffness }),
        1 => Part::ShearHinge(ShearHinge { stiffness }),
        _ => Part::Lever(Lever { output_x: random.pick([-0.5, 0.5]) * value }),
    }
}

fn beam(random: &mut Random) -> Beam<f64> {
    Beam { length: random.value(), bending_stiffness: random.value(), mass_per_length: random.value() }
}

impl Generator {
    fn support(&mut self, space: Space) -> Support {
        match space {
            Space::Bending => self.random.pick([Support::Fixed, Support::Pinned, Support::Free, Support::Guided]),
            _ => self.random.pick([Support::Fixed, Support::Free]),
        }
    }

    /// A path that ends in an element of a space.
    fn path(&mut self, space: Space, depth: usize) -> Tree {
        let mut tree =
            if depth == 0 || self.random.chance(0.4) { self.start(space) } else { self.junction(space, depth) };
        for _ in 0..1 + self.random.below(2) {
            tree.push(ListStep::Element(self.part(space)));
        }
        tree
    }

    /// A support, with a spring if it holds a line: a mass there would not move.
    fn start(&mut self, space: Space) -> Tree {
        let support = self.support(space);
        let mut tree = vec![ListStep::Tip(support)];
        match (support, space) {
            (Support::Fixed, Space::Translation) => tree.push(ListStep::Element(self.translational_spring())),
            (Support::Fixed, Space::Rotation) => tree.push(ListStep::Element(self.torsional_spring())),
            _ => {}
        }
        tree
    }

    /// A connection that goes on in a space.
    fn junction(&mut self, output: Space, depth: usize) -> Tree {
        let mixed = output.is(Space::Bending) || self.random.chance(0.6);
        let (mut tree, mut inputs, mut space) = (Vec::new(), 0, None);
        let mut wide = false;
        for _ in 0..1 + self.random.below(3) {
            let input = match mixed {
                true => self.random.pick([Space::Bending, Space::Bending, Space::Translation, Space::Rotation]),
                false => output,
            };
            inputs += self.arms(&mut tree, input, depth - 1);
            wide |= input.is(Space::Bending);
            space = space.map_or(Some(input), |space: Space| space.join(input));
        }
        let space = space.and_then(|space| space.join(output));
        let bending = space.is_some_and(|space| space.is(Space::Bending));
        // one input alone narrows; a connection of lines that has a plane takes it from a support
        let narrows = bending && !output.is(Space::Bending);
        if inputs == 1 && !narrows || bending && !wide || self.random.chance(0.25) {
            let free = self.random.chance(0.4);
            let support = self.support(if bending { Space::Bending } else { output });
            tree.push(ListStep::Tip(if free { Support::Free } else { support }));
            inputs += 1;
        }
        tree.push(ListStep::Connection(inputs));
        tree
    }

    /// A path into a connection, or several equal ones: they have roots of higher multiplicity.
    fn arms(&mut self, tree: &mut Tree, space: Space, depth: usize) -> usize {
        let path = self.path(space, depth);
        let copies = if self.random.chance(0.15) { 2 + self.random.below(2) } else { 1 };
        (0..copies).for_each(|_| tree.extend_from_slice(&path));
        copies
    }

    fn part(&mut self, space: Space) -> Part {
        let kind = self.random.unit();
        match space {
            Space::Bending if kind < 0.7 && self.beams > 0 => {
                self.beams -= 1;
                let own = beam(&mut self.random);
                Part::Beam(if self.random.chance(0.5) { self.random.pick(self.common) } else { own })
            }
            Space::Bending if kind < 0.8 => self.body(),
            Space::Bending if kind < 0.9 => {
                Part::PointMass(PointMass { mass: self.random.value(), inertia: 0.1 * self.random.value() })
            }
            Space::Bending => Part::ElasticHinge(ElasticHinge {
                stiffness_y: 10.0 * self.random.value(),
                stiffness_theta: self.random.value(),
            }),
            Space::Translation if kind < 0.5 => self.translational_spring(),
            Space::Translation => Part::Mass(Mass { mass: self.random.value() }),
            _ if kind < 0.5 => self.torsional_spring(),
            _ => Part::Inertia(Inertia { inertia: self.random.value() }),
        }
    }

    fn body(&mut self) -> Part {
        let (mass, centre_x) = (self.random.value(), 0.25 * self.random.value());
        let inertia = mass * centre_x * centre_x + 0.1 * self.random.value();
        Part::Body(Body { mass, inertia, output_x: 0.5 * self.random.value(), centre_x })
    }

    fn translational_spring(&mut self) -> Part {
        let (stiffness, damping) = (10.0 * self.random.value(), self.random.value());
        match self.random.below(3) {
            0 if self.damped => Part::Damper(Damper { damping }),
            1 if self.damped => Part::SpringDamper(SpringDamper { stiffness, damping }),
            _ => Part::Spring(Spring { stiffness }),
        }
    }

    fn torsional_spring(&mut self) -> Part {
        let (stiffness, damping) = (self.random.value(), 0.1 * self.random.value());
        match self.random.below(3) {
            0 if self.damped => Part::TorsionDamper(TorsionDamper { damping }),
            1 if self.damped => Part::TorsionSpringDamper(TorsionSpringDamper { stiffness, damping }),
            _ => Part::TorsionSpring(TorsionSpring { stiffness }),
        }
    }
}
