//! The bending of a plain beam over the displacements `y1, θ1 l, y2, θ2 l`, over `EI/l³`, by `x = z⁴ = -(mλ² + k) l⁴/EI`.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::member::Member;
use crate::proof::level::Level;

/// The bending of a beam.
pub(crate) type Bending<N> = Member<N, 10>;

/// The matrix of a beam from the stiffness of an end, `b, f, d`, and between its ends, `t, u, v`.
pub(crate) fn symmetric<N: Level<Word = f64>>([b, f, d, t, u, v]: [ComplexBall<N>; 6]) -> [ComplexBall<N>; 10] {
    [b, f, d, -t, -u, b, u, v, -f, d]
}

/// The beam at any x.
pub(crate) fn bending<N: Level<Word = f64>>(x: ComplexBall<N>) -> Bending<N> {
    if x.largest() < 1.0 { short(x) } else { long(x) }
}

/// Short waves: series in x. The first frequency of a clamped beam is at z = 4.73.
fn short<N: Level<Word = f64>>(x: ComplexBall<N>) -> Bending<N> {
    let y = x.scaled(-4.0);
    let minor = y.series::<4, 4>().scaled(2.0);
    let entries = [
        y.series::<1, 4>(),
        y.series::<2, 4>(),
        y.series::<3, 4>().scaled(2.0),
        x.series::<1, 4>(),
        x.series::<2, 4>(),
        x.series::<3, 4>(),
    ];
    let inverse = minor.inverse();
    Member { stiffness: symmetric(entries.map(|entry| entry * inverse)), minor, terms: 1.0 / 12.0 }
}

/// Longer waves. Each entry is a quotient of products of hyperbolic and circular functions of z, and both times `4 p t`, with `p = e^-z` and
/// `t = e^±iz`, of which neither grows: `2p cosh z = 1 + p²`, `2t cos z = 1 + t²`, `2t sin z = ±i (1 - t²)`.
fn long<N: Level<Word = f64>>(x: ComplexBall<N>) -> Bending<N> {
    let z = x.root().root().to_the_right();
    let one = ComplexBall::of(1.0);
    let is_upper = z.leading().im >= 0.0;
    let turned = if is_upper { -z.times_i() } else { z.times_i() };
    let [p, t] = [z, turned].map(ComplexBall::decay);
    let [p_square, t_square] = [p * p, t * t];
    let (ch, sh, c, s) = (one + p_square, one - p_square, one + t_square, (one - t_square).times_i());
    let s = if is_upper { s } else { -s };
    let (p, t) = (p.scaled(2.0), t.scaled(2.0));
    let (ch_s, sh_c, ch_c, both) = (ch * s, sh * c, ch * c, p * t);
    let minor = both - ch_c;
    let first = z * minor.inverse();
    let second = first * z;
    let third = second * z;
    let entries = [
        third * (ch_s + sh_c),
        second * (sh * s),
        first * (ch_s - sh_c),
        third * (sh * t + p * s),
        second * (ch * t - p * c),
        first * (sh * t - p * s),
    ];
    Member { stiffness: symmetric(entries), minor, terms: 1.0 + t_square.size() }
}
