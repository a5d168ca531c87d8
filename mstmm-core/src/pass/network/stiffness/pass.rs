//! The evaluation of a network by dynamic stiffnesses, at several frequencies at once.

use crate::element::MemberNumbers;
use crate::number::{FrequencyPowers, Scalar, Size};
use crate::pass::network::stiffness::compiled::StiffnessScalar;
use crate::pass::network::stiffness::fronts::StiffnessFronts;
use crate::pass::network::stiffness::in_front::InFront;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::released::OwnStiffness;
use crate::pass::network::stiffness::waves::{BeamWaves, Line, line};
use mstmm_plan::Freedoms;

/// Eliminates all nodes at a frequency. None where memory ends or a member is not known.
#[inline(always)]
pub(super) fn eliminate_all<S: StiffnessScalar>(
    model: &StiffnessModel<'_>,
    fronts: &mut StiffnessFronts<'_, S>,
    omega: S,
) -> Option<()> {
    let (at, mut waves) = (FrequencyPowers::new(omega, true), BeamWaves::new());
    for &node in model.order.nodes {
        eliminate_node(model, fronts, (&at, &mut waves), node)?;
        eliminate_ties(model, fronts, node)?;
    }
    Some(())
}

/// The forces of the rigid joint that a member is, as a group of variables beyond all nodes, and their number.
#[inline(always)]
fn ties(model: &StiffnessModel<'_>, member: usize) -> Option<[usize; 2]> {
    match model.members[member].numbers {
        MemberNumbers::Joint(rigid, _) if rigid.count() > 0 => Some([model.nodes.len() + member, rigid.count()]),
        _ => None,
    }
}

/// Eliminates a node with all members that its elimination cuts.
#[inline(always)]
fn eliminate_node<'a, S: StiffnessScalar>(
    model: &'a StiffnessModel<'_>,
    fronts: &mut StiffnessFronts<'_, S>,
    (at, waves): (&FrequencyPowers<S>, &mut BeamWaves<'a, S>),
    node: usize,
) -> Option<()> {
    let (order, own) = (&model.order, &model.nodes[node]);
    let taken_up = order.taken_up[node];
    fronts.begin(taken_up, node)?;
    for &end in order.incidence.ends(node) {
        if order.is_first_at(end, node) {
            let other = order.incidence.beyond(end);
            if other != node {
                fronts.include(other, model.nodes[other].motions)?;
            }
            if let Some([ties, count]) = ties(model, end / 2) {
                fronts.include(ties, count)?;
            }
        }
    }
    fronts.include(node, own.motions)?;
    fronts.fill(taken_up)?;
    for &end in order.incidence.ends(node) {
        if order.is_first_at(end, node) {
            add_member(model, fronts, (at, waves), end / 2)?;
        }
    }
    if let (Some(masses), Some(place)) = (&own.masses, fronts.place_of(node)) {
        fronts.add_body(place, masses, at.lambda_squared);
    }
    fronts.eliminate(own.motions)
}

/// Eliminates the forces of rigid joints whose nodes have both left.
#[inline(always)]
fn eliminate_ties<S: Scalar>(
    model: &StiffnessModel<'_>,
    fronts: &mut StiffnessFronts<'_, S>,
    node: usize,
) -> Option<()> {
    let order = &model.order;
    for &end in order.incidence.ends(node) {
        let is_last = !order.is_first_at(end, node) || order.incidence.beyond(end) == node;
        if let (true, Some([ties, count])) = (is_last, ties(model, end / 2))
            && (order.incidence.beyond(end) != node || end % 2 == 0)
        {
            fronts.begin(1, ties)?;
            fronts.include(ties, count)?;
            fronts.fill(1)?;
            fronts.eliminate(count)?;
        }
    }
    Some(())
}

/// Adds a member.
#[inline(always)]
fn add_member<'a, S: StiffnessScalar>(
    model: &'a StiffnessModel<'_>,
    fronts: &mut StiffnessFronts<'_, S>,
    (at, waves): (&FrequencyPowers<S>, &mut BeamWaves<'a, S>),
    member: usize,
) -> Option<()> {
    let own = &model.members[member];
    let place = |end: usize| fronts.place_of(model.order.incidence.node(2 * member + end)).filter(|_| !own.rests[end]);
    let in_front = InFront { ends: [place(0), place(1)], member: own };
    let numbers = &own.numbers;
    match numbers {
        MemberNumbers::Other => return None,
        MemberNumbers::Beam(across, along) => {
            let (of_across, of_along) = waves.of(numbers, (across, along.as_ref()), at);
            fronts.total.include(of_across);
            if own.is_shared {
                fronts.add_bending(of_across, in_front);
            } else {
                S::join(&mut OwnStiffness::of_bending(of_across), fronts, in_front);
            }
            if along.is_some() {
                add_line(fronts, of_along, 0, in_front);
            }
        }
        MemberNumbers::Line(freedom, numbers) => {
            add_line(fronts, &line(numbers, at), *freedom, in_front);
        }
        MemberNumbers::Joint(rigid, elastic) => {
            let mut tie = fronts.place_of(model.nodes.len() + member).map_or(0, |[first, _]| first);
            for (freedom, stiffness) in elastic.iter().enumerate() {
                if *stiffness > 0.0 {
                    let own = S::from_f64(*stiffness);
                    fronts.add_line([own, -own], freedom, in_front);
                }
                if rigid.contains(Freedoms::SINGLE[freedom]) {
                    fronts.add_tie(tie, freedom, in_front);
                    fronts.total.below = fronts.total.below + S::Size::of(-1.0);
                    tie += 1;
                }
            }
        }
    }
    Some(())
}

/// Adds a line.
#[inline(always)]
fn add_line<S: StiffnessScalar>(
    fronts: &mut StiffnessFronts<'_, S>,
    waves: &Line<S>,
    freedom: usize,
    in_front: InFront<'_>,
) {
    fronts.total.include(waves);
    if in_front.member.is_shared {
        fronts.add_line(waves.stiffness, freedom, in_front);
    } else {
        S::join(&mut OwnStiffness::of_line(waves, freedom), fronts, in_front);
    }
}
