//! A tree step by step: each open path has at most two variables, of which displacement and rotation at its end are rows.

use crate::element::{BodyNumbers, DampingNumbers, Exact, MemberNumbers, OwnPart};
use crate::proof::ball::Ball;
use crate::proof::constraint::{FREEDOMS, JOINED, PointRows, go_on, hold, satisfy};
use crate::proof::join::{Failure, Join};
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::row::{Row, TERMS, Term, is_zero};
use mstmm_plan::{Freedoms, Space, Support};

/// An open path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Path<N: Number> {
    /// The step that it has come to.
    step: usize,
    /// The support behind which nothing has come yet.
    support: Option<Support>,
    rows: PointRows<N>,
}

/// The open paths of a tree, in memory for as many.
#[derive(Debug)]
pub(crate) struct Paths<'m, A: Number> {
    paths: &'m mut [Path<A>],
    count: usize,
}

impl<N: Level<Word = f64, Alone = N>> Path<N> {
    /// No path.
    pub(crate) fn none() -> Self {
        Path { step: 0, support: None, rows: [None; 2] }
    }
}

impl<'m, A: Level<Word = f64, Alone = A>> Paths<'m, A> {
    /// No path is open.
    pub(crate) fn new(paths: &'m mut [Path<A>]) -> Self {
        Paths { paths, count: 0 }
    }

    fn open<J: Join<Alone = A>>(&mut self, path: Path<A>, joining: &mut J) {
        if self.count == self.paths.len() {
            joining.fail(Failure::Full);
            return;
        }
        self.paths[self.count] = path;
        self.count += 1;
    }

    /// Takes the path that has come to a step.
    fn take(&mut self, step: usize) -> Path<A> {
        let last = self.count.saturating_sub(1);
        let place = self.paths[..self.count].iter().rposition(|path| path.step == step).unwrap_or(last);
        self.paths.swap(place, last);
        self.count = last;
        self.paths[last]
    }

    /// A path starts from a support.
    pub(crate) fn tip<J: Join<Alone = A>>(&mut self, step: usize, support: Support, joining: &mut J) {
        self.open(Path { step, support: Some(support), rows: [None; 2] }, joining);
    }

    /// A path goes through an element.
    #[inline(never)]
    pub(crate) fn element<J: Join<Alone = A>>(
        &mut self,
        [step, input]: [usize; 2],
        space: Space,
        part: (&MemberNumbers, Option<OwnPart>),
        joining: &mut J,
    ) {
        let path = self.take(input);
        let rows = match path.support {
            Some(support) => of_support(support, space, joining),
            None => path.rows,
        };
        let rows = through(rows, step, part, joining);
        self.open(Path { step, support: None, rows }, joining);
    }

    /// Paths are joined: their displacements and rotations are equal, supports hold them, and what does not go on leaves.
    #[inline(never)]
    pub(crate) fn connection<J: Join<Alone = A>>(
        &mut self,
        step: usize,
        inputs: &[usize],
        output: Option<Space>,
        joining: &mut J,
    ) {
        // while paths are joined a row may have the variables of both
        let mut rows: PointRows<A, JOINED> = [None; 2];
        let mut held = Freedoms::NONE;
        for &input in inputs {
            let path = self.take(input);
            if let Some(support) = path.support {
                held = held.union(support.holds());
                continue;
            }
            let mut others: PointRows<A, JOINED> = path.rows.map(|row| row.map(|row| row.widened()));
            for freedom in 0..2 {
                match (rows[freedom], others[freedom]) {
                    (Some(row), Some(other)) => {
                        let mut constraint = other;
                        constraint.add(&row, Ball::of(-1.0));
                        (rows[freedom], others[freedom]) = (None, None);
                        let replaced = satisfy(&constraint, [&mut rows, &mut others], step, joining);
                        // both rows are equal now: that without the variable goes on
                        rows[freedom] = Some(match replaced {
                            Some((variable, _)) if !row.contains(variable) => row,
                            Some((variable, by)) => other.substituted(variable, &by),
                            None => row,
                        });
                    }
                    (None, other) => rows[freedom] = other,
                    _ => {}
                }
            }
            // a freedom that came in before the other one was substituted
            for freedom in 0..2 {
                rows[freedom] = rows[freedom].or(others[freedom]);
            }
        }
        let mut rows: PointRows<A> = rows.map(|row| row.map(|row| row.widened()));
        for (freedom, row) in FREEDOMS.into_iter().zip(&mut rows) {
            if output.is_some_and(|output| output.contains(freedom)) && row.is_none() {
                *row = Some(if held.contains(freedom) { Row::none() } else { Row::of(joining.enter()) });
            }
        }
        hold(held, &mut rows, step, joining);
        if let Some(output) = output {
            for (row, freedom) in FREEDOMS.into_iter().enumerate() {
                if !output.contains(freedom) && rows[row].is_some() {
                    let before = rows;
                    rows[row] = None;
                    go_on(&before, &mut rows, step, joining);
                }
            }
        }
        self.open(Path { step, support: None, rows }, joining);
    }

    /// The last path ends in the root.
    pub(crate) fn root<J: Join<Alone = A>>(&mut self, input: usize, support: Support, joining: &mut J) {
        let Path { mut rows, .. } = self.take(input);
        hold(support.holds(), &mut rows, input, joining);
        go_on(&rows, &mut [None; 2], input, joining);
        joining.leave_behind();
    }
}

/// What a support leaves of the freedoms of a space.
fn of_support<J: Join>(support: Support, space: Space, joining: &mut J) -> PointRows<J::Alone> {
    FREEDOMS.map(|freedom| {
        space
            .contains(freedom)
            .then(|| if support.holds().contains(freedom) { Row::none() } else { Row::of(joining.enter()) })
    })
}

/// Takes the rows of a point through an element.
#[inline(never)]
fn through<J: Join>(
    rows: PointRows<J::Alone>,
    step: usize,
    (numbers, own_part): (&MemberNumbers, Option<OwnPart>),
    joining: &mut J,
) -> PointRows<J::Alone> {
    let [y, theta] = [0, 1].map(|index| rows[index].as_ref().map_or(&[][..], |row| row.terms()));
    let mut next = rows;
    let (numbers, damping) = numbers.parted();
    match &numbers {
        MemberNumbers::Other => {
            let index = usize::from(rows[0].is_none());
            let Some(own) = own_row(own_part, rows[index].as_ref(), joining) else { return next };
            next[index] = Some(own);
            if matches!(own_part, Some(OwnPart::Tie { .. })) {
                return next;
            }
        }
        MemberNumbers::Body(body) => {
            add_body(body, [y, theta], joining);
            let output = Ball::of_pair(body.output_x);
            if let ([Some(row), Some(theta)], false) = (&mut next, is_zero(&output)) {
                row.add(theta, output);
            }
            return next;
        }
        MemberNumbers::Disc(body, spin) => {
            add_body(body, [y, theta], joining);
            joining.add_spin(spin, theta);
            return next;
        }
        MemberNumbers::Spring(freedom, stiffness) => {
            let index = usize::from(*freedom == 2);
            next[index] = Some(spring((stiffness, &damping), rows[index].as_ref(), joining));
        }
        MemberNumbers::Joint(rigid, stiffnesses) => {
            for (index, freedom) in FREEDOMS.into_iter().enumerate() {
                if !rigid.contains(freedom) {
                    next[index] = Some(spring((&stiffnesses[1 + index], &damping), rows[index].as_ref(), joining));
                }
            }
        }
        MemberNumbers::Line(freedom, line) => {
            let index = usize::from(*freedom == 2);
            let own = Row::of(joining.enter());
            joining.add_line((line, &damping), Ball::of_pair(line.length), [[y, theta][index], own.terms()]);
            next[index] = Some(own);
        }
        _ => {
            let own = [joining.enter(), joining.enter()].map(Row::of);
            let ends = [y, theta, own[0].terms(), own[1].terms()];
            match &numbers {
                MemberNumbers::Tapered(beam) => joining.add_tapered(beam, Ball::of_pair(beam.length), ends),
                _ => match numbers.spun_beam() {
                    Some((beam, spin)) => joining.add_bending((beam, &damping, spin), Ball::of_pair(beam.length), ends),
                    None => joining.fail(Failure::NotInNumbers),
                },
            }
            next = own.map(Some);
        }
    }
    go_on(&rows, &mut next, step, joining);
    joining.leave_behind();
    next
}

/// Adds a spring behind a row. Returns the row of its other end.
fn spring<J: Join>(
    spring: (&Exact, &DampingNumbers),
    input: Option<&Row<J::Alone, 2>>,
    joining: &mut J,
) -> Row<J::Alone, 2> {
    let own = Row::of(joining.enter());
    joining.add_spring::<_, TERMS>(spring, [input.unwrap_or(&Row::none()), &own]);
    own
}

/// Adds the inertia of a body, and the stiffness of an axial force against its rotation: where it turns by Θ its ends come closer by `|b| Θ²/2`.
fn add_body<J: Join>(body: &BodyNumbers, rows: [&[Term<J::Alone>]; 2], joining: &mut J) {
    let [mass, inertia, centre, output] =
        [body.mass, body.inertia, body.centre_x, body.output_x].map(Ball::<J::Alone>::of_pair);
    let moment = if is_zero(&centre) || is_zero(&mass) { Ball::of(0.0) } else { mass * centre };
    // Steiner's theorem
    let inertia = if body.is_central && !is_zero(&moment) { inertia + moment * centre } else { inertia };
    joining.add_inertia([mass, moment, inertia], rows);
    if body.axial_force != [0.0; 2] {
        let length = if output.mid.leading() < 0.0 { -output } else { output };
        joining.add_term(Ball::of_pair(body.axial_force) * length, rows[1]);
    }
}

/// Adds an element that is known by its stiffness at this frequency alone. Returns what its output end is of the variables.
fn own_row<J: Join>(
    part: Option<OwnPart>,
    input: Option<&Row<J::Alone, 2>>,
    joining: &mut J,
) -> Option<Row<J::Alone, 2>> {
    let Some(part) = part else {
        joining.fail(Failure::NotInNumbers);
        return None;
    };
    let nothing = Row::none();
    let input = input.unwrap_or(&nothing);
    match part {
        OwnPart::Tie { ratio, stiffness } => {
            let mut row = Row::none();
            row.add(input, Ball::of_pair(ratio));
            joining.add_term(Ball::of_pair(stiffness), input.terms());
            Some(row)
        }
        OwnPart::Stiffness { stiffness, held } => {
            let own = Row::of(joining.enter());
            joining.add_counted(stiffness, held, [input.terms(), own.terms()]);
            Some(own)
        }
    }
}
