//! The speed from which on a whirl of a rotor grows.

use crate::model::{ParameterError, SearchError, SpeedError};
use crate::pass::searched::Spectrum;
use crate::search::damped::eigenvalues::Eigenvalues;
use crate::search::damped::found::{Eigenvalue, Region};
use crate::search::rotor::{Rotor, Whirl};

/// Room for the eigenvalues of the region at one speed.
const ROOM: usize = 64;

/// Most speeds that are tried: halves of a range down to the last bit of a number, and a secant step before each.
const STEPS: usize = 120;

/// Width of an interval, in units of eps of the speed, that is not divided any more.
const NARROW: f64 = 4.0;

/// Uncertainties of an eigenvalue by which a speed moves away from one at which the sign of the growth is not decided, first; then four times as many.
const AWAY: f64 = 2.0;

/// The speed from which on a motion of a whirl grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// The speed [rad/s].
    pub speed: f64,
    /// A speed at which the circles of all eigenvalues of the region are to the left of the imaginary axis.
    pub lower: f64,
    /// A speed at which the circle of `eigenvalue` is to the right of it.
    pub upper: f64,
    /// The eigenvalue that grows at `upper`, with its circle.
    pub eigenvalue: Eigenvalue<f64>,
}

/// The rightmost eigenvalue of a region at a speed.
#[derive(Clone, Copy)]
struct AtSpeed {
    speed: f64,
    rightmost: Option<Eigenvalue<f64>>,
}

impl AtSpeed {
    /// Whether the motion grows; none where its circle meets the imaginary axis.
    fn grows(&self) -> Option<bool> {
        let Some(Eigenvalue { lambda, error, .. }) = self.rightmost else { return Some(false) };
        match () {
            () if lambda.re - error > 0.0 => Some(true),
            () if lambda.re + error < 0.0 => Some(false),
            () => None,
        }
    }

    fn growth(&self) -> Option<f64> {
        self.rightmost.map(|root| root.lambda.re)
    }
}

/// The speed of a range \[rad/s\] from which on a motion of a whirl grows, with eigenvalues in a region above the real axis: `None` where none of these grows at
/// the last speed.
///
/// The region begins at `Re λ = 0`, and reaches as far to the left as to the right while the eigenvalue is followed. Both ends of the interval are
/// certified as their eigenvalues are: where these are proven, it is a theorem that at `lower` the motions that were found decay and that at `upper` one grows. A growth
/// that begins and ends again within the range is not seen.
///
/// # Errors
/// [`SpeedError::Parameter`] where the function fails, [`SpeedError::Grows`] where a motion grows at the first speed already, and [`SpeedError::Search`] for a range
/// that is empty or not finite, a region that does not begin at zero or reaches down to the real axis, or a search that fails.
///
/// # Source
/// Signs of the real parts of eigenvalues, which change where a whirl is neither damped nor driven.
pub fn stability_threshold<Y: Spectrum<Parameter = f64>>(
    speeds: core::ops::RangeInclusive<f64>,
    whirl: Whirl,
    region: Region<f64>,
    mut build: impl FnMut(f64) -> Result<Rotor<Y>, ParameterError>,
) -> Result<Option<Threshold>, SpeedError> {
    let (start, end) = speeds.into_inner();
    if !(start < end && (end - start).is_finite()) {
        return Err(SearchError::Range { start, end }.into());
    }
    let (from, width) = (*region.re.start(), *region.re.end());
    if from != 0.0 {
        return Err(SearchError::Range { start: from, end: width }.into());
    }
    let region = Region { re: -width..=width, ..region };
    let mut at = |speed: f64| -> Result<AtSpeed, SpeedError> {
        let rotor = build(speed).map_err(|error| SpeedError::Parameter { speed, error })?;
        let roots = rotor.whirl(whirl).eigenvalues::<ROOM>(region.clone())?;
        let rightmost = roots.iter().copied().max_by(|one, other| one.lambda.re.total_cmp(&other.lambda.re));
        Ok(AtSpeed { speed, rightmost })
    };
    let (lower, upper) = (at(start)?, at(end)?);
    match (lower.grows(), upper.grows()) {
        (Some(false), Some(true)) => narrowed(lower, upper, &mut at).map(threshold),
        (Some(false), Some(false)) => Ok(None),
        (Some(true), _) => Err(SpeedError::Grows { speed: start }),
        (None, _) => Err(unresolved(&lower).into()),
        (_, None) => Err(unresolved(&upper).into()),
    }
}

/// Two speeds as close to each other as the circles of their eigenvalues let them be, between which a motion begins to grow.
fn narrowed(
    mut lower: AtSpeed,
    mut upper: AtSpeed,
    at: &mut dyn FnMut(f64) -> Result<AtSpeed, SpeedError>,
) -> Result<[AtSpeed; 2], SpeedError> {
    for step in 0..STEPS {
        let width = upper.speed - lower.speed;
        if width <= NARROW * f64::EPSILON * upper.speed.abs() {
            break;
        }
        let half = lower.speed + 0.5 * width;
        let speed = if step % 3 == 2 { half } else { secant(&lower, &upper).unwrap_or(half) };
        let middle = at(speed)?;
        match middle.grows() {
            Some(true) => upper = middle,
            Some(false) => lower = middle,
            // the ends are as far apart as the eigenvalue is uncertain
            None => return around(&middle, [lower, upper], at),
        }
    }
    Ok([lower, upper])
}

/// Two speeds on both sides of one at which the sign of the growth is not decided.
fn around(
    middle: &AtSpeed,
    [mut lower, mut upper]: [AtSpeed; 2],
    at: &mut dyn FnMut(f64) -> Result<AtSpeed, SpeedError>,
) -> Result<[AtSpeed; 2], SpeedError> {
    let slope = match (lower.growth(), upper.growth()) {
        (Some(below), Some(above)) => (above - below) / (upper.speed - lower.speed),
        _ => return Ok([lower, upper]),
    };
    let error = middle.rightmost.map_or(0.0, |root| root.error);
    let mut away = (AWAY * error / slope).max(f64::EPSILON * middle.speed.abs());
    let (first, last) = (lower.speed, upper.speed);
    while away.is_finite() && (lower.speed == first || upper.speed == last) {
        let [below, above] = [middle.speed - away, middle.speed + away];
        if below <= first && above >= last {
            break;
        }
        for speed in [below, above] {
            if speed <= lower.speed || speed >= upper.speed {
                continue;
            }
            let beside = at(speed)?;
            match beside.grows() {
                Some(true) if speed > middle.speed => upper = beside,
                Some(false) if speed < middle.speed => lower = beside,
                _ => {}
            }
        }
        away *= 4.0;
    }
    Ok([lower, upper])
}

/// The zero of the chord between two speeds, if it is between them.
fn secant(lower: &AtSpeed, upper: &AtSpeed) -> Option<f64> {
    let (below, above) = (lower.growth()?, upper.growth()?);
    let speed = lower.speed + (upper.speed - lower.speed) * (below / (below - above));
    (lower.speed < speed && speed < upper.speed).then_some(speed)
}

/// What two speeds tell.
fn threshold([lower, upper]: [AtSpeed; 2]) -> Option<Threshold> {
    let speed = secant(&lower, &upper).unwrap_or(lower.speed + 0.5 * (upper.speed - lower.speed));
    upper.rightmost.map(|eigenvalue| Threshold { speed, lower: lower.speed, upper: upper.speed, eigenvalue })
}

/// The error of a growth of zero.
fn unresolved(at: &AtSpeed) -> SearchError {
    SearchError::Unresolved { near: at.rightmost.map_or(0.0, |root| root.lambda.im) }
}
