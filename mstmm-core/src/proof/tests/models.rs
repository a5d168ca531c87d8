//! Random models for tests of whole proofs: trees that can be written from any of their ends, and frames that can be numbered in any order.

use crate::elements::{
    Beam, BeamColumn, Body, ElasticHinge, FoundationBeam, Inertia, Lever, Mass, PointMass, RayleighBeam, Rod,
    RotationalHinge, Shaft, ShearHinge, Spring, TautString, TimoshenkoBeam, TorsionSpring,
};
use crate::number::Scalar;
use crate::pass::characteristic::{Characteristic, counted_pass};
use crate::pass::network::{Member, Network, Node};
use crate::pass::searched::Undamped;
use crate::proof::tests::random::Random;
use crate::proof::visit::Visited;
use crate::search::undamped::proven::Parts;
use crate::search::{NaturalFrequencies, NaturalFrequency};
use crate::subspace::{NoCount, WittrickWilliams};
use crate::{AnyUndamped, DoubleDouble, End, Freedoms, ListStep, Section, Space, StepList, Support, UndampedMember};
use std::boxed::Box;
use std::vec;
use std::vec::Vec;

/// Frequencies that are sought of each model.
pub(super) const SOUGHT: usize = 5;

/// A model as tests ask it.
pub(super) trait Asked {
    /// The lowest frequencies, each with its proven interval; none where they are refused.
    fn frequencies(&self) -> Option<Vec<NaturalFrequency<f64>>>;

    /// The count by minors in twice the digits, which shares nothing with a proof.
    fn counted(&self, omega: f64) -> u64;

    /// The sign of Δ in twice the digits: it changes at frequencies of odd multiplicity, and no count is in it.
    fn sign(&self, omega: f64) -> f64;

    /// The parts.
    fn parts(&self) -> Box<dyn Visited + '_>;
}

impl<Y> Asked for Y
where
    Y: Undamped + Characteristic<DoubleDouble> + crate::System<Parameter = f64>,
{
    fn frequencies(&self) -> Option<Vec<NaturalFrequency<f64>>> {
        let found = self.first_frequencies::<SOUGHT>().ok()?;
        found.iter().all(|root| root.is_proven).then(|| found.to_vec())
    }

    fn counted(&self, omega: f64) -> u64 {
        counted_pass(self, DoubleDouble::from_f64(omega), WittrickWilliams::<f64>::default()).0.below()
    }

    fn sign(&self, omega: f64) -> f64 {
        let delta = counted_pass(self, DoubleDouble::from_f64(omega), NoCount).1.mantissa();
        f64::from(delta > DoubleDouble::from_f64(0.0)) - f64::from(delta < DoubleDouble::from_f64(0.0))
    }

    fn parts(&self) -> Box<dyn Visited + '_> {
        Box::new(Parts(self))
    }
}

/// An element of a path, and the same one seen from its other end.
type Part = [AnyUndamped<f64>; 2];

/// A point of a tree: what holds it, and paths that end in it.
struct Point {
    support: Support,
    hung: Vec<Vec<ListStep<AnyUndamped<f64>>>>,
}

/// A tree of points and paths between them, of one space.
pub(super) struct Tree {
    space: Space,
    points: Vec<Point>,
    /// Each path leads from an earlier point to the next one.
    paths: Vec<(usize, Vec<Part>)>,
}

/// A frame.
pub(super) struct Frame {
    nodes: Vec<Node<f64>>,
    members: Vec<Member<UndampedMember<f64>>>,
}

/// A model that is written in more than one order.
pub(super) enum Model {
    Tree(Tree),
    Frame(Frame),
}

/// A parameter of so many decades about 1.
fn size(random: &mut Random, decades: f64) -> f64 {
    10f64.powf(decades * random.signed())
}

/// A number with few bits: sums and products of such numbers are exact.
fn short(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & !((1 << 42) - 1))
}

/// An element that is the same from both ends.
fn same(element: impl TryInto<AnyUndamped<f64>>) -> Part {
    let built = element.try_into().ok().unwrap();
    [built, built]
}

/// A body whose numbers are exact from either end.
fn body(random: &mut Random, decades: f64) -> Part {
    let eighths = |random: &mut Random| (random.below(17) as f64 - 8.0) / 8.0;
    let (mass, central) = (short(size(random, decades)), short(size(random, decades)));
    let (output_x, centre_x) = (eighths(random), eighths(random));
    [centre_x, output_x - centre_x].map(|centre_x| {
        let inertia = central + mass * centre_x * centre_x;
        Body { mass, inertia, output_x, centre_x }.try_into().unwrap()
    })
}

fn bending_part(random: &mut Random, decades: f64) -> Part {
    // lengths vary less: their fourth powers are in the wave numbers
    let length = size(random, decades / 4.0);
    let [bending_stiffness, mass_per_length, other, more] = [(); 4].map(|()| size(random, decades));
    match random.below(15) {
        0..5 => same(Beam { length, bending_stiffness, mass_per_length }),
        5 => same(RayleighBeam { length, bending_stiffness, mass_per_length, rotary_inertia: other }),
        6 => same(TimoshenkoBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness: other,
            rotary_inertia: more,
        }),
        7 => same(BeamColumn { length, bending_stiffness, mass_per_length, axial_force: other }),
        8 => same(FoundationBeam {
            length,
            bending_stiffness,
            mass_per_length,
            foundation_stiffness: other,
            foundation_shear_stiffness: more,
        }),
        9 => same(PointMass { mass: other, inertia: more }),
        10 => same(ElasticHinge { stiffness_y: other, stiffness_theta: more }),
        11 => same(RotationalHinge { stiffness: other }),
        12 => same(ShearHinge { stiffness: other }),
        13 => same(Lever { output_x: length }),
        _ => body(random, decades),
    }
}

fn line_part(random: &mut Random, space: Space, decades: f64) -> Part {
    let length = size(random, decades / 2.0);
    let [stiffness, inertia, other] = [(); 3].map(|()| size(random, decades));
    let foundation_stiffness = if random.below(2) == 0 { 0.0 } else { other };
    match (random.below(4), space.is(Space::Translation)) {
        (0, true) => same(Spring { stiffness }),
        (1, true) => same(Mass { mass: inertia }),
        (2, true) => same(Rod { length, axial_stiffness: stiffness, mass_per_length: inertia, foundation_stiffness }),
        (_, true) => same(TautString { length, tension: stiffness, mass_per_length: inertia, foundation_stiffness }),
        (0, _) => same(TorsionSpring { stiffness }),
        (1, _) => same(Inertia { inertia }),
        _ => same(Shaft { length, torsional_stiffness: stiffness, inertia_per_length: inertia }),
    }
}

/// A path that ends in a point: a spring to the ground, or an oscillator.
fn hung(random: &mut Random, space: Space, decades: f64) -> Vec<ListStep<AnyUndamped<f64>>> {
    let turns = space.is(Space::Rotation) || space.is(Space::Bending) && random.below(2) == 0;
    let [stiffness, inertia] = [(); 2].map(|()| size(random, decades));
    let [spring, mass] = if turns {
        [TorsionSpring { stiffness }.try_into(), Inertia { inertia }.try_into()]
    } else {
        [Spring { stiffness }.try_into(), Mass { mass: inertia }.try_into()]
    }
    .map(|part| ListStep::Element(part.unwrap()));
    match random.below(2) {
        0 => vec![ListStep::Tip(Support::Fixed), spring],
        _ => vec![ListStep::Tip(Support::Free), mass, spring],
    }
}

impl Tree {
    fn new(random: &mut Random, decades: f64) -> Self {
        let space =
            [Space::Bending, Space::Bending, Space::Bending, Space::Translation, Space::Rotation][random.below(5)];
        let is_bending = space.is(Space::Bending);
        let supports = [Support::Fixed, Support::Free, Support::Pinned, Support::Guided];
        let count = 2 + random.below(4);
        let points = (0..count).map(|_| {
            let support = supports[random.below(if is_bending { 4 } else { 2 })];
            let hung = (0..random.below(3) / 2).map(|_| hung(random, space, decades)).collect();
            Point { support: if random.below(3) == 0 { support } else { Support::Free }, hung }
        });
        let mut points: Vec<Point> = points.collect();
        points[0].support = supports[random.below(if is_bending { 4 } else { 2 })];
        let paths = (1..count).map(|to| {
            let parts = (0..1 + random.below(3)).map(|_| match is_bending {
                true => bending_part(random, decades),
                false => line_part(random, space, decades),
            });
            let parts = parts.collect();
            (random.below(to), parts)
        });
        let paths = paths.collect();
        Tree { space, points, paths }
    }

    /// The steps of the path that ends in a point, which it came to from another one.
    fn path_to(
        &self,
        at: usize,
        from: Option<usize>,
        random: &mut Random,
        steps: &mut Vec<ListStep<AnyUndamped<f64>>>,
    ) {
        let Point { support, hung } = &self.points[at];
        let paths = self.paths.iter().enumerate().map(|(k, (from, parts))| ([*from, k + 1], parts));
        let joins = |ends: &[usize; 2]| ends.contains(&at) && from.is_none_or(|from| !ends.contains(&from));
        let mut branches: Vec<_> = paths.filter(|(ends, _)| joins(ends)).collect();
        for last in (1..branches.len()).rev() {
            branches.swap(last, random.below(last + 1));
        }
        let is_end = branches.is_empty() && hung.is_empty();
        let is_passed = branches.len() == 1 && hung.is_empty() && *support == Support::Free;
        let mut inputs = hung.len() + branches.len();
        let support_first = random.below(2) == 0;
        let has_tip = !is_passed;
        inputs += usize::from(has_tip);
        if has_tip && support_first {
            steps.push(ListStep::Tip(*support));
        }
        hung.iter().for_each(|path| steps.extend_from_slice(path));
        for (ends, parts) in branches {
            let is_forward = ends[1] == at;
            self.path_to(if is_forward { ends[0] } else { ends[1] }, Some(at), random, steps);
            let element = |part: &Part| ListStep::Element(part[usize::from(!is_forward)]);
            if is_forward {
                steps.extend(parts.iter().map(element));
            } else {
                steps.extend(parts.iter().rev().map(element));
            }
        }
        if has_tip && !support_first {
            steps.push(ListStep::Tip(*support));
        }
        if !(is_end || is_passed) {
            steps.push(ListStep::Connection(inputs));
        }
    }

    /// The points that may be the root of the same tree. Rotations have the sense of their paths, and where paths meet they are equal: only a
    /// row of paths is the same from its other end. Lines have no sense.
    fn roots(&self) -> Vec<usize> {
        let all = 0..self.points.len();
        let degree = |point: &usize| {
            let paths = self.paths.iter().enumerate();
            paths.filter(|(k, (from, _))| from == point || k + 1 == *point).count()
        };
        match () {
            () if !self.space.is(Space::Bending) => all.collect(),
            () if all.clone().all(|point| degree(&point) < 3) => all.filter(|point| degree(point) == 1).collect(),
            () => vec![0],
        }
    }

    /// The steps from a root on, with branches in any order.
    fn steps(&self, random: &mut Random) -> Vec<ListStep<AnyUndamped<f64>>> {
        let (mut steps, roots) = (Vec::new(), self.roots());
        let root = roots[random.below(roots.len())];
        self.path_to(root, None, random, &mut steps);
        steps.push(ListStep::Root(Support::Free));
        steps
    }
}

impl Frame {
    fn new(random: &mut Random, decades: f64) -> Self {
        let count = 2 + random.below(4);
        let mut nodes: Vec<Node<f64>> = Vec::new();
        for node in 0..count {
            let apart = 0.25 + random.unit();
            let place = [node as f64 + 0.5 * random.unit(), apart * random.signed()];
            let own = match random.below(if node == 0 { 2 } else { 6 }) {
                0 => Node::at(place).held(Support::Fixed.holds()),
                1 => Node::at(place).held(Support::Pinned.holds()),
                2 => Node::at(place).along([random.signed() + 1.5, random.signed()]),
                _ => Node::at(place),
            };
            let has_body = node > 0 && random.below(3) == 0;
            let [mass, inertia] = [(); 2].map(|()| size(random, decades));
            nodes.push(if has_body { own.with_body(mass, inertia, [place[0], place[1] + 0.125]) } else { own });
        }
        let mut members = Vec::new();
        for to in 1..count {
            let from = random.below(to);
            members.push(Self::member(random, &nodes, [from, to], decades));
        }
        for _ in 0..random.below(3) {
            let ends = [random.below(count), random.below(count)];
            if ends[0] != ends[1] {
                members.push(Self::member(random, &nodes, ends, decades));
            }
        }
        if random.below(3) == 0 {
            let spring = Spring { stiffness: size(random, decades) };
            members.push(Member::new(0, count - 1, spring));
        }
        Frame { nodes, members }
    }

    fn member(
        random: &mut Random,
        nodes: &[Node<f64>],
        [from, to]: [usize; 2],
        decades: f64,
    ) -> Member<UndampedMember<f64>> {
        let [axial_stiffness, bending_stiffness, mass_per_length] = [(); 3].map(|()| size(random, decades));
        let is_hinged = random.below(5) == 0;
        let released = if is_hinged { Freedoms::RZ } else { Freedoms::NONE };
        let section = Section { axial_stiffness, bending_stiffness, mass_per_length };
        let end = End::of(from).releasing(released);
        let [x, y] = nodes[from].position;
        // some ends are tied to their nodes by an arm
        let end = if random.below(4) == 0 { end.at([x + 0.125, y - 0.0625]) } else { end };
        Member::new(end, to, section)
    }

    /// The same frame with its nodes, members and ends in another order.
    fn shuffled(&self, random: &mut Random) -> Self {
        let mut order: Vec<usize> = (0..self.nodes.len()).collect();
        for last in (1..order.len()).rev() {
            order.swap(last, random.below(last + 1));
        }
        let mut nodes = self.nodes.clone();
        (0..nodes.len()).for_each(|node| nodes[order[node]] = self.nodes[node]);
        let mut members = self.members.clone();
        for last in (1..members.len()).rev() {
            members.swap(last, random.below(last + 1));
        }
        for member in &mut members {
            for end in &mut member.ends {
                end.node = order[end.node];
            }
            if random.below(2) == 0 {
                member.ends.swap(0, 1);
            }
        }
        Frame { nodes, members }
    }
}

impl Model {
    /// A tree or a frame with parameters of so many decades about 1.
    pub(super) fn new(random: &mut Random, decades: f64) -> Self {
        if random.below(3) == 0 {
            Model::Frame(Frame::new(random, decades))
        } else {
            Model::Tree(Tree::new(random, decades))
        }
    }

    /// Asks the model, written in any order; none where it is refused as it stands.
    pub(super) fn ask<R>(&self, random: &mut Random, ask: impl FnOnce(&dyn Asked) -> R) -> Option<R> {
        match self {
            Model::Tree(tree) => {
                let steps = tree.steps(random);
                let list = StepList::new(&steps);
                assert!(list.is_ok(), "{:?}: {steps:?}", tree.space);
                list.ok().map(|list| ask(&list))
            }
            Model::Frame(frame) => {
                let Frame { nodes, members } = frame.shuffled(random);
                Network::new(&nodes, &members).ok().map(|network| ask(&network))
            }
        }
    }
}
