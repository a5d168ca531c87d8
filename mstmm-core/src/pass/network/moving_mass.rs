//! The mass of bodies that modes can move along an axis.
//!
//! With the mass matrix A of all motions and the momentum b of a displacement of 1 along the axis, all modes together have the effective mass `bᵀ A⁻¹ b`: that of the
//! displacement if nothing holds it. Bodies are eliminated one after the other, those that hang on others first.

use crate::element::MemberNumbers;
use crate::model::MotionError;
use crate::number::Real;
use crate::pass::network::motions::{NONE, Shared};
use crate::pass::network::placed::Placed;
use crate::pass::network::ties::shares;
use crate::pass::network::vector::Six;
use mstmm_plan::Freedoms;
use num_traits::{One, Zero};

/// The part of a diagonal entry of a mass matrix below which what is left of it is rounding: of six eliminations with some roundings each.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The mass matrix of a node over its motions, and the momentum of a displacement along the axis.
#[derive(Clone, Copy, Debug)]
struct Inertia<T> {
    masses: [Six<T>; 6],
    /// The diagonal before the first elimination.
    diagonal: Six<T>,
    momentum: Six<T>,
}

impl<T: Real> Inertia<T> {
    fn none() -> Self {
        let zero = [T::zero(); 6];
        Inertia { masses: [zero; 6], diagonal: zero, momentum: zero }
    }

    /// Eliminates a motion, and gives what it adds to the mass.
    fn eliminate(&mut self, motion: usize) -> T {
        let (column, pivot, momentum) = (self.masses[motion], self.masses[motion][motion], self.momentum[motion]);
        (self.masses[motion], self.momentum[motion]) = ([T::zero(); 6], T::zero());
        self.masses.iter_mut().for_each(|row| row[motion] = T::zero());
        if pivot.size() <= ROUNDING * self.diagonal[motion].size() {
            return T::zero();
        }
        for (place, own) in column.iter().enumerate().filter(|(place, _)| *place != motion) {
            let part = *own / pivot;
            self.momentum[place] -= part * momentum;
            for (other, entry) in column.iter().enumerate().filter(|(other, _)| *other != motion) {
                self.masses[place][other] -= part * *entry;
            }
        }
        momentum * momentum / pivot
    }

    /// Adds another one, whose motions are motions of this one, or are at rest.
    fn add(&mut self, other: &Self, motions: &[Option<usize>; 6]) {
        let pairs = || motions.iter().enumerate().filter_map(|(from, to)| to.map(|to| (from, to)));
        for (from, to) in pairs() {
            self.momentum[to] += other.momentum[from];
            self.diagonal[to] += other.diagonal[from];
            for (other_from, other_to) in pairs() {
                self.masses[to][other_to] += other.masses[from][other_from];
            }
        }
    }
}

/// The mass of all bodies along an axis, as far as modes can move it.
///
/// # Errors
/// [`MotionError::HeldMass`] where a support holds a body along the axis, and a rigid joint ties bodies otherwise than motion by motion.
pub(crate) fn mass_of_bodies<Y: Placed>(network: &Y, axis: usize) -> Result<Y::Parameter, MotionError> {
    let [nodes, members] = network.sizes();
    let is_odd_joint = |member: &usize| {
        let is_rigid = matches!(network.numbers()[*member], MemberNumbers::Joint(rigid, _) if !rigid.is_empty());
        is_rigid && !network.placement(*member).is_tie
    };
    let mut joined = (0..members).filter(is_odd_joint);
    let moves = |node: usize| moves_along(network, node, axis);
    let unmoved = (0..nodes).find(|node| network.node(*node).0.has_body() && !moves(*node));
    if let Some(member) = joined.next() {
        let mut ends = core::iter::once(member).chain(joined);
        let all_move = ends.all(|member| [0, 1].iter().all(|end| moves(network.placement(member).node_of(*end))));
        if let (false, Some(node)) =
            (all_move && unmoved.is_none(), (0..nodes).find(|node| network.node(*node).0.has_body()))
        {
            return Err(MotionError::HeldMass { at: network.spot(unmoved.unwrap_or(node)) });
        }
    }
    if unmoved.is_none() {
        return Ok((0..nodes).fold(Y::Parameter::zero(), |sum, node| sum + network.node(node).0.mass));
    }
    Ok(eliminated(network, axis))
}

/// Whether nothing holds a node along an axis.
fn moves_along<Y: Placed>(network: &Y, node: usize, axis: usize) -> bool {
    let (body, motions) = network.node(node);
    body.skew.is_none() && !body.held.contains(Freedoms::EACH[axis]) && !motions.rests_along(axis)
}

/// The mass of all bodies, of which some are held.
fn eliminated<Y: Placed>(network: &Y, axis: usize) -> Y::Parameter {
    let count = network.sizes()[0];
    let (mut inertias, mut waiting) = (network.per_node(Inertia::none()), network.per_node(0_u32));
    let (inertias, waiting) = (inertias.as_mut(), waiting.as_mut());
    let mut along = [Y::Parameter::zero(); 6];
    along[axis] = Y::Parameter::one();
    let above = |node: usize| {
        let tie = network.node(node).1.hangs_by;
        (tie != NONE).then(|| network.placement(tie as usize)).map(|placement| {
            let leaf = usize::from(placement.node_of(1) == node);
            (placement, leaf, placement.node_of(1 - leaf))
        })
    };
    for (node, inertia) in inertias.iter_mut().enumerate().take(count) {
        let (body, motions) = network.node(node);
        if body.has_body() {
            let masses = motions.masses::<Y::Parameter>(body);
            let diagonal = core::array::from_fn(|motion| masses[motion][motion]);
            *inertia = Inertia { masses, diagonal, momentum: motions.parts_of(body.momentum(along)) };
        }
        if let Some((.., root)) = above(node) {
            waiting[root] += 1;
        }
    }
    let mut mass = Y::Parameter::zero();
    for first in 0..count {
        let mut node = first;
        while waiting[node] == 0 {
            waiting[node] = NONE;
            let mut own = inertias[node];
            let shared = above(node).map_or([Shared::Own; 6], |(placement, leaf, root)| {
                shares(placement, leaf, network.node(root).1.count == 0, root).unwrap_or([Shared::Own; 6])
            });
            for motion in (0..network.node(node).1.count).filter(|motion| shared[*motion] == Shared::Own) {
                mass += own.eliminate(motion);
            }
            let Some((.., root)) = above(node) else { break };
            let motions = shared.map(|shared| match shared {
                Shared::With { motion, .. } => Some(usize::from(motion)),
                Shared::Own | Shared::AtRest => None,
            });
            inertias[root].add(&own, &motions);
            waiting[root] -= 1;
            node = root;
        }
    }
    mass
}
