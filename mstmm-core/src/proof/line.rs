//! A uniform line (rod, string, shaft) over the displacements of its ends, over `H/l`, by `x = (m ω² - k) l²/H`.

use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::member::{BESIDE_POLE, Member, any, half_wave, is_nonzero};
use crate::proof::word::{Word, apart};
use core::f64::consts::FRAC_1_PI;

/// The size of x below which waves are short: as far as the terms of the series fall as they should.
const SHORT: f64 = 0.875;

/// A line.
pub(crate) type Line<N> = Member<N, 2, 3>;

/// The line of an end's own stiffness and that between the ends.
#[inline(always)]
fn of<N: Level>(own: Ball<N>, between: Ball<N>, held: [N::Word; 2], minor: N::Word) -> Line<N> {
    let size = own.mid.size().first().max(between.mid.size().first());
    Line { stiffness: [own, between, own], border: None, held, minor, sizes: [size; 2] }
}

apart! {
    /// The member at x of either sign.
    pub(crate) fn line<N: Level>(x: Ball<N>) -> Line<N> {
        let word = N::Word::of;
        let is_short = x.largest().is_less(word(SHORT));
        if N::Word::all(is_short) {
            return short(x);
        }
        let is_stiff = x.mid.leading().is_less(word(0.0));
        let (is_short_or_stiff, one) =
            (N::Word::not(N::Word::both(N::Word::not(is_short), N::Word::not(is_stiff))), Ball::of(1.0));
        let mut member = if any::<N::Word>(N::Word::not(is_short_or_stiff)) {
            waving(Ball::select(N::Word::not(is_short_or_stiff), x, one))
        } else {
            decaying(Ball::select(is_stiff, -x, one))
        };
        if any::<N::Word>(is_stiff) {
            member = Line::select(is_stiff, decaying(Ball::select(is_stiff, -x, one)), member);
        }
        if any::<N::Word>(is_short) {
            member = Line::select(is_short, short(Ball::select(is_short, x, one)), member);
        }
        member
    }
}

/// Short waves: series in x. The first frequency of a line with both ends held is at x = π².
#[inline(always)]
fn short<N: Level>(x: Ball<N>) -> Line<N> {
    let y = -x;
    let [cosine, sine] = y.series::<0, 2, 2, 14>();
    let inverse = sine.inverse();
    of(cosine * inverse, -inverse, [N::Word::of(0.0); 2], sine.mid.leading())
}

/// A foundation that is stiffer than inertia, of x < 0: no wave, and no frequency with both ends held.
#[inline(always)]
fn decaying<N: Level>(stiffness: Ball<N>) -> Line<N> {
    let z = stiffness.root();
    let decay = z.decay();
    let (square, one) = (decay * decay, Ball::of(1.0));
    let over_sinh = z * (one - square).inverse();
    let minor = (one - square).mid.leading() / z.mid.leading();
    of(over_sinh * (one + square), -(over_sinh * decay.scaled(2.0)), [N::Word::of(0.0); 2], minor)
        .known_where(stiffness.is_positive())
}

/// Waves of `x >= SHORT`.
#[inline(always)]
fn waving<N: Level>(x: Ball<N>) -> Line<N> {
    let word = N::Word::of;
    let z = x.root();
    let [s, c] = z.sin_cos();
    let half_waves = z.mid.leading() * word(FRAC_1_PI);
    // held ends have their frequencies at whole half waves, in the middle of those of a free end
    let (middle, is_in_the_middle) = half_wave(half_waves + word(0.5));
    let is_bordered = N::Word::both(s.mid.size().is_less(word(BESIDE_POLE)), is_in_the_middle);
    let plain = {
        let first = z * s.inverse();
        // sin z is (-1)^i between iπ and (i + 1)π: near iπ the nearest whole number is i, and the sign says whether it is reached
        let nearest = half_waves.nearest();
        let lacks = N::Word::select(s.is_negative(), word(1.0), word(0.0));
        let differs = (nearest - lacks).is_odd();
        let held = nearest - N::Word::select(differs, word(1.0), word(0.0));
        of(first * c, -first, [held; 2], s.mid.leading() / z.mid.leading()).known_where(is_nonzero(s))
    };
    if !any::<N::Word>(is_bordered) {
        return plain;
    }
    Line::select(is_bordered, bordered(z, s, c, middle), plain)
}

/// The member beside a pole, as that of a beam: n = (cos, -1), E = sin.
#[inline(always)]
fn bordered<N: Level>(z: Ball<N>, s: Ball<N>, c: Ball<N>, middle: N::Word) -> Line<N> {
    let over_c = c.inverse();
    let mut stiffness = [Ball::of(0.0), Ball::of(0.0), -(z * s * over_c)];
    let forces = [z * c, -z];
    let (border, left) = Line::shifted(&mut stiffness, forces, z * (c * s), z.inverse());
    let size = z.mid.leading().first();
    Line {
        stiffness,
        border: Some(border),
        // with one end let go the frequencies are at odd quarter waves, where the cosine vanishes
        held: [middle - N::Word::of(1.0); 2],
        minor: -left.mid.leading() / (z * z * c).mid.leading(),
        sizes: [size; 2],
    }
    .known_where(N::Word::both(left.is_positive(), is_nonzero(c)))
}
