//! Ranges of frequencies over a box of fields, whose formulas give the parameters.

mod ends;

use crate::model::{Fields, NamedFields, ToleranceError};
use crate::number::List;
use crate::number::interval::Interval;
use crate::pass::formulas::{Formulas, PerField};
use crate::pass::searched::Undamped;
use crate::search::closed_range::ClosedRange;
use crate::search::undamped::field_box::ends::{Ends, check_seen};
use crate::search::undamped::natural::NaturalFrequencies;
use crate::search::undamped::tolerance_box::{FrequencyRange, ToleranceBox, collected};
use core::ops::RangeInclusive;

/// A model that gives boxes of its fields: each whose parameters are formulas of fields, but rotors.
pub trait Between: Formulas {
    /// The box between two models, which gives ranges of frequencies: each field of a model in it is at least that of the first one and at most that of the second one. What no
    /// formula depends on, and fields that are marked `#[no_sensitivity]`, are those of the first one.
    ///
    /// A formula that compares fields, by `if` or `match`, has two answers where a box holds both. It is refused as the program is compiled.
    ///
    /// # Errors
    /// [`ToleranceError::Field`] for a field whose values are reversed or not finite; [`ToleranceError::Unseen`] where a parameter differs by something else than fields. What no box
    /// may have is said by the questions that it is asked, since parts may cure it.
    fn between<'m>(low: &'m Self, high: &Self) -> Result<FieldBox<'m, Self>, ToleranceError>
    where
        Self: Formulas<Built: Undamped> + Sized,
    {
        const {
            assert!(
                !Self::COMPARES,
                "a formula of this model compares fields: a box of them may have both answers, so write it without `if` and `match`"
            );
        }
        FieldBox::new(low, high)
    }
}

impl<M: Formulas> Between for M {}

/// A box of the fields of a model: each of them lies anywhere between two values, whatever the others are.
///
/// Each formula is enclosed over the whole box, with its slopes. Parameters on which frequencies grow are taken at the lower ends of these intervals in the soft system, and at the
/// upper ends in the stiff one; masses the other way round. So each frequency of each model of the box lies in its range. A field that stiffens one part and makes another one heavier,
/// as the side of a section does, pulls the range wider than it is in truth: [`is_attained`](FieldBox::is_attained) says so, and [`in_parts`](FieldBox::in_parts) narrows it.
///
/// [`Between::between`] makes it.
#[derive(Debug)]
pub struct FieldBox<'m, M: Formulas> {
    model: &'m M,
    fields: PerField<M, Interval>,
    parts: PerField<M, usize>,
}

impl<M: Formulas> Clone for FieldBox<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Formulas> Copy for FieldBox<'_, M> {}

impl<'m, M: Formulas> FieldBox<'m, M> {
    /// The box between two models.
    ///
    /// # Errors
    /// As [`Between::between`].
    fn new(low: &'m M, high: &M) -> Result<Self, ToleranceError> {
        let mut fields = M::Built::per_field(Interval::default());
        let (of_low, of_high) = (low.values(), high.values());
        let ends = of_low.as_ref().iter().zip(of_high.as_ref());
        for ((own, (low, high)), field) in fields.as_mut().iter_mut().zip(ends).zip(M::Built::NAMES) {
            if !(low <= high && low.is_finite() && high.is_finite()) {
                return Err(ToleranceError::Field { field, low: *low, high: *high });
            }
            *own = Interval::between(*low, *high);
        }
        check_seen(low, high)?;
        Ok(FieldBox { model: low, fields, parts: M::Built::per_field(1) })
    }

    /// The box with a field in parts, each as long. The range over the whole box is that of all parts together, and is the narrower the more there are. Each part costs two searches, and four or six
    /// systems for each number that fields move; of several fields all combinations do.
    ///
    /// # Errors
    /// [`ToleranceError::NoSuchField`] for a name of no field that formulas depend on; [`ToleranceError::NoParts`] for no part.
    pub fn in_parts(mut self, field: &'static str, parts: usize) -> Result<Self, ToleranceError> {
        let place = M::Built::NAMES.iter().position(|name| *name == field);
        let place = place.ok_or(ToleranceError::NoSuchField { field })?;
        if parts == 0 {
            return Err(ToleranceError::NoParts { field });
        }
        self.parts.as_mut()[place] = parts;
        Ok(self)
    }

    /// Whether both ends of each range are attained, but for the rounding of formulas: by two models of the box, one of which is the softest and the other one the stiffest of all.
    ///
    /// # Errors
    /// As [`first_frequencies`](FieldBox::first_frequencies), but for searches.
    pub fn is_attained(&self) -> Result<bool, ToleranceError> {
        for ends in self.ends() {
            if !ends?.is_attained {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The ends of all parts, one after the other.
    fn ends(&self) -> impl Iterator<Item = Result<Ends<M>, ToleranceError>> {
        let mut next = Some(M::Built::per_field(0_usize));
        core::iter::from_fn(move || {
            let mut place = next?;
            let mut own = self.fields;
            let parts = place.as_ref().iter().zip(self.parts.as_ref());
            for (field, (part, parts)) in own.as_mut().iter_mut().zip(parts) {
                *field = part_of(*field, *part, *parts);
            }
            next = next_combination(place.as_mut(), self.parts.as_ref()).then_some(place);
            Some(Ends::of(self.model, &own))
        })
    }

    /// The boxes of all parts.
    fn boxes(&self) -> impl Iterator<Item = Result<ToleranceBox<M::Built>, ToleranceError>> {
        self.ends().map(|ends| ends?.systems(self.model))
    }

    /// What all boxes have together, given what each has and how two join.
    fn of_boxes<R>(
        &self,
        of: impl Fn(&ToleranceBox<M::Built>) -> Result<R, ToleranceError>,
        join: impl Fn(R, R) -> R,
    ) -> Result<R, ToleranceError> {
        let mut parts = self.boxes().map(|part| of(&part?));
        // there is one part at least
        let first = parts.next().unwrap_or(Err(ToleranceError::NoParts { field: "" }))?;
        parts.try_fold(first, |all, own| Ok(join(all, own?)))
    }
}

impl<M: Formulas<Built: NaturalFrequencies + Undamped>> FieldBox<'_, M> {
    /// The ranges of the first `N` frequencies, each of a multiple one by itself.
    ///
    /// # Errors
    /// - [`ToleranceError::Mixed`] for a field that moves a parameter which acts both ways on frequencies, such as a place; [`ToleranceError::OwnElement`] for one of an element of one's own.
    /// - [`ToleranceError::Unbounded`] for a formula that is not defined, or not bounded, in all of the box; [`ToleranceError::Parameter`] for a parameter that may be out of its range.
    ///   More [parts](FieldBox::in_parts) may cure both.
    /// - [`ToleranceError::Search`] as [`first_frequencies`](NaturalFrequencies::first_frequencies) of both systems.
    pub fn first_frequencies<const N: usize>(&self) -> Result<List<FrequencyRange<f64>, N>, ToleranceError> {
        self.of_boxes(
            |own| own.first_frequencies::<N>(),
            |all, own| collected(0, |place| joined(all.get(place as usize), own.get(place as usize))),
        )
    }

    /// The ranges of the first `count` frequencies in a vector, as [`first_frequencies`](FieldBox::first_frequencies).
    ///
    /// # Errors
    /// As [`first_frequencies`](FieldBox::first_frequencies).
    #[cfg(feature = "std")]
    pub fn frequencies(&self, count: usize) -> Result<std::vec::Vec<FrequencyRange<f64>>, ToleranceError> {
        self.of_boxes(
            |own| own.frequencies(count),
            |all, own| all.iter().zip(&own).filter_map(|(all, own)| joined(Some(all), Some(own))).collect(),
        )
    }

    /// How many frequencies a model of the box may have below ω [rad/s].
    ///
    /// # Errors
    /// As [`first_frequencies`](FieldBox::first_frequencies).
    pub fn count_below(&self, omega: f64) -> Result<RangeInclusive<u64>, ToleranceError> {
        self.of_boxes(
            |own| own.count_below(omega),
            |all, own| *all.start().min(own.start())..=*all.end().max(own.end()),
        )
    }

    /// Whether no model of the box has a frequency in a range [rad/s], as [`ToleranceBox::is_free_of`] of each part.
    ///
    /// # Errors
    /// As [`ToleranceBox::is_free_of`] and [`first_frequencies`](FieldBox::first_frequencies).
    pub fn is_free_of(&self, range: impl ClosedRange<f64>) -> Result<bool, ToleranceError> {
        let range = range.closed();
        for part in self.boxes() {
            if !part?.is_free_of(range.clone())? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Goes on to the next combination of parts, as a counter whose digits are the parts of fields; false behind the last one.
fn next_combination(place: &mut [usize], parts: &[usize]) -> bool {
    for (part, parts) in place.iter_mut().zip(parts) {
        *part += 1;
        if *part < *parts {
            return true;
        }
        *part = 0;
    }
    false
}

/// A part of an interval. Neighbours have their common end in both.
fn part_of(field: Interval, part: usize, parts: usize) -> Interval {
    let end = |part: usize| match part {
        0 => field.low,
        part if part == parts => field.high,
        part => {
            let along = part as f64 / parts as f64;
            (field.low * (1.0 - along) + field.high * along).clamp(field.low, field.high)
        }
    };
    Interval::between(end(part), end(part + 1))
}

/// The range of two parts.
fn joined(one: Option<&FrequencyRange<f64>>, other: Option<&FrequencyRange<f64>>) -> Option<FrequencyRange<f64>> {
    let (one, other) = (one?, other?);
    let lowest = if other.lowest.omega < one.lowest.omega { other.lowest } else { one.lowest };
    let highest = if other.highest.omega > one.highest.omega { other.highest } else { one.highest };
    Some(FrequencyRange { lowest, highest })
}
