//! The bending of a uniform beam over the displacements `y1, θ1 l, y2, θ2 l`, over `EI/l³`, by `x = z⁴ = m ω² l⁴/EI`.

use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::member::{BESIDE_POLE, Border, Member, any, half_wave, is_nonzero};
use crate::proof::word::{Word, apart};
use core::f64::consts::FRAC_1_PI;

/// The bending of a beam.
pub(crate) type Bending<N> = Member<N, 4, 10>;

/// The matrix of a beam from the stiffness of an end, `b, f, d`, and between its ends, `t, u, v`.
#[inline(always)]
pub(crate) fn symmetric<N: Level>([b, f, d, t, u, v]: [Ball<N>; 6]) -> [Ball<N>; 10] {
    [b, f, d, -t, -u, b, u, v, -f, d]
}

/// The sizes of the four displacements' stiffnesses: the larger one of an end's own and that between the ends, since either may vanish.
#[inline(always)]
pub(crate) fn sizes_of<N: Level>([b, _, d, t, _, v]: [Ball<N>; 6]) -> [f64; 4] {
    let across = b.mid.size().first().max(t.mid.size().first());
    let rotation = d.mid.size().first().max(v.mid.size().first());
    [across, rotation, across, rotation]
}

apart! {
    /// The member at `x >= 0`.
    pub(crate) fn bending<N: Level>(x: Ball<N>) -> Bending<N> {
        let is_short = x.largest().is_less(N::Word::of(1.0));
        if N::Word::all(is_short) {
            return short(x);
        }
        if !any::<N::Word>(is_short) {
            return long(x);
        }
        let one = Ball::of(1.0);
        let [at_most_one, at_least_one] = [Ball::select(is_short, x, one), Ball::select(is_short, one, x)];
        Bending::select(is_short, short(at_most_one), long(at_least_one))
    }

    /// Short waves: series in x. The first frequency of a clamped beam is at z = 4.73.
    fn short<N: Level>(x: Ball<N>) -> Bending<N> {
        let y = x.scaled(-4.0);
        let [b, f, d, e] = y.series::<1, 4, 4, 64>();
        let [t, u, v] = x.series::<1, 3, 4, 16>();
        let (d, e) = (d.scaled(2.0), e.scaled(2.0));
        let inverse = e.inverse();
        let entries = [b * inverse, f * inverse, d * inverse, t * inverse, u * inverse, v * inverse];
        let zero = N::Word::of(0.0);
        Bending {
            sizes: sizes_of(entries),
            stiffness: symmetric(entries),
            border: None,
            held: [zero; 2],
            minor: e.mid.leading(),
        }
    }

    /// Waves of z >= 1, all functions times `2e^-z`.
    fn long<N: Level>(x: Ball<N>) -> Bending<N> {
        let word = N::Word::of;
        let z = x.root().root();
        let [s, c] = z.sin_cos();
        let decay = z.decay();
        let (square, one) = (decay * decay, Ball::of(1.0));
        let (ch, sh, o) = (one + square, one - square, decay.scaled(2.0));
        let (ch_s, sh_c) = (ch * s, sh * c);
        let minor = o - ch * c;
        let (b, f, d) = (ch_s + sh_c, sh * s, ch_s - sh_c);
        let (t, u, v) = (sh + o * s, ch - o * c, sh - o * s);
        let half_waves = z.mid.leading() * word(FRAC_1_PI);
        let (middle, is_in_the_middle) = half_wave(half_waves);
        let is_beside = minor.mid.size().is_less(word(BESIDE_POLE));
        let is_bordered = N::Word::both(is_beside, is_in_the_middle);
        let member = plain(z, minor, [b, f, d, t, u, v]);
        if !any::<N::Word>(is_bordered) {
            return member;
        }
        // minors of rows (1, i) and columns (1, j) over the minor of all, over b
        let m = [o + ch * c, v, -(sh * s).scaled(2.0), -(ch + o * c), d, (ch * c).scaled(2.0)];
        Bending::select(is_bordered, bordered(z, minor, [b, f, t, u], m, middle, x), member)
    }
}

/// The member away from its poles.
#[inline(always)]
fn plain<N: Level>(z: Ball<N>, minor: Ball<N>, [b, f, d, t, u, v]: [Ball<N>; 6]) -> Bending<N> {
    let word = N::Word::of;
    let first = z * minor.inverse();
    let second = first * z;
    let third = second * z;
    let entries = [third * b, second * f, first * d, third * t, second * u, first * v];
    let is_negative = minor.is_negative();
    // Near kπ a rounded quotient may be k or k - 1, and both give k - 1: there the sign of the minor is known, and has the parity of the count.
    let half_waves = z.mid.leading() * word(FRAC_1_PI);
    let below = (half_waves - word(0.5)).nearest();
    let lacks = N::Word::select(is_negative, word(1.0), word(0.0));
    let differs = (below - lacks).is_odd();
    let held = (below - N::Word::select(differs, word(1.0), word(0.0))).or_larger(word(0.0));
    let fourth = z * z * (z * z);
    Bending {
        sizes: sizes_of(entries),
        stiffness: symmetric(entries),
        border: None,
        held: [held; 2],
        minor: minor.mid.leading() / fourth.mid.leading(),
    }
    .known_where(is_nonzero(minor))
}

/// The member beside a pole: Sylvester's identity `N = n nᵀ/n₁ + E M/n₁` of its numerators, n the first row, E the minor, M minors of two rows
/// and columns over E in closed form.
#[inline(always)]
fn bordered<N: Level>(
    z: Ball<N>,
    minor: Ball<N>,
    [b, f, t, u]: [Ball<N>; 4],
    [m22, m23, m33, m24, m34, m44]: [Ball<N>; 6],
    middle: N::Word,
    x: Ball<N>,
) -> Bending<N> {
    let zero = Ball::of(0.0);
    let square = z * z;
    let kappa = square * z;
    let over_b = b.inverse();
    let [first, second, third] = [z * over_b, square * over_b, kappa * over_b];
    let (second_row, third_row) = (m22 * first, [m23 * second, m33 * third]);
    let fourth_row = [m24 * first, m34 * second, m44 * first];
    let mut stiffness =
        [zero, zero, second_row, zero, third_row[0], third_row[1], zero, fourth_row[0], fourth_row[1], fourth_row[2]];
    let forces = [kappa * b, square * f, -(kappa * t), square * u];
    let flexibility = kappa * (b * minor);
    let (Border { forces, flexibility }, left) = Bending::shifted(&mut stiffness, forces, flexibility, kappa.inverse());
    // With y1 let go the frequencies are those of tan z = -tanh z, one in each (kπ - π/4, kπ): in the middle of a half wave the number of
    // half waves below. They are where b vanishes: none is in the ball, if b does not.
    let held = middle - N::Word::of(1.0);
    let scale = (kappa * b * x).mid.leading();
    let size = kappa.mid.leading().first();
    let rotation = z.mid.leading().first();
    Bending {
        stiffness,
        border: Some(Border { forces, flexibility }),
        held: [held; 2],
        minor: -left.mid.leading() / scale,
        sizes: [size, rotation, size, rotation],
    }
    .known_where(N::Word::both(left.is_positive(), is_nonzero(b)))
}
