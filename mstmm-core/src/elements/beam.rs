//! Euler-Bernoulli beam.

use crate::element::{Element, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::bending_chart::wave_fourth;
use crate::elements::shared::compound::{BendingCoefficients, Units};
use crate::elements::shared::krylov::bending_matrix;
use crate::model::{Bending, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scaled, Single, Size, Truth, WaveProducts, twice};
use crate::subspace::{RootCounter, Subspace};
use mstmm_plan::Support;
use nalgebra::Matrix4;

mod chart;

/// Uniform Euler-Bernoulli beam, exact at every frequency.
///
/// Transfer matrix on `[Y, Θ, M, Q]` with `β⁴ = -mλ²/EI`, `z = βl` and the Krylov functions S, T, U, V of z:
///
/// ```text
/// S        T/β      U/(EIβ²)  V/(EIβ³)
/// βV       S        T/(EIβ)   U/(EIβ²)
/// EIβ²U    EIβV     S         T/β
/// EIβ³T    EIβ²U    βV        S
/// ```
///
/// Every entry is an entire function of `z⁴`, so that λ = 0 is an ordinary point (the static beam).
///
/// # Source
/// Eq. (19) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Bending stiffness EI [N m²], positive.
    pub bending_stiffness: T,
    /// Mass per length m [kg/m], zero or positive.
    pub mass_per_length: T,
}

/// A beam with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltBeam<T> {
    parameters: Beam<T>,
    /// `z / sqrt(ω) = (m/EI)^(1/4) l`.
    wave: T,
    /// `z⁴ / ω² = m l⁴/EI`.
    wave_fourth: T,
    /// Units of the minors with the wave number `β / sqrt(ω)`.
    wave_units: Units<T>,
    /// Units of the minors with `1/l` in place of β, for small z.
    length_units: Units<T>,
}

impl<T: Copy> BuiltBeam<T> {
    /// What the beam was built of.
    pub(crate) fn parameters(&self) -> Beam<T> {
        self.parameters
    }
}

impl<T: Parameter> Element for Beam<T> {
    type State = Bending;
    type Built = BuiltBeam<T>;

    fn build(self) -> Result<BuiltBeam<T>, InvalidParameter> {
        let Beam { length, bending_stiffness, mass_per_length } = self;
        Requirement::Positive.check("length", length)?;
        Requirement::Positive.check("bending_stiffness", bending_stiffness)?;
        Requirement::NonNegative.check("mass_per_length", mass_per_length)?;
        // a beam without mass has no waves: nothing uses the units of its waves, which only have to be finite
        let is_massless = mass_per_length.vanishes();
        let of_waves = T::select(is_massless, bending_stiffness, mass_per_length);
        let square = (of_waves / bending_stiffness).sqrt();
        let wave_number = square.sqrt();
        let square = square * length * length;
        let wave_units = Units::new(bending_stiffness, wave_number);
        let length_units = Units::new(bending_stiffness, T::one() / length);
        if !(wave_units.are_in_range() && length_units.are_in_range()) {
            return Err(InvalidParameter::most_extreme([
                ("length", length),
                ("bending_stiffness", bending_stiffness),
                ("mass_per_length", mass_per_length),
            ]));
        }
        Ok(BuiltBeam {
            parameters: self,
            wave: T::select(is_massless, T::zero(), wave_number * length),
            wave_fourth: T::select(is_massless, T::zero(), square * square),
            wave_units,
            length_units,
        })
    }

    fn estimate(built: &BuiltBeam<T>, estimates: &mut FrequencyEstimates) {
        let Beam { length, bending_stiffness, mass_per_length } = built.parameters;
        let (l, ei, m) = (length.to_f64(), bending_stiffness.to_f64(), mass_per_length.to_f64());
        estimates.waves(1.0 / (built.wave * built.wave).to_f64());
        estimates.translational_stiffness(ei / (l * l * l));
        estimates.torsional_stiffness(ei / l);
        estimates.length(l);
        estimates.mass(m * l);
        estimates.moment_of_inertia(m * l * l * l);
    }

    fn extent(built: &BuiltBeam<T>) -> Extent {
        let Beam { length, bending_stiffness, .. } = built.parameters;
        Extent::along(length.to_f64()).of_stiffness(bending_stiffness.to_f64())
    }

    fn member_numbers(built: &BuiltBeam<T>) -> MemberNumbers {
        let Beam { length, bending_stiffness, mass_per_length } = built.parameters;
        MemberNumbers::beam([length, bending_stiffness, mass_per_length])
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Beam<T> {
    fn transfer_matrix(built: &BuiltBeam<T>, x: S) -> Matrix4<S> {
        let Beam { length, bending_stiffness, mass_per_length } = built.parameters;
        bending_matrix(length, bending_stiffness, mass_per_length, x.lambda_squared())
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Beam<T> {
    const WAVES: bool = true;
    type Coefficients = BendingCoefficients<S>;

    #[inline(always)]
    fn coefficients(built: &BuiltBeam<T>, at: &FrequencyPowers<S>) -> BendingCoefficients<S> {
        let z = built.z(at);
        let is_wave = S::Size::of(1.0).is_below(z.size());
        if is_wave.all() {
            return built.waving(z, at);
        }
        if !S::IN_LANES {
            return built.called_short(z, at);
        }
        let short = built.short(z, at);
        if is_wave.any() { BendingCoefficients::select(is_wave, built.waving(z, at), short) } else { short }
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        coefficients.step(input, counter)
    }

    #[inline(always)]
    fn root<C: RootCounter<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        coefficients.root(input, support, counter)
    }
}

impl<T: Parameter> BuiltBeam<T> {
    /// `z = βl`; in extended precision from the parameters, since `build` has rounded.
    #[inline(always)]
    pub(super) fn z<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> S {
        if S::IS_EXTENDED { at.powers[0] * self.exact_fourth::<S>().sqrt().sqrt() } else { at.powers[0] * self.wave }
    }

    /// `z⁴`, as [`z`](Self::z).
    #[inline(always)]
    pub(super) fn z_fourth<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> S {
        if S::IS_EXTENDED {
            -at.lambda_squared * self.exact_fourth::<S>()
        } else {
            -at.lambda_squared * self.wave_fourth
        }
    }

    /// `z⁴/ω²` from the parameters.
    #[inline(always)]
    fn exact_fourth<S: Frequency<T>>(&self) -> S {
        let Beam { length, bending_stiffness, mass_per_length } = self.parameters;
        wave_fourth([bending_stiffness, mass_per_length], S::from_parameter(length))
    }

    /// The coefficients for `|z| > 1`. In line where lanes need it, not where size counts: each beam of a model has them.
    #[cfg_attr(feature = "std", inline(always))]
    #[cfg_attr(not(feature = "std"), inline)]
    fn waving<S: Frequency<T>>(&self, z: S, at: &FrequencyPowers<S>) -> BendingCoefficients<S> {
        let WaveProducts { ch_cos, ch_sin, sh_cos, sh_sin: f, one, exponent } = z.wave_products();
        let (b, d, e) = (ch_sin + sh_cos, ch_sin - sh_cos, one - ch_cos);
        let Units { factors, inverses } = self.units(z, at);
        BendingCoefficients {
            z,
            a: one + ch_cos,
            c: ch_cos + ch_cos,
            b,
            f,
            d,
            e,
            raised_b: b,
            raised_f: f,
            raised_d: d,
            raised_e: e,
            factors,
            inverses,
            // above stands twice of each
            exponent: exponent - 1,
        }
    }

    /// Units of the minors with the wave number β. In extended precision they are computed anew, since a step is the compound of
    /// the transfer matrix only if they fit each other.
    #[inline(always)]
    fn units<S: Frequency<T>>(&self, z: S, at: &FrequencyPowers<S>) -> Units<S> {
        if S::IS_EXTENDED {
            let Beam { length, bending_stiffness, .. } = self.parameters;
            return Units::new(S::from_parameter(bending_stiffness), z / S::from_parameter(length));
        }
        Units {
            factors: products(at.powers, self.wave_units.factors),
            inverses: products(at.inverse_powers, self.wave_units.inverses),
        }
    }

    /// Units of the minors with `1/l` in place of β.
    #[inline(always)]
    fn short_units<S: Frequency<T>>(&self) -> Units<S> {
        if S::IS_EXTENDED {
            let Beam { length, bending_stiffness, .. } = self.parameters;
            return Units::new(S::from_parameter(bending_stiffness), S::one() / S::from_parameter(length));
        }
        self.length_units.map(S::from_parameter)
    }

    /// [`short`](Self::short), called where size counts.
    #[inline]
    fn called_short<S: Frequency<T>>(&self, z: S, at: &FrequencyPowers<S>) -> BendingCoefficients<S> {
        self.short(z, at)
    }

    /// The coefficients for `|z| <= 1`, entire in `z⁴`.
    #[inline(always)]
    fn short<S: Frequency<T>>(&self, z: S, at: &FrequencyPowers<S>) -> BendingCoefficients<S> {
        let x = self.z_fourth(at);
        let [c, b, f, d, e] = x.short_wave_products();
        let Units { factors, inverses } = self.short_units();
        BendingCoefficients {
            z,
            a: S::one() + c,
            c: twice(c),
            b,
            f,
            d,
            e,
            raised_b: x * b,
            raised_f: x * f,
            raised_d: x * d,
            raised_e: x * x * e,
            factors,
            inverses,
            // above stands twice of each, as for waves
            exponent: -1,
        }
    }
}

/// The products of powers of the frequency with their factors.
#[inline(always)]
fn products<T: Parameter, S: Frequency<T>>([a, b, c, d]: [S; 4], [e, f, g, h]: [T; 4]) -> [S; 4] {
    [a * e, b * f, c * g, d * h]
}

mod member;
mod motion;

#[cfg(test)]
impl super::laws::Sample for Beam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Beam { length: next(), bending_stiffness: next(), mass_per_length: next() }
    }

    fn length(&self) -> f64 {
        self.length
    }

    fn halves(self) -> Option<Self> {
        Some(Beam { length: self.length / 2.0, ..self })
    }
}

#[cfg(test)]
mod tests;
