//! The count of a general beam with both ends held, in bounds.

use crate::number::constants::HALF_PI;
use crate::proof::ball::Ball;
use crate::proof::general_bending::equations::{Equations, Roots, either};
use crate::proof::level::Level;
use crate::proof::member::any;
use crate::proof::word::Word;
use core::f64::consts::FRAC_1_PI;

/// Half waves from which on nothing is counted: far more than sines are known for.
const MOST_HALF_WAVES: f64 = 1e9;

impl<N: Level> Equations<N> {
    /// Bounds of the count of the beam with both ends pinned, and where they are known.
    ///
    /// Its shapes are `Y = sin kx`, `Θ = cos kx` with `k = nπ`, each with a stiffness of two rows. The determinant has the sign of
    /// `(k² + κ₁)(k² + κ₂)`. For large k the stiffness is positive definite. Between two waves that travel one eigenvalue is negative. Below
    /// both the signs are those for k near zero, of `-h` and `cut`. There `d = -h cut` is positive: two are negative where h > 0, none where
    /// h < 0. In the shape n = 0 all sections turn: it counts where cut < 0, and does not exist without shear.
    #[inline(always)]
    pub(crate) fn pinned(
        &self,
        shears: bool,
        is_short: <N::Word as Word>::Mask,
        [larger, smaller, _]: Roots<N>,
    ) -> ([N::Word; 2], <N::Word as Word>::Mask) {
        let (word, zero) = (N::Word::of, N::Word::of(0.0));
        let (first, second) = (half_waves(larger), half_waves(smaller));
        let more = [first[0].or_larger(second[0]), first[1].or_larger(second[1])];
        let fewer = [-(-first[0]).or_larger(-second[0]), -(-first[1]).or_larger(-second[1])];
        let least = (more[0] - fewer[1]).or_larger(zero);
        let least = N::Word::select(self.h.is_positive(), more[0] + fewer[0], least);
        let most = N::Word::select(self.h.is_negative(), more[1] - fewer[0], more[1] + fewer[1]);
        // Complex κ count nothing. Short waves do not either: no κ is beyond 1 + √2, and π² is.
        let square = self.waves.square;
        let counts_none = either::<N::Word>(is_short, square.is_negative());
        let may_count_none = either::<N::Word>(counts_none, N::Word::not(square.is_positive()));
        let bounds = [N::Word::select(may_count_none, zero, least), N::Word::select(counts_none, zero, most)];
        let [is_finite, is_other_finite] = [first, second].map(|[_, most]| most.is_less(word(MOST_HALF_WAVES)));
        let is_known = either::<N::Word>(counts_none, N::Word::both(is_finite, is_other_finite));
        let [turns, may_turn] = [self.cut.is_negative(), N::Word::not(self.cut.is_positive())]
            .map(|truth| if shears { N::Word::select(truth, word(1.0), zero) } else { zero });
        ([bounds[0] + turns, bounds[1] + may_turn], is_known)
    }
}

/// Bounds of the number of frequencies with both ends held, by those of the pinned beam.
///
/// It is less by the negative eigenvalues of the stiffness against rotations of both ends. The minor is negative where the number is odd. So
/// the parity of both numbers says whether one eigenvalue is negative. Else both have the sign of their mean. By the symmetry of the beam
/// that is the stiffness of an end, `K₁₄/K₀₄`: none is negative, or two are.
///
/// Each number that the pinned beam may have gives numbers of the held one, and these do not fall as it grows. So the ends of its range give
/// those of theirs. Beside one jump of the pinned beam both ends give the same number, beside two at once they do not.
#[inline(always)]
pub(crate) fn clamped<N: Level>([least, most]: [N::Word; 2], minor: Ball<N>, rotation: Ball<N>) -> [N::Word; 2] {
    let word = N::Word::of;
    let is_negative = minor.is_negative();
    let parity = N::Word::select(is_negative, word(1.0), word(0.0));
    let mean = Ball::select(is_negative, -rotation, rotation);
    let less = |pinned: N::Word, even: N::Word| pinned - N::Word::select((pinned - parity).is_odd(), word(1.0), even);
    let [few, many] = [(mean.is_positive(), 0.0, 2.0), (mean.is_negative(), 2.0, 0.0)]
        .map(|(truth, number, other)| N::Word::select(truth, word(number), word(other)));
    [less(least, few).or_larger(parity), less(most, many)]
}

/// Bounds of the number of `n >= 1` with `(nπ)² < -κ`.
#[inline(always)]
fn half_waves<N: Level>(kappa: Ball<N>) -> [N::Word; 2] {
    let word = N::Word::of;
    let square = -kappa;
    let (middle, spread) = (square.mid.leading(), square.rad + square.mid.size() * word(1e-14));
    let (least, most) = (whole(middle - spread, 1.0 - 1e-14), whole(middle + spread, 1.0 + 1e-14));
    let is_open = least.is_less(most);
    if !any::<N::Word>(is_open) {
        return [least, most];
    }
    let [first, second, third, fourth, ..] = HALF_PI;
    let pi = N::of_parts([first, second, third, fourth]);
    let phase = Ball { mid: pi, rad: word(N::SUM * first) }.scaled(2.0) * Ball::exactly(N::of_word(most));
    let beyond = square - phase * phase;
    [
        N::Word::select(N::Word::both(is_open, beyond.is_positive()), most, least),
        N::Word::select(N::Word::both(is_open, beyond.is_negative()), most - word(1.0), most),
    ]
}

/// The whole half waves of a share of the root of a square; a NaN stays.
#[inline(always)]
fn whole<W: Word>(square: W, share: f64) -> W {
    let phase = W::select(square.is_less(W::of(0.0)), W::of(0.0), square).root() * W::of(FRAC_1_PI * share);
    let nearest = phase.nearest();
    nearest - W::select(phase.is_less(nearest), W::of(1.0), W::of(0.0))
}
