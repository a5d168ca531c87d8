//! The stiffness pass of structures in space: the parts of members in rows of six motions.

use crate::number::{FrequencyPowers, Scalar, Size};
use crate::pass::network::stiffness::front::StiffnessFront;
use crate::pass::network::stiffness::joined::Joins;
use crate::pass::network::stiffness::member::{Seat, StiffnessMember};
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::numbers::Waving;
use crate::pass::network::stiffness::released::OwnStiffness;
use crate::pass::network::stiffness::spatial_room::{Rows, SpatialRoom};
use crate::pass::network::stiffness::waves::{BeamWaves, Bending, Line, line};
use crate::pass::network::vector::Six;
use crate::structure::triangle::{place, row};
use mstmm_plan::Freedoms;

/// Eliminates all nodes at a frequency: members join a front, and what no member will join any more leaves.
#[inline(always)]
pub(super) fn eliminate_all_in_space<S: Joins>(
    model: &StiffnessModel<'_>,
    room: &SpatialRoom,
    front: &mut StiffnessFront<'_, S>,
    omega: S,
) {
    let (at, mut waves) = (FrequencyPowers::new(omega, true), BeamWaves::new());
    let (mut joined, mut parted) = (0usize, 0usize);
    for &index in model.order {
        let node = &model.nodes[index];
        let (all_joined, all_parted) = (node.joined as usize, node.parted as usize);
        for &member in &model.joining[joined..all_joined] {
            let member = member as usize;
            add_part(front, (&model.members[member], &room.rows[member]), &at, &mut waves);
        }
        let [first, count] = node.group.places();
        if let Some(masses) = &room.masses[index] {
            for k in 0..count {
                for l in 0..=k {
                    front.entries[row(first + k) + first + l] += at.lambda_squared * S::from_f64(masses[row(k) + l]);
                }
            }
        }
        front.eliminate_in_space(&node.group);
        for &member in &model.parting[parted..all_parted] {
            front.eliminate(&model.members[member as usize].seat.ties);
        }
        (joined, parted) = (all_joined, all_parted);
    }
}

/// Adds a part of a member.
#[inline(always)]
fn add_part<S: Joins>(
    front: &mut StiffnessFront<'_, S>,
    (member, rows): (&StiffnessMember, &Rows),
    at: &FrequencyPowers<S>,
    waves: &mut BeamWaves<S>,
) {
    let seat = &member.seat;
    match &member.waving {
        // arranged are structures without such members
        Waving::Other => {}
        Waving::Beam(across, along) => {
            let (across, of_along) = waves.of(seat, (across, along.as_ref()), at);
            front.total.include_both(across, of_along);
            if seat.is_shared {
                add_bent(front, (across, of_along), (seat, rows));
            } else {
                OwnStiffness::of_bending(across).join_rows(front, seat, rows);
                if along.is_some() {
                    OwnStiffness::of_line(of_along, 0).join_rows(front, seat, rows);
                }
            }
        }
        Waving::Line(freedom, numbers) => {
            let waves = line(numbers, at);
            front.total.include(&waves);
            OwnStiffness::of_line(&waves, *freedom).join_rows(front, seat, rows);
        }
        Waving::Joint(rigid, elastic) => {
            let [mut tie, _] = seat.ties.places();
            for (freedom, stiffness) in elastic.iter().enumerate() {
                if !stiffness.vanishes() {
                    let own = S::from_f64(*stiffness);
                    OwnStiffness::of_spring(own, freedom).join_rows(front, seat, rows);
                }
                if rigid.contains(Freedoms::SINGLE[freedom]) {
                    add_tie(front, (tie, freedom), (seat, rows));
                    front.total.below = front.total.below + S::Size::of(-1.0);
                    tie += 1;
                }
            }
        }
    }
}

/// Adds forces that tie a freedom of both ends, at a place.
#[inline(always)]
fn add_tie<S: Scalar>(front: &mut StiffnessFront<'_, S>, (at, freedom): (usize, usize), (seat, rows): (&Seat, &Rows)) {
    for (end, rows) in rows.iter().enumerate() {
        let Some([first, count]) = seat.places(end) else { continue };
        for (k, part) in rows[freedom][..count].iter().enumerate() {
            front.entries[place(at, first + k)] += S::from_f64(if end == 0 { -*part } else { *part });
        }
    }
}

/// Adds a beam whose ends share all that it has with their nodes.
#[inline(always)]
fn add_bent<S: Scalar>(
    front: &mut StiffnessFront<'_, S>,
    (bending, along): (&Bending<S>, &Line<S>),
    (seat, rows): (&Seat, &Rows),
) {
    let [yy, yt, tt, yy_across, yt_across, tt_across] = bending.stiffness;
    let [xx, xx_across] = along.stiffness;
    for (end, turn) in [yt, -yt].into_iter().enumerate() {
        let Some([first, count]) = seat.places(end) else { continue };
        for k in 0..count {
            // y with θ is `yt` at the input end, and the opposite at the output end
            let own = work([xx, yy, tt], [turn, turn], &rows[end], k);
            let start = row(first + k) + first;
            for (l, entry) in front.entries[start..=start + k].iter_mut().enumerate() {
                *entry += on(own, &rows[end], l);
            }
        }
    }
    let [Some([first, count]), Some([other, other_count])] = [seat.places(0), seat.places(1)] else { return };
    for k in 0..count {
        // y with θ' is `yt'`, and θ with y' the opposite
        let own = work([xx_across, yy_across, tt_across], [-yt_across, yt_across], &rows[0], k);
        for l in 0..other_count {
            front.add([first + k, other + l], on(own, &rows[1], l));
        }
    }
}

/// What a motion of a node makes of the forces along, across and about, given the stiffness of each and that of y by θ and of θ by y.
#[inline(always)]
fn work<S: Scalar>(
    [xx, yy, tt]: [S; 3],
    [y_by_turn, turn_by_y]: [S; 2],
    rows: &[Six<f64>; 3],
    motion: usize,
) -> [S; 3] {
    let along = S::from_f64(rows[0][motion]);
    let across = S::from_f64(rows[1][motion]);
    let turn = S::from_f64(rows[2][motion]);
    [xx * along, yy * across + y_by_turn * turn, turn_by_y * across + tt * turn]
}

/// The work of forces along, across and about on a motion of a node.
#[inline(always)]
fn on<S: Scalar>([along, across, about]: [S; 3], rows: &[Six<f64>; 3], motion: usize) -> S {
    along * S::from_f64(rows[0][motion]) + across * S::from_f64(rows[1][motion]) + about * S::from_f64(rows[2][motion])
}
