//! The states of a tree under a load from one system of linear equations in double-double arithmetic: an element's transfer
//! matrix between its ends, equal displacements and balanced forces at connections, supports at tips.
//!
//! Nothing is carried along paths; what grows costs digits, of which there are twice as many.

#![expect(clippy::unwrap_used, reason = "random trees are valid lists")]

pub(crate) use crate::support::tree::Wide;

use crate::support::tree::{Part, Tree};
use mstmm::element::{Coordinate, Space, Support};
use mstmm::list::ListStep;
use mstmm::number::Scalar;
use mstmm_core::Step;

/// A pivot that is none: the equations of a tree that is held twice, or not at all, in some direction.
const SINGULAR: f64 = 1e-25;

/// A row: entries by column, and the right side.
type Row = (Vec<(usize, Wide)>, Wide);

/// The equations of a tree, and where its states stand among the unknowns.
#[derive(Debug)]
pub(crate) struct StateEquations {
    pub(crate) steps: Vec<Step<'static>>,
    /// Space of the state behind each step.
    pub(crate) spaces: Vec<Space>,
    /// Space of connections.
    widest: Vec<Space>,
    first: Vec<usize>,
    pub(crate) unknowns: usize,
}

fn number(value: f64) -> Wide {
    Wide::from_f64(value)
}

fn is_force(coordinate: Coordinate) -> bool {
    matches!(coordinate, Coordinate::M | Coordinate::Q)
}

/// The entries that a support holds at zero.
fn held(support: Support, space: Space) -> Vec<Coordinate> {
    use Coordinate::{M, Q, Theta, Y};
    let held = match support {
        Support::Fixed => [Y, Theta],
        Support::Pinned => [Y, M],
        Support::Guided => [Theta, Q],
        _ => [M, Q],
    };
    held.into_iter().filter(|coordinate| space.coordinates().contains(coordinate)).collect()
}

/// The inputs of the steps of a tree: a connection takes the last open paths.
pub(crate) fn steps_of(tree: &Tree) -> Vec<Step<'static>> {
    let mut open: Vec<usize> = Vec::new();
    let mut steps = Vec::new();
    for (index, step) in tree.iter().enumerate() {
        let step = match *step {
            ListStep::Tip(support) => Step::Tip(support),
            ListStep::Element(part) => Step::Element(open.pop().unwrap(), part.space()),
            ListStep::Connection(count) => Step::Connection(open.split_off(open.len() - count).leak()),
            ListStep::Root(support) => Step::Root(open.pop().unwrap(), support),
        };
        open.push(index);
        steps.push(step);
    }
    steps
}

/// What multiplies each entry of the state behind an element, and those before it: rows of its transfer matrix, of a hinge times its
/// stiffness, which may be zero.
fn relations(part: Part, lambda: Wide) -> Vec<(Wide, Vec<Wide>)> {
    let (freedom, force, stiffness) = match part {
        Part::ShearHinge(hinge) => (0, 3, -hinge.stiffness),
        Part::RotationalHinge(hinge) => (1, 2, hinge.stiffness),
        _ => return part.transfer_matrix(lambda).into_iter().map(|line| (number(1.0), line)).collect(),
    };
    let relation = |row: usize| {
        let factor = if row == freedom { stiffness } else { 1.0 };
        let entry = |column: usize| match column {
            _ if column == row => factor,
            _ if row == freedom && column == force => 1.0,
            _ => 0.0,
        };
        (number(factor), (0..4).map(|column| number(entry(column))).collect())
    };
    (0..4).map(relation).collect()
}

impl StateEquations {
    pub(crate) fn new(tree: &Tree) -> Self {
        let steps = steps_of(tree);
        let count = steps.len();
        let mut below = vec![count; count];
        for (index, step) in steps.iter().enumerate() {
            match *step {
                Step::Tip(_) => {}
                Step::Element(input, _) | Step::Root(input, _) => below[input] = index,
                Step::Connection(inputs) => inputs.iter().for_each(|&input| below[input] = index),
            }
        }
        let mut spaces = vec![Space::Bending; count];
        let mut widest = spaces.clone();
        for index in 0..count {
            let next = steps.get(below[index]);
            let wide = |space: Option<Space>, other: Space| space.map_or(Some(other), |space| space.join(other));
            match steps[index] {
                Step::Element(_, space) => spaces[index] = space,
                Step::Connection(inputs) => {
                    let paths = inputs.iter().filter(|&&input| !matches!(steps[input], Step::Tip(_)));
                    let output = if let Some(Step::Element(_, space)) = next { Some(*space) } else { None };
                    let sum = paths.map(|&input| spaces[input]).fold(output, wide);
                    widest[index] = sum.unwrap_or(Space::Bending);
                    spaces[index] = output.unwrap_or(widest[index]);
                }
                _ => {}
            }
        }
        for index in 0..count {
            if let (Step::Tip(_), Some(next)) = (&steps[index], steps.get(below[index])) {
                spaces[index] = if let Step::Element(_, space) = next { *space } else { widest[below[index]] };
            }
        }
        let mut unknowns = 0;
        let mut first = Vec::new();
        for index in 0..count {
            first.push(unknowns);
            unknowns += match steps[index] {
                Step::Root(..) => 0,
                Step::Connection(_) => spaces[index].size() + widest[index].size() / 2,
                _ => spaces[index].size(),
            };
        }
        StateEquations { steps, spaces, widest, first, unknowns }
    }

    /// The column of an entry of the state behind a step.
    fn column(&self, step: usize, coordinate: Coordinate) -> usize {
        let place = self.spaces[step].coordinates().iter().position(|&own| own == coordinate);
        self.first[step] + place.unwrap_or(usize::MAX)
    }

    /// All states behind the steps, on the upstream side of the load, which is a jump by `jump` in one entry.
    pub(crate) fn solve(
        &self,
        tree: &Tree,
        lambda: Wide,
        at: usize,
        entry: Coordinate,
        jump: f64,
    ) -> Option<Vec<Wide>> {
        let (triangle, _) = triangular(self.rows(tree, lambda, at, entry, jump), self.unknowns);
        solved(triangle)
    }

    /// The determinant of the equations, times a positive number.
    pub(crate) fn determinant(&self, tree: &Tree, lambda: Wide) -> Wide {
        let (triangle, sign) = triangular(self.rows(tree, lambda, 0, Coordinate::Q, 0.0), self.unknowns);
        (0..self.unknowns).fold(number(sign), |product, k| product * triangle[k][k])
    }

    fn rows(&self, tree: &Tree, lambda: Wide, at: usize, entry: Coordinate, jump: f64) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        // a term `factor * entry` of the state on the downstream side of a step
        let add = |row: &mut Row, step: usize, coordinate: Coordinate, factor: Wide| {
            row.0.push((self.column(step, coordinate), factor));
            if step == at && coordinate == entry {
                row.1 -= factor * number(jump);
            }
        };
        let (one, nothing) = (number(1.0), || (Vec::new(), number(0.0)));
        for (index, step) in self.steps.iter().enumerate() {
            match *step {
                Step::Tip(support) => {
                    for coordinate in held(support, self.spaces[index]) {
                        rows.push((vec![(self.column(index, coordinate), one)], number(0.0)));
                    }
                }
                Step::Root(input, support) => {
                    for coordinate in held(support, self.spaces[input]) {
                        let mut row = nothing();
                        add(&mut row, input, coordinate, one);
                        rows.push(row);
                    }
                }
                Step::Element(input, space) => {
                    let ListStep::Element(part) = tree[index] else { continue };
                    let coordinates = space.coordinates();
                    for ((factor, line), &coordinate) in relations(part, lambda).into_iter().zip(coordinates) {
                        let mut row = (vec![(self.column(index, coordinate), -factor)], number(0.0));
                        for (&input_coordinate, factor) in coordinates.iter().zip(line) {
                            add(&mut row, input, input_coordinate, factor);
                        }
                        rows.push(row);
                    }
                }
                Step::Connection(inputs) => {
                    let displacements = self.first[index] + self.spaces[index].size();
                    for (place, &coordinate) in self.widest[index].coordinates().iter().enumerate() {
                        let goes_on = self.spaces[index].coordinates().contains(&coordinate);
                        let has = |input: &&usize| self.spaces[**input].coordinates().contains(&coordinate);
                        let mut balance = nothing();
                        for &input in inputs.iter().filter(has) {
                            let mut row = nothing();
                            let sum = if is_force(coordinate) { &mut balance } else { &mut row };
                            add(sum, input, coordinate, one);
                            if !is_force(coordinate) {
                                row.0.push((displacements + place, -one));
                                rows.push(row);
                            }
                        }
                        if goes_on {
                            balance.0.push((self.column(index, coordinate), -one));
                        }
                        if is_force(coordinate) {
                            rows.push(balance);
                        } else if goes_on {
                            balance.0.push((displacements + place, one));
                            rows.push(balance);
                        }
                    }
                }
            }
        }
        rows
    }

    /// An entry of a state among the unknowns.
    pub(crate) fn entry(&self, solution: &[Wide], step: usize, coordinate: Coordinate) -> Wide {
        solution[self.column(step, coordinate)]
    }
}

/// Gauss's elimination, pivots chosen in rows of unit size; and the sign of its interchanges.
fn triangular(rows: Vec<Row>, unknowns: usize) -> (Vec<Vec<Wide>>, f64) {
    assert_eq!(rows.len(), unknowns, "as many equations as unknowns");
    let mut dense: Vec<Vec<Wide>> = Vec::new();
    for (terms, right) in rows {
        let mut row = vec![number(0.0); unknowns + 1];
        for (column, factor) in terms {
            row[column] += factor;
        }
        row[unknowns] = right;
        let size = row[..unknowns].iter().map(|entry| entry.size()).fold(0.0, f64::max);
        // the same for a parameter and its neighbours, so that determinants can be compared
        let factor = number((-(1.37 * size).log2().ceil()).exp2());
        dense.push(row.into_iter().map(|entry| entry * factor).collect());
    }
    let mut sign = 1.0;
    for column in 0..unknowns {
        let size = |row: usize| dense[row][column].size();
        let pivot = (column..unknowns).fold(column, |best, row| if size(row) > size(best) { row } else { best });
        if pivot != column {
            dense.swap(column, pivot);
            sign = -sign;
        }
        let (head, tail) = dense.split_at_mut(column + 1);
        let own = &head[column];
        for row in tail.iter_mut().filter(|row| row[column].size() > 0.0) {
            let factor = row[column] / own[column];
            for (entry, own) in row.iter_mut().zip(own).skip(column).filter(|(_, own)| own.size() > 0.0) {
                *entry -= factor * *own;
            }
        }
    }
    (dense, sign)
}

/// The solution of triangular equations; `None` where there is none for certain.
fn solved(triangle: Vec<Vec<Wide>>) -> Option<Vec<Wide>> {
    let unknowns = triangle.len();
    let mut solution = vec![number(0.0); unknowns];
    for line in (0..unknowns).rev() {
        if triangle[line][line].size() < SINGULAR {
            return None;
        }
        let mut value = triangle[line][unknowns];
        for column in line + 1..unknowns {
            value -= triangle[line][column] * solution[column];
        }
        solution[line] = value / triangle[line][line];
    }
    Some(solution)
}
