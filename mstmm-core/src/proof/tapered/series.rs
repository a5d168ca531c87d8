//! The stiffness of a short piece, by Taylor series with a bound of their rest.
//!
//! With a constant C, terms of all orders k obey `|y_k| <= C ρ^-k/16`, `|θ_k| <= C ρ^-k`, `|m_k| <= C ρ^-k` and `|q_k| <= 8 C ρ^-k`.
//!
//! *Proof*. C is read off the orders up to 64. Let all this hold below the order n, which is larger. The order n follows from the one
//! before by a slope over n, in which `ρ/n <= 1/16`. By `|β|ρ, |η|ρ <= 1/2` the series of `1/E` has absolute values that add up to
//! `F <= 16` at ρ: those of `1/((1 - |β|s)(1 - |η|s)³)` do. In units of `C ρ^-n` the limits then give, for y, θ, m and q,
//!
//! ```text
//! 1/16 · 1 = 1/16     1/16 · F · 1 <= 1     1/16 · (|G| · 1 + 8) <= 1     1/16 · |P|/16 <= 290/256 < 8   ∎
//! ```

use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::member::Member;
use crate::proof::number::Number;
use crate::proof::tapered::{Piece, RADIUS};
use crate::proof::word::Word;

/// The bounds of y, θ, m and q over `C ρ^-k`.
const WEIGHTS: [f64; 4] = [0.0625, 1.0, 1.0, 8.0];
/// The last order at least, and the last one whatever the rest is.
const LEAST_ORDER: usize = 64;
const MOST_ORDER: usize = 160;
/// Terms of this order and above are added up by themselves first: to a small sum, of which a small part is rounded.
const SMALL_ORDER: usize = 8;

impl<N: Level> Piece<N> {
    /// The stiffness. Displacements `z = (y, θ)` and forces `p = (-q, m)` obey `z₂ = A z₁ + B p₁` and `p₂ = C z₁ + D p₁`: it is
    /// `[[B⁻¹A, -B⁻¹], [-B⁻ᵀ, D B⁻¹]]`, in units `EI/Δ` and as many `1/Δ` as it has deflections.
    pub(super) fn member(&self) -> Member<N, 4, 10> {
        let [y, t, p, m] = self.columns([(0, 1.0), (1, 1.0), (3, -1.0), (2, 1.0)]);
        let minor = |u: [Ball<N>; 4], v: [Ball<N>; 4], i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let det = minor(p, m, 0, 1);
        let over = self.length.inverse();
        let rotation = self.stiffness * over * det.inverse();
        let [mixed, across] = [rotation * over, rotation * over * over];
        let stiffness = [
            across * minor(y, m, 0, 1),
            mixed * minor(p, y, 0, 1),
            rotation * minor(p, t, 0, 1),
            -(across * m[1]),
            mixed * p[1],
            across * minor(p, m, 1, 3),
            mixed * m[0],
            -(rotation * p[0]),
            mixed * minor(p, m, 2, 1),
            rotation * minor(p, m, 0, 2),
        ];
        let sizes = [[0, 3], [2, 7], [5, 3], [9, 7]].map(|of| {
            let [own, between] = of.map(|k: usize| stiffness[k].mid.size().first());
            own.max(between)
        });
        let flexibility = self.length.mid.leading() * self.length.mid.leading() / self.stiffness.mid.leading();
        let minor = det.mid.leading() * flexibility * flexibility;
        Member { stiffness, border: None, held: [N::Word::of(0.0); 2], minor, sizes }
    }

    /// The states at the other end that are one unit at this one.
    fn columns(&self, units: [(usize, f64); 4]) -> [[Ball<N>; 4]; 4] {
        let word = N::Word::of;
        let mut series = units.map(|(number, unit)| {
            let mut terms = [[Ball::of(0.0); 4]; 5];
            terms[0][number] = Ball::of(unit);
            // 1 is within the weights of 16
            Series { terms, sums: [terms[0], terms[1]], bends: [Ball::of(0.0); 4], most: word(16.0) }
        });
        let mut power = 1.0;
        for order in 1..=MOST_ORDER {
            power *= RADIUS;
            let over = Ball::of(order as f64).inverse();
            series.iter_mut().for_each(|series| series.extend(self, over, order, power));
            let is_small = |series: &Series<N>| {
                let rest = series.most * word(1.0 / power);
                N::Word::all(rest.is_less(word(0.02 * N::SUM)))
            };
            if order >= LEAST_ORDER && series.iter().all(is_small) {
                break;
            }
        }
        // Σ ρ^-k over the orders beyond is a third of the last
        series.map(|Series { sums: [first, small], most, .. }| {
            [0, 1, 2, 3].map(|k| (first[k] + small[k]).widened(most * word(0.34 * WEIGHTS[k] / power)))
        })
    }
}

/// The Taylor series of a state.
struct Series<N: Number> {
    /// The last terms, the newest first.
    terms: [[Ball<N>; 4]; 5],
    sums: [[Ball<N>; 4]; 2],
    /// The last terms of m over the first factors of E.
    bends: [Ball<N>; 4],
    /// C
    most: N::Word,
}

impl<N: Level> Series<N> {
    /// Adds the next term, of an order, given the inverse of that and the power of ρ.
    fn extend(&mut self, piece: &Piece<N>, over: Ball<N>, order: usize, power: f64) {
        let [_, theta, mut bend, q] = self.terms[0];
        for (last, change) in self.bends.iter_mut().zip([piece.beta, piece.eta, piece.eta, piece.eta]) {
            *last = bend - change * *last;
            bend = *last;
        }
        let times = |polynomial: &[Ball<N>], number: usize| {
            polynomial.iter().zip(&self.terms).fold(Ball::of(0.0), |sum, (factor, term)| sum + *factor * term[number])
        };
        let next = [theta, bend, q + times(&piece.g, 1), times(&piece.p, 0)].map(|slope| slope * over);
        self.terms.rotate_right(1);
        self.terms[0] = next;
        let sum = &mut self.sums[usize::from(order >= SMALL_ORDER)];
        for k in 0..4 {
            sum[k] = sum[k] + next[k];
            self.most = self.most.or_larger(next[k].largest() * N::Word::of(power / WEIGHTS[k]));
        }
    }
}
