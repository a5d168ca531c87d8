//! A short piece of a general uniform beam over `y1, θ1 l, y2, θ2 l`, over `EI/l³`, as [the undamped one](crate::proof::general_bending) with complex
//! parameters: `EI e`, `f/e` and `k + c_e λ`.

use crate::element::{BeamNumbers, DampingNumbers, SpinNumbers};
use crate::number::Scalar;
use crate::number::constants::RECIPROCAL_FACTORIALS;
use crate::proof::ball::Ball;
use crate::proof::disc::bending::{Bending, symmetric};
use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::member::{Frequency, Member};
use crate::proof::general_bending::products::{FIRSTS, Summed, short_sums, short_terms};
use crate::proof::level::Level;
use crate::proof::number::UNDERFLOW;

/// The equations of a piece: see [`Equations`](crate::proof::general_bending::equations::Equations).
#[derive(Clone, Copy)]
pub(crate) struct Piece<N> {
    /// `EI e/l³`.
    pub(crate) factor: ComplexBall<N>,
    sigma: ComplexBall<N>,
    tau: ComplexBall<N>,
    g: ComplexBall<N>,
    h: ComplexBall<N>,
    cut: ComplexBall<N>,
    /// Sum and product of both squared wave numbers, and the square of their difference.
    sum: ComplexBall<N>,
    product: ComplexBall<N>,
    square: ComplexBall<N>,
}

/// Bounds of the sum and the product of a piece.
const SHORT: [f64; 2] = [2.0, 1.0];

/// Part of these bounds that is used, so that balls have room.
const USED: f64 = 0.9;

impl<N: Level<Word = f64>> Summed for ComplexBall<N> {
    fn of(number: f64) -> Self {
        ComplexBall::of(number)
    }

    fn doubled(self) -> Self {
        self.scaled(2.0)
    }

    fn over_factorial(self, n: usize) -> Self {
        self * Ball::reciprocal_factorial(n)
    }
}

impl<N: Level<Word = f64>> Piece<N> {
    pub(crate) fn of(
        at: &Frequency<N>,
        (beam, damping, spin): (&BeamNumbers, &DampingNumbers, &SpinNumbers),
        length: Ball<N>,
    ) -> Self {
        let one = ComplexBall::of(1.0);
        let parameter = ComplexBall::parameter;
        let loss = at.factor_of(damping, spin);
        let stiffness = loss * Ball::of_pair(beam.bending_stiffness);
        let flexibility =
            if beam.shears() { (loss * Ball::of_pair(beam.shear_stiffness)).inverse() } else { ComplexBall::of(0.0) };
        let tension = parameter(&beam.axial_force) + parameter(&beam.shear_layer);
        let inertia = at.square * Ball::of_pair(beam.rotary_inertia);
        let inertia = if spin.is_none() { inertia } else { inertia + at.moment(spin) };
        let square = length * length;
        let scale = stiffness.inverse() * square;
        let sigma = (one + tension * flexibility).inverse();
        let tau = flexibility * sigma * scale.inverse();
        let g = (sigma * tension + inertia) * scale;
        let load = at.load(&beam.mass_per_length, damping, &beam.foundation_stiffness);
        let h = -(load * (scale * square));
        let cut = sigma * (one + flexibility * inertia);
        let product = tau * h;
        let coupling = g + product;
        let variance = sigma * sigma;
        Piece {
            factor: stiffness * (square * length).inverse(),
            sigma,
            tau,
            g,
            h,
            cut,
            sum: g - product,
            product: -(h * cut),
            square: coupling * coupling + (h * variance).scaled(4.0),
        }
    }

    /// The number of equal pieces of which each is short: sum and product grow by the square and the fourth power of the length. It decides nothing.
    pub(crate) fn count(&self) -> f64 {
        let by_sum = Scalar::sqrt(self.sum.size() / (USED * SHORT[0]));
        let by_product = Scalar::sqrt(Scalar::sqrt(self.product.size() / (USED * SHORT[1])));
        1.0 + (if by_sum > by_product { by_sum } else { by_product })
    }

    /// The stiffness, where the piece is short; elsewhere nothing is known of it. The series and their rest are those of the undamped beam: they
    /// ask for the sizes of sum and product alone.
    pub(crate) fn stiffness(&self) -> Bending<N> {
        let Piece { sigma, tau, g, h, cut, sum: s, product: d, square, .. } = *self;
        let (one, terms) = (ComplexBall::of(1.0), short_terms(N::TERMS));
        let mut sums = short_sums([s, d, square], terms);
        let is_short = s.largest() <= SHORT[0] && d.largest() <= SHORT[1];
        let power = (0..terms).fold(2.0 * (terms as f64 + 1.0) * (1.0 + 1e-12), |power, _| 4.0 * power);
        for (sum, first) in sums.iter_mut().zip(FIRSTS) {
            let rest = power * RECIPROCAL_FACTORIALS[2 * terms + first][0] + UNDERFLOW;
            *sum = sum.widened(if is_short { rest } else { f64::INFINITY });
        }
        let [w, half_r, v, e, c2, c3, rest] = sums;
        let c1 = one - d * rest;
        let variance = sigma * sigma;
        let minor = (tau * half_r + variance * e).scaled(2.0);
        let inverse = minor.inverse();
        let entries = [
            w - (h * tau * v).scaled(2.0),
            sigma * (half_r - (g + tau * h) * e),
            tau * w + (cut * v).scaled(2.0),
            c1 + g * c3,
            sigma * c2,
            c3 * (tau * tau * h + variance) - tau * c1,
        ]
        .map(|entry| entry * inverse);
        let terms = 2.0 * (tau.size() * half_r.size() + variance.size() * e.size());
        Member { stiffness: symmetric(entries), minor, terms }
    }
}
