//! The evaluation of a network by dynamic stiffnesses, at several frequencies at once.

use crate::number::{FrequencyPowers, Scalar, Size};
use crate::pass::network::stiffness::front::StiffnessFront;
use crate::pass::network::stiffness::joined::Joins;
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::numbers::Waving;
use crate::pass::network::stiffness::released::OwnStiffness;
use crate::pass::network::stiffness::waves::{BeamWaves, Line, line};
use mstmm_plan::Freedoms;

/// Eliminates all nodes at a frequency: members join a front, and what no member will join any more leaves.
#[inline(always)]
pub(super) fn eliminate_all<S: Joins>(model: &StiffnessModel<'_>, front: &mut StiffnessFront<'_, S>, omega: S) {
    let (at, mut waves) = (FrequencyPowers::new(omega, true), BeamWaves::new());
    let (mut joined, mut parted) = (0usize, 0usize);
    for &node in model.order {
        let node = &model.nodes[node];
        let (all_joined, all_parted) = (node.joined as usize, node.parted as usize);
        for &member in &model.joining[joined..all_joined] {
            add_member(front, &model.members[member as usize], &at, &mut waves);
        }
        if let Some(masses) = &node.masses {
            front.add_body(&node.group, masses, at.lambda_squared);
        }
        front.eliminate(&node.group);
        for &member in &model.parting[parted..all_parted] {
            front.eliminate(&model.members[member as usize].seat.ties);
        }
        (joined, parted) = (all_joined, all_parted);
    }
}

/// Adds a member.
#[inline(always)]
pub(super) fn add_member<S: Joins>(
    front: &mut StiffnessFront<'_, S>,
    member: &StiffnessMember,
    at: &FrequencyPowers<S>,
    waves: &mut BeamWaves<S>,
) {
    match &member.waving {
        // arranged are networks without such members
        Waving::Other => {}
        Waving::Beam(across, along) => {
            let (across, of_along) = waves.of(&member.seat, (across, along.as_ref()), at);
            front.total.include_both(across, of_along);
            if member.seat.is_shared {
                front.add_beam(&across.stiffness, &of_along.stiffness, member);
            } else {
                S::join(&mut OwnStiffness::of_bending(across), front, member);
                if along.is_some() {
                    S::join(&mut OwnStiffness::of_line(of_along, 0), front, member);
                }
            }
        }
        Waving::Line(freedom, numbers) => add_line(front, &line(numbers, at), *freedom, member),
        Waving::Joint(rigid, elastic) => {
            let [mut tie, _] = member.seat.ties.places();
            for (freedom, stiffness) in elastic.iter().enumerate() {
                if !stiffness.vanishes() {
                    let own = S::from_f64(*stiffness);
                    front.add_line([own, -own], freedom, member);
                }
                if rigid.contains(Freedoms::SINGLE[freedom]) {
                    front.add_tie(tie, freedom, member);
                    front.total.below = front.total.below + S::Size::of(-1.0);
                    tie += 1;
                }
            }
        }
    }
}

/// Adds a line.
#[inline(always)]
fn add_line<S: Joins>(front: &mut StiffnessFront<'_, S>, waves: &Line<S>, freedom: usize, member: &StiffnessMember) {
    front.total.include(waves);
    if member.seat.is_shared {
        front.add_line(waves.stiffness, freedom, member);
    } else {
        S::join(&mut OwnStiffness::of_line(waves, freedom), front, member);
    }
}
