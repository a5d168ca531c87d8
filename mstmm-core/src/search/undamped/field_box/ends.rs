//! The soft and the stiff end of a box of fields: by the interval of each number and by how it acts on frequencies.
//!
//! A number is enclosed over the box in two steps. Where its slope along a field has one sign in the whole box, its bounds are those at the ends of this field; along other fields it is
//! enclosed over all of them. How it acts is seen by systems that differ in it alone: one has to dominate the other one. The lower half and the upper half of its interval are looked at,
//! so that a parameter whose zero means that it is absent does not pass for one that grows.
//!
//! Then each parameter of each model of the box is between those of both ends, and acts one way: the ends dominate all of them.

use crate::model::{Fields, NamedFields, Spot, ToleranceError};
use crate::number::elementary::Elementary;
use crate::number::interval::Interval;
use crate::pass::formulas::{Formulas, PerField};
use crate::search::undamped::domination::check_domination;

use crate::search::undamped::tolerance_box::ToleranceBox;

/// How a number goes with a field.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Trend {
    /// It does not depend on it.
    Flat,
    Up,
    Down,
    /// Both ways, or it is not known.
    Either,
}

impl Trend {
    fn of(slope: Interval) -> Self {
        match slope {
            Interval { low, high } if low == 0.0 && high == 0.0 => Trend::Flat,
            Interval { low, .. } if low >= 0.0 => Trend::Up,
            Interval { high, .. } if high <= 0.0 => Trend::Down,
            _ => Trend::Either,
        }
    }

    /// The trend along a field; none along a field that is known.
    fn along_field(field: Interval, number: Interval, slope: Interval) -> Self {
        match (field.low == field.high, number.is_number()) {
            (true, _) => Trend::Flat,
            (false, true) => Trend::of(slope),
            (false, false) => Trend::Either,
        }
    }

    /// The trend of what goes with a number as that goes with a field.
    fn through(self, acts: Self) -> Self {
        match (acts, self) {
            (Trend::Flat, _) => Trend::Flat,
            (Trend::Down, Trend::Up) => Trend::Down,
            (Trend::Down, Trend::Down) => Trend::Up,
            (_, own) => own,
        }
    }

    /// What two numbers do together.
    fn with(self, other: Self) -> Self {
        match (self, other) {
            (Trend::Flat, other) => other,
            (own, Trend::Flat) => own,
            (own, other) if own == other => own,
            _ => Trend::Either,
        }
    }
}

/// What is known of a number, as a mark in a row of numbers: it depends on no field that was seen yet; its bounds are being found; they are known.
const UNSEEN: f64 = 0.0;
const AT_WORK: f64 = 1.0;
const DONE: f64 = 2.0;

/// The numbers at both ends.
pub(crate) struct Ends<M: Formulas> {
    soft: M::Numbers,
    stiff: M::Numbers,
    /// Whether the ends are two models of the box.
    pub(crate) is_attained: bool,
}

impl<M: Formulas> Ends<M> {
    /// The ends of a box. Numbers of the same trends are looked at together.
    ///
    /// # Errors
    /// As `Between::between`.
    pub(crate) fn of(model: &M, fields: &PerField<M, Interval>) -> Result<Self, ToleranceError> {
        let base = model.numbers();
        let mut ends = Ends { soft: base, stiff: base, is_attained: true };
        let mut marks = base;
        marks.as_mut().fill(UNSEEN);
        let mut together = M::Built::per_field(Trend::Flat);
        while let Some(trends) = mark_next(model, fields, marks.as_mut()) {
            ends.bound(model, fields, &trends, marks.as_ref());
            for (place, mark) in marks.as_mut().iter_mut().enumerate() {
                if *mark == AT_WORK {
                    *mark = DONE;
                    let acts = ends.order(model, &base, place, trends.as_ref())?;
                    for (all, own) in together.as_mut().iter_mut().zip(trends.as_ref()) {
                        *all = all.with(own.through(acts));
                    }
                }
            }
        }
        ends.is_attained = !together.as_ref().contains(&Trend::Either);
        Ok(ends)
    }

    /// Bounds all marked numbers: from below in the soft row, from above in the stiff one.
    fn bound(&mut self, model: &M, fields: &PerField<M, Interval>, trends: &PerField<M, Trend>, marks: &[f64]) {
        let corner = |is_upper: bool| {
            let mut corner = *fields;
            for (field, trend) in corner.as_mut().iter_mut().zip(trends.as_ref()) {
                match (trend, is_upper) {
                    (Trend::Up, false) | (Trend::Down, true) | (Trend::Flat, _) => *field = Interval::point(field.low),
                    (Trend::Up, true) | (Trend::Down, false) => *field = Interval::point(field.high),
                    (Trend::Either, _) => {}
                }
            }
            corner
        };
        let (soft, stiff) = (self.soft.as_mut(), self.stiff.as_mut());
        model.enclose(&corner(false), &mut |place, number, _| {
            if marks[place] == AT_WORK {
                soft[place] = number.low;
            }
        });
        model.enclose(&corner(true), &mut |place, number, _| {
            if marks[place] == AT_WORK {
                stiff[place] = number.high;
            }
        });
    }

    /// Puts the bounds of a number into the rows by how it acts on frequencies, which is returned.
    fn order(&mut self, model: &M, base: &M::Numbers, place: usize, trends: &[Trend]) -> Result<Trend, ToleranceError> {
        let bounds = [self.soft.as_ref()[place], self.stiff.as_ref()[place]];
        let [low, high] = bounds;
        let moves = trends.iter().position(|trend| *trend != Trend::Flat);
        let field = moves.map_or("", |field| M::Built::NAMES[field]);
        if !(low <= high && low.is_finite() && high.is_finite()) {
            return Err(ToleranceError::Unbounded { field, low, high });
        }
        if M::is_of_own_element(place) {
            return Err(ToleranceError::OwnElement { field });
        }
        let middle = 0.5 * low + 0.5 * high;
        let is_dominated = |soft, stiff| compare(model, base, place, [soft, stiff]);
        let up = is_dominated(low, middle).and_then(|()| is_dominated(middle, high));
        let Err(error) = up else { return Ok(Trend::Up) };
        if is_dominated(high, middle).and_then(|()| is_dominated(middle, low)).is_ok() {
            self.soft.as_mut()[place] = high;
            self.stiff.as_mut()[place] = low;
            return Ok(Trend::Down);
        }
        Err(match place_of(error) {
            Some((element, parameter)) => ToleranceError::Mixed { field, element, parameter },
            None => error,
        })
    }

    /// The systems at the ends.
    pub(crate) fn systems(&self, model: &M) -> Result<ToleranceBox<M::Built>, ToleranceError> {
        ToleranceBox::between(model.built(&self.soft)?, model.built(&self.stiff)?)
    }
}

/// The trends of the first number that is not seen yet, if there is one; it is marked, and with it all others of these trends. A number whose fields are known stays what it is.
fn mark_next<M: Formulas>(model: &M, fields: &PerField<M, Interval>, marks: &mut [f64]) -> Option<PerField<M, Trend>> {
    let mut next: Option<PerField<M, Trend>> = None;
    model.enclose(fields, &mut |place, number, slopes| {
        if marks[place] != UNSEEN {
            return;
        }
        let mut own = M::Built::per_field(Trend::Flat);
        for ((trend, field), slope) in own.as_mut().iter_mut().zip(fields.as_ref()).zip(slopes) {
            *trend = Trend::along_field(*field, number, *slope);
        }
        if own.as_ref().iter().all(|trend| *trend == Trend::Flat) {
            marks[place] = DONE;
        } else if next.get_or_insert(own).as_ref() == own.as_ref() {
            marks[place] = AT_WORK;
        }
    });
    next
}

/// Checks that another model differs from one by fields alone, as far as something may move frequencies: at its fields each formula of the first model has its number.
///
/// # Errors
/// [`ToleranceError::Unseen`] for the first number that differs by something else.
pub(crate) fn check_seen<M: Formulas>(model: &M, other: &M) -> Result<(), ToleranceError> {
    let (base, numbers) = (model.numbers(), other.numbers());
    let values = other.values();
    let mut fields = M::Built::per_field(Interval::default());
    fields.as_mut().iter_mut().zip(values.as_ref()).for_each(|(field, value)| *field = Interval::point(*value));
    let mut is_seen = base;
    is_seen.as_mut().iter_mut().zip(base.as_ref()).zip(numbers.as_ref()).for_each(|((seen, own), number)| {
        *seen = f64::from(u8::from(own == number));
    });
    let seen = is_seen.as_mut();
    model.enclose(&fields, &mut |place, number, _| {
        seen[place] = f64::from(u8::from(number.holds(numbers.as_ref()[place])))
    });
    for (place, (own, number)) in base.as_ref().iter().zip(numbers.as_ref()).enumerate() {
        if is_seen.as_ref()[place] == 0.0 {
            let apart = [[*own, *number], [*number, *own]];
            let moved = apart.into_iter().try_for_each(|ends| compare(model, &base, place, ends));
            moved.map_err(|error| match place_of(error) {
                Some((element, parameter)) => ToleranceError::Unseen { element, parameter, low: *own, high: *number },
                None => error,
            })?;
        }
    }
    Ok(())
}

/// Checks that a system with one number is dominated by that with another one in its place.
#[inline(never)]
fn compare<M: Formulas>(model: &M, base: &M::Numbers, place: usize, ends: [f64; 2]) -> Result<(), ToleranceError> {
    let [soft, stiff] = ends.map(|number| {
        let mut numbers = *base;
        numbers.as_mut()[place] = number;
        model.built(&numbers)
    });
    check_domination(&soft?, &stiff?)
}

/// The element and the parameter by which two systems are not in order.
fn place_of(error: ToleranceError) -> Option<(Spot, &'static str)> {
    match error {
        ToleranceError::NotOrdered { element, parameter, .. } => Some((element, parameter)),
        ToleranceError::NotAlike { at } => Some((at, "geometry")),
        _ => None,
    }
}
