//! What a model gives the page, and the models that there are.

use crate::bridge::Bridge;
use crate::portal::Portal;
use crate::problem::Problem;
use crate::shown::Shown;
use crate::slider::Slider;
use core::fmt::{self, Write};

/// A model that the page explores.
pub trait Explored: Default + 'static {
    /// Its name.
    const NAME: &'static str;
    /// What there is to see, in a sentence or two.
    const ABOUT: &'static str;
    /// What the response is, in a sentence without its end, and what the dashed one is.
    const RESPONSE: [&'static str; 2];
    /// Sliders on its fields.
    const SLIDERS: &'static [Slider<Self>];

    /// Shows its natural frequencies and its eigenvalues.
    ///
    /// # Errors
    /// Any [`Problem`].
    fn show_roots(&self, shown: &Shown) -> Result<(), Problem>;

    /// Shows all of it.
    ///
    /// # Errors
    /// Any [`Problem`].
    fn show(&self, shown: &Shown) -> Result<(), Problem>;

    /// The model at values of its sliders; where one is missing, the slider stands where it does at first.
    fn at(values: impl IntoIterator<Item = f64>) -> Self {
        let (mut model, mut values) = (Self::default(), values.into_iter());
        for slider in Self::SLIDERS {
            *(slider.field)(&mut model) = slider.unit.1 * values.next().unwrap_or(slider.start);
        }
        model
    }
}

/// A model among others.
#[derive(Clone, Copy, Debug)]
pub struct Listed {
    describe: fn(&mut dyn Write) -> fmt::Result,
    show: fn(&[f64], &Shown) -> Result<(), Problem>,
    show_roots: fn(&[f64], &Shown) -> Result<(), Problem>,
}

impl Listed {
    const fn new<M: Explored>() -> Self {
        Listed {
            describe: |out| describe_model::<M>(out),
            show: |values, shown| M::at(values.iter().copied()).show(shown),
            show_roots: |values, shown| M::at(values.iter().copied()).show_roots(shown),
        }
    }

    /// Shows all of the model at values of its sliders, or nothing.
    ///
    /// # Errors
    /// Any [`Problem`].
    pub fn show(self, values: &[f64], shown: &Shown) -> Result<(), Problem> {
        shown.clear();
        (self.show)(values, shown).inspect_err(|_| shown.clear())
    }

    /// Shows the roots of the model at values of its sliders, and nothing else.
    ///
    /// # Errors
    /// Any [`Problem`].
    pub fn show_roots(self, values: &[f64], shown: &Shown) -> Result<(), Problem> {
        shown.clear();
        (self.show_roots)(values, shown).inspect_err(|_| shown.clear())
    }
}

/// The models, as the page has them.
pub const MODELS: [Listed; 2] = [Listed::new::<Bridge>(), Listed::new::<Portal>()];

fn describe_model<M: Explored>(out: &mut dyn Write) -> fmt::Result {
    let [response, bare] = M::RESPONSE;
    write!(
        out,
        r#"{{"name":"{}","about":"{}","response":"{response}","bare":"{bare}","sliders":["#,
        M::NAME,
        M::ABOUT
    )?;
    for (k, slider) in M::SLIDERS.iter().enumerate() {
        out.write_str(if k == 0 { "" } else { "," })?;
        slider.describe(out)?;
    }
    out.write_str("]}")
}

/// Writes what the page has to know before it asks: the models with their sliders, the kinds of parts, and the tables.
///
/// # Errors
/// Those of `out`.
pub fn describe(out: &mut dyn Write, shown: &Shown) -> fmt::Result {
    out.write_str(r#"{"models":["#)?;
    for (k, model) in MODELS.iter().enumerate() {
        out.write_str(if k == 0 { "" } else { "," })?;
        (model.describe)(out)?;
    }
    write!(out, r#"],"kinds":{:?},"tables":["#, crate::drawing::KINDS)?;
    shown.describe(out)?;
    out.write_str("]}")
}
