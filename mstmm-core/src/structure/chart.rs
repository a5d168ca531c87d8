//! Charts of members: their relations between both ends as an element gives them.

use crate::model::EndMotion;
use crate::number::{Operation, Products, Scalar, Scaled, Size, power_of_two, with_products};
use crate::structure::triangle;
use crate::structure::units::Units;
use mstmm_plan::Freedoms;

/// Most freedoms of an end of a part of a member, in a plane.
pub const MOST_FREEDOMS: usize = Freedoms::SINGLE.len();

/// Most motions of a node.
pub(crate) const MOST_MOTIONS: usize = Freedoms::EACH.len();

/// Most variables of a member.
pub const MOST_VARIABLES: usize = 2 * MOST_FREEDOMS;

/// Most entries of a member's matrix, of which the lower triangle stands for both.
pub const MOST_ENTRIES: usize = triangle::row(MOST_VARIABLES);

/// A member as a symmetric matrix over displacements and forces of both ends, in its own axes and units.
///
/// The variables are the freedoms of the input end and then those of the output end, each a displacement or its force. A kind for each is
/// chosen with which all entries are bounded.
#[derive(Clone, Copy, Debug)]
pub struct Chart<S: Scalar> {
    /// The freedoms of an end, in the axes of the member.
    pub freedoms: Freedoms,
    /// The lower triangle of the matrix, row after row.
    pub(crate) entries: [S; MOST_ENTRIES],
    /// A bit per variable: whether it is a force.
    pub forces: u32,
    /// Logarithms to base 2 of the units of displacements and of rotations.
    pub(crate) units: Units,
    /// The minor of the subspace for these variables, without units: an entire function.
    pub product: Scaled<S>,
    /// Natural frequencies of the member with its displacement variables held and its force variables free, less the number of forces.
    pub below: S::Size,
}

impl<S: Scalar> Chart<S> {
    /// A chart of displacements without entries.
    pub(crate) fn empty(freedoms: Freedoms, units: Units) -> Self {
        Chart {
            freedoms,
            entries: [S::zero(); MOST_ENTRIES],
            forces: 0,
            units: units.in_range(),
            product: Scaled::new(S::one(), 0),
            below: S::Size::of(0.0),
        }
    }

    /// The entry between two variables.
    #[inline]
    pub fn entry(&self, row: usize, column: usize) -> S {
        self.entries[triangle::place(row, column)]
    }

    /// Sets the entry between two variables.
    #[inline]
    pub(crate) fn set(&mut self, row: usize, column: usize, entry: S) {
        self.entries[triangle::place(row, column)] = entry;
    }

    /// Takes units that are no finer than others.
    pub(crate) fn coarsen(&mut self, others: Units) {
        let units = self.units.coarser(others);
        if units == self.units {
            return;
        }
        let freedoms = Freedoms::SINGLE.into_iter().filter(|kind| self.freedoms.contains(*kind));
        let mut powers = [1.0; MOST_VARIABLES];
        for (place, (power, kind)) in powers.iter_mut().zip(freedoms.clone().chain(freedoms)).enumerate() {
            let is_rotation = kind.is(Freedoms::RZ);
            let by = units.of(is_rotation) - self.units.of(is_rotation);
            *power = power_of_two(if self.is_force(place) { -by } else { by });
        }
        for row in 0..2 * self.freedoms.count() {
            for column in 0..=row {
                self.set(row, column, self.entry(row, column).scaled(powers[row] * powers[column]));
            }
        }
        self.units = units;
    }

    /// Displacements of both ends in the units of the chart, by the places of its variables.
    pub(crate) fn moved(&self, displacements: &[[S; MOST_FREEDOMS]; 2]) -> [S; MOST_VARIABLES] {
        let mut moved = [S::zero(); MOST_VARIABLES];
        let mut place = 0;
        for (freedom, displacement) in displacements.iter().flat_map(|end| Freedoms::SINGLE.into_iter().zip(end)) {
            if self.freedoms.contains(freedom) {
                moved[place] = displacement.scaled(power_of_two(-self.units.of(freedom.is(Freedoms::RZ))));
                place += 1;
            }
        }
        moved
    }

    /// The displacements and forces of both ends, given the values of the variables and what Π grows by with each of them under a load.
    pub(crate) fn motion(&self, values: &[S; MOST_VARIABLES], load: &[S; MOST_VARIABLES]) -> [EndMotion<S>; 2] {
        let mut motions = [EndMotion::at_rest(); 2];
        let mut place = 0;
        for motion in &mut motions {
            for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
                if !self.freedoms.contains(kind) {
                    continue;
                }
                let count = 2 * self.freedoms.count();
                let row = self.row(place);
                let gradient = load[place] - with_products::<S, _>(Work { row: &row[..count], values });
                let value = values[place];
                let [displacement, force] = if self.is_force(place) { [-gradient, value] } else { [value, gradient] };
                let unit = self.units.of(kind.is(Freedoms::RZ));
                motion.displacements[freedom] = displacement.scaled(power_of_two(unit));
                motion.forces[freedom] = force.scaled(power_of_two(-unit));
                place += 1;
            }
        }
        motions
    }

    /// Makes a variable one of the other kind, and counts it. Returns the entry on the diagonal that divides.
    ///
    /// The potential is `Π = xᵀMx/2`. The gradient at a displacement is its force, at a force its displacement, negative. Solved for the
    /// variable, and put into the other gradients, `M_ij - M_ik M_kj/d` with `d = M_kk`, `M_kj/d`, negative where it was a force, and `-1/d`.
    pub(crate) fn flip(&mut self, variable: usize) -> S {
        let count = 2 * self.freedoms.count();
        let row = self.row(variable);
        let (pivot, is_force) = (row[variable], self.is_force(variable));
        let inverse = S::one() / pivot;
        for one in (0..count).filter(|one| *one != variable && !row[*one].is_constant_zero()) {
            let factor = row[one] * inverse;
            let entries = &mut self.entries[triangle::row(one)..triangle::row(one + 1)];
            with_products::<S, _>(SubtractRow { entries, factor, row: &row, but: variable });
            self.set(one, variable, if is_force { -factor } else { factor });
        }
        self.set(variable, variable, -inverse);
        let freed = if is_force { 0.0 } else { -1.0 };
        self.below = self.below + S::Size::one_if(pivot.is_negative()) + S::Size::of(freed);
        self.forces ^= 1 << variable;
        pivot
    }

    /// The row of a variable.
    pub(crate) fn row(&self, variable: usize) -> [S; MOST_VARIABLES] {
        let mut row = [S::zero(); MOST_VARIABLES];
        for (other, entry) in row.iter_mut().enumerate().take(2 * self.freedoms.count()) {
            *entry = self.entry(variable, other);
        }
        row
    }

    /// Whether a variable is a force.
    #[inline]
    pub(crate) fn is_force(&self, place: usize) -> bool {
        self.forces >> place & 1 == 1
    }
}

/// Subtracts a factor times a row of a matrix from another row, but for one entry.
struct SubtractRow<'a, S> {
    entries: &'a mut [S],
    factor: S,
    row: &'a [S; MOST_VARIABLES],
    but: usize,
}

impl<S: Scalar> Operation for SubtractRow<'_, S> {
    type Output = ();

    #[inline(always)]
    fn by<P: Products>(self) {
        for (other, (entry, part)) in self.entries.iter_mut().zip(self.row).enumerate() {
            if other != self.but && !part.is_constant_zero() {
                *entry = entry.less_product::<P>(self.factor, *part);
            }
        }
    }
}

/// The sum of the entries of a row times values, negative.
struct Work<'a, S> {
    row: &'a [S],
    values: &'a [S; MOST_VARIABLES],
}

impl<S: Scalar> Operation for Work<'_, S> {
    type Output = S;

    #[inline(always)]
    fn by<P: Products>(self) -> S {
        let mut sum = S::zero();
        for (entry, value) in self.row.iter().zip(self.values) {
            if !(entry.is_constant_zero() || value.is_constant_zero()) {
                sum = sum.less_product::<P>(*entry, *value);
            }
        }
        sum
    }
}

/// Where an end of a member is joined.
#[derive(Clone, Copy, Debug)]
pub struct JoinedEnd<S> {
    /// The freedoms that the end does not share with the node.
    pub(crate) released: Freedoms,
    /// Whether its displacements vanish.
    pub(crate) rests: bool,
    /// What its displacements along and across the member and its rotation are of the motions of the node.
    pub(crate) rows: [[S; MOST_MOTIONS]; MOST_FREEDOMS],
}
