//! The search for the largest of a ratio over a band: piece by piece, from the start to the end.

use crate::model::{MotionError, PeakError, SearchError};
use crate::number::{List, modulus};
use crate::search::damped::peak::function::{Side, node};
use crate::search::damped::peak::level::{Verdict, below};
use crate::search::damped::peak::piece::{Piece, Sides, evaluations_for, values_for};
use crate::search::damped::peak::source::Source;
use core::ops::RangeInclusive;
use num_complex::Complex;

/// Tolerances that are served: below, roundings of sixteen digits and of their squares decide.
const TOLERANCES: RangeInclusive<f64> = 1e-12..=0.5;
/// Room for pieces that wait: one of each size.
const WAITING: usize = 64;
/// Pieces after which the search is given up: there may be thousands of modes in a band.
const PIECES: usize = 50_000;
/// Half length of a piece, as a part of its frequency, below which rounding would move places by more than the polynomial through them bears.
const FINEST: f64 = 2e-11;
/// Half length of a piece, as a part of the band, below which a pole at rest counts as in it.
const SHORTEST: f64 = 1e-12;
/// Distance of a pole from the band, in its radii, and in units of rounding of its size, up to which it counts as on it.
const NEAR: [f64; 2] = [4.0, 64.0];
/// Levels in units of what rounding leaves of zero, so that values that are rounding alone count as below.
const ABOVE_NOISE: f64 = 1_048_576.0;
/// Resonances of the list at which the response is looked at beforehand, so that levels are high from the beginning.
const LOOKS: usize = 64;
/// Steps and halvings of the way up to a maximum of a polynomial.
const CLIMB: usize = 200;
/// Halvings of the gap between two values of unlike signs.
const HALVINGS: usize = 50;
/// Levels that values on one piece may raise before it is cut.
const RAISES: usize = 40;

type C = Complex<f64>;

/// What is asked of a ratio over a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extreme {
    Peak,
    Least,
}

/// The largest of `|f/g|` over a band; of the least of a response f is 1, or its divisor, and g the response.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Largest {
    /// Where the largest value was found.
    pub(crate) omega: f64,
    /// That value; infinite where g vanishes.
    pub(crate) found: f64,
    /// The level below which all were found to be; infinite where g vanishes, or where rounding may make it vanish.
    pub(crate) bound: f64,
    pub(crate) evaluations: usize,
}

/// How the work at a piece ended.
enum Ended {
    Proven,
    /// It has to be cut, and what to say where it is too short for that.
    Cut(PeakError),
    /// The divisor vanishes, since it changes its sign.
    Vanishes {
        omega: f64,
    },
}

/// A search in progress.
pub(super) struct Search<'s> {
    source: &'s dyn Source,
    extreme: Extreme,
    tolerance: f64,
    /// Levels are no lower.
    floor: f64,
    pub(super) best: Largest,
}

/// The largest of a ratio over a band, to a tolerance.
pub(crate) fn largest(
    source: &dyn Source,
    range: &RangeInclusive<f64>,
    extreme: Extreme,
    tolerance: f64,
) -> Result<Largest, PeakError> {
    let (start, end) = (*range.start(), *range.end());
    if !(start < end && (end - start).is_finite()) {
        return Err(MotionError::Range { start, end }.into());
    }
    if !TOLERANCES.contains(&tolerance) {
        return Err(PeakError::Tolerance { tolerance });
    }
    refuse_resonances(source, start, end)?;
    let mut search = Search::new(source, start, extreme, tolerance);
    if search.look_about(start, end) {
        return Ok(search.best);
    }
    search.run(Piece { start, end })
}

/// Refuses a band on which the list has a pole, to rounding.
fn refuse_resonances(source: &dyn Source, start: f64, end: f64) -> Result<(), PeakError> {
    let mut refused = None;
    source.for_each_pole(&mut |pole| {
        let beside = (start - pole.lambda.im).max(pole.lambda.im - end).max(0.0);
        let distance = modulus(C::new(pole.lambda.re, beside));
        if distance <= NEAR[0] * pole.radius + NEAR[1] * f64::EPSILON * modulus(pole.lambda) {
            refused = Some(pole.lambda.im);
        }
    });
    refused.map_or(Ok(()), |omega| Err(PeakError::Resonance { omega }))
}

impl<'s> Search<'s> {
    pub(super) fn new(source: &'s dyn Source, start: f64, extreme: Extreme, tolerance: f64) -> Self {
        let best = Largest { omega: start, found: 0.0, bound: f64::INFINITY, evaluations: 0 };
        Search { source, extreme, tolerance, floor: 0.0, best }
    }

    /// Responses f and g at λ.
    fn values(&mut self, lambda: C) -> Result<[C; 2], MotionError> {
        self.best.evaluations += if self.source.is_ratio() { 2 } else { 1 };
        self.source.values(lambda).map(|values| self.turned(values))
    }

    /// Two of the response and of its divisor as f and g.
    fn turned<V>(&self, [response, divisor]: [V; 2]) -> [V; 2] {
        match self.extreme {
            Extreme::Peak => [response, divisor],
            Extreme::Least => [divisor, response],
        }
    }

    /// Takes note of the ratio at a frequency.
    fn note(&mut self, omega: f64, [f, g]: [C; 2]) -> bool {
        let ratio = modulus(f) / modulus(g);
        let is_larger = ratio > self.best.found && ratio.is_finite();
        if is_larger {
            (self.best.omega, self.best.found) = (omega, ratio);
        }
        is_larger
    }

    /// Looks at the ends, at the middle and at resonances: what rounding leaves of zero, and first values. Whether the divisor is nowhere more than that.
    fn look_about(&mut self, start: f64, end: f64) -> bool {
        let mut places = List::<f64, { LOOKS + 3 }>::new();
        let mut add = |omega: f64| {
            // further resonances are found when their pieces come
            let _is_full = places.push(omega).is_err();
        };
        [start, 0.5 * start + 0.5 * end, end].into_iter().for_each(&mut add);
        self.source.for_each_pole(&mut |pole| {
            if pole.lambda.im > start && pole.lambda.im < end {
                add(pole.lambda.im);
            }
        });
        let mut seen = List::<(f64, [C; 2]), { LOOKS + 3 }>::new();
        let mut left = [0.0_f64; 2];
        for &omega in &places {
            let lambda = C::new(0.0, omega);
            let noise = self.source.noise(lambda);
            self.best.evaluations += if self.source.is_ratio() { 2 } else { 1 };
            left = [0, 1].map(|k| left[k].max(noise[k]));
            // at rest there may be none
            if let Ok(values) = self.values(lambda) {
                let _is_full = seen.push((omega, values)).is_err();
            }
        }
        let [of_f, of_g] = self.turned(left);
        let mut vanishes = !seen.is_empty();
        for &(omega, values) in &seen {
            self.note(omega, values);
            let divisor = modulus(values[1]);
            vanishes &= divisor <= ABOVE_NOISE * of_g;
            if divisor > 0.0 {
                self.floor = self.floor.max(ABOVE_NOISE * of_f / divisor);
            }
        }
        vanishes
    }

    /// The level that is tried.
    fn level(&self) -> f64 {
        (self.best.found * (1.0 + self.tolerance)).max(self.floor)
    }

    /// Proves all pieces of a band, whatever level is given beforehand.
    pub(super) fn run(&mut self, whole: Piece) -> Result<Largest, PeakError> {
        let mut waiting = List::<Piece, WAITING>::new();
        let (mut next, mut pieces) = (Some(whole), 0);
        while let Some(piece) = next.take().or_else(|| waiting.pop()) {
            pieces += 1;
            if pieces > PIECES {
                return Err(PeakError::Effort { evaluations: self.best.evaluations });
            }
            match self.at(&piece)? {
                Ended::Proven => {}
                Ended::Vanishes { omega } => {
                    (self.best.omega, self.best.found) = (omega, f64::INFINITY);
                    return Ok(self.best);
                }
                Ended::Cut(error) => {
                    let middle = piece.middle();
                    let is_short = piece.half() <= (FINEST * middle.abs()).max(SHORTEST * whole.half());
                    if is_short || waiting.push(Piece { start: middle, ..piece }).is_err() {
                        // of a least value that rounding hides zero is a bound
                        let is_bounded =
                            self.extreme == Extreme::Least && matches!(error, PeakError::Unresolved { .. });
                        return if is_bounded { Ok(self.best) } else { Err(error) };
                    }
                    next = Some(Piece { end: middle, ..piece });
                }
            }
        }
        self.best.bound = self.level();
        Ok(self.best)
    }

    /// Proves that a piece is below the level, which values there may raise.
    fn at(&mut self, piece: &Piece) -> Result<Ended, PeakError> {
        let Some(poles) = piece.poles(self.source) else {
            return Ok(Ended::Cut(PeakError::Resonance { omega: piece.middle() }));
        };
        match self.source.check_box(&piece.region(), poles.len() as u64) {
            Ok(()) => {}
            Err(error) if is_final(&error, piece) => return Err(error),
            Err(error) => return Ok(Ended::Cut(error)),
        }
        let count = values_for(self.tolerance);
        self.best.evaluations += evaluations_for(count) * if self.source.is_ratio() { 2 } else { 1 };
        let Sides { sides, values } = match piece.sides(self.source, &poles, count) {
            Ok(sides) => sides,
            Err(error) => return Ok(Ended::Cut(error)),
        };
        for (number, &values) in values.iter().enumerate() {
            let values = self.turned(values);
            self.note(piece.omega(node(count, number)), values);
        }
        let [f, g] = self.turned(sides);
        if let Some(x) = sign_change(&g, values.iter().map(|&values| self.turned(values)[1])) {
            return Ok(Ended::Vanishes { omega: piece.omega(x) });
        }
        for _ in 0..RAISES {
            match below(&f, &g, self.level()) {
                Verdict::Below => return Ok(Ended::Proven),
                Verdict::Undecided { x } => return Ok(Ended::Cut(PeakError::Unresolved { omega: piece.omega(x) })),
                Verdict::Above { x, s } => {
                    let omega = piece.omega(climb(&f, &g, x, s));
                    let values = self.values(C::new(0.0, omega))?;
                    if !self.note(omega, values) {
                        return Ok(Ended::Cut(PeakError::Unresolved { omega }));
                    }
                }
            }
        }
        Ok(Ended::Cut(PeakError::Unresolved { omega: piece.middle() }))
    }
}

/// Whether cutting a piece does not help: nothing is known of what is below the real axis, or Δ vanishes.
fn is_final(error: &PeakError, piece: &Piece) -> bool {
    match error {
        PeakError::Search(SearchError::LossFactor { .. } | SearchError::OtherWhirl { .. }) => piece.start <= 0.0,
        PeakError::Search(SearchError::Zero { .. }) => true,
        _ => false,
    }
}

/// Where a divisor that is real on the whole piece changes its sign.
fn sign_change(divisor: &Side, values: impl Iterator<Item = C> + Clone) -> Option<f64> {
    let Side::Series { error, .. } = divisor else { return None };
    if values.clone().any(|value| value.im.abs() > 0.0) {
        return None;
    }
    // the polynomial is that of a real response but for the product, which has no zero on the axis
    let signs = values.map(|value| value.re > 0.0);
    let count = signs.clone().count();
    let turn = signs.clone().zip(signs.skip(1)).position(|(one, other)| one != other)?;
    let [mut from, mut to] = [turn, turn + 1].map(|number| node(count, number));
    let is_clear = |x: f64| modulus(divisor.value(x)) > *error;
    if !(is_clear(from) && is_clear(to)) {
        return None;
    }
    let at = |x: f64| divisor.value(x);
    let first = at(from);
    for _ in 0..HALVINGS {
        let x = 0.5 * (from + to);
        let turned = at(x) * first.conj();
        if turned.re > 0.0 { from = x } else { to = x }
    }
    Some(0.5 * (from + to))
}

/// The way up from x to a maximum of `|f/g|` as polynomials, by steps of s and smaller ones.
fn climb(f: &Side, g: &Side, x: f64, s: f64) -> f64 {
    let ratio = |x: f64| modulus(f.value(x)) / modulus(g.value(x));
    let (mut best, mut height, mut step) = (x, ratio(x), s);
    for _ in 0..CLIMB {
        let beside = [best - step, best + step].map(|x| x.clamp(-1.0, 1.0));
        let heights = beside.map(ratio);
        let higher = usize::from(heights[1] > heights[0]);
        if heights[higher] > height {
            (best, height) = (beside[higher], heights[higher]);
        } else {
            step *= 0.5;
            if step < f64::EPSILON {
                break;
            }
        }
    }
    best
}
