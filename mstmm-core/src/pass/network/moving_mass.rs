//! The mass of bodies that modes can move along an axis, or about one.
//!
//! With the mass matrix A of all motions and the momentum b of a displacement of 1 along the axis, or a rotation about it, all modes together have the effective mass `bᵀ A⁻¹ b`: that of the
//! displacement if nothing holds it. Bodies are eliminated one after the other, those that hang on others first.

use crate::element::MemberNumbers;
use crate::model::MotionError;
use crate::number::{Real, Scalar};
use crate::pass::network::motions::Shared;
use crate::pass::network::placed::Placed;
use crate::pass::network::ties::{Tie, from_leaves, shares};
use crate::pass::network::vector::Six;
use mstmm_plan::Freedoms;
use num_traits::Zero;

/// The part of a diagonal entry of a mass matrix below which what is left of it is rounding: of six eliminations with some roundings each.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The mass matrix of a node over its motions, and the momentum of a displacement along the axis.
#[derive(Clone, Copy, Debug)]
struct Inertia<T> {
    masses: [Six<T>; 6],
    /// The diagonal before the first elimination, and the largest that its momentum may be.
    diagonal: Six<T>,
    largest: Six<T>,
    momentum: Six<T>,
}

impl<T: Real> Inertia<T> {
    fn none() -> Self {
        let zero = [T::zero(); 6];
        Inertia { masses: [zero; 6], diagonal: zero, largest: zero, momentum: zero }
    }

    /// Eliminates a motion, and gives what it adds to the mass; none where rounding hides that.
    fn eliminate(&mut self, motion: usize) -> Option<T> {
        let (column, pivot, momentum) = (self.masses[motion], self.masses[motion][motion], self.momentum[motion]);
        (self.masses[motion], self.momentum[motion]) = ([T::zero(); 6], T::zero());
        self.masses.iter_mut().for_each(|row| row[motion] = T::zero());
        if pivot.size() <= ROUNDING * self.diagonal[motion].size() {
            return (momentum.size() <= ROUNDING * self.largest[motion].size()).then_some(T::zero());
        }
        for (place, own) in column.iter().enumerate().filter(|(place, _)| *place != motion) {
            let part = *own / pivot;
            self.momentum[place] -= part * momentum;
            for (other, entry) in column.iter().enumerate().filter(|(other, _)| *other != motion) {
                self.masses[place][other] -= part * *entry;
            }
        }
        Some(momentum * momentum / pivot)
    }

    /// Adds another one, whose motions are motions of this one, or are at rest.
    fn add(&mut self, other: &Self, motions: &[Option<usize>; 6]) {
        let pairs = || motions.iter().enumerate().filter_map(|(from, to)| to.map(|to| (from, to)));
        for (from, to) in pairs() {
            self.momentum[to] += other.momentum[from];
            self.diagonal[to] += other.diagonal[from];
            self.largest[to] += other.largest[from];
            for (other_from, other_to) in pairs() {
                self.masses[to][other_to] += other.masses[from][other_from];
            }
        }
    }
}

/// Nodes that rigid joints tie, directly or by others: which node stands for them, whether all move along the axis, and whether a joint ties them otherwise than motion by
/// motion.
#[derive(Clone, Copy, Debug)]
struct Tied {
    by: u32,
    all_move: bool,
    is_odd: bool,
}

/// The node that stands for all that are tied to one.
fn stands_for(tied: &[Tied], node: usize) -> usize {
    let mut last = node;
    while tied[last].by as usize != last {
        last = tied[last].by as usize;
    }
    last
}

/// The mass of all bodies as far as modes can move it as a whole, given what that moves each node by: along an axis, or about one.
///
/// # Errors
/// [`MotionError::HeldMass`] for a body that something holds in part, where rigid joints tie it otherwise than motion by motion, or rounding hides how it turns.
pub(crate) fn mass_of_bodies<Y: Placed>(
    network: &Y,
    rigid: impl Fn(usize) -> Six<Y::Parameter>,
) -> Result<Y::Parameter, MotionError> {
    let count = network.sizes()[0];
    let mut tied = network.per_node(Tied { by: 0, all_move: true, is_odd: false });
    let tied = &mut tied.as_mut()[..count];
    for (node, tied) in tied.iter_mut().enumerate() {
        *tied = Tied { by: node as u32, all_move: moves_along(network, node, &rigid(node)), is_odd: false };
    }
    tie_all(network, tied);
    let mut inertias = network.per_node(Inertia::none());
    let mut mass = Y::Parameter::zero();
    for (node, inertia) in inertias.as_mut().iter_mut().enumerate().take(count) {
        let (body, motions) = network.node(node);
        let Tied { all_move, is_odd, .. } = tied[stands_for(tied, node)];
        let rigid = rigid(node);
        let whole = body.mass_form(rigid, rigid);
        if all_move {
            mass += whole;
        } else if is_odd && !whole.is_zero() {
            return Err(MotionError::HeldMass { at: network.spot(node) });
        } else if body.has_body() {
            let masses = motions.masses::<Y::Parameter>(body);
            let diagonal = core::array::from_fn(|motion| masses[motion][motion]);
            let largest = diagonal.map(|own: Y::Parameter| (own * whole).sqrt());
            let momentum = motions.parts_of(body.momentum(rigid));
            *inertia = Inertia { masses, diagonal, largest, momentum };
        }
    }
    Ok(mass + eliminated(network, inertias.as_mut())?)
}

/// Finds which nodes rigid joints tie.
fn tie_all<Y: Placed>(network: &Y, tied: &mut [Tied]) {
    for member in 0..network.sizes()[1] {
        let placement = network.placement(member);
        let is_rigid = matches!(network.numbers()[member], MemberNumbers::Joint(rigid, _) if !rigid.is_empty());
        if !(is_rigid || placement.is_tie) {
            continue;
        }
        let [one, other] = [0, 1].map(|end| (!placement.rests(end)).then(|| placement.node_of(end)));
        let (Some(one), Some(other)) = (one.or(other), other.or(one)) else { continue };
        let [one, other] = [one, other].map(|node| stands_for(tied, node));
        let holds = [0, 1].iter().any(|end| placement.rests(*end)) && !placement.is_tie;
        tied[one].all_move &= tied[other].all_move && !holds;
        tied[one].is_odd |= tied[other].is_odd || !placement.is_tie;
        tied[other].by = one as u32;
    }
}

/// Whether nothing holds a node in a displacement.
fn moves_along<Y: Placed>(network: &Y, node: usize, displaced: &Six<Y::Parameter>) -> bool {
    let (body, motions) = network.node(node);
    let mut moved = (0..displaced.len()).filter(|axis| !displaced[*axis].is_zero());
    body.skew.is_none() && moved.all(|axis| !body.held.contains(Freedoms::EACH[axis]) && !motions.rests_along(axis))
}

/// The mass of bodies of which some are held, node by node.
fn eliminated<Y: Placed>(network: &Y, inertias: &mut [Inertia<Y::Parameter>]) -> Result<Y::Parameter, MotionError> {
    let mut mass = Ok(Y::Parameter::zero());
    from_leaves(network, |node, tie| {
        let mut own = inertias[node];
        let shared = tie.and_then(|Tie { member, leaf, root }| {
            shares(network.placement(member), leaf, network.node(root).1.count == 0, root)
        });
        let shared = shared.unwrap_or([Shared::Own; 6]);
        for motion in (0..network.node(node).1.count).filter(|motion| shared[*motion] == Shared::Own) {
            let part = own.eliminate(motion).ok_or(MotionError::HeldMass { at: network.spot(node) });
            mass = mass.and_then(|mass| Ok(mass + part?));
        }
        if let Some(Tie { root, .. }) = tie {
            let motions = shared.map(|shared| match shared {
                Shared::With { motion, .. } => Some(usize::from(motion)),
                Shared::Own | Shared::AtRest => None,
            });
            inertias[root].add(&own, &motions);
        }
    });
    mass
}
