//! The bending of a general uniform beam over `y1, θ1 l, y2, θ2 l`, over `EI/l³`: shear, rotary inertia, axial force, foundation.
//!
//! Lengths are in l and forces in EI/l². With `T = N + G` the state obeys `Y' = σΘ - τQ`, `Θ' = M`, `M' = gΘ + σQ`, `Q' = hY`. So
//! `exp A = c₀ + c₁A + c₂A² + c₃A³` takes (M, Q) to (Y, Θ) by `B = [[σc₂, (σ² + τ²h)c₃ - τc₁], [c₁ + gc₃, σc₂]]`. Between the ends the
//! stiffness is the inverse of B but for signs. Its determinant, the minor, is `K₀₄ = τR + 2σ²E`. An end's own stiffness is
//! `K₃₄ = W - 2hτV`, `K₂₄ = σ(R/2 - (g + τh)E)` and `K₁₄ = τW + 2 cut V` over it: minors of two rows of exp A.

use crate::element::BeamNumbers;
use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, sizes_of, symmetric};
use crate::proof::level::Level;
use crate::proof::member::BESIDE_POLE;
use crate::proof::number::Number;
use crate::proof::word::{Word, apart};
use equations::{Equations, either, select_all};
use held::clamped;
use products::{apart_by_roots, of_forms, short, together};

mod equations;
mod held;
pub(crate) mod products;

/// A general beam at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct General<N: Number> {
    pub(crate) member: Bending<N>,
    /// Where the beam is better cut in two: its minor is small, or its count is a range. It decides nothing.
    pub(crate) is_beside_pole: <N::Word as Word>::Mask,
}

apart! {
    /// The beam at a squared frequency of either sign, with a moment per length and rotation, of either sign, if it spins. EI, m and `1 + (N + G) f` are
    /// positive, f and r zero or positive.
    pub(crate) fn general_bending<N: Level>(
        beam: &BeamNumbers,
        length: Ball<N>,
        square: Ball<N>,
        moment: Option<Ball<N>>,
    ) -> General<N> {
        let word = N::Word::of;
        let at = Equations::of(beam, length, square, moment);
        let Equations { sigma, tau, g, h, cut, waves, .. } = at;
        // a short wave is one whose whole balls are: the bound of the rest of its series needs it
        let is_short = N::Word::both(waves.sum.largest().is_less(word(2.0)), waves.product.largest().is_less(word(1.0)));
        let is_together = waves.square.mid.leading().is_less(waves.product.mid.leading() * word(4.0));
        let is_apart = N::Word::not(either::<N::Word>(is_short, is_together));
        let roots = if N::Word::all(is_short) { [Ball::of(0.0); 3] } else { waves.roots() };
        let [w, r, v, e, difference, c1, c2, c3, terms] = of_forms::<N, 9>(
            [is_short, is_apart],
            |truth| short(&at, waves.where_true(truth, [0.0; 3])),
            |truth| apart_by_roots(&at, select_all(truth, roots, [Ball::of(1.0), Ball::of(-1.0), Ball::of(2.0)])),
            |truth| together(&at, waves.where_true(truth, [0.0, 1.0, -4.0])),
        );
        let variance = sigma * sigma;
        let minor = tau * r + (variance * e).scaled(2.0);
        let rotation = tau * w + (cut * v).scaled(2.0);
        let inverse = minor.inverse();
        let entries = [
            (w - (h * tau * v).scaled(2.0)) * inverse,
            sigma * difference * inverse,
            rotation * inverse,
            (c1 + g * c3) * inverse,
            sigma * c2 * inverse,
            (c3 * (tau * tau * h + variance) - tau * c1) * inverse,
        ];
        let (pinned, is_counted) = at.pinned(beam.shears(), is_short, roots);
        let held = clamped(pinned, minor, rotation);
        let is_beside = (minor.mid.size() / terms.mid.size()).is_less(word(BESIDE_POLE));
        let has_sign = either::<N::Word>(minor.is_negative(), minor.is_positive());
        let is_known = N::Word::both(has_sign, N::Word::both(is_counted, sigma.is_positive()));
        General {
            member: Bending {
                sizes: sizes_of(entries),
                stiffness: symmetric(entries),
                border: None,
                held,
                minor: minor.mid.leading(),
            }
            .known_where(is_known),
            is_beside_pole: either::<N::Word>(is_beside, held[0].is_less(held[1])),
        }
    }
}
