//! What sets a network in motion: loads on nodes, motions of supports, loads along members.

use crate::model::SpreadLoad;
use crate::number::{Frequency, FrequencyPowers, Real, Scalar, Size};
use crate::pass::network::placed::Placed;
use crate::pass::network::placement::Placement;
use crate::pass::network::vector::Six;
use crate::structure::{Chart, MOST_VARIABLES};
use crate::structure::{LoadEverywhere, MemberLoad, Units};

/// A harmonic load on one node: forces x and y and a moment on it, or displacements by which its support moves it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LoadAt<S> {
    pub(crate) node: usize,
    pub(crate) forces: Six<S>,
    pub(crate) moved: Option<Six<S>>,
}

/// A jump between the end of a member and its node: how far the end is from it in a freedom of the member.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JumpAt<S> {
    pub(crate) member: usize,
    pub(crate) end: usize,
    pub(crate) freedom: usize,
    pub(crate) by: S,
}

/// A load of a response.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ActingLoad<S> {
    At(LoadAt<S>),
    Jump(JumpAt<S>),
    Spread(SpreadLoad),
}

impl<S: Scalar> ActingLoad<S> {
    /// The forces x and y and the moment on a node; a weight acts in the mass centre of its body.
    pub(crate) fn on_node<Y: Placed>(&self, network: &Y, node: usize) -> Option<Six<S>>
    where
        S: Frequency<Y::Parameter>,
    {
        match self {
            ActingLoad::At(load) => (load.node == node).then_some(load.forces),
            ActingLoad::Jump(_) | ActingLoad::Spread(SpreadLoad { member: Some(_), .. }) => None,
            ActingLoad::Spread(SpreadLoad { member: None, axis, is_inertia }) => {
                let body = network.node(node).0;
                let mut lifted = [S::zero(); 6];
                lifted[*axis] = if *is_inertia { -S::one() } else { S::one() };
                body.has_body().then(|| body.momentum(lifted))
            }
        }
    }
}

/// What Π of a member grows by with each variable of its chart, under a load along it.
pub(crate) type ChartLoad<'a, S> = &'a dyn Fn(usize, &Chart<S>) -> [S; MOST_VARIABLES];

/// What sets a network in motion.
pub(crate) enum Loading<'a, S: Scalar> {
    Acting(ActingLoad<S>, ChartLoad<'a, S>),
    Everywhere(LoadEverywhere),
    Nothing,
}

/// The finest units that charts of motions may have, given λ².
fn finest_units<Y: Placed, S: Scalar>(network: &Y, lambda_squared: S) -> Units {
    let square = lambda_squared.size().first();
    Units::of_exponents(network.frequency_estimates().between_stiffness_and_inertia(square))
}

impl<S: Scalar> Loading<'_, S> {
    /// The load of a number: forces on all displacements, and perhaps dislocations, in the units of a network at λ².
    pub(crate) fn everywhere<Y: Placed, R: Scalar>(number: u32, dislocates: bool, (network, square): (&Y, R)) -> Self {
        Loading::Everywhere(LoadEverywhere { number, dislocates, units: finest_units(network, square) })
    }

    /// The finest units that charts have at a frequency. A load everywhere brings its own.
    pub(super) fn units<Y: Placed>(&self, network: &Y, at: &FrequencyPowers<S>) -> Units {
        match self {
            Loading::Everywhere(load) => load.units,
            Loading::Acting(..) | Loading::Nothing => finest_units(network, at.lambda_squared),
        }
    }

    /// The forces on the motions of a node. A body resists the motion of its support.
    pub(super) fn on_node<Y: Placed>(&self, network: &Y, node: usize, at: &FrequencyPowers<S>) -> Six<S>
    where
        S: Frequency<Y::Parameter>,
    {
        let acting = match self {
            Loading::Everywhere(_) | Loading::Nothing => None,
            Loading::Acting(load, _) => load.on_node(network, node),
        };
        let Some(mut forces) = acting else { return [S::zero(); 6] };
        let (body, motions) = network.node(node);
        if let Some(moved) = self.moved(node) {
            for (force, momentum) in forces.iter_mut().zip(body.momentum(moved)) {
                *force -= at.lambda_squared * momentum;
            }
        }
        motions.parts_of(forces)
    }

    /// Whether it moves a support: what hangs on that moves with it then, and is no unknown that rests.
    pub(super) fn moves_support(&self) -> bool {
        matches!(self, Loading::Acting(ActingLoad::At(LoadAt { moved: Some(_), .. }), _))
    }

    /// By what its support moves a node.
    pub(super) fn moved(&self, node: usize) -> Option<Six<S>> {
        match self {
            Loading::Acting(ActingLoad::At(load), _) if load.node == node => load.moved,
            _ => None,
        }
    }

    /// By what supports move the ends of a member, along it, across it and of the rotation; what an end does not share with its node is a
    /// variable of its own, to which a constant more or less is nothing.
    pub(super) fn of_ends<T: Real>(&self, placement: &Placement<T>) -> [[S; 3]; 2]
    where
        S: Frequency<T>,
    {
        [0, 1].map(|end| {
            let moved = self.moved(placement.node_of(end));
            moved.map_or([S::zero(); 3], |moved| placement.tied(end, moved))
        })
    }

    /// What acts on a member, if anything does.
    pub(super) fn on_member<T: Real>(
        &self,
        member: usize,
        placement: &Placement<T>,
        chart: &Chart<S>,
    ) -> Option<MemberLoad<S>>
    where
        S: Frequency<T>,
    {
        let zero = [S::zero(); MOST_VARIABLES];
        match self {
            Loading::Acting(ActingLoad::Spread(_), load) => {
                Some(MemberLoad { along: load(member, chart), moved: zero })
            }
            Loading::Acting(ActingLoad::At(LoadAt { moved: Some(_), .. }), _) => {
                Some(MemberLoad { along: zero, moved: chart.moved(&self.of_ends(placement)) })
            }
            Loading::Acting(ActingLoad::Jump(jump), _) if jump.member == member => {
                let mut ends = [[S::zero(); 3]; 2];
                ends[jump.end][jump.freedom] = jump.by;
                Some(MemberLoad { along: zero, moved: chart.moved(&ends) })
            }
            Loading::Acting(..) | Loading::Everywhere(_) | Loading::Nothing => None,
        }
    }
}
