//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar, Scaled, Size};
use crate::pass::characteristic::System;
use crate::pass::network::member::Placement;
use crate::pass::network::node::{Motions, Node};
use crate::subspace::{
    Chart, Choice, Front, Joint, MOST_FREEDOMS, Measure, NodeUnits, Objects, Role, RootCounter, Total, Units, Variable,
};
use mstmm_plan::NetworkOrder;

/// Number of roundings that add up in the row of a pivot, in units of the largest one.
const ROUNDINGS: f64 = 2.0;

/// The end of a member to which a variable belongs.
fn end_of(variable: &Variable) -> usize {
    variable.label / MOST_FREEDOMS
}

/// A network as its evaluation reads it.
pub trait Placed: System {
    /// A node and its motions.
    fn node(&self, node: usize) -> (&Node<Self::Parameter>, &Motions<Self::Parameter>);

    /// Where a member stands.
    fn placement(&self, member: usize) -> &Placement<Self::Parameter>;

    /// The order of its nodes.
    fn order(&self) -> NetworkOrder<'_>;
}

/// A network whose members are known at a frequency.
pub trait PlacedCharts<S: Frequency<Self::Parameter>>: Placed {
    /// The chart of a member of a length.
    fn chart(&self, member: usize, at: &FrequencyPowers<S>, length: S) -> Option<Chart<S>>;
}

/// Δ of a network, with a counter. `WIDTH` is the largest number of variables of a front.
pub fn network_pass<const WIDTH: usize, Y, S, C>(network: &Y, x: S, counter: &mut C) -> Scaled<S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter>,
    C: RootCounter<S>,
{
    let total = Evaluation::<WIDTH, _, S>::new(network, x, counter.looks_at_root()).eliminated(Choice::Largest);
    if C::WATCHES && total.has_vanished {
        counter.cancelled(true);
    }
    if counter.looks_at_root() {
        let [row, error] = total.smallest_row;
        counter.root_sum(S::Size::of(row), S::Size::of(ROUNDINGS * error));
        // another choice of pivots rounds otherwise: what differs is decided by rounding
        let other = Evaluation::<WIDTH, _, S>::new(network, x, false).eliminated(Choice::InOrder);
        if other.below != total.below {
            counter.cancelled(false);
        }
    }
    counter.eliminated(total.below);
    // in extended precision a row of rounding alone is zero: there is nothing further that could tell
    if S::IS_EXTENDED && total.has_vanished { Scaled::new(S::zero(), 0) } else { total.delta() }
}

/// An evaluation at work.
struct Evaluation<'a, const WIDTH: usize, Y, S: Scalar> {
    network: &'a Y,
    order: NetworkOrder<'a>,
    at: FrequencyPowers<S>,
    objects: Objects<S, WIDTH>,
    front: Front<S, WIDTH>,
    total: Total<S>,
    /// Whether each variable belongs to an end at the node, and what it becomes there.
    is_here: [bool; WIDTH],
    roles: [Role<S>; WIDTH],
}

impl<'a, const WIDTH: usize, Y, S> Evaluation<'a, WIDTH, Y, S>
where
    Y: PlacedCharts<S>,
    S: Frequency<Y::Parameter>,
{
    fn new(network: &'a Y, x: S, carries_errors: bool) -> Self {
        let at = FrequencyPowers::new(x, true);
        Evaluation {
            network,
            order: network.order(),
            at,
            objects: Objects::new(),
            front: Front::new(),
            total: Total::new(carries_errors),
            is_here: [false; WIDTH],
            roles: [Role::Absent; WIDTH],
        }
    }

    /// Eliminates all nodes.
    fn eliminated(mut self, choice: Choice) -> Total<S> {
        for &node in self.order.nodes {
            let from = self.objects.len() - self.order.taken_up[node];
            self.push_members(node);
            self.join(node, from);
            self.front.eliminate(choice, &mut self.total);
            self.objects.drop_last(self.objects.len() - from);
            let shift = self.front.balance();
            self.objects.push_front(&self.front, shift);
        }
        self.total
    }

    /// Adds the members that are cut by the elimination of a node.
    fn push_members(&mut self, node: usize) {
        for &end in self.order.incidence.ends(node) {
            let member = end / 2;
            if !self.order.is_first_at(end, node) {
                continue;
            }
            let length = self.network.placement(member).length();
            if let Some(chart) = self.network.chart(member, &self.at, length) {
                self.objects.push_chart(&chart, member * 2 * MOST_FREEDOMS, &mut self.total);
            }
        }
    }

    /// Joins the last objects at a node, with the body there.
    fn join(&mut self, node: usize, from: usize) {
        let places = self.objects.last(from);
        let mut units = NodeUnits::new();
        for place in places.clone() {
            let variable = &self.objects.variables[place];
            self.is_here[place] = self.order.incidence.node(end_of(variable)) == node;
            if self.is_here[place] {
                units.include(variable);
            }
        }
        let (body, motions) = self.network.node(node);
        let square = self.at.lambda_squared.size().first();
        let units = units.units([body.mass, body.inertia].map(|inertia| square * inertia.to_f64()));
        let mut variables = [Variable::NONE; MOST_FREEDOMS];
        for (motion, variable) in variables.iter_mut().enumerate() {
            variable.is_rotation = motions.is_rotation(motion);
            variable.unit = units.of(variable.is_rotation);
        }
        let variables = &variables[..motions.count];
        for place in places {
            self.roles[place] = self.role(place, variables, units);
        }
        let joint = Joint { motions: variables, from, roles: &self.roles };
        self.front.join(&self.objects, &joint, &mut self.total);
        self.add_body(body, motions, variables);
    }

    /// What a variable becomes in the front of a node.
    fn role(&mut self, place: usize, motions: &[Variable], units: Units) -> Role<S> {
        let variable = self.objects.variables[place];
        let unit = units.of(variable.is_rotation);
        if !self.is_here[place] {
            // the unit of a front is no smaller than that of its node
            let is_own = variable.measure != Measure::Nothing;
            return Role::Boundary(if is_own { unit.max(variable.unit) } else { unit });
        }
        let end = end_of(&variable);
        let member = self.network.placement(end / 2);
        let freedom = variable.label % MOST_FREEDOMS;
        if member.releases(end % 2, freedom) {
            return if variable.is_force { Role::Absent } else { Role::Released(unit) };
        }
        if !variable.is_force {
            self.objects.restrain(place, unit, &mut self.front, &mut self.total);
        }
        let variable = &self.objects.variables[place];
        let mut row = member.row::<S>(end % 2, freedom, self.network.node(self.order.incidence.node(end)).1);
        // the row of a force stands in the unit of the node, that of a displacement in its own
        let own = if variable.is_force { unit } else { variable.unit };
        for (coefficient, motion) in row.iter_mut().zip(motions) {
            *coefficient = coefficient.times_power_of_two(motion.unit - own);
        }
        if variable.is_force { Role::Force(unit, row) } else { Role::Displacement(row) }
    }

    /// Adds the inertia of the body at a node: `λ² M` over its motions.
    fn add_body(&mut self, node: &Node<Y::Parameter>, motions: &Motions<Y::Parameter>, variables: &[Variable]) {
        if node.mass.vanishes() && node.inertia.vanishes() {
            return;
        }
        // of all three displacements by all motions, and then of all motions by these
        let rows = node.mass_matrix::<S>().map(|row| motions.parts_of(row));
        for (l, other) in variables.iter().enumerate() {
            let column = motions.parts_of(rows.map(|row| row[l]));
            for (k, one) in variables.iter().enumerate().take(l + 1) {
                let term = self.at.lambda_squared * column[k];
                self.front.add(k, l, term.times_power_of_two(one.unit + other.unit));
            }
        }
    }
}
