//! A part of a tapered beam: planes and states go through it by Taylor series.

use crate::elements::shared::compound::Units;
use crate::elements::tapered_beam::profile::Profile;
use crate::elements::tapered_beam::series;
use crate::number::{Scalar, twice};
use crate::subspace::{Held, Plane};

/// Bound of `(max q Δ⁴/EI)^¼ + (max |g| Δ²/EI)^½`, beyond which series lose digits.
const REACH: f64 = 2.5;

/// Bounds of `Δ² ∫ Y''²` over `∫ Y'²`, and of `Δ⁴ ∫ Y''²` over `∫ Y²`, of deflections with both ends clamped: 4π² and 4.73⁴ rounded down.
const CLAMPED: [f64; 2] = [39.4, 500.0];

/// A part of a beam in units of its length Δ and of EI at its start, with polynomials in the share of Δ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<S> {
    length: S,
    stiffness: S,
    /// EI, of first coefficient 1.
    e: [S; 5],
    /// `N + r λ²`
    g: [S; 5],
    /// `-m (λ² - Ω² sin² ψ) - k`
    q: [S; 3],
    /// The product of EI and q.
    qe: [S; 7],
}

impl<S: Scalar> Part<S> {
    /// The part from a share of the length of a beam, of a width that is such a share.
    pub(super) fn new(beam: &Profile<S>, start: f64, width: f64) -> Self {
        let wide = S::from_f64(width);
        let (b, h, radius) = (beam.width.at(start), beam.height.at(start), beam.radius.at(start));
        let (beta, eta) = (beam.width.change * wide / b, beam.height.change * wide / h);
        let length = beam.length * wide;
        let stiffness = beam.stiffness_at(start);
        let flexibility = S::one() / stiffness;
        let (mass, square) = (beam.mass * b * h, length * length);
        let m = [S::one(), beta + eta, beta * eta];
        let three = S::from_f64(3.0);
        let cubic = [S::one(), three * eta, three * eta * eta, eta * eta * eta, S::zero()];
        let e: [S; 5] = core::array::from_fn(|k| if k == 0 { S::one() } else { cubic[k] + beta * cubic[k - 1] });
        // the slope of the axial force is the load and the centrifugal force, which pull towards the end where the other force acts
        let [load, centrifugal] = [beam.load * length, beam.speed_squared * length * mass];
        let [load, pull] = if beam.outer > start { [-load, -centrifugal] } else { [load, centrifugal] };
        let further = beam.radius.change * wide;
        let product = |k: usize| {
            let own = if k < 3 { m[k] * radius } else { S::zero() };
            own + if k > 0 { m[k - 1] * further } else { S::zero() }
        };
        let rotary = beam.rotary_at(start) * beam.lambda_squared;
        let g = core::array::from_fn(|k| {
            let force = match k {
                0 => beam.force_at(start),
                1 => load + pull * product(0),
                _ => pull * product(k - 1) / S::from_f64(k as f64),
            };
            (force + rotary * e[k]) * square * flexibility
        });
        let unit = square * square * flexibility;
        let mut q = m.map(|m| -(m * mass * beam.of_mass * unit));
        q[0] -= beam.foundation * unit;
        let mut qe = [S::zero(); 7];
        for (k, factor) in q.iter().enumerate() {
            for (j, entry) in e.iter().enumerate() {
                qe[k + j] += *factor * *entry;
            }
        }
        Part { length, stiffness, e, g, q, qe }
    }

    /// The minors of a plane behind the part, not shifted into the range. `None` if the series does not converge.
    pub(super) fn plane(&self, plane: &Plane<S>) -> Option<Plane<S>> {
        let Units { factors: f, inverses: i } = Units::new(self.stiffness, S::one() / self.length);
        let first = [plane.y_theta, plane.y_m * i[0], plane.w * i[1], plane.theta_q * i[2], plane.m_q * i[3]];
        let [y_theta, y_m, w, theta_q, m_q] = self.minors(first)?;
        Some(Plane::unscaled([y_theta, y_m * f[0], w * f[1], theta_q * f[2], m_q * f[3]], plane.exponent))
    }

    /// The same in units of the part.
    fn minors(&self, first: [S; 5]) -> Option<[S; 5]> {
        series::sum(first, |terms| {
            let [y_m, w, theta_q, m_q] = [1, 2, 3, 4].map(|number| terms.before(0, number));
            [
                y_m - terms.convolved_slope(&self.e, 0),
                twice(w) + terms.convolved(&self.g, 0),
                theta_q,
                m_q - terms.convolved(&self.qe, 0) - terms.convolved_slope(&self.e, 3),
                terms.convolved(&self.g, 3) - terms.convolved(&self.q, 1),
            ]
        })
    }

    /// Y, Θ, M, Q behind the part. `None` if the series does not converge.
    pub(super) fn state(&self, state: [S; 4]) -> Option<[S; 4]> {
        let moment = self.stiffness / self.length;
        let units = [self.length, S::one(), moment, moment / self.length];
        let first = core::array::from_fn(|k| state[k] / units[k]);
        let behind = series::sum(first, |terms| {
            let [theta, m, q] = [1, 2, 3].map(|number| terms.before(0, number));
            let moment = m - terms.convolved_slope(&self.e, 1);
            [theta, moment, q + terms.convolved(&self.g, 1), terms.convolved(&self.q, 0)]
        })?;
        Some(core::array::from_fn(|k| behind[k] * units[k]))
    }

    /// What a count needs of the part with both ends clamped: it has no frequency below this one.
    pub(super) fn held(&self) -> Option<Held<S>> {
        let unit =
            |number: usize| self.minors(core::array::from_fn(|k| if k == number { S::one() } else { S::zero() }));
        let ([k01, ..], [k04, ..]) = (unit(1)?, unit(4)?);
        let stiffness = Units::new(self.stiffness, S::one() / self.length).factors[2] * k01;
        Some(Held {
            below: S::Size::default(),
            is_negative: k04.is_negative(),
            stiffness: [stiffness, k04],
            units: None,
        })
    }
}

/// Whether a part of a beam is so short that its series converge, and that it has no frequency below the present one with both ends
/// clamped. The beam has the sizes of parameters and of λ².
pub(super) fn is_short(beam: &Profile<f64>, start: f64, width: f64) -> bool {
    let (b, h) = (beam.width.at(start), beam.height.at(start));
    let (beta, eta) = (beam.width.change * width / b, beam.height.change * width / h);
    // the section vanishes no nearer than at twice the length
    if beta.size() > 0.5 || eta.size() > 0.5 {
        return false;
    }
    let [least_b, least_h] = [beta, eta].map(|change| 1.0 + change.min(0.0));
    let [most_b, most_h] = [beta, eta].map(|change| 1.0 + change.max(0.0));
    let least = least_b * least_h * least_h * least_h;
    let length = beam.length * width;
    let square = length * length / beam.stiffness_at(start);
    let most_mass = beam.mass * b * h * most_b * most_h;
    let farthest = beam.radius.at(start).size().max(beam.radius.at(start + width).size());
    let load = beam.load.size() + beam.speed_squared * most_mass * farthest;
    let force = beam.force_at(start).size() + length * load;
    let rotary = beam.rotary_at(start) * beam.lambda_squared * most_b * most_h * most_h * most_h;
    let g = (force + rotary) * square;
    let q = beam.most_hold(most_mass) * square * length * length;
    let [by_slope, by_deflection] = CLAMPED;
    Scalar::sqrt(Scalar::sqrt(q)) + Scalar::sqrt(g) < REACH && g / by_slope + q / by_deflection < least
}
