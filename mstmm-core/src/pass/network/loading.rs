//! What sets a network in motion: loads on nodes, motions of supports, loads along members.

use crate::model::SpreadLoad;
use crate::number::{Frequency, FrequencyPowers, Real, Scalar};
use crate::pass::network::evaluate::Placed;
use crate::pass::network::member::Placement;
use crate::subspace::{Chart, LoadEverywhere, MOST_VARIABLES, NodeLoad};

/// A harmonic load on one node: forces x and y and a moment on it, or displacements by which its support moves it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LoadAt<S> {
    pub(crate) node: usize,
    pub(crate) forces: [S; 3],
    pub(crate) moved: Option<[S; 3]>,
}

/// A load of a response.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ActingLoad<S> {
    At(LoadAt<S>),
    Spread(SpreadLoad),
}

impl<S: Scalar> ActingLoad<S> {
    /// The forces x and y and the moment on a node; a weight acts in the mass centre of its body.
    pub(crate) fn on_node<Y: Placed>(&self, network: &Y, node: usize) -> Option<[S; 3]>
    where
        S: Frequency<Y::Parameter>,
    {
        match self {
            ActingLoad::At(load) => (load.node == node).then_some(load.forces),
            ActingLoad::Spread(SpreadLoad { member: Some(_), .. }) => None,
            ActingLoad::Spread(SpreadLoad { member: None, axis }) => {
                let body = network.node(node).0;
                let mut lifted = [S::zero(); 3];
                lifted[*axis] = S::one();
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
}

impl<S: Scalar> Loading<'_, S> {
    /// What the load is at a node. A body resists the motion of its support.
    pub(super) fn on_node<Y: Placed>(&self, network: &Y, node: usize, at: &FrequencyPowers<S>) -> NodeLoad<S>
    where
        S: Frequency<Y::Parameter>,
    {
        let load = match self {
            Loading::Everywhere(load) => return NodeLoad::Everywhere(*load),
            Loading::Acting(load, _) => load,
        };
        let Some(mut forces) = load.on_node(network, node) else { return NodeLoad::Nothing };
        let (body, motions) = network.node(node);
        if let Some(moved) = self.moved(node) {
            for (force, momentum) in forces.iter_mut().zip(body.momentum(moved)) {
                *force -= at.lambda_squared * momentum;
            }
        }
        NodeLoad::Motions(motions.parts_of(forces))
    }

    /// By what its support moves a node.
    pub(super) fn moved(&self, node: usize) -> Option<[S; 3]> {
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

    /// What Π of a member grows by under a load along it.
    pub(super) fn along(&self, member: usize, chart: &Chart<S>) -> [S; MOST_VARIABLES] {
        match self {
            Loading::Acting(ActingLoad::Spread(_), load) => load(member, chart),
            _ => [S::zero(); MOST_VARIABLES],
        }
    }

    /// What Π of a member grows by, whose ends supports may move.
    pub(super) fn of_chart<T: Real>(
        &self,
        member: usize,
        placement: &Placement<T>,
        chart: &Chart<S>,
    ) -> Option<[S; MOST_VARIABLES]>
    where
        S: Frequency<T>,
    {
        let is_something = |parts: &[S]| parts.iter().any(|part| !part.is_zero());
        let moved = self.of_ends(placement);
        let load =
            if is_something(moved.as_flattened()) { chart.load_of_moved(&moved) } else { self.along(member, chart) };
        is_something(&load).then_some(load)
    }
}
