//! Constraints between the rows of a point of a tree: a variable becomes a combination of others, and what does not go on leaves.

use crate::proof::ball::Ball;
use crate::proof::join::{Failure, Join};
use crate::proof::level::Level;
use crate::proof::row::{Row, Term, is_one, is_zero};
use mstmm_plan::Freedoms;

/// Displacement and rotation, in this order.
pub(crate) const FREEDOMS: [Freedoms; 2] = [Freedoms::Y, Freedoms::RZ];

/// What displacement and rotation of a point are of the variables; none where there is no such freedom.
pub(crate) type PointRows<N, const T: usize = 2> = [Option<Row<N, T>>; 2];

/// Most terms of a row while two paths are joined: each has two variables at most.
pub(crate) const JOINED: usize = 4;

/// Holds the freedoms of a support.
pub(crate) fn hold<J: Join>(held: Freedoms, rows: &mut PointRows<J::Alone>, step: usize, joining: &mut J) {
    for (index, freedom) in FREEDOMS.into_iter().enumerate() {
        if let (true, Some(row)) = (held.contains(freedom), rows[index]) {
            satisfy(&row, [rows, &mut [None; 2]], step, joining);
        }
    }
}

/// Satisfies that a combination of variables is zero: one of them is a combination of the others. What is zero already needs nothing: it is held
/// twice, by the same. Returns that variable and the combination.
#[inline(never)]
pub(crate) fn satisfy<J: Join, const T: usize>(
    constraint: &Row<J::Alone, T>,
    rows: [&mut PointRows<J::Alone, T>; 2],
    step: usize,
    joining: &mut J,
) -> Option<(usize, Row<J::Alone, T>)> {
    let pivot = largest(constraint, |_| true)?;
    let Some(by) = solved(constraint, &pivot) else {
        joining.fail(Failure::Redundant(step));
        return None;
    };
    joining.substitute(pivot.variable, by.terms());
    for row in rows.into_iter().flatten().flatten() {
        *row = row.substituted(pivot.variable, &by);
    }
    Some((pivot.variable, by))
}

/// Whether a coefficient is 1 or -1 exactly, and the least size that it may have.
fn rank<N: Level<Word = f64, Alone = N>>(coefficient: &Ball<N>) -> (bool, f64) {
    (is_one(coefficient) || is_one(&-*coefficient), coefficient.least())
}

/// The term with the largest coefficient among some variables; a unit goes before others, since it is exact.
fn largest<N: Level<Word = f64, Alone = N>, const T: usize>(
    row: &Row<N, T>,
    is_asked: impl Fn(usize) -> bool,
) -> Option<Term<N>> {
    let asked = row.terms().iter().filter(|term| !is_zero(&term.coefficient) && is_asked(term.variable));
    let best = asked.max_by(|one, other| {
        let (one, other) = (rank(&one.coefficient), rank(&other.coefficient));
        one.0.cmp(&other.0).then(one.1.total_cmp(&other.1))
    });
    best.copied()
}

/// What a variable is of the others where a combination of all is zero; none where its coefficient may be zero.
fn solved<N: Level<Word = f64, Alone = N>, const T: usize>(
    constraint: &Row<N, T>,
    pivot: &Term<N>,
) -> Option<Row<N, T>> {
    let (is_unit, least) = rank(&pivot.coefficient);
    if least <= 0.0 || least.is_nan() {
        return None;
    }
    let inverse = if is_unit { pivot.coefficient } else { pivot.coefficient.inverse() };
    let mut by = Row::none();
    for term in constraint.terms().iter().filter(|term| term.variable != pivot.variable) {
        by.add(&Row::<N, 1>::of(term.variable), -(term.coefficient * inverse));
    }
    Some(by)
}

/// Eliminates the variables of a point that do not go on. As many go on as there are rows: a sum that goes on alone becomes a variable.
#[inline(never)]
pub(crate) fn go_on<J: Join>(
    before: &PointRows<J::Alone>,
    rows: &mut PointRows<J::Alone>,
    step: usize,
    joining: &mut J,
) {
    let mut old = Variables::of(before);
    for index in 0..2 {
        let Some(row) = rows[index] else { continue };
        let other = Variables::of(&[rows[1 - index], None]);
        let alone = largest(&row, |variable| !other.contains(variable));
        let all = Variables::of(rows);
        let count = rows.iter().flatten().filter(|row| !row.terms().is_empty()).count();
        if let (true, Some(pivot)) = (all.count > count, alone) {
            let own = joining.enter();
            let mut constraint = row.widened::<JOINED>();
            constraint.add(&Row::<J::Alone, 1>::of(own), Ball::of(-1.0));
            let Some(by) = solved(&constraint, &pivot) else {
                joining.fail(Failure::Redundant(step));
                return;
            };
            joining.substitute(pivot.variable, by.terms());
            old.remove(pivot.variable);
            rows[index] = Some(Row::of(own));
        }
    }
    let kept = Variables::of(rows);
    for &variable in old.list.iter().take(old.count).filter(|variable| !kept.contains(**variable)) {
        joining.leave(variable);
    }
}

/// The variables of a point.
struct Variables {
    list: [usize; 4],
    count: usize,
}

impl Variables {
    fn of<A: Level<Word = f64, Alone = A>>(rows: &PointRows<A>) -> Self {
        let mut all = Variables { list: [0; 4], count: 0 };
        for term in rows.iter().flatten().flat_map(|row| row.terms()) {
            if !all.contains(term.variable) {
                all.list[all.count] = term.variable;
                all.count += 1;
            }
        }
        all
    }

    fn contains(&self, variable: usize) -> bool {
        self.list[..self.count].contains(&variable)
    }

    fn remove(&mut self, variable: usize) {
        if let Some(place) = self.list[..self.count].iter().position(|own| *own == variable) {
            self.list.swap(place, self.count - 1);
            self.count -= 1;
        }
    }
}
