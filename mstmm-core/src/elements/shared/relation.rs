//! The relation between both ends of a beam, given its transfer matrix and the minors of that: its chart.

use crate::elements::shared::chart_form::{Factors, Form};
use crate::elements::shared::compound::Units;
use crate::number::{Scalar, Scaled, Size};
use crate::structure::Chart;

/// Places of the entries of a state: displacements Y and Θ, and their forces Q and M.
const DISPLACEMENTS: [usize; 2] = [0, 1];
const FORCES: [usize; 2] = [3, 2];
/// Signs of these forces on the beam at its input end; at its output end they are turned round.
const SIGNS: [f64; 2] = [1.0, -1.0];

/// A choice of variables at an end: whether that of the deflection and that of the rotation is a force.
type Kinds = [bool; 2];

/// The kinds of an end, and the minor of a compound that stands for each.
const KINDS: [(Kinds, usize); 4] = [([false; 2], 0), ([false, true], 1), ([true, false], 3), ([true; 2], 4)];

/// The variables of an end, as entries of a state.
fn variables(kinds: Kinds) -> [usize; 2] {
    [0, 1].map(|k| if kinds[k] { FORCES[k] } else { DISPLACEMENTS[k] })
}

/// The minor of a pair of entries among those of a compound, and whether the pair stands in the other order.
fn minor_of([first, second]: [usize; 2]) -> (usize, bool) {
    let index = match (first.min(second), first.max(second)) {
        (0, 1) => 0,
        (0, 2) => 1,
        (1, 3) => 3,
        (2, 3) => 4,
        _ => 2,
    };
    (index, first > second)
}

/// The transfer matrix of a beam over `Y, Θ, M, Q`, and its second compound over `YΘ, YM, w, ΘQ, MQ`, in units in which the beam has neither stiffness nor
/// length, over a power of two.
pub(crate) struct Compound<S> {
    pub(crate) minors: [[S; 5]; 5],
    pub(crate) states: [[S; 4]; 4],
    pub(crate) exponent: i32,
}

/// The relation between both ends of a beam: its compound, and its transfer matrix over the same power of two.
pub(crate) struct Relation<S: Scalar> {
    compound: [[S; 5]; 5],
    matrix: [[S; 4]; 4],
    /// Units of minors over that of `p_YΘ`.
    units: [S; 5],
    /// The clamped count.
    clamped: S::Size,
    exponent: i32,
}

impl<S: Scalar> Relation<S> {
    /// The relation of a beam, given its compound, the units of minors and the clamped count.
    pub(crate) fn new(compound: Compound<S>, units: &Units<S>, clamped: S::Size) -> Self {
        let Compound { minors, states, exponent } = compound;
        let [first, second, third, fourth] = units.factors;
        Relation {
            compound: minors,
            matrix: states,
            units: [S::one(), first, second, third, fourth],
            clamped,
            exponent,
        }
    }

    /// The minor of two rows and two columns of the transfer matrix; where `{Y, Q}` or `{Θ, M}` is one of both, half of the column of w.
    fn minor(&self, rows: [usize; 2], columns: [usize; 2]) -> S {
        let ((row, is_turned), (column, is_column_turned)) = (minor_of(rows), minor_of(columns));
        let entry = self.compound[row][column];
        let entry = if column == 2 { entry.times_power_of_two(-1) } else { entry };
        if is_turned == is_column_turned { entry } else { -entry }
    }

    /// The minor for kinds at the input end and at the output end: its root is a frequency of the beam whose displacement variables vanish.
    pub(crate) fn divisor(&self, input: usize, output: usize) -> S {
        self.compound[KINDS[output].1][4 - KINDS[input].1]
    }

    /// The kinds of both ends with the largest minor in the units of a chart, so that no entry is large.
    fn best_kinds(&self, chart: &Chart<S>) -> [usize; 2] {
        let powers = [0, 1, 2, 3].map(|k| {
            let unit = |is_rotation: bool, is_force: bool| {
                let unit = chart.units.of(is_rotation);
                if is_force { unit } else { -unit }
            };
            let [deflection, rotation] = KINDS[k].0;
            unit(false, deflection) + unit(true, rotation)
        });
        let size = |input: usize, output: usize| {
            let (row, column) = (KINDS[output].1, 4 - KINDS[input].1);
            let minor = self.compound[row][column] * self.units[row] / self.units[column];
            // dependent variables at the input end have the inverse units
            minor.times_power_of_two(powers[output] + powers[input]).size().first()
        };
        let mut best = ([0, 0], -1.0);
        for input in 0..4 {
            for output in 0..4 {
                let size = size(input, output);
                if size > best.1 {
                    best = ([input, output], size);
                }
            }
        }
        best.0
    }

    /// The number of natural frequencies below with the displacement variables held and the force variables free: each variable that is
    /// freed adds one where the sign of the minor changes.
    pub(crate) fn below(&self, input: usize, output: usize) -> S::Size {
        let mut below = self.clamped;
        let mut negative = self.compound[0][4].is_negative();
        let (mut at_input, mut at_output) = (0, 0);
        let mut free = |is_input: bool, kinds: usize| {
            let place = if is_input { &mut at_input } else { &mut at_output };
            *place = kinds;
            let after = self.divisor(at_input, at_output).is_negative();
            below = below + S::Size::one_if(after ^ negative);
            negative = after;
        };
        for (is_input, kinds) in [(true, input), (false, output)] {
            // by way of a single freed rotation
            if kinds == 3 {
                free(is_input, 1);
            }
            if kinds > 0 {
                free(is_input, kinds);
            }
        }
        below
    }

    /// The form over the variables of these kinds, deflection and rotation of the input end and of the output end.
    fn form(&self, input: usize, output: usize) -> Form<S, 4, 10> {
        let (at_input, at_output) = (KINDS[input].0, KINDS[output].0);
        let opposite = at_input.map(|is_force| !is_force);
        // independent and dependent entries of the states
        let (a, c) = (variables(at_input), variables(opposite));
        let (b, e) = (variables(at_output), variables(at_output.map(|is_force| !is_force)));
        let inverse = S::one() / self.minor(b, c);
        let entry = |row: usize, column: usize| match (row / 2, column / 2, row % 2, column % 2) {
            (0, 0, i, j) => -(self.minor(b, replaced(c, i, a[j])) * inverse),
            (1, 1, i, j) => self.minor(replaced(b, j, e[i]), c) * inverse,
            // the dependent variable of the input end: a row of the inverse of the block of both
            (_, _, j, i) => {
                let cofactor = self.matrix[b[1 - j]][c[1 - i]];
                (if i == j { cofactor } else { -cofactor }) * inverse
            }
        };
        let forces = [at_input[0], at_input[1], at_output[0], at_output[1]];
        let sign = |place: usize| if place < 2 { SIGNS[place] } else { -SIGNS[place - 2] };
        // of a variable as an entry of a state, and of the quantity that belongs to it
        let independent = |place: usize| if forces[place] { sign(place) } else { 1.0 };
        let dependent = |place: usize| if forces[place] { -1.0 } else { sign(place) };
        let mut entries = [S::zero(); 10];
        let mut all = entries.iter_mut();
        for row in 0..4 {
            for column in 0..=row {
                // the relation of the ends is known by the row of the input end
                let (of, by) = if row > 1 && column < 2 { (column, row) } else { (row, column) };
                if let Some(place) = all.next() {
                    *place = entry(row, column).scaled(dependent(of) * independent(by));
                }
            }
        }
        // with the sign of the compound, whatever the order of the variables
        let product = self.divisor(input, output) * self.units[KINDS[output].1] / self.units[4 - KINDS[input].1];
        let count = forces.iter().filter(|is_force| **is_force).count();
        Form {
            entries,
            forces,
            product: Scaled::new(product, i64::from(self.exponent)),
            below: self.below(input, output) + S::Size::of(-(count as f64)),
        }
    }

    /// Enters the bending of the beam into its chart, at the places of deflections and rotations of both ends.
    pub(crate) fn enter(&self, chart: &mut Chart<S>, places: [usize; 4], factors: &Factors<S>) {
        let [input, output] = self.best_kinds(chart);
        self.form(input, output).enter(chart, places, [false, true, false, true], factors);
    }
}

/// A pair with one of its entries replaced.
fn replaced(mut pair: [usize; 2], place: usize, by: usize) -> [usize; 2] {
    pair[place] = by;
    pair
}
