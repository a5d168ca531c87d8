//! The dynamic stiffness of a member: its chart in the displacements of its ends, but for borders.
//!
//! A variable of a chart is flipped where it should be of the other kind. Of an end that moves with its node the displacement is a variable,
//! of a freedom that it does not share the force, which is zero. A flip divides by a diagonal entry. Where that is small the variable stays:
//! the force of a border, or the displacement of a released end, is an unknown of its own.

use crate::model::EndMotion;
use crate::number::{Scalar, Scaled, Size, power_of_two};
use crate::structure::chart::{Chart, JoinedEnd, MOST_FREEDOMS, MOST_MOTIONS, MOST_VARIABLES};
use crate::structure::units::Units;
use mstmm_plan::Freedoms;

/// The diagonal entry of a variable, in the units of its chart, below which it is not flipped. Entries grow by its inverse, and so does the
/// coupling of a border, whose square is added to the stiffness: three digits of sixteen are lost at most.
const SMALL: f64 = 1e-3;

/// What a variable of a member is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The displacement of an end that moves with its node.
    Tied,
    /// The displacement of an end whose node has no motions.
    Held,
    /// The force of a freedom that the end does not share: zero.
    Released,
    /// The displacement of such a freedom: an unknown of its own.
    Loose,
    /// The force of an end that moves with its node: an unknown of its own.
    Border,
    /// The force of an end whose node has no motions: an unknown of its own.
    HeldBorder,
}

impl Kind {
    /// Whether it is an unknown of the member's own.
    pub(crate) fn is_own(self) -> bool {
        matches!(self, Kind::Loose | Kind::Border | Kind::HeldBorder)
    }

    /// Whether it is a force that is not zero.
    pub(crate) fn is_border(self) -> bool {
        matches!(self, Kind::Border | Kind::HeldBorder)
    }

    /// Whether it is a displacement that unknowns change.
    pub(crate) fn moves(self) -> bool {
        matches!(self, Kind::Tied | Kind::Loose)
    }
}

/// What acts on a member, over the variables of its chart: by what the potential grows with each, and by what supports move the ends.
#[derive(Clone, Copy, Debug)]
pub struct MemberLoad<S> {
    pub(crate) along: [S; MOST_VARIABLES],
    pub(crate) moved: [S; MOST_VARIABLES],
}

/// The dynamic stiffness of a member over the displacements of its ends, with its borders.
#[derive(Clone, Copy, Debug)]
pub struct MemberStiffness<S: Scalar> {
    /// Its chart: product and count are its part of Δ and of the count, but for the pivots of the unknowns of its own.
    pub(super) chart: Chart<S>,
    load: Option<MemberLoad<S>>,
    pub(crate) kinds: [Kind; MOST_VARIABLES],
    /// The end and the freedom of each variable.
    pub(crate) places: [(usize, usize); MOST_VARIABLES],
    /// What the displacements of both ends are of the motions of their nodes.
    pub(crate) rows: [[[S; MOST_MOTIONS]; MOST_FREEDOMS]; 2],
    /// The numbers of the unknowns of its own.
    pub(crate) unknowns: [u32; MOST_VARIABLES],
    /// The work of the load on what flips have solved for.
    pub(crate) work: S,
}

impl<S: Scalar> MemberStiffness<S> {
    /// No member.
    pub(crate) fn none() -> Self {
        MemberStiffness {
            chart: Chart::empty(Freedoms::NONE, Units { displacement: 0, rotation: 0 }),
            load: None,
            kinds: [Kind::Held; MOST_VARIABLES],
            places: [(0, 0); MOST_VARIABLES],
            rows: [[[S::zero(); MOST_MOTIONS]; MOST_FREEDOMS]; 2],
            unknowns: [0; MOST_VARIABLES],
            work: S::zero(),
        }
    }

    /// Sets all of it from the chart of a member.
    pub(crate) fn set(&mut self, chart: &Chart<S>, ends: &[JoinedEnd<S>; 2], load: Option<MemberLoad<S>>) {
        (self.chart, self.load, self.work) = (*chart, load, S::zero());
        let mut variable = 0;
        for (end, joined) in ends.iter().enumerate() {
            self.rows[end] = joined.rows;
            for (freedom, kind) in
                Freedoms::SINGLE.into_iter().enumerate().filter(|(_, kind)| chart.freedoms.contains(*kind))
            {
                self.places[variable] = (end, freedom);
                self.kinds[variable] = match (joined.released.contains(kind), joined.rests) {
                    (true, _) => Kind::Released,
                    (false, false) => Kind::Tied,
                    (false, true) => Kind::Held,
                };
                variable += 1;
            }
        }
        self.flip_all();
        for variable in 0..variable {
            let is_force = self.chart.is_force(variable);
            let kind = match (self.kinds[variable], is_force) {
                (Kind::Released, false) => Kind::Loose,
                (Kind::Tied, true) => Kind::Border,
                (Kind::Held, true) => Kind::HeldBorder,
                (kind, _) => kind,
            };
            self.kinds[variable] = kind;
            if kind == Kind::Released {
                self.chart.below = self.chart.below + S::Size::of(1.0);
            }
            if kind.is_own() {
                let sign = if is_force { -S::one() } else { S::one() };
                self.chart.product = self.chart.product.product(Scaled::new(sign, self.pivot_unit(variable)));
            }
        }
    }

    /// Flips all variables that are to be of the other kind and whose entries are not small, the largest one first.
    fn flip_all(&mut self) {
        let (count, freedoms) = (self.count(), self.chart.freedoms.count());
        let mut wrong = [false; MOST_VARIABLES];
        let mut number = 0;
        for (variable, wrong) in wrong.iter_mut().enumerate().take(count) {
            *wrong = self.chart.is_force(variable) != (self.kinds[variable] == Kind::Released);
            number += usize::from(*wrong);
        }
        let (mut product, mut exponent) = (S::one(), 0);
        while number > 0 {
            let (mut largest, mut size) = (0, -1.0);
            for variable in (0..count).filter(|variable| wrong[*variable]) {
                let own = self.chart.entry(variable, variable).size().first();
                if own > size {
                    (largest, size) = (variable, own);
                }
            }
            // no more motions than freedoms are left to a member that is held: as many variables at most must stay as they are
            let least = if number > freedoms { f64::MIN_POSITIVE } else { SMALL };
            if size < least {
                break;
            }
            exponent += self.pivot_unit(largest);
            let is_force = self.chart.is_force(largest);
            let pivot = self.flip(largest);
            product *= if is_force { -pivot } else { pivot };
            (wrong[largest], number) = (false, number - 1);
        }
        self.chart.product = self.chart.product.product(Scaled::new(product, exponent));
    }

    /// Logarithm to base 2 of what the unit of a variable has changed a pivot on it by.
    fn pivot_unit(&self, variable: usize) -> i64 {
        let unit = i64::from(self.unit(self.places[variable].1));
        if self.chart.is_force(variable) { 2 * unit } else { -2 * unit }
    }

    /// The number of its variables.
    pub(crate) fn count(&self) -> usize {
        2 * self.chart.freedoms.count()
    }

    /// An entry of its matrix.
    pub(crate) fn entry(&self, row: usize, column: usize) -> S {
        self.chart.entry(row, column)
    }

    /// Logarithm to base 2 of the unit of a displacement.
    pub(crate) fn unit(&self, freedom: usize) -> i32 {
        self.chart.units.of(Freedoms::SINGLE[freedom].is(Freedoms::RZ))
    }

    /// Makes a variable one of the other kind, with the load, whose potential is `lᵀx` more: `l_i - M_ik l_k/d` and `l_k/d`, negative where it was
    /// a force. Returns the entry that divides.
    fn flip(&mut self, variable: usize) -> S {
        if let Some(load) = &mut self.load {
            let row = self.chart.row(variable);
            let own = load.along[variable];
            let share = own / row[variable];
            for (along, entry) in load.along.iter_mut().zip(row) {
                *along -= entry * share;
            }
            self.work += own * share;
            load.along[variable] = if self.chart.is_force(variable) { -share } else { share };
        }
        self.chart.flip(variable)
    }

    /// What the potential grows by with each variable, under the load and where supports move ends; none without a load.
    pub(crate) fn loads(&self) -> Option<[S; MOST_VARIABLES]> {
        let MemberLoad { along, moved } = self.load?;
        let count = self.count();
        let mut loads = along;
        for (variable, moved) in moved.iter().enumerate().take(count).filter(|(_, moved)| !moved.is_zero()) {
            match self.kinds[variable] {
                Kind::Tied | Kind::Held => {
                    for (row, load) in loads.iter_mut().enumerate().take(count) {
                        *load += self.entry(row, variable) * *moved;
                    }
                }
                Kind::Border | Kind::HeldBorder => loads[variable] += *moved,
                // a constant more or less is nothing to a variable of its own
                Kind::Released | Kind::Loose => {}
            }
        }
        Some(loads)
    }

    /// What a border is coupled to, the displacement of a variable; of a border itself that of its end.
    pub(crate) fn coupling(&self, border: usize, variable: usize) -> S {
        match self.kinds[variable] {
            _ if border == variable => S::one(),
            Kind::Tied | Kind::Loose => self.entry(border, variable),
            _ => S::zero(),
        }
    }

    /// The motion of both ends, given the displacements that unknowns give the variables, and the values of the unknowns of its own.
    pub(crate) fn motion(&self, displacements: &[S; MOST_VARIABLES], own: &[S; MOST_VARIABLES]) -> [EndMotion<S>; 2] {
        let count = self.count();
        let zero = [S::zero(); MOST_VARIABLES];
        let MemberLoad { along, moved } = self.load.unwrap_or(MemberLoad { along: zero, moved: zero });
        let mut values = zero;
        for variable in 0..count {
            values[variable] = match self.kinds[variable] {
                Kind::Tied => displacements[variable] + moved[variable],
                Kind::Held => moved[variable],
                Kind::Released => S::zero(),
                Kind::Loose => own[variable],
                Kind::Border | Kind::HeldBorder => {
                    let mut force = own[variable];
                    for (other, displacement) in displacements.iter().enumerate().take(count) {
                        let moves = self.kinds[other].moves() || other == variable;
                        if moves {
                            force += self.coupling(variable, other) * *displacement;
                        }
                    }
                    force
                }
            };
        }
        let mut ends = self.chart.motion(&values, &along);
        // an end moves as its node does: what the force of a border makes of it is that but for rounding, and for a dislocation
        for variable in (0..count).filter(|variable| self.kinds[*variable].is_border()) {
            let (end, freedom) = self.places[variable];
            let displacement = displacements[variable] + moved[variable];
            ends[end].displacements[freedom] = displacement.scaled(power_of_two(self.unit(freedom)));
        }
        ends
    }
}
