//! The bending of a general uniform beam over `y1, θ1 l, y2, θ2 l`, over `EI/l³`: shear, rotary inertia, axial force, foundation.
//!
//! Lengths are in l and forces in EI/l². With `T = N + G` the state obeys `Y' = σΘ - τQ`, `Θ' = M`, `M' = gΘ + σQ`, `Q' = hY`.

use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, sizes_of, symmetric};
use crate::proof::constants::{HALF_PI, RECIPROCAL_FACTORIALS};
use crate::proof::functions::Level;
use crate::proof::member::{BESIDE_POLE, any, both, not};
use crate::proof::number::Number;
use crate::proof::word::Word;
use core::f64::consts::FRAC_1_PI;

/// The parameters of a general beam, each the exact sum of two words. EI, m and `1 + (N + G) f` are positive, f and r zero or positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GeneralSection {
    pub(crate) bending_stiffness: [f64; 2],
    pub(crate) mass_per_length: [f64; 2],
    /// `f = 1/(k G A)`; zero is a beam without shear.
    pub(crate) shear_flexibility: [f64; 2],
    pub(crate) rotary_inertia: [f64; 2],
    pub(crate) axial_force: [f64; 2],
    pub(crate) shear_layer: [f64; 2],
    pub(crate) foundation_stiffness: [f64; 2],
}

/// A general beam at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct General<N: Number> {
    pub(crate) member: Bending<N>,
    /// Where the beam is better cut in two: its minor is small, or its count is a range. It decides nothing.
    pub(crate) is_beside_pole: <N::Word as Word>::Mask,
}

/// The constants of the equations.
#[derive(Clone, Copy)]
struct Equations<N: Number> {
    /// `1/(1 + T f)`.
    sigma: Ball<N>,
    /// `f σ EI/l²`.
    tau: Ball<N>,
    /// `(σ T - r ω²) l²/EI`.
    g: Ball<N>,
    /// `(m ω² - k) l⁴/EI`.
    h: Ball<N>,
    /// `σ² + τ g`.
    cut: Ball<N>,
    /// `g + τ h`.
    coupling: Ball<N>,
    waves: WavePair<N>,
}

/// The two squared wave numbers κ, which are negative where waves travel: `κ² - s κ + d = 0`.
#[derive(Clone, Copy)]
struct WavePair<N: Number> {
    /// s.
    sum: Ball<N>,
    /// d.
    product: Ball<N>,
    /// `δ = (κ₁ - κ₂)²`.
    square: Ball<N>,
}

/// The κ that is larger in size, the other one, and the first less the second.
type Roots<N> = [Ball<N>; 3];

/// With `C = cosh √κ` and `S = sinh √κ/√κ`: `W = (κ₁ S₁ C₂ - κ₂ C₁ S₂)/(κ₁ - κ₂)`, `R = S₁ S₂`, `V = (C₁ S₂ - S₁ C₂)/(2(κ₁ - κ₂))`,
/// `E = (1 - C₁ C₂ + s R/2)/δ`, `D = R/2 - (g + τh) E`, `c₁ = (κ₁ S₂ - κ₂ S₁)/(κ₁ - κ₂)`, `c₂ = (C₁ - C₂)/(κ₁ - κ₂)` and
/// `c₃ = (S₁ - S₂)/(κ₁ - κ₂)`. Last is about the size of the terms of `τR + 2σ²E`. All are times the same positive number.
type Products<N> = [Ball<N>; 9];

/// C and S, both times `e^-x`; x, which is √κ where that is real and not small, else 0; `e^-x`; the amplitudes of C and S.
type Waves<N> = [Ball<N>; 6];

/// Half waves from which on nothing is counted: far more than sines are known for.
const MOST_HALF_WAVES: f64 = 1e9;

/// The beam at a squared frequency of either sign.
#[inline(always)]
pub(crate) fn general_bending<N: Level>(section: &GeneralSection, length: Ball<N>, square: Ball<N>) -> General<N> {
    let word = N::Word::of;
    let at = Equations::of(section, length, square);
    let Equations { sigma, tau, g, h, cut, waves, .. } = at;
    // whole balls are short: the bound of the series' rest needs it
    let is_short = both::<N::Word>(waves.sum.largest().is_less(word(2.0)), waves.product.largest().is_less(word(1.0)));
    let is_together = waves.square.mid.leading().is_less(waves.product.mid.leading() * word(4.0));
    let is_apart = not::<N::Word>(either::<N::Word>(is_short, is_together));
    let roots = if N::Word::all(is_short) { [Ball::of(0.0); 3] } else { waves.roots() };
    let [w, r, v, e, difference, c1, c2, c3, terms] = of_forms::<N, 9>(
        [is_short, is_apart],
        |truth| at.short(waves.where_true(truth, [0.0; 3])),
        |truth| at.apart(select_all(truth, roots, [1.0, -1.0, 2.0].map(Ball::of))),
        |truth| at.together(waves.where_true(truth, [0.0, 1.0, -4.0])),
    );
    let variance = sigma * sigma;
    let minor = tau * r + (variance * e).scaled(2.0);
    let rotation = tau * w + (cut * v).scaled(2.0);
    let inverse = minor.inverse();
    let entries = [
        w - (h * tau * v).scaled(2.0),
        sigma * difference,
        rotation,
        c1 + g * c3,
        sigma * c2,
        c3 * (tau * tau * h + variance) - tau * c1,
    ]
    .map(|entry| entry * inverse);
    let shears = section.shear_flexibility != [0.0; 2];
    let (pinned, is_counted) = at.pinned(shears, is_short, roots);
    let held = clamped(pinned, minor, rotation);
    let is_beside = (minor.mid.size() / terms.mid.size()).is_less(word(BESIDE_POLE));
    let is_known = both::<N::Word>(has_sign(minor), both::<N::Word>(is_counted, sigma.is_positive()));
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

impl<N: Level> Equations<N> {
    #[inline(always)]
    fn of(section: &GeneralSection, length: Ball<N>, square: Ball<N>) -> Self {
        let [stiffness, mass, flexibility, rotary, axial, layer, foundation] = [
            section.bending_stiffness,
            section.mass_per_length,
            section.shear_flexibility,
            section.rotary_inertia,
            section.axial_force,
            section.shear_layer,
            section.foundation_stiffness,
        ]
        .map(Ball::<N>::of_pair);
        let (one, tension, inertia) = (Ball::of(1.0), axial + layer, rotary * square);
        let length_squared = length * length;
        let scale = length_squared * stiffness.inverse();
        let sigma = (one + tension * flexibility).inverse();
        let tau = flexibility * sigma * scale.inverse();
        let g = (sigma * tension - inertia) * scale;
        let h = (mass * square - foundation) * (scale * length_squared);
        // σ² + τg = σ² (1 + T f) - σ f r ω², and σ (1 + T f) = 1
        let cut = sigma * (one - flexibility * inertia);
        let product = tau * h;
        let (coupling, inertia) = (g + product, h * (sigma * sigma));
        // (κ₁ - κ₂)² = s² - 4d, without cancellation where h > 0
        let square = coupling * coupling + inertia.scaled(4.0);
        let waves = WavePair { sum: g - product, product: -(h * cut), square };
        Equations { sigma, tau, g, h, cut, coupling, waves }
    }

    /// About the size of the terms of `τR + 2σ²E`, for those of R and E.
    #[inline(always)]
    fn terms(&self, [r, e]: [N::Word; 2]) -> Ball<N> {
        let [sigma, tau] = [self.sigma, self.tau].map(|ball| ball.mid.size());
        size_of(tau * r + (sigma * sigma + sigma * sigma) * e)
    }

    /// Series, where `|s| <= 2` and `|d| <= 1`.
    ///
    /// With `u = s + 2√d` and `v = s - 2√d`, `H_k` is the sum of all products of k of u and v. So `H_k = 2s H_(k-1) - δ H_(k-2)`, and
    /// `p_k = (u^k + v^k)/2 = H_k - s H_(k-1)`. The sums `h_k` of κ₁ and κ₂ are `h_k = s h_(k-1) - d h_(k-2)`. Neither u nor v is beyond 4 in
    /// size, and no κ beyond `1 + √2`. So `H_k`, `p_k` and `h_k` are `(k + 1) 4^k` at most. From one term to the next these bounds over
    /// factorials fall by more than a half: the rest is twice the first one.
    #[inline(always)]
    fn short(&self, WavePair { sum: s, product: d, square }: WavePair<N>) -> Products<N> {
        let (zero, one) = (Ball::of(0.0), Ball::of(1.0));
        let terms = short_terms(N::TERMS);
        let firsts = [1, 2, 3, 4, 2, 3, 5];
        let (mut last, mut before) = ([one; 2], [zero; 2]);
        let mut sums = [zero; 7];
        for k in 0..terms {
            let [big, small] = last;
            let powers = [big - s * before[0], big, big, big, small, small, small];
            for (sum, (power, first)) in sums.iter_mut().zip(powers.into_iter().zip(firsts)) {
                *sum = *sum + power * Ball::reciprocal_factorial(2 * k + first);
            }
            let next = [s.scaled(2.0) * big - square * before[0], s * small - d * before[1]];
            (before, last) = (last, next);
        }
        let count = terms as f64;
        let power = N::Word::of(2.0 * count).power_of_two() * N::Word::of(2.0 * (count + 1.0) * (1.0 + 1e-12));
        for (sum, first) in sums.iter_mut().zip(firsts) {
            *sum = sum.widened(power * N::Word::of(RECIPROCAL_FACTORIALS[2 * terms + first][0]));
        }
        let [w, half_r, v, e, c2, c3, rest] = sums;
        let r = half_r.scaled(2.0);
        [w, r, v, e, half_r - self.coupling * e, one - d * rest, c2, c3, self.terms([r, e].map(|ball| ball.mid.size()))]
    }

    /// By κ₁ and κ₂, where `δ >= 4d`.
    #[inline(always)]
    fn apart(&self, [first, second, gap]: Roots<N>) -> Products<N> {
        let [[c1, s1, _, e1, c1_size, s1_size], [c2, s2, _, e2, c2_size, s2_size]] = [first, second].map(waves);
        let (sigma, t, inverse) = (self.sigma, self.coupling, gap.inverse());
        let (p, r, sc, cs) = (c1 * c2, s1 * s2, s1 * c2, c1 * s2);
        let variance = sigma * sigma;
        let (over_square, less) = (inverse * inverse, e1 * e2 - p);
        let e = (less + (first + second) * r.scaled(0.5)) * over_square;
        // R/2 - tE by δ = t² + 4hσ² and s = t - 2τh: strings have no other form without cancellation
        let product = self.tau * self.h;
        let difference = (((self.h * variance).scaled(2.0) + t * product) * r - t * less) * over_square;
        let (c1, s1, c2, s2) = (c1 * e2, s1 * e2, c2 * e1, s2 * e1);
        // 2σ²E is (2σ² (1 - P) + σ²sR)/δ
        let [both_c, both_s] = [(c1_size, c2_size), (s1_size, s2_size)].map(|(a, b)| a.mid.size() * b.mid.size());
        let of_r = (self.tau + variance * (first + second) * over_square).mid.size() * both_s;
        let of_p = (variance * over_square).scaled(2.0).mid.size() * both_c;
        [
            (first * sc - second * cs) * inverse,
            r,
            ((cs - sc) * inverse).scaled(0.5),
            e,
            difference,
            (first * s2 - second * s1) * inverse,
            (c1 - c2) * inverse,
            (s1 - s2) * inverse,
            size_of(of_r + of_p),
        ]
    }

    /// By `u/4` and `v/4`, where `δ < 4d`: `cosh √u = C² + u S²/4`, `sinh √u/√u = S C` and `(cosh √u - 1)/u = S²/2` of them.
    ///
    /// By F, G and H for these three, `R = 2(F_u - F_v)/(u - v)`, `W = (G_u + G_v)/2`, `V = (G_u - G_v)/(u - v)`, and `E = (H_u - H_v)/(u - v)`.
    /// The one of u and v that is larger in size is a sum, the other one is δ over it.
    #[inline(always)]
    fn together(&self, WavePair { sum, product, square }: WavePair<N>) -> Products<N> {
        let (zero, one, root) = (N::Word::of(0.0), Ball::of(1.0), product.root());
        // (u - v)/4
        let root = Ball::select(sum.mid.leading().is_less(zero), -root, root);
        let u = sum + root.scaled(2.0);
        let quarters = [u, square * u.inverse()].map(|number| number.scaled(0.25));
        let [first, second] = quarters.map(waves);
        // all are times the same: e^-2x of the one that grows more
        let ahead = first[2] - second[2];
        let is_behind = ahead.mid.leading().is_less(zero);
        let factor = Ball::select(is_behind, -ahead, ahead).decay();
        let twice = factor * factor;
        let shares = [Ball::select(is_behind, twice, one), Ball::select(is_behind, one, twice)];
        let whole = |quarter: Ball<N>, [c, s, _, _, c_size, s_size]: Waves<N>, share: Ball<N>| {
            let (squared, sizes) = (s * s, [c_size * c_size, (s_size * s_size).scaled(0.5)]);
            let f = (c * c + quarter * squared) * share;
            let [c_size, s_size] = sizes.map(|size| (size * share).mid.size());
            (f, s * c * share, squared.scaled(0.5) * share, [c_size.or_larger(f.mid.size()), s_size])
        };
        let (f, g, h, f_sizes) = whole(quarters[0], first, shares[0]);
        let (other_f, other_g, other_h, other_sizes) = whole(quarters[1], second, shares[1]);
        let inverse = root.inverse();
        let (r, e) = (((f - other_f) * inverse).scaled(0.5), ((h - other_h) * inverse).scaled(0.25));
        let [half, quarter] = [0.5, 0.25].map(|part| inverse.mid.size() * N::Word::of(part));
        let sizes = [(f_sizes[0] + other_sizes[0]) * half, (f_sizes[1] + other_sizes[1]) * quarter];
        let (a, b) = (first[0] * second[1] * factor, first[1] * second[0] * factor);
        let [one_first, one_second] = quarters;
        let (mostly_first, mostly_second) =
            (one_first.scaled(2.0) + one_first + one_second, one_first + one_second.scaled(2.0) + one_second);
        [
            (g + other_g).scaled(0.5),
            r,
            ((g - other_g) * inverse).scaled(0.25),
            e,
            r.scaled(0.5) - self.coupling * e,
            ((b * mostly_first - a * mostly_second) * inverse).scaled(0.5),
            (first[1] * second[1] * factor).scaled(0.5),
            ((a - b) * inverse).scaled(0.5),
            self.terms(sizes),
        ]
    }

    /// Bounds of the count of the beam with both ends pinned, and where they are known.
    ///
    /// Its shapes are `Y = sin kx`, `Θ = cos kx`, `k = nπ`, each with a stiffness of two rows. Its determinant has the sign of
    /// `(k² + κ₁)(k² + κ₂)`. It is positive definite for large k. Between two waves that travel it has one negative eigenvalue. Below both its
    /// signs are those for k near zero, of `-h` and `cut`. There `d = -h cut` is positive: two are negative where h > 0, none where h < 0. In
    /// the shape n = 0 all sections turn: it counts where cut < 0, and does not exist without shear.
    #[inline(always)]
    fn pinned(
        &self,
        shears: bool,
        is_short: <N::Word as Word>::Mask,
        [larger, smaller, _]: Roots<N>,
    ) -> ([N::Word; 2], <N::Word as Word>::Mask) {
        let (word, zero) = (N::Word::of, N::Word::of(0.0));
        let [first, second] = [larger, smaller].map(half_waves);
        let more = [0, 1].map(|k| first[k].or_larger(second[k]));
        let fewer = [0, 1].map(|k| -(-first[k]).or_larger(-second[k]));
        let least = (more[0] - fewer[1]).or_larger(zero);
        let least = N::Word::select(self.h.is_positive(), more[0] + fewer[0], least);
        let most = N::Word::select(self.h.is_negative(), more[1] - fewer[0], more[1] + fewer[1]);
        // Complex κ count nothing. Short waves do not either: no κ is beyond 1 + √2, and π² is.
        let square = self.waves.square;
        let counts_none = either::<N::Word>(is_short, square.is_negative());
        let may_count_none = either::<N::Word>(counts_none, not::<N::Word>(square.is_positive()));
        let bounds = [N::Word::select(may_count_none, zero, least), N::Word::select(counts_none, zero, most)];
        let [is_finite, is_other_finite] = [first, second].map(|[_, most]| most.is_less(word(MOST_HALF_WAVES)));
        let is_known = either::<N::Word>(counts_none, both::<N::Word>(is_finite, is_other_finite));
        let [turns, may_turn] = [self.cut.is_negative(), not::<N::Word>(self.cut.is_positive())]
            .map(|truth| if shears { N::Word::select(truth, word(1.0), zero) } else { zero });
        ([bounds[0] + turns, bounds[1] + may_turn], is_known)
    }
}

impl<N: Level> WavePair<N> {
    /// The pair where a truth holds, else another one.
    #[inline(always)]
    fn where_true(self, truth: <N::Word as Word>::Mask, other: [f64; 3]) -> Self {
        let of_lanes = [self.sum, self.product, self.square];
        let [sum, product, square] = select_all(truth, of_lanes, other.map(Ball::of));
        WavePair { sum, product, square }
    }

    /// κ₁ and κ₂ where they are real. Where the sign of δ is not known, √δ is anything up to the largest.
    #[inline(always)]
    fn roots(&self) -> Roots<N> {
        let zero = N::Word::of(0.0);
        let is_positive = self.square.is_positive();
        let root = Ball::select(is_positive, self.square, Ball::of(1.0)).root();
        let anything = Ball { mid: N::of(0.0), rad: self.square.largest().root() * N::Word::of(1.0 + 1e-15) };
        let root = Ball::select(is_positive, root, anything);
        let gap = Ball::select(self.sum.mid.leading().is_less(zero), -root, root);
        let larger = (self.sum + gap).scaled(0.5);
        [larger, self.product * larger.inverse(), gap]
    }
}

/// Bounds of the number of frequencies with both ends held, by those of the pinned beam: it has less by the negative eigenvalues of the
/// stiffness against rotations of the ends, which are none, one or two.
///
/// The minor is negative where the count is odd. So both numbers say whether one eigenvalue is negative. Else both have a sign, which is
/// that of their mean: by the symmetry of the beam the stiffness of an end, `K₁₄/K₀₄`. The bounds are those over all numbers that the pinned
/// beam may have: of two numbers next to each other both may give the same, since the count does not jump where the pinned beam's does.
#[inline(always)]
fn clamped<N: Level>([least, most]: [N::Word; 2], minor: Ball<N>, rotation: Ball<N>) -> [N::Word; 2] {
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
    let whole = |square: N::Word, share: f64| {
        // a NaN stays
        let phase = N::Word::select(square.is_less(word(0.0)), word(0.0), square).root() * word(FRAC_1_PI * share);
        let nearest = phase.nearest();
        nearest - N::Word::select(phase.is_less(nearest), word(1.0), word(0.0))
    };
    let [least, most] = [whole(middle - spread, 1.0 - 1e-14), whole(middle + spread, 1.0 + 1e-14)];
    let is_open = least.is_less(most);
    if !any::<N::Word>(is_open) {
        return [least, most];
    }
    let [first, second, third, fourth, ..] = HALF_PI;
    let pi = N::of_parts([first, second, third, fourth]);
    let phase = Ball { mid: pi, rad: word(N::SUM * first) }.scaled(2.0) * Ball::exactly(N::of_word(most));
    let beyond = square - phase * phase;
    [
        N::Word::select(both::<N::Word>(is_open, beyond.is_positive()), most, least),
        N::Word::select(both::<N::Word>(is_open, beyond.is_negative()), most - word(1.0), most),
    ]
}

/// `cosh √κ` and `sinh √κ/√κ`, entire in κ, in the form that its size and its sign give.
#[inline(always)]
fn waves<N: Level>(kappa: Ball<N>) -> Waves<N> {
    let (zero, one) = (Ball::of(0.0), Ball::of(1.0));
    let size = |ball: Ball<N>| size_of(ball.mid.size());
    let is_small = kappa.largest().is_less(N::Word::of(1.0));
    let is_positive = not::<N::Word>(kappa.mid.leading().is_less(N::Word::of(0.0)));
    let travels = not::<N::Word>(either::<N::Word>(is_small, is_positive));
    of_forms::<N, 6>(
        [is_small, travels],
        |truth| {
            let kappa = Ball::select(truth, kappa, zero);
            let [c, s] = [0, 1].map(|first| kappa.series([first, 2, N::TERMS + 1], 1.0));
            [c, s, zero, one, size(c), size(s)]
        },
        |truth| {
            let phase = Ball::select(truth, -kappa, one).root();
            let ([s, c], inverse) = (phase.sin_cos(), phase.inverse());
            [c, s * inverse, zero, one, one, size(inverse)]
        },
        |truth| {
            let growth = Ball::select(truth, kappa, one).root();
            let decay = growth.decay();
            let square = decay * decay;
            let (c, s) = ((one + square).scaled(0.5), (one - square).scaled(0.5) * growth.inverse());
            [c, s, growth, decay, size(c), size(s)]
        },
    )
}

/// Numbers in the form of each lane: a form gets the truth where it is asked for, and its other lanes are not used.
#[inline(always)]
fn of_forms<N: Level, const K: usize>(
    [is_first, is_second]: [<N::Word as Word>::Mask; 2],
    first: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
    second: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
    third: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
) -> [Ball<N>; K] {
    let is_third = not::<N::Word>(either::<N::Word>(is_first, is_second));
    let mut numbers = [Ball::of(0.0); K];
    if any::<N::Word>(is_first) {
        numbers = first(is_first);
    }
    if any::<N::Word>(is_second) {
        numbers = select_all(is_second, second(is_second), numbers);
    }
    if any::<N::Word>(is_third) {
        numbers = select_all(is_third, third(is_third), numbers);
    }
    numbers
}

/// The first balls where a truth holds, else the second ones.
#[inline(always)]
fn select_all<N: Level, const K: usize>(
    truth: <N::Word as Word>::Mask,
    first: [Ball<N>; K],
    second: [Ball<N>; K],
) -> [Ball<N>; K] {
    core::array::from_fn(|k| Ball::select(truth, first[k], second[k]))
}

/// A size that decides nothing, among balls.
#[inline(always)]
fn size_of<N: Level>(size: N::Word) -> Ball<N> {
    Ball::exactly(N::of_word(size))
}

/// One of two truths at least.
#[inline(always)]
fn either<W: Word>(first: W::Mask, second: W::Mask) -> W::Mask {
    not::<W>(both::<W>(not::<W>(first), not::<W>(second)))
}

/// Whether no number of a ball is zero, and all have one sign.
#[inline(always)]
fn has_sign<N: Level>(ball: Ball<N>) -> <N::Word as Word>::Mask {
    either::<N::Word>(ball.is_negative(), ball.is_positive())
}

/// Number of terms of the series of short waves: the first one that is left out is below the rounding of a number of `TERMS`.
const fn short_terms(of_squares: usize) -> usize {
    of_squares + of_squares / 3 + 1
}
