//! Models whose fields are filled with random numbers, and what their systems say of roots.
#![expect(clippy::unwrap_used, reason = "the models are right")]

use crate::support::random_tree::Random;
use mstmm::Complex;
use mstmm::motion::{MotionError, Root};
use mstmm::number::{DoubleDouble, Oscillation, Scaled};

/// The numbers that a field may have.
#[derive(Clone, Copy, Debug)]
pub(super) enum Spread {
    /// Evenly between two numbers, as places and directions.
    Even(f64, f64),
    /// As often in each decade, as stiffnesses and masses.
    Decades(f64, f64),
}

impl Spread {
    fn draw(self, random: &mut Random) -> f64 {
        let share = random.unit();
        let number = match self {
            Spread::Even(least, largest) => least + share * (largest - least),
            Spread::Decades(least, largest) => least * (largest / least).powf(share),
        };
        // the bits that are left are for steps of a difference
        f64::from(number as f32)
    }
}

/// A simple root, ω or λ, and its derivatives with respect to the fields, or why there are none.
pub(super) struct Answer {
    pub(super) root: Complex<f64>,
    pub(super) slopes: Result<Vec<Complex<f64>>, MotionError>,
}

/// A model, by the numbers of its fields.
pub(super) trait Sampled {
    /// ω or λ in extended precision.
    type Frequency: Oscillation<DoubleDouble>;

    /// Names of the fields, and what they may be.
    const FIELDS: &'static [(&'static str, Spread)];

    /// The first roots that are simple, with a frequency that is not zero.
    fn answers(fields: &[f64]) -> Vec<Answer>;

    /// The determinant of the overall matrix.
    fn determinant(fields: &[f64], x: Self::Frequency) -> Scaled<Self::Frequency>;
}

/// The fields of a model from a seed.
pub(super) fn fields<M: Sampled>(seed: u64) -> Vec<f64> {
    let mut random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
    M::FIELDS.iter().map(|(_, spread)| spread.draw(&mut random)).collect()
}

/// What cannot fail with fields that are valid.
pub(super) fn valid<V, E: core::fmt::Debug>(result: Result<V, E>) -> V {
    result.unwrap()
}

/// The answers of a system at simple roots that vibrate.
pub(super) fn answers<R: Root<f64>>(
    roots: &[R],
    slopes: impl Fn(&R) -> Result<Vec<R::Frequency>, MotionError>,
) -> Vec<Answer> {
    let vibrates = |root: &&R| root.multiplicity() == 1 && root.peak().0 > 1e-3 * root.frequency().modulus();
    let answer = |root: &R| Answer {
        root: root.frequency().to_complex(),
        slopes: slopes(root).map(|slopes| slopes.into_iter().map(|slope| slope.to_complex()).collect()),
    };
    roots.iter().filter(vibrates).map(answer).collect()
}

/// `Sampled` for a model of `system!`: the search for its roots, and a spread for each field.
macro_rules! sampled {
    ($model:ident, $search:ident, $frequency:ty, { $($field:ident: $spread:ident($least:expr, $largest:expr)),+ $(,)? }) => {
        const _: () = {
            use $crate::motions::sensitivities::sampled::{Answer, Sampled, Spread, answers, valid};

            fn model(fields: &[f64]) -> $model {
                let mut numbers = fields.iter().copied();
                $model { $($field: valid(numbers.next().ok_or(stringify!($field)))),+ }
            }

            impl Sampled for $model {
                type Frequency = $frequency;

                const FIELDS: &'static [(&'static str, Spread)] =
                    &[$((stringify!($field), Spread::$spread($least, $largest))),+];

                fn answers(fields: &[f64]) -> Vec<Answer> {
                    let system = valid(model(fields).build());
                    let roots = valid(system.$search::<8>());
                    answers(&roots, |root| {
                        system.sensitivity(root).map(|found| found.iter().map(|(_, slope)| slope).collect())
                    })
                }

                fn determinant(fields: &[f64], x: $frequency) -> mstmm::number::Scaled<$frequency> {
                    valid(model(fields).build_as::<mstmm::number::DoubleDouble>()).overall_determinant(x)
                }
            }
        };
    };
}

/// The same without dampers.
macro_rules! undamped {
    ($model:ident, $fields:tt) => {
        $crate::motions::sensitivities::sampled::sampled!(
            $model,
            first_frequencies,
            mstmm::number::DoubleDouble,
            $fields
        );
    };
}

/// The same with dampers.
macro_rules! damped {
    ($model:ident, $fields:tt) => {
        $crate::motions::sensitivities::sampled::sampled!(
            $model,
            first_eigenvalues,
            mstmm::Complex<mstmm::number::DoubleDouble>,
            $fields
        );
    };
}

pub(super) use {damped, sampled, undamped};
