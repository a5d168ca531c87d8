//! Euler-Bernoulli beam.

use crate::at::At;
use crate::beam_functions::{bending_matrix, plane_series};
use crate::bounds::FrequencyBounds;
use crate::count::{BeamSigns, Tally};
use crate::element::{Element, PlaneStep, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real, Scalar, WaveProducts};
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
        let WaveProducts { ch_cos, ch_sin, sh_cos, sh_sin: f, one, exponent } = z.wave_products();
        let (b, d, e) = (ch_sin + sh_cos, ch_sin - sh_cos, one - ch_cos);
        BeamCoefficients {
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
            factors: core::array::from_fn(|k| at.powers[k] * built.wave_units.factors[k]),
            inverses: core::array::from_fn(|k| at.inverse_powers[k] * built.wave_units.inverses[k]),
            // above stands twice of each
            exponent: exponent - 1,
        }
    }

    #[inline(always)]
    fn step<C: Tally<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, tally: &mut C) -> Subspace<S> {
        let after = match input {
            Subspace::Tip(support, _) => coefficients.behind_tip(support),
            Subspace::Springs { y, theta } => coefficients.behind_springs(y, theta),
            Subspace::OnPin(plane) => coefficients.behind_pin(&plane).in_range(),
            _ => coefficients.through(&input.plane()).in_range(),
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
        if C::COUNTS || matches!(input, Subspace::Tip(..)) {
            return Self::step(coefficients, input, tally).at_root(support, tally);
        }
        // no look at the range: only the minor that decides is needed
        let plane = match input {
            Subspace::Springs { y, theta } => coefficients.behind_springs(y, theta),
            Subspace::OnPin(plane) => coefficients.behind_pin(&plane),
            _ => coefficients.through(&input.plane()),
        };
        Scaled::new(plane.minor_at(support), i64::from(plane.exponent))
    }
}

impl<S: Scalar> BeamCoefficients<S> {
    /// The coefficients for `|z| <= 1`, entire in `z⁴`.
    #[cold]
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

    /// The plane behind the beam, given its minors in the units of the coefficients.
    #[inline(always)]
    fn plane(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5], exponent: i32) -> Plane<S> {
        let factors = self.factors;
        let minors = [y_theta, y_m * factors[0], w * factors[1], theta_q * factors[2], m_q * factors[3]];
        Plane::unscaled(minors, exponent.saturating_add(self.exponent))
    }

    /// Takes a plane through the beam. Sums in pairs: short chains of dependent additions.
    #[inline(always)]
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, inverses, .. } = *self;
        let (y_theta, y_m, w) = (p.y_theta, p.y_m * inverses[0], p.w * inverses[1]);
        let (theta_q, m_q) = (p.theta_q * inverses[2], p.m_q * inverses[3]);
        let (two_y_m, two_w, two_theta_q) = (y_m + y_m, w + w, theta_q + theta_q);
        let minors = [
            (a * y_theta + b * y_m) + (f * two_w + d * theta_q) + e * m_q,
            (c * y_m - raised_d * y_theta) + (b * two_w + f * two_theta_q) + d * m_q,
            (c * w - raised_f * y_theta) + (b * theta_q - raised_d * y_m) + f * m_q,
            (c * theta_q - raised_b * y_theta) - (raised_f * two_y_m + raised_d * two_w) + b * m_q,
            (a * m_q + raised_e * y_theta) - (raised_b * y_m + raised_f * two_w) - raised_d * theta_q,
        ];
        self.plane(minors, p.exponent)
    }

    /// The same for the plane of a point on a pin.
    #[inline(always)]
    fn behind_pin(&self, p: &Plane<S>) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_d, inverses, .. } = *self;
        let (theta_q, m_q) = (p.theta_q * inverses[2], p.m_q * inverses[3]);
        let minors = [
            d * theta_q + e * m_q,
            f * (theta_q + theta_q) + d * m_q,
            b * theta_q + f * m_q,
            c * theta_q + b * m_q,
            a * m_q - raised_d * theta_q,
        ];
        self.plane(minors, p.exponent)
    }

    /// The same for grounded springs at the free end of the beam, like behind a tip without a look at the range.
    #[inline(always)]
    fn behind_springs(&self, y: Option<S>, theta: Option<S>) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, raised_e, inverses, .. } = *self;
        let minors = match (theta.map(|theta| theta * inverses[0]), y.map(|y| y * inverses[2])) {
            (None, None) => [a, -raised_d, -raised_f, -raised_b, raised_e],
            (Some(y_m), None) => [
                a + b * y_m,
                c * y_m - raised_d,
                -(raised_f + raised_d * y_m),
                -(raised_b + raised_f * (y_m + y_m)),
                raised_e - raised_b * y_m,
            ],
            (None, Some(theta_q)) => [
                a + d * theta_q,
                f * (theta_q + theta_q) - raised_d,
                b * theta_q - raised_f,
                c * theta_q - raised_b,
                raised_e - raised_d * theta_q,
            ],
            (Some(y_m), Some(theta_q)) => {
                let m_q = y_m * theta_q;
                [
                    (a + b * y_m) + (d * theta_q + e * m_q),
                    (c * y_m - raised_d) + (f * (theta_q + theta_q) + d * m_q),
                    (b * theta_q - raised_f) + (f * m_q - raised_d * y_m),
                    (c * theta_q - raised_b) + (b * m_q - raised_f * (y_m + y_m)),
                    (a * m_q + raised_e) - (raised_b * y_m + raised_d * theta_q),
                ]
            }
        };
        self.plane(minors, 0)
    }

    /// The plane behind a beam that starts at a support: a column of the compound.
    fn behind_tip(&self, support: Support) -> Plane<S> {
        let BeamCoefficients { a, c, b, f, d, e, raised_b, raised_f, raised_d, .. } = *self;
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
            Support::Free => return self.behind_springs(None, None),
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
