//! Models whose eigenvalues are roots of quadratic equations, in many digits: uniform beams, rods and shafts with all their damping, in one piece or in
//! several, as trees and as frames.

use crate::element::{BeamNumbers, DampingNumbers, LineNumbers, MemberNumbers, OwnPart};
use crate::model::{MemberPlane, Spot};
use crate::proof::tests::discs::exact_complex::ExactComplex;
use crate::proof::tests::exact::{Exact, exact, pi};
use crate::proof::tests::random::Random;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use crate::{Freedoms, Space, Support};
use std::vec::Vec;

/// What the pieces are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// A beam with both ends pinned.
    Beam,
    /// A rod or a shaft with both ends held.
    Line(Space),
    /// A beam between two pins of a frame, which stretches too.
    Member,
}

/// A uniform row of pieces.
#[derive(Debug)]
pub(super) struct Row {
    kind: Kind,
    /// Lengths of pieces over five, of few bits.
    parts: Vec<f64>,
    beam: BeamNumbers,
    damping: DampingNumbers,
}

fn pair(number: f64) -> [f64; 2] {
    [number, 0.0]
}

impl Row {
    pub(super) fn new(random: &mut Random) -> Self {
        let mut some = |decades: f64| pair(10f64.powf(decades * random.signed()));
        let (bending_stiffness, mass_per_length, axial_stiffness) = (some(2.0), some(2.0), some(4.0));
        let (time, viscous, foundation) = (some(2.0)[0] * 1e-4, some(2.0)[0] * 0.1, some(2.0));
        let kind = match random.below(5) {
            0 | 1 => Kind::Beam,
            2 => Kind::Line(Space::Translation),
            3 => Kind::Line(Space::Rotation),
            _ => Kind::Member,
        };
        let parts = (0..1 + random.below(3)).map(|_| (1 + random.below(64)) as f64 / 256.0).collect();
        let mut choose = |number: f64| if random.below(3) == 0 { pair(0.0) } else { pair(number) };
        let damping = DampingNumbers {
            time: choose(time),
            viscous: choose(viscous),
            loss_factor: choose(0.03),
            ..DampingNumbers::default()
        };
        let foundation_stiffness = if kind == Kind::Member { pair(0.0) } else { choose(foundation[0]) };
        let axial_stiffness = if kind == Kind::Beam { pair(0.0) } else { axial_stiffness };
        let beam = BeamNumbers {
            bending_stiffness,
            mass_per_length,
            axial_stiffness,
            foundation_stiffness,
            ..BeamNumbers::default()
        };
        Row { kind, parts, beam, damping }
    }

    /// A piece of a length.
    fn piece(&self, length: f64) -> MemberNumbers {
        let BeamNumbers { mass_per_length, axial_stiffness, foundation_stiffness, .. } = self.beam;
        let line = LineNumbers {
            length: pair(length),
            stiffness: axial_stiffness,
            inertia: mass_per_length,
            foundation: foundation_stiffness,
        };
        match self.kind {
            Kind::Beam | Kind::Member => MemberNumbers::Beam(BeamNumbers { length: pair(length), ..self.beam }),
            Kind::Line(space) => MemberNumbers::Line(if space.is(Space::Rotation) { 2 } else { 0 }, line),
        }
        .damped(self.damping)
    }

    fn visit_tree(&self, space: Space, support: Support, visitor: &mut dyn Visitor) {
        visitor.tip(0, support);
        for (k, part) in self.parts.iter().enumerate() {
            visitor.element(k + 1, k, space, &self.piece(5.0 * part));
        }
        visitor.root(self.parts.len(), support);
    }

    /// Along (3, 4): all lengths are exact.
    fn visit_frame(&self, visitor: &mut dyn Visitor) {
        let mut at = 0.0;
        let mut node = |index: usize, step: f64| {
            at += step;
            let place = [pair(3.0 * at), pair(4.0 * at), [0.0; 2]];
            let is_end = index == 0 || index == self.parts.len();
            NodeNumbers { index, place, free: if is_end { Freedoms::RZ } else { Freedoms::PLANE }, skew: None }
        };
        let end = |node: NodeNumbers| MemberEnd { node, place: node.place, along: None, released: Freedoms::NONE };
        let mut from = node(0, 0.0);
        for (k, part) in self.parts.iter().enumerate() {
            let to = node(k + 1, *part);
            visitor.member(
                (k, Freedoms::PLANE, MemberPlane::Structure),
                &self.piece(5.0 * part),
                &[end(from), end(to)],
                k,
            );
            visitor.leave(k);
            from = to;
        }
        visitor.leave(from.index);
    }

    /// Both roots of `mλ² + c_e λ + k + s (1 + iη)(1 + cλ)` for a stiffness s.
    fn roots(&self, stiffness: &Exact) -> [ExactComplex; 2] {
        let real = |number: &[f64; 2]| ExactComplex::of(number[0], 0.0);
        let loss = ExactComplex { re: stiffness.clone(), im: stiffness * exact(self.damping.loss_factor[0]) };
        let mass = real(&self.beam.mass_per_length);
        let linear = &real(&self.damping.viscous) + &(&loss * &real(&self.damping.time));
        let constant = &real(&self.beam.foundation_stiffness) + &loss;
        let four = ExactComplex::of(4.0, 0.0);
        let root = (&(&linear * &linear) - &(&four * &(&mass * &constant))).sqrt();
        let twice = &ExactComplex::of(2.0, 0.0) * &mass;
        [&(&root - &linear) / &twice, &(&-&root - &linear) / &twice]
    }

    /// The eigenvalues of so many half waves, and of some more than are looked at.
    pub(super) fn eigenvalues(&self, half_waves: usize) -> Vec<ExactComplex> {
        let length = exact(5.0 * self.parts.iter().sum::<f64>());
        let mut all = Vec::new();
        for k in 1..=half_waves {
            let beta = pi() * exact(k as f64) / &length;
            let square = &beta * &beta;
            if !matches!(self.kind, Kind::Line(_)) {
                all.extend(self.roots(&(exact(self.beam.bending_stiffness[0]) * &square * &square)));
            }
            if self.kind != Kind::Beam {
                all.extend(self.roots(&(exact(self.beam.axial_stiffness[0]) * &square)));
            }
        }
        all
    }
}

impl Visited for Row {
    fn visit(&self, visitor: &mut dyn Visitor) {
        match self.kind {
            Kind::Beam => self.visit_tree(Space::Bending, Support::Pinned, visitor),
            Kind::Line(space) => self.visit_tree(space, Support::Fixed, visitor),
            Kind::Member => self.visit_frame(visitor),
        }
    }

    fn spot(&self, place: usize) -> Spot {
        Spot::Step(place)
    }

    fn own_part(&self, _: usize, _: [f64; 2]) -> Option<OwnPart> {
        None
    }
}
