//! Euler-Bernoulli beam.

use crate::at::At;
use crate::beam_functions::{bending_matrix, plane_series};
use crate::bounds::FrequencyBounds;
use crate::count::{BeamSigns, Tally};
use crate::element::{Element, PlaneStep, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real, Scalar};
use crate::scaled::{Scaled, binary_exponent};
use crate::state::{Bending, Support};
use crate::subspace::{Plane, Subspace};
use nalgebra::Matrix4;

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
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
}

/// A beam with what does not depend on the frequency.
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

/// `EI b, EI b², EI b³, EI² b⁴` and their inverses: the minors p_YM, w, p_ΘQ, p_MQ of a plane whose states have the
/// entries `Y, Θ/b, M/(EI b²), Q/(EI b³)`, divided by the minor p_YΘ.
#[derive(Clone, Copy, Debug)]
struct Units<T> {
    factors: [T; 4],
    inverses: [T; 4],
}

impl<T: Real> Units<T> {
    fn new(stiffness: T, b: T) -> Self {
        let first = stiffness * b;
        let second = first * b;
        let factors = [first, second, second * b, second * second];
        Units { factors, inverses: factors.map(|factor| T::one() / factor) }
    }

    /// Whether all of them are numbers other than zero.
    fn are_in_range(&self) -> bool {
        let is_number = |x: &T| x.size() > 0.0 && x.size().is_finite();
        self.factors.iter().chain(&self.inverses).all(is_number)
    }
}

impl<T: Real> Element for Beam<T> {
    type State = Bending;
    type Built = BuiltBeam<T>;

    fn build(self) -> Result<BuiltBeam<T>, InvalidParameter> {
        let Beam { length, bending_stiffness, mass_per_length } = self;
        Requirement::Positive.check("length", length)?;
        Requirement::Positive.check("bending_stiffness", bending_stiffness)?;
        Requirement::Positive.check("mass_per_length", mass_per_length)?;
        let square = (mass_per_length / bending_stiffness).sqrt();
        let wave_number = square.sqrt();
        let square = square * length * length;
        let wave_units = Units::new(bending_stiffness, wave_number);
        let length_units = Units::new(bending_stiffness, T::one() / length);
        if !(wave_units.are_in_range() && length_units.are_in_range()) {
            return Err(self.most_extreme());
        }
        Ok(BuiltBeam {
            parameters: self,
            wave: wave_number * length,
            wave_fourth: square * square,
            wave_units,
            length_units,
        })
    }

    fn bound(built: &BuiltBeam<T>, bounds: &mut FrequencyBounds) {
        let Beam { length, bending_stiffness, mass_per_length } = built.parameters;
        let (l, ei, m) = (length.to_f64(), bending_stiffness.to_f64(), mass_per_length.to_f64());
        bounds.waves(1.0 / (built.wave * built.wave).to_f64());
        bounds.translational_stiffness(ei / (l * l * l));
        bounds.torsional_stiffness(ei / l);
        bounds.length(l);
        bounds.mass(m * l);
        bounds.moment_of_inertia(m * l * l * l);
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Beam<T> {
    fn transfer_matrix(built: &BuiltBeam<T>, x: S) -> Matrix4<S> {
        let Beam { length, bending_stiffness, mass_per_length } = built.parameters;
        bending_matrix(length, bending_stiffness, mass_per_length, x.lambda_squared())
    }
}

impl<T: Real> Beam<T> {
    /// The parameter farthest from 1, where their products leave the range of the type.
    fn most_extreme(&self) -> InvalidParameter {
        let parameters = [
            ("length", self.length.to_f64()),
            ("bending_stiffness", self.bending_stiffness.to_f64()),
            ("mass_per_length", self.mass_per_length.to_f64()),
        ];
        let mut worst = parameters[0];
        for parameter in parameters {
            if binary_exponent(parameter.1).abs() > binary_exponent(worst.1).abs() {
                worst = parameter;
            }
        }
        InvalidParameter { parameter: worst.0, value: worst.1, requirement: Requirement::Moderate }
    }
}

/// The second compound of the transfer matrix in units in which it has neither l, EI nor β, and those units.
///
/// With `ch, sh, c, s` of z: `a = (1 + ch c)/2, c = ch c, b = (ch s + sh c)/2, f = sh s/2, d = (ch s - sh c)/2,
/// e = (1 - ch c)/2`, all divided by `2^exponent`. For small z, where these cancel, their Taylor series divided by z, z²,
/// z³, z⁴ take the place of b, f, d, e, those multiplied by z³, z², z, z⁴ the place of the raised ones, and `1/l` that of β.
#[derive(Clone, Copy, Debug)]
pub struct BeamCoefficients<S> {
    z: S,
    a: S,
    c: S,
    b: S,
    f: S,
    d: S,
    e: S,
    raised_b: S,
    raised_f: S,
    raised_d: S,
    raised_e: S,
    /// `EI b, EI b², EI b³, EI² b⁴`.
    factors: [S; 4],
    /// Their inverses.
    inverses: [S; 4],
    exponent: i32,
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Beam<T> {
    const WAVES: bool = true;
    type Coefficients = BeamCoefficients<S>;

    #[inline(always)]
    fn coefficients(built: &BuiltBeam<T>, at: &At<S>) -> BeamCoefficients<S> {
        let z = at.powers[0] * built.wave;
        if z.size() <= 1.0 {
            return BeamCoefficients::small(z, built, at);
        }
        let waves = z.wave_products();
        let (one, c, f) = (waves.one, waves.ch_cos, waves.sh_sin);
        let (b, d) = (waves.ch_sin + waves.sh_cos, waves.ch_sin - waves.sh_cos);
        BeamCoefficients {
            z,
            a: one + c,
            c: c + c,
            b,
            f,
            d,
            e: one - c,
            raised_b: b,
            raised_f: f,
            raised_d: d,
            raised_e: one - c,
            factors: core::array::from_fn(|k| at.powers[k] * built.wave_units.factors[k]),
            inverses: core::array::from_fn(|k| at.inverse_powers[k] * built.wave_units.inverses[k]),
            // above stands twice of each
            exponent: waves.exponent - 1,
        }
    }

    #[inline(always)]
    fn step<C: Tally<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, tally: &mut C) -> Subspace<S> {
        let after = match input {
            Subspace::Tip(support, _) => coefficients.behind_tip(support),
            Subspace::Springs { y, theta } => coefficients.behind_springs(y, theta),
            _ => coefficients.through(input.plane()),
        };
        if C::COUNTS {
            let BeamCoefficients { z, e, b, .. } = *coefficients;
            let clamped_stiffness = coefficients.factors[2] * b / e;
            tally.beam(&input.plane(), &after, BeamSigns { z, one_minus_product: e, clamped_stiffness });
        }
        Subspace::Plane(after)
    }

    #[inline(always)]
    fn root<C: Tally<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        tally: &mut C,
    ) -> Scaled<S> {
        if C::COUNTS || matches!(input, Subspace::Tip(..) | Subspace::Springs { .. }) {
            return Self::step(coefficients, input, tally).at_root(support, tally);
        }
        let plane = input.plane();
        let exponent = i64::from(plane.exponent) + i64::from(coefficients.exponent);
        Scaled::new(coefficients.minor_at(support, plane), exponent)
    }
}

impl<S: Scalar> BeamCoefficients<S> {
    /// The coefficients for `|z| <= 1`, entire in `z⁴`.
    fn small<T: Real>(z: S, built: &BuiltBeam<T>, at: &At<S>) -> Self
    where
        S: Frequency<T>,
    {
        let x = -at.lambda_squared * built.wave_fourth;
        let [c, b, f, d, e] = plane_series(x);
        let half = S::from_f64(0.5);
        BeamCoefficients {
            z,
            a: half + c * half,
            c,
            b,
            f,
            d,
            e,
            raised_b: x * b,
            raised_f: x * f,
            raised_d: x * d,
            raised_e: x * x * e,
            factors: built.length_units.factors.map(S::from_parameter),
            inverses: built.length_units.inverses.map(S::from_parameter),
            exponent: 0,
        }
    }

    /// The minors of a plane in the units of the coefficients.
    #[inline(always)]
    fn local(&self, p: Plane<S>) -> [S; 5] {
        [
            p.y_theta,
            p.y_m * self.inverses[0],
            p.w * self.inverses[1],
            p.theta_q * self.inverses[2],
            p.m_q * self.inverses[3],
        ]
    }

    /// Takes a plane through the beam.
    #[inline(always)]
    fn through(&self, plane: Plane<S>) -> Plane<S> {
        let p = self.local(plane);
        let minors = [
            self.y_theta(p),
            self.y_m(p) * self.factors[0],
            self.w(p) * self.factors[1],
            self.theta_q(p) * self.factors[2],
            self.m_q(p) * self.factors[3],
        ];
        Plane::new(minors, plane.exponent.saturating_add(self.exponent))
    }

    /// The one minor that decides at the root.
    #[inline(always)]
    fn minor_at(&self, support: Support, plane: Plane<S>) -> S {
        let p = self.local(plane);
        match support {
            Support::Fixed => self.y_theta(p),
            Support::Pinned => self.y_m(p) * self.factors[0],
            Support::Guided => self.theta_q(p) * self.factors[2],
            Support::Free => self.m_q(p) * self.factors[3],
            Support::Roller => S::zero(),
        }
    }

    // sums in pairs: short chains of dependent additions
    #[inline(always)]
    fn y_theta(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5]) -> S {
        (self.a * y_theta + self.b * y_m) + (self.f * (w + w) + self.d * theta_q) + self.e * m_q
    }

    #[inline(always)]
    fn y_m(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5]) -> S {
        (self.c * y_m - self.raised_d * y_theta) + (self.b * (w + w) + self.f * (theta_q + theta_q)) + self.d * m_q
    }

    #[inline(always)]
    fn w(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5]) -> S {
        (self.c * w - self.raised_f * y_theta) + (self.b * theta_q - self.raised_d * y_m) + self.f * m_q
    }

    #[inline(always)]
    fn theta_q(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5]) -> S {
        (self.c * theta_q - self.raised_b * y_theta) - (self.raised_f * (y_m + y_m) + self.raised_d * (w + w))
            + self.b * m_q
    }

    #[inline(always)]
    fn m_q(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5]) -> S {
        (self.a * m_q + self.raised_e * y_theta) - (self.raised_b * y_m + self.raised_f * (w + w))
            - self.raised_d * theta_q
    }

    /// The plane behind a beam with grounded springs at its free end, like one behind a tip without a look at the range.
    #[inline(always)]
    fn behind_springs(&self, y: S, theta: S) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, factors, .. } = *self;
        let (y_m, theta_q) = (theta * self.inverses[0], y * self.inverses[2]);
        let m_q = y_m * theta_q;
        let minors = [
            (a + b * y_m) + (d * theta_q + e * m_q),
            ((c * y_m - raised_d) + (f * (theta_q + theta_q) + d * m_q)) * factors[0],
            ((b * theta_q - raised_f) + (f * m_q - raised_d * y_m)) * factors[1],
            ((c * theta_q - raised_b) + (b * m_q - raised_f * (y_m + y_m))) * factors[2],
            ((a * m_q + raised_e) - (raised_b * y_m + raised_d * theta_q)) * factors[3],
        ];
        Plane::unscaled(minors, self.exponent)
    }

    /// The plane behind a beam that starts at a support: a column of the compound.
    fn behind_tip(&self, support: Support) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, .. } = *self;
        let (factor, inverse) = (self.factors, self.inverses);
        let minors = match support {
            Support::Fixed => [e * inverse[3], d * inverse[2], f * inverse[1], b * inverse[0], a],
            Support::Pinned => {
                let length = factor[0] * inverse[1];
                [d * inverse[2], (f + f) * (length * length), b * length, c, -(raised_d * factor[0])]
            }
            Support::Guided => {
                let number = factor[1] * inverse[0];
                [b * inverse[0], c, -(raised_d * number), -((raised_f + raised_f) * (number * number)), -(raised_b * factor[2])]
            }
            Support::Free => [a, -(raised_d * factor[0]), -(raised_f * factor[1]), -(raised_b * factor[2]), raised_e * factor[3]],
            // refused before: the roller is a support of planar states
            Support::Roller => [S::zero(); 5],
        };
        Plane::unscaled(minors, self.exponent)
    }
}

#[cfg(test)]
impl super::laws::Sample for Beam<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Beam { length: next(), bending_stiffness: next(), mass_per_length: next() }
    }

    fn halves(self) -> Option<Self> {
        Some(Beam { length: self.length / 2.0, ..self })
    }
}

#[cfg(test)]
mod tests;
