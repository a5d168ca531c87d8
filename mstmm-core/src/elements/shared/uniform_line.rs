//! Uniform lines with mass: strings, rods and shafts, which vibrate along one coordinate.

use crate::element::LineNumbers;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::model::{FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar, Single, Size, Truth, binary_exponent};
use crate::structure::{Chart, Units, unit_of};
use mstmm_plan::Freedoms;
use nalgebra::Matrix2;

/// What a line is made of: `H y'' = (m λ² + k) y`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineSection<T> {
    /// Length l.
    pub(crate) length: T,
    /// Stiffness H: tension, axial stiffness or torsional stiffness.
    pub(crate) stiffness: T,
    /// Inertia per length m.
    pub(crate) inertia: T,
    /// Stiffness k of the foundation per length.
    pub(crate) foundation: T,
}

/// A line with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct UniformLine<T> {
    pub(crate) section: LineSection<T>,
    /// `κ / λ² = m l²/H` without a foundation.
    inertia: T,
    /// `κ = k l²/H` at rest.
    foundation: T,
    /// `H/l` and its inverse.
    stiffness: T,
    compliance: T,
}

/// A line at a frequency: its transfer matrix on `(y, q)` is `[[C, -S l/H], [-κ S H/l, C]]`, with `C = cosh √κ` and `S = sinh √κ / √κ` of
/// `κ = (mλ² + k) l²/H`, both divided by `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub struct LineWaves<S> {
    /// κ: the square of the wave number times the length, negative where waves travel.
    pub(crate) square: S,
    pub(crate) cosh: S,
    pub(crate) sinhc: S,
    /// `H/l` and its inverse.
    pub(crate) stiffness: S,
    pub(crate) compliance: S,
    pub(crate) exponent: i32,
}

impl<T: Parameter> LineSection<T> {
    /// The parameters as numbers of another type.
    #[inline]
    pub(crate) fn map<S>(self, to: impl Fn(T) -> S) -> LineSection<S> {
        let LineSection { length, stiffness, inertia, foundation } = self;
        LineSection { length: to(length), stiffness: to(stiffness), inertia: to(inertia), foundation: to(foundation) }
    }

    /// The line, if products of its parameters are in the range of the type; the names are those of its parameters.
    pub(crate) fn build(self, names: [&'static str; 4]) -> Result<UniformLine<T>, InvalidParameter> {
        let LineSection { length, stiffness, inertia, foundation } = self;
        let [a, b, c, d] = names;
        let parameters = [(a, length), (b, stiffness), (c, inertia), (d, foundation)];
        for ((name, parameter), requirement) in parameters.into_iter().zip(REQUIREMENTS) {
            requirement.check(name, parameter)?;
        }
        let compliance = length / stiffness;
        let line = UniformLine {
            section: self,
            inertia: inertia * length * compliance,
            foundation: foundation * length * compliance,
            stiffness: stiffness / length,
            compliance,
        };
        if line.is_in_range() { Ok(line) } else { Err(InvalidParameter::most_extreme(parameters)) }
    }
}

impl<S: Scalar> LineSection<S> {
    /// The line at λ², from its parameters alone.
    pub(crate) fn waves_at(&self, lambda_squared: S) -> LongitudinalWaves<S> {
        let LineSection { length, stiffness, inertia, foundation } = *self;
        let square = (lambda_squared * inertia + foundation) * length * length / stiffness;
        LongitudinalWaves { square, stiffness: stiffness / length }
    }
}

/// Ranges of the parameters.
const REQUIREMENTS: [Requirement; 4] =
    [Requirement::Positive, Requirement::Positive, Requirement::NonNegative, Requirement::NonNegative];

/// The axial force of a line between places: a string adds it to its tension.
macro_rules! axial_force_of_line {
    ($built:ident tension of $($line:ident)*) => {
        fn add_axial_force(built: &mut $built<T>, force: [f64; 2]) -> Result<bool, InvalidParameter> {
            built $(.$line)* .add_tension(force)?;
            Ok(true)
        }
    };
    ($built:ident $stiffness:ident of $($line:ident)*) => {};
}
pub(crate) use axial_force_of_line;

impl<T: Parameter> UniformLine<T> {
    /// Adds an axial force to the tension of a string.
    pub(crate) fn add_tension(&mut self, force: [f64; 2]) -> Result<(), InvalidParameter> {
        let stiffness = self.section.stiffness + T::of_words(force);
        let names = ["length", "tension", "mass_per_length", "foundation_stiffness"];
        *self = LineSection { stiffness, ..self.section }.build(names)?;
        Ok(())
    }

    /// Whether what is computed is finite, and not zero but for a foundation that there is not.
    fn is_in_range(&self) -> bool {
        // a product with the inverse is about 1, unless one of both is out of the range
        let is_one = |product: T| product.size().is_below(T::Size::of(2.0));
        let inverse = T::one() / self.inertia;
        let is_finite = self.foundation.size().is_below(T::Size::of(f64::INFINITY));
        (is_one(self.stiffness * self.compliance)
            & (self.inertia.vanishes() | is_one(self.inertia * inverse))
            & is_finite)
            .all()
    }

    /// Adds `[stiffness, inertia]` of the line as one lump, and those of its foundation, to the estimates.
    pub(crate) fn estimate(
        &self,
        estimates: &mut FrequencyEstimates,
        [stiffness, inertia]: [fn(&mut FrequencyEstimates, f64); 2],
    ) {
        let LineSection { length, inertia: per_length, foundation, .. } = self.section;
        estimates.linear_waves(1.0 / self.inertia.sqrt().to_f64());
        stiffness(estimates, self.stiffness.to_f64());
        stiffness(estimates, (foundation * length).to_f64());
        inertia(estimates, (per_length * length).to_f64());
    }

    /// Its parameters.
    pub(crate) fn numbers(&self) -> LineNumbers {
        let LineSection { length, stiffness, inertia, foundation } = self.section;
        let [length, stiffness, inertia, foundation] = [length, stiffness, inertia, foundation].map(T::words);
        LineNumbers { length, stiffness, inertia, foundation }
    }

    /// κ at λ²; in extended precision from the parameters, since `build` has rounded.
    #[inline(always)]
    pub(crate) fn square<S: Frequency<T>>(&self, lambda_squared: S) -> S {
        if S::IS_EXTENDED {
            return self.section.map(S::from_parameter).waves_at(lambda_squared).square;
        }
        lambda_squared * self.inertia + S::from_parameter(self.foundation)
    }

    /// `H/l` and its inverse.
    #[inline(always)]
    fn stiffness_and_compliance<S: Frequency<T>>(&self) -> [S; 2] {
        if S::IS_EXTENDED {
            let LineSection { length, stiffness, .. } = self.section;
            let [length, stiffness] = [S::from_parameter(length), S::from_parameter(stiffness)];
            return [stiffness / length, length / stiffness];
        }
        [S::from_parameter(self.stiffness), S::from_parameter(self.compliance)]
    }

    /// The line at a frequency.
    #[inline(always)]
    pub(crate) fn waves<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> LineWaves<S> {
        LineWaves::new(self.square(at.lambda_squared), self.stiffness_and_compliance())
    }

    /// The transfer matrix on displacement and force, whose sign is that of `-H y'` in translation, of `H y'` in rotation.
    pub(crate) fn transfer_matrix<S: Frequency<T> + Single>(&self, x: S, is_rotation: bool) -> Matrix2<S> {
        self.waves(&FrequencyPowers::new(x, false)).transfer_matrix(is_rotation)
    }

    /// The waves without their functions.
    pub(crate) fn longitudinal<S: Frequency<T>>(&self, lambda_squared: S) -> LongitudinalWaves<S> {
        LongitudinalWaves { square: self.square(lambda_squared), stiffness: self.stiffness_and_compliance()[0] }
    }

    /// The chart at a frequency, of the displacement in one freedom.
    pub(crate) fn chart<S: Frequency<T> + ChartScalar>(&self, at: &FrequencyPowers<S>, freedom: Freedoms) -> Chart<S> {
        line_chart(&self.longitudinal(at.lambda_squared), freedom)
    }
}

/// The chart of waves along a line, of the displacement in one freedom.
pub(crate) fn line_chart<S: ChartScalar>(waves: &LongitudinalWaves<S>, freedom: Freedoms) -> Chart<S> {
    let unit = unit_of(binary_exponent(waves.unit()));
    let mut chart = Chart::empty(freedom, Units { displacement: unit, rotation: unit });
    S::enter_longitudinal(waves, &mut chart, [0, 1]);
    chart
}

impl<S: Single> LineWaves<S> {
    /// The transfer matrix on displacement and force, whose sign is that of `-H y'` in translation, of `H y'` in rotation.
    pub(crate) fn transfer_matrix(&self, is_rotation: bool) -> Matrix2<S> {
        let LineWaves { square, cosh, sinhc, stiffness, compliance, exponent } = *self;
        let sign = if is_rotation { S::one() } else { -S::one() };
        let entries = [cosh, sign * sinhc * compliance, sign * square * sinhc * stiffness, cosh];
        let [a, b, c, d] = entries.map(|entry| entry.times_power_of_two(exponent));
        Matrix2::new(a, b, c, d)
    }
}

impl<S: Scalar> LineWaves<S> {
    /// The waves of κ, given `H/l` and its inverse.
    #[inline(always)]
    pub(crate) fn new(square: S, [stiffness, compliance]: [S; 2]) -> Self {
        let waves = square.even_waves();
        LineWaves { square, cosh: waves.cosh, sinhc: waves.sinhc, stiffness, compliance, exponent: waves.exponent }
    }

    /// The count of the line with both ends held: half waves, `√-κ/π` rounded down to the number whose parity is that of the sign of S. So
    /// both agree however a phase beside a multiple of π is rounded.
    #[inline(always)]
    pub(crate) fn held(&self) -> S::Size {
        let number = S::Size::of;
        let travelling = S::select(self.square.is_negative(), -self.square, S::zero());
        let half_waves = travelling.sqrt().size() * number(core::f64::consts::FRAC_1_PI);
        let odd = S::Size::one_if(self.sinhc.is_negative());
        let pairs = ((half_waves + odd * number(-1.0)) * number(0.5) + number(0.25)).whole().0;
        odd + pairs * number(2.0)
    }
}
