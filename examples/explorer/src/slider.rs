//! Sliders on the fields of a model.

use core::fmt::{self, Write};

/// A slider on a field of a model `M`.
#[derive(Debug)]
pub struct Slider<M> {
    /// What the field is.
    pub label: &'static str,
    /// The unit that the page shows, and how many of the model's own it is.
    pub unit: (&'static str, f64),
    /// Least and greatest value, in the unit that the page shows.
    pub range: [f64; 2],
    /// Step of the slider.
    pub step: f64,
    /// Where it stands at first.
    pub start: f64,
    /// The field.
    pub field: fn(&mut M) -> &mut f64,
}

impl<M> Slider<M> {
    /// Writes the slider as JSON, without its field.
    pub(crate) fn describe(&self, out: &mut dyn Write) -> fmt::Result {
        let Slider { label, unit: (unit, _), range: [min, max], step, start, .. } = self;
        write!(out, r#"{{"label":"{label}","unit":"{unit}","min":{min},"max":{max},"step":{step},"start":{start}}}"#)
    }
}
