//! The evaluation of a network: its nodes are eliminated one after the other.

use crate::element::{MemberChart, MemberElement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar, Scaled, Size};
use crate::pass::characteristic::Characteristic;
use crate::pass::network::node::{Motions, Node};
use crate::pass::network::structure::Network;
use crate::subspace::{
    Choice, Front, Joint, MOST_FREEDOMS, NodeUnits, Objects, Role, RootCounter, Total, Units, Variable,
};

/// Number of roundings that add up in the row of a pivot, in units of the largest one.
const ROUNDINGS: f64 = 4.0;

/// The end of a member to which a variable belongs.
fn end_of(variable: &Variable) -> usize {
    variable.label / MOST_FREEDOMS
}

impl<E, S, const WIDTH: usize> Characteristic<S> for Network<'_, E, WIDTH>
where
    E: MemberChart<S>,
    S: Frequency<E::Parameter>,
{
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        let total = Evaluation::new(self, x).eliminated(Choice::Largest);
        if C::WATCHES && total.has_vanished {
            counter.cancelled(true);
        }
        if counter.looks_at_root() {
            let [row, error] = total.smallest_row;
            counter.root_sum(S::Size::of(row), S::Size::of(ROUNDINGS * error));
            // another choice of pivots rounds otherwise: what differs is decided by rounding
            let other = Evaluation::new(self, x).eliminated(Choice::InOrder);
            if other.below != total.below {
                counter.cancelled(false);
            }
        }
        counter.eliminated(total.below);
        // in extended precision a row of rounding alone is zero: there is nothing further that could tell
        if S::IS_EXTENDED && total.has_vanished { Scaled::new(S::zero(), 0) } else { total.delta() }
    }
}

/// An evaluation at work.
struct Evaluation<'a, 'n, E: MemberElement, S: Scalar, const WIDTH: usize> {
    network: &'a Network<'n, E, WIDTH>,
    at: FrequencyPowers<S>,
    objects: Objects<S, WIDTH>,
    front: Front<S, WIDTH>,
    total: Total<S>,
    /// Whether each variable belongs to an end at the node, and what it becomes there.
    is_here: [bool; WIDTH],
    roles: [Role<S>; WIDTH],
}

impl<'a, 'n, E, S, const WIDTH: usize> Evaluation<'a, 'n, E, S, WIDTH>
where
    E: MemberChart<S>,
    S: Frequency<E::Parameter>,
{
    fn new(network: &'a Network<'n, E, WIDTH>, x: S) -> Self {
        let at = FrequencyPowers::new(x, true);
        Evaluation {
            network,
            at,
            objects: Objects::new(),
            front: Front::new(),
            total: Total::new(),
            is_here: [false; WIDTH],
            roles: [Role::Absent; WIDTH],
        }
    }

    /// Eliminates all nodes.
    fn eliminated(mut self, choice: Choice) -> Total<S> {
        for &node in self.network.order {
            let from = self.objects.len() - self.network.taken_up[node];
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
        for &end in self.network.incidence.ends(node) {
            if self.network.is_first_at(end, node)
                && let Some(member) = &self.network.members[end / 2]
            {
                let chart = E::chart(&member.built, &self.at, member.length(self.network.motions_of(end / 2)));
                self.objects.push_chart(&chart, end / 2 * 2 * MOST_FREEDOMS, &mut self.total);
            }
        }
    }

    /// Joins the last objects at a node, with the body there.
    fn join(&mut self, node: usize, from: usize) {
        let places = self.objects.last(from);
        let mut units = NodeUnits::new();
        for place in places.clone() {
            let variable = &self.objects.variables[place];
            self.is_here[place] = self.network.incidence.node(end_of(variable)) == node;
            if self.is_here[place] {
                units.include(variable);
            }
        }
        let Node { mass, inertia, .. } = self.network.nodes[node];
        let square = self.at.lambda_squared.size().first();
        let units = units.units([mass, inertia].map(|inertia| square * inertia.to_f64()));
        let motions = &self.network.motions[node];
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
        self.add_body(node, motions, variables);
    }

    /// What a variable becomes in the front of a node.
    fn role(&mut self, place: usize, motions: &[Variable], units: Units) -> Role<S> {
        let variable = self.objects.variables[place];
        let unit = units.of(variable.is_rotation);
        if !self.is_here[place] {
            // the unit of a front is no smaller than that of its node
            return Role::Boundary(unit.max(variable.unit));
        }
        let end = end_of(&variable);
        let Some(member) = &self.network.members[end / 2] else { return Role::Absent };
        let freedom = member.freedom(variable.label % MOST_FREEDOMS);
        if member.releases(end % 2, freedom) {
            return if variable.is_force { Role::Absent } else { Role::Released(unit) };
        }
        if !variable.is_force {
            self.objects.restrain(place, unit, &mut self.front, &mut self.total);
        }
        let variable = &self.objects.variables[place];
        let mut row = member.row::<S>(end % 2, freedom, self.network.motions_of(end / 2));
        // the row of a force stands in the unit of the node, that of a displacement in its own
        let own = if variable.is_force { unit } else { variable.unit };
        for (coefficient, motion) in row.iter_mut().zip(motions) {
            *coefficient = coefficient.times_power_of_two(motion.unit - own);
        }
        if variable.is_force { Role::Force(unit, row) } else { Role::Displacement(row) }
    }

    /// Adds the inertia of the body at a node: `λ² M` over its motions.
    fn add_body(&mut self, node: usize, motions: &Motions<E::Parameter>, variables: &[Variable]) {
        let node = &self.network.nodes[node];
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
