//! The dynamic stiffness of beams and lines at a frequency.

use crate::number::{FrequencyPowers, Scalar, Size, Truth, series, twice};
use crate::pass::network::stiffness::arrangement::KEPT;
use crate::pass::network::stiffness::member::Seat;
use crate::pass::network::stiffness::numbers::{BendingWave, LineWave};
use core::f64::consts::FRAC_1_PI;

/// A dynamic stiffness over the displacements of both ends of a uniform member, with equal ends.
#[derive(Clone, Copy)]
pub(super) struct Waves<S: Scalar, const ENTRIES: usize> {
    /// The entries.
    pub(super) stiffness: [S; ENTRIES],
    /// The minor that divides it, an entire function that does not vanish at rest, over `2^exponent`.
    pub(super) minor: S,
    pub(super) exponent: i32,
    /// Natural frequencies below with both ends held.
    pub(super) below: S::Size,
}

/// Deflection against deflection, rotation and rotation against rotation at one end, and with the other end.
pub(super) type Bending<S> = Waves<S, 6>;

/// One end, and with the other end.
pub(super) type Line<S> = Waves<S, 2>;

impl<S: Scalar, const ENTRIES: usize> Waves<S, ENTRIES> {
    /// No stiffness.
    #[inline(always)]
    fn none() -> Self {
        Waves { stiffness: [S::zero(); ENTRIES], minor: S::one(), exponent: 0, below: S::Size::of(0.0) }
    }
}

/// The waves of beams, each different from the others.
pub(super) struct BeamWaves<S: Scalar>([(Bending<S>, Line<S>); KEPT]);

impl<S: Scalar> BeamWaves<S> {
    /// No waves yet.
    #[inline(always)]
    pub(super) fn new() -> Self {
        BeamWaves([(Waves::none(), Waves::none()); KEPT])
    }

    /// The waves of a beam, across and along: those of an equal one, if there was one.
    #[inline(always)]
    pub(super) fn of(
        &mut self,
        seat: &Seat,
        (across, along): (&BendingWave, Option<&LineWave>),
        at: &FrequencyPowers<S>,
    ) -> &(Bending<S>, Line<S>) {
        let waves = &mut self.0[seat.waves as usize];
        if seat.is_first {
            // a closure would be compiled for itself, and not for the lanes of its caller
            waves.0 = bending(across, at);
            waves.1 = match along {
                Some(along) => line(along, at),
                None => Waves::none(),
            };
        }
        waves
    }
}

/// The stiffness of bending: of deflection and rotation at the input end, `k_YY, k_YΘ, k_ΘΘ`, and with those of the output end, `k_YY', k_YΘ',
/// k_ΘΘ'`. With ch, sh, c, s of z and over `1 - ch c` they are
///
/// ```text
/// z³ (ch s + sh c)   z² sh s   z (ch s - sh c)      -z³ (sh + s)   z² (ch - c)   z (sh - s)
/// ```
#[inline(always)]
fn bending<S: Scalar>(beam: &BendingWave, at: &FrequencyPowers<S>) -> Bending<S> {
    let z = at.powers[0] * S::from_f64(beam.wave);
    let x = at.powers[3] * S::from_f64(beam.wave_fourth);
    let is_long = S::Size::of(1.0).is_below(x.size());
    let mut waves = if is_long.all() {
        long_waves(beam, at, z)
    } else if is_long.any() {
        let (long, short) = (long_waves(beam, at, z), short_waves(x));
        let mut stiffness = long.stiffness;
        let mut k = 0;
        while k < 6 {
            stiffness[k] = S::select(is_long, stiffness[k], short.stiffness[k]);
            k += 1;
        }
        Waves { stiffness, minor: S::select(is_long, long.minor, short.minor), ..long }
    } else {
        short_waves(x)
    };
    let first = beam.stiffness * beam.length;
    let factors = [beam.stiffness, first, first * beam.length];
    let mut k = 0;
    while k < 6 {
        waves.stiffness[k] *= S::from_f64(factors[k % 3]);
        k += 1;
    }
    // one less where `1 - ch c` has not yet the sign that it has beyond the last half wave
    let (half_waves, is_odd) = (z.size() * S::Size::of(FRAC_1_PI)).whole();
    let is_less = (is_odd ^ waves.minor.is_negative()) & S::Size::of(0.0).is_below(half_waves);
    waves.below = half_waves + S::Size::choose(is_less, S::Size::of(-1.0), S::Size::of(0.0));
    waves
}

/// The stiffness of long waves over `EI/l³` and lengths.
#[inline(always)]
fn long_waves<S: Scalar>(beam: &BendingWave, at: &FrequencyPowers<S>, z: S) -> Bending<S> {
    let waves = z.wave_functions();
    let [circular, hyperbolic] = waves.exponents;
    let (sin, cos) = (waves.sin.times_power_of_two(-hyperbolic), waves.cos.times_power_of_two(-hyperbolic));
    let (sh, ch) = (waves.sh.times_power_of_two(-circular), waves.ch.times_power_of_two(-circular));
    let minor = waves.one - waves.ch * waves.cos;
    // over z⁴, that it does not vanish at rest
    let entire = minor * at.inverse_powers[3] * S::from_f64(beam.inverse_fourth);
    let first = z / minor;
    let second = first * z;
    let third = second * z;
    let (ch_sin, sh_cos) = (waves.ch * waves.sin, waves.sh * waves.cos);
    let stiffness = [
        third * (ch_sin + sh_cos),
        second * (waves.sh * waves.sin),
        first * (ch_sin - sh_cos),
        -(third * (sh + sin)),
        second * (ch - cos),
        first * (sh - sin),
    ];
    Waves { stiffness, minor: entire, exponent: circular.saturating_add(hyperbolic), below: S::Size::of(0.0) }
}

/// The stiffness of short waves, of `x = z⁴`, where those of long ones cancel.
#[inline(always)]
fn short_waves<S: Scalar>(x: S) -> Bending<S> {
    let [_, b, f, d, e] = x.short_wave_products();
    let inverse = S::one() / e;
    let twofold = twice(inverse);
    let stiffness = [
        b * inverse,
        f * inverse,
        d * inverse,
        -(series(x, 1, 4) * twofold),
        series(x, 2, 4) * twofold,
        series(x, 3, 4) * twofold,
    ];
    Waves { stiffness, minor: e, exponent: 0, below: S::Size::of(0.0) }
}

/// The stiffness of a line, `H/l` times `√κ coth √κ` and `-√κ / sinh √κ`.
#[inline(always)]
pub(super) fn line<S: Scalar>(line: &LineWave, at: &FrequencyPowers<S>) -> Line<S> {
    if line.inertia.vanishes() && line.foundation.vanishes() {
        let own = S::from_f64(line.stiffness);
        return Waves { stiffness: [own, -own], minor: S::one(), exponent: 0, below: S::Size::of(0.0) };
    }
    let square = at.lambda_squared * S::from_f64(line.inertia) + S::from_f64(line.foundation);
    let waves = square.even_waves();
    let inverse = S::one() / waves.sinhc * S::from_f64(line.stiffness);
    // the half waves to the nearest frequency of the line with both ends held, on whose side the sign of the minor tells: rounding alone would not
    let travelling = S::select(square.is_negative(), -square, S::zero());
    let half = S::Size::of(0.5);
    let (half_waves, is_odd) = (travelling.sqrt().size() * S::Size::of(FRAC_1_PI) + half).whole();
    let is_less = is_odd ^ waves.sinhc.is_negative();
    let below = half_waves + S::Size::choose(is_less, S::Size::of(-1.0), S::Size::of(0.0));
    Waves {
        stiffness: [waves.cosh * inverse, -(waves.one * inverse)],
        minor: waves.sinhc,
        exponent: waves.exponent,
        below,
    }
}
