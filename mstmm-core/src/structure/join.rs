//! A member joins the factor: its displacements are sums of the motions of its nodes.

use crate::model::EndMotion;
use crate::number::{Scalar, Size, power_of_two};
use crate::structure::chart::{MOST_FREEDOMS, MOST_MOTIONS, MOST_VARIABLES};
use crate::structure::factor::Factor;
use crate::structure::member::{Kind, MemberStiffness};
use crate::structure::node_unknowns::NodeUnknowns;

/// A usual size of the flexibility of a border, in the units of its chart. It is a border where that is less than 1e-3, and may vanish.
const FLEXIBILITY: f64 = 1e-6;

/// What a variable of a member is of the unknowns.
#[derive(Clone, Copy)]
struct Sum<S> {
    slots: [u32; MOST_MOTIONS],
    coefficients: [S; MOST_MOTIONS],
    count: usize,
}

impl<S: Scalar> Sum<S> {
    /// Nothing.
    fn none() -> Self {
        Sum { slots: [0; MOST_MOTIONS], coefficients: [S::zero(); MOST_MOTIONS], count: 0 }
    }

    /// An unknown.
    fn of(slot: u32) -> Self {
        let mut sum = Sum::none();
        (sum.slots[0], sum.coefficients[0], sum.count) = (slot, S::one(), 1);
        sum
    }

    /// The displacement of an end in a freedom, in its unit.
    fn of_end(member: &MemberStiffness<S>, end: usize, freedom: usize, node: &NodeUnknowns) -> Self {
        let power = power_of_two(-member.unit(freedom));
        let mut sum = Sum::none();
        for (motion, slot) in node.slots() {
            let coefficient = member.rows[end][freedom][motion];
            if !coefficient.is_constant_zero() {
                (sum.slots[sum.count], sum.coefficients[sum.count]) = (slot, coefficient.scaled(power));
                sum.count += 1;
            }
        }
        sum
    }

    /// The terms.
    fn terms(&self) -> impl Iterator<Item = (u32, S)> {
        self.slots.into_iter().zip(self.coefficients).take(self.count)
    }
}

impl<S: Scalar> Factor<'_, S> {
    /// Adds a member, whose nodes have entered.
    pub(super) fn join(&mut self, member: &mut MemberStiffness<S>, nodes: [&NodeUnknowns; 2]) {
        self.works[0] += member.work;
        self.total.include(member.chart.product, member.chart.below);
        let kinds = &member.kinds[..member.count()];
        if kinds.iter().all(|kind| matches!(kind, Kind::Tied | Kind::Held)) {
            self.join_tied(member, nodes);
        } else {
            self.join_others(member, nodes);
        }
    }

    /// Adds a member all of whose displacements are those of its nodes: block by block of both ends `TᵀKT`, with the rows T.
    fn join_tied(&mut self, member: &MemberStiffness<S>, nodes: [&NodeUnknowns; 2]) {
        let freedoms = member.chart.freedoms.count();
        let mut rows = [[[S::zero(); MOST_MOTIONS]; MOST_FREEDOMS]; 2];
        let is_tied = [0, freedoms].map(|first| member.kinds[first] == Kind::Tied);
        for end in (0..2).filter(|end| is_tied[*end]) {
            for (place, row) in rows[end].iter_mut().enumerate().take(freedoms) {
                let freedom = member.places[place].1;
                let power = power_of_two(-member.unit(freedom));
                for (motion, slot) in nodes[end].slots() {
                    let entry = &mut row[motion];
                    *entry = member.rows[end][freedom][motion].scaled(power);
                    // the unit of a chart is a usual size of its stiffness
                    let size = entry.size().first();
                    self.note(slot, size * size);
                }
            }
        }
        for [one, other] in [[0, 0], [1, 0], [1, 1]].into_iter().filter(|pair| pair.iter().all(|end| is_tied[*end])) {
            let motions = [one, other].map(|end| nodes[end].count as usize);
            let mut block = [[S::zero(); MOST_MOTIONS]; MOST_MOTIONS];
            for place in 0..freedoms {
                for column in 0..motions[1] {
                    let mut sum = S::zero();
                    for (beside, row) in rows[other].iter().enumerate().take(freedoms) {
                        let entry = member.entry(one * freedoms + place, other * freedoms + beside);
                        if !(row[column].is_constant_zero() || entry.is_constant_zero()) {
                            sum += entry.times_real(row[column]);
                        }
                    }
                    let first = if one == other { column } else { 0 };
                    for (motion, line) in block.iter_mut().enumerate().take(motions[0]).skip(first) {
                        let of_row = rows[one][place][motion];
                        if !of_row.is_constant_zero() {
                            line[column] += sum.times_real(of_row);
                        }
                    }
                }
            }
            self.add_block(&block, [nodes[one], nodes[other]], one == other);
        }
        if let Some(loads) = member.loads() {
            for (load, (end, freedom)) in loads.into_iter().zip(member.places).take(member.count()) {
                if is_tied[end] {
                    self.push(load, &Sum::of_end(member, end, freedom, nodes[end]));
                }
            }
        }
    }

    /// Adds a block between the motions of two nodes, or its lower triangle on the diagonal.
    fn add_block(&mut self, block: &[[S; MOST_MOTIONS]; MOST_MOTIONS], nodes: [&NodeUnknowns; 2], is_diagonal: bool) {
        for (motion, slot) in nodes[0].slots() {
            for (column, other) in nodes[1].slots() {
                if is_diagonal && column > motion {
                    continue;
                }
                let entry = block[motion][column];
                // both ends of the member may be joined to one node
                let is_double = !is_diagonal && slot == other;
                self.add(slot, other, if is_double { entry + entry } else { entry });
            }
        }
    }

    /// Adds a member with unknowns of its own.
    fn join_others(&mut self, member: &mut MemberStiffness<S>, nodes: [&NodeUnknowns; 2]) {
        let count = member.count();
        // of each variable its displacement, and of one that is an unknown itself that one
        let (mut displacements, mut own) = ([Sum::none(); MOST_VARIABLES], [Sum::none(); MOST_VARIABLES]);
        for variable in 0..count {
            let kind = member.kinds[variable];
            if kind.is_own() {
                let (number, slot) = self.enter(kind.is_border());
                member.unknowns[variable] = number;
                self.note(slot, FLEXIBILITY);
                own[variable] = Sum::of(slot);
            }
            let (end, freedom) = member.places[variable];
            displacements[variable] = match kind {
                Kind::Tied | Kind::Border => Sum::of_end(member, end, freedom, nodes[end]),
                Kind::Loose => own[variable],
                Kind::Held | Kind::HeldBorder | Kind::Released => Sum::none(),
            };
        }
        for (slot, coefficient) in displacements.iter().flat_map(Sum::terms) {
            let size = coefficient.size().first();
            self.note(slot, size * size);
        }
        let loads = member.loads();
        self.add_displacements(member, &displacements, loads.as_ref());
        if member.kinds[..count].iter().any(|kind| kind.is_border()) {
            self.add_borders(member, &displacements, &own, loads.as_ref());
        }
        own.iter().flat_map(Sum::terms).for_each(|(slot, _)| self.wait(slot));
    }

    /// Adds the stiffness over displacements.
    fn add_displacements(
        &mut self,
        member: &MemberStiffness<S>,
        displacements: &[Sum<S>; MOST_VARIABLES],
        loads: Option<&[S; MOST_VARIABLES]>,
    ) {
        for row in (0..member.count()).filter(|row| member.kinds[*row].moves()) {
            for column in (0..=row).filter(|column| member.kinds[*column].moves()) {
                self.add_product(member.entry(row, column), &displacements[row], &displacements[column], row == column);
            }
            if let Some(loads) = loads {
                self.push(loads[row], &displacements[row]);
            }
        }
    }

    /// Adds the borders `[[R, gᵀ], [g, -σ]]`, with the unknown `f - g y` in the place of the force f: `[[R + gᵀ(2 - σ)g, gᵀ(1 - σ)], .., -σ]`.
    /// That is another basis of the same form. Without it a row of R is zero, and the sum over several members may vanish at each frequency.
    fn add_borders(
        &mut self,
        member: &MemberStiffness<S>,
        displacements: &[Sum<S>; MOST_VARIABLES],
        own: &[Sum<S>; MOST_VARIABLES],
        loads: Option<&[S; MOST_VARIABLES]>,
    ) {
        let count = member.count();
        let is_border = |variable: &usize| member.kinds[*variable].is_border();
        for border in (0..count).filter(is_border) {
            let mut couplings = [S::zero(); MOST_VARIABLES];
            for (variable, coupling) in couplings.iter_mut().enumerate().take(count) {
                *coupling = member.coupling(border, variable);
            }
            for row in 0..count {
                // the row of (1 - σ) g; with one g more that of (2 - σ) g
                let once = (0..count).filter(is_border).fold(couplings[row], |sum, other| {
                    let entry = member.entry(border, other);
                    if entry.is_constant_zero() { sum } else { sum + entry * member.coupling(other, row) }
                });
                let twice = once + couplings[row];
                for (column, displacement) in displacements.iter().enumerate().take(count) {
                    if !(couplings[column].is_constant_zero() || twice.is_constant_zero()) {
                        // each pair is met twice, and stands twice in the form
                        let entry = (couplings[column] * twice).times_power_of_two(-1);
                        self.add_product(entry, &displacements[row], displacement, false);
                    }
                }
                self.add_product(once, &own[border], &displacements[row], false);
                if let Some(loads) = loads {
                    self.push(couplings[row] * loads[border], &displacements[row]);
                }
            }
            for other in (0..=border).filter(is_border) {
                self.add_product(member.entry(border, other), &own[border], &own[other], border == other);
            }
            if let Some(loads) = loads {
                self.push(loads[border], &own[border]);
            }
        }
    }

    /// Adds an entry between two variables, which stands twice in the form, or once on the diagonal.
    fn add_product(&mut self, entry: S, row: &Sum<S>, column: &Sum<S>, is_diagonal: bool) {
        if entry.is_constant_zero() {
            return;
        }
        for (one, of_one) in row.terms() {
            let scaled = entry.times_real(of_one);
            for (other, of_other) in column.terms() {
                if is_diagonal && other > one {
                    continue;
                }
                let term = scaled.times_real(of_other);
                let is_double = !is_diagonal && one == other;
                self.add(one, other, if is_double { term + term } else { term });
            }
        }
    }

    /// Adds what the potential grows by with a variable: a force, negative.
    fn push(&mut self, load: S, sum: &Sum<S>) {
        if load.is_zero() {
            return;
        }
        for (slot, coefficient) in sum.terms() {
            self.add_load(slot, -load.times_real(coefficient));
        }
    }

    /// Adds the body of a node and the forces on its motions, and lets these leave.
    pub(super) fn take_up(
        &mut self,
        node: &NodeUnknowns,
        body: &Option<[[S; MOST_MOTIONS]; MOST_MOTIONS]>,
        forces: &[S; MOST_MOTIONS],
    ) {
        for (row, slot) in node.slots() {
            if let Some(entries) = body {
                for (column, other) in node.slots().take_while(|(column, _)| *column <= row) {
                    self.add(slot, other, entries[row][column]);
                }
            }
            self.add_load(slot, forces[row]);
        }
        self.leave_node(node);
    }

    /// The motion of both ends of a member under a load.
    pub(super) fn motion(
        &self,
        member: &MemberStiffness<S>,
        nodes: [&NodeUnknowns; 2],
        load: usize,
    ) -> [EndMotion<S>; 2] {
        let (mut displacements, mut own) = ([S::zero(); MOST_VARIABLES], [S::zero(); MOST_VARIABLES]);
        let of_nodes = nodes.map(|node| self.values_of(node, load));
        for variable in 0..member.count() {
            let kind = member.kinds[variable];
            if kind.is_own() {
                own[variable] = self.value(member.unknowns[variable], load);
            }
            let (end, freedom) = member.places[variable];
            displacements[variable] = match kind {
                Kind::Tied | Kind::Border => {
                    let terms = member.rows[end][freedom].iter().zip(of_nodes[end]);
                    let terms = terms.take(nodes[end].count as usize).filter(|(coefficient, _)| !coefficient.is_zero());
                    let displacement =
                        terms.fold(S::zero(), |sum, (coefficient, value)| sum + value.times_real(*coefficient));
                    displacement.scaled(power_of_two(-member.unit(freedom)))
                }
                Kind::Loose => own[variable],
                Kind::Held | Kind::HeldBorder | Kind::Released => S::zero(),
            };
        }
        member.motion(&displacements, &own)
    }
}
