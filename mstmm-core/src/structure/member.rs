//! The dynamic stiffness of a member: its chart in the displacements of its ends, but for borders.
//!
//! A variable of a chart is flipped where it should be of the other kind. Of an end that moves with its node the displacement is a variable,
//! of a freedom that it does not share the force, which is zero. A flip divides by a diagonal entry. Where that is small the variable stays:
//! the force of a border, or the displacement of a released end, is an unknown of its own.

use crate::model::EndMotion;
use crate::number::{Scalar, Scaled, Size, power_of_two};
use crate::structure::chart::{Chart, JoinedEnd, MOST_FREEDOMS, MOST_VARIABLES};
use crate::structure::units::Units;
use mstmm_plan::Freedoms;

/// The diagonal entry of a variable, in the units of its chart, below which it is not flipped. Entries grow by its inverse, and so does the
/// coupling of a border, whose square is added to the stiffness.
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
    chart: Chart<S>,
    load: MemberLoad<S>,
    pub(crate) kinds: [Kind; MOST_VARIABLES],
    /// The end and the freedom of each variable.
    pub(crate) places: [(usize, usize); MOST_VARIABLES],
    /// What the displacements of both ends are of the motions of their nodes.
    pub(crate) rows: [[[S; MOST_FREEDOMS]; MOST_FREEDOMS]; 2],
    /// The numbers of the unknowns of its own.
    pub(crate) unknowns: [u32; MOST_VARIABLES],
    /// The work of the load on what flips have solved for.
    pub(crate) work: S,
}

impl<S: Scalar> MemberStiffness<S> {
    /// No member.
    pub(crate) fn none() -> Self {
        let zero = [S::zero(); MOST_VARIABLES];
        MemberStiffness {
            chart: Chart::empty(Freedoms::NONE, Units { displacement: 0, rotation: 0 }),
            load: MemberLoad { along: zero, moved: zero },
            kinds: [Kind::Held; MOST_VARIABLES],
            places: [(0, 0); MOST_VARIABLES],
            rows: [[[S::zero(); MOST_FREEDOMS]; MOST_FREEDOMS]; 2],
            unknowns: [0; MOST_VARIABLES],
            work: S::zero(),
        }
    }

    /// Sets all of it from the chart of a member.
    pub(crate) fn set(&mut self, chart: &Chart<S>, ends: &[JoinedEnd<S>; 2], load: &MemberLoad<S>) {
        let member = self;
        (member.chart, member.load, member.rows) = (*chart, *load, [ends[0].rows, ends[1].rows]);
        let count = member.count();
        let mut is_released = [false; MOST_VARIABLES];
        let mut rests = [false; MOST_VARIABLES];
        let own = |end| {
            (0..3).filter(|freedom| chart.freedoms.contains(Freedoms::SINGLE[*freedom])).map(move |own| (end, own))
        };
        for (variable, place) in own(0).chain(own(1)).enumerate() {
            member.places[variable] = place;
            let (end, freedom) = place;
            is_released[variable] = ends[end].released.contains(Freedoms::SINGLE[freedom]);
            rests[variable] = ends[end].rests;
        }
        loop {
            let wrong = (0..count).filter(|variable| member.chart.is_force(*variable) != is_released[*variable]);
            let size = |variable: usize| member.chart.entry(variable, variable).size().first();
            let number = wrong.clone().count();
            let Some(largest) = wrong.max_by(|one, other| size(*one).total_cmp(&size(*other))) else { break };
            // no more motions than freedoms are left to a member that is held: as many variables at most must stay as they are
            let least = if number > chart.freedoms.count() { f64::MIN_POSITIVE } else { SMALL };
            if size(largest) < least || size(largest).is_nan() {
                break;
            }
            member.flip(largest);
        }
        for variable in 0..count {
            member.kinds[variable] = match (is_released[variable], member.chart.is_force(variable), rests[variable]) {
                (true, true, _) => Kind::Released,
                (true, false, _) => Kind::Loose,
                (false, false, false) => Kind::Tied,
                (false, false, true) => Kind::Held,
                (false, true, false) => Kind::Border,
                (false, true, true) => Kind::HeldBorder,
            };
            match member.kinds[variable] {
                kind if kind.is_own() => member.multiply(variable, S::one()),
                Kind::Released => member.chart.below = member.chart.below + S::Size::of(1.0),
                _ => {}
            }
        }
    }

    /// Multiplies the product by the pivot of a variable, in the unit of that.
    fn multiply(&mut self, variable: usize, pivot: S) {
        let unit = i64::from(self.unit(self.places[variable].1));
        let pivot =
            if self.chart.is_force(variable) { Scaled::new(-pivot, 2 * unit) } else { Scaled::new(pivot, -2 * unit) };
        self.chart.product = self.chart.product.product(pivot);
    }

    /// The number of its variables.
    pub(crate) fn count(&self) -> usize {
        2 * self.chart.freedoms.count()
    }

    /// Its part of Δ, but for the pivots of the unknowns of its own.
    pub(crate) fn product(&self) -> Scaled<S> {
        self.chart.product
    }

    /// Its part of the count, likewise.
    pub(crate) fn below(&self) -> S::Size {
        self.chart.below
    }

    /// An entry of its matrix.
    pub(crate) fn entry(&self, row: usize, column: usize) -> S {
        self.chart.entry(row, column)
    }

    /// Logarithm to base 2 of the unit of a displacement.
    pub(crate) fn unit(&self, freedom: usize) -> i32 {
        self.chart.units.of(Freedoms::SINGLE[freedom].is(Freedoms::RZ))
    }

    /// Makes a variable one of the other kind.
    ///
    /// The potential is `Π = xᵀMx/2 + lᵀx`. The gradient at a displacement is its force, at a force its displacement, negative. Solved for the
    /// variable, and put into the other gradients, `M_ij - M_ik M_kj/d` with `d = M_kk`, `M_kj/d`, negative where it was a force, and `-1/d`.
    fn flip(&mut self, variable: usize) {
        let count = self.count();
        let mut row = [S::zero(); MOST_VARIABLES];
        for (other, entry) in row.iter_mut().enumerate().take(count) {
            *entry = self.chart.entry(variable, other);
        }
        let pivot = row[variable];
        let inverse = S::one() / pivot;
        let load = self.load.along[variable];
        let signed = if self.chart.is_force(variable) { -inverse } else { inverse };
        for one in (0..count).filter(|one| *one != variable && !row[*one].is_constant_zero()) {
            let factor = row[one] * inverse;
            for other in (0..=one).filter(|other| *other != variable && !row[*other].is_constant_zero()) {
                let entry = self.chart.entry(one, other) - factor * row[other];
                self.chart.set(one, other, entry);
            }
            self.chart.set(one, variable, row[one] * signed);
            if !load.is_zero() {
                self.load.along[one] -= factor * load;
            }
        }
        self.chart.set(variable, variable, -inverse);
        self.multiply(variable, pivot);
        let becomes_force = !self.chart.is_force(variable);
        self.chart.below =
            self.chart.below + S::Size::one_if(pivot.is_negative()) + S::Size::of(-f64::from(becomes_force));
        self.chart.forces ^= 1 << variable;
        if !load.is_zero() {
            self.work += load * load * inverse;
            self.load.along[variable] = load * signed;
        }
    }

    /// What the potential grows by with each variable, under the load and where supports move ends.
    pub(crate) fn loads(&self) -> [S; MOST_VARIABLES] {
        let count = self.count();
        let mut loads = self.load.along;
        for (variable, moved) in self.load.moved.iter().enumerate().take(count).filter(|(_, moved)| !moved.is_zero()) {
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
        loads
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
        let mut values = [S::zero(); MOST_VARIABLES];
        for variable in 0..count {
            values[variable] = match self.kinds[variable] {
                Kind::Tied => displacements[variable] + self.load.moved[variable],
                Kind::Held => self.load.moved[variable],
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
        let mut ends = self.chart.motion(&values, &self.load.along);
        // an end moves as its node does: what the force of a border makes of it is that but for rounding, and for a dislocation
        for variable in (0..count).filter(|variable| self.kinds[*variable].is_border()) {
            let (end, freedom) = self.places[variable];
            let displacement = displacements[variable] + self.load.moved[variable];
            ends[end].displacements[freedom] = displacement.scaled(power_of_two(self.unit(freedom)));
        }
        ends
    }
}
