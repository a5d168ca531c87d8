//! The speed from which on a whirl of a rotor grows.

use crate::model::{SearchError, SpeedError};
use crate::pass::searched::Spectrum;
use crate::search::damped::eigenvalues::Eigenvalues;
use crate::search::damped::found::{Eigenvalue, Region};
use crate::search::rotor::{Rotor, Spinning, Whirl};

/// Room for the eigenvalues of the region at one speed.
const ROOM: usize = 64;

/// Most speeds that are tried: halves of both sides of a range down to the last bit of a number, and a secant step before each.
const STEPS: usize = 160;

/// Width of an interval, in units of eps of the speed, that is not divided any more.
const NARROW: f64 = 4.0;

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

/// The eigenvalues of a region at a speed.
#[derive(Clone, Copy)]
struct AtSpeed {
    speed: f64,
    /// That which grows most, by the left edge of its circle.
    growing: Option<Eigenvalue<f64>>,
    /// The largest right edge of a circle.
    most: f64,
}

impl AtSpeed {
    fn new(speed: f64, roots: &[Eigenvalue<f64>]) -> Self {
        let left = |root: &&Eigenvalue<f64>| root.lambda.re - root.error;
        let growing = roots.iter().max_by(|one, other| left(one).total_cmp(&left(other))).copied();
        let most = roots.iter().map(|root| root.lambda.re + root.error).fold(f64::NEG_INFINITY, f64::max);
        AtSpeed { speed, growing, most }
    }

    /// Whether a motion grows; none where a circle meets the imaginary axis and none is to the right of it.
    fn grows(&self) -> Option<bool> {
        let is_right = self.growing.is_some_and(|root| root.lambda.re - root.error > 0.0);
        if is_right { Some(true) } else { (self.most < 0.0).then_some(false) }
    }

    fn growth(&self) -> Option<f64> {
        self.growing.map(|root| root.lambda.re)
    }
}

/// The speed of a range \[rad/s\] from which on a motion of a whirl grows, with eigenvalues in a region above the real axis: `None` where none of these grows at
/// the last speed.
///
/// The region begins at `Re λ = 0`. The end of its real part is a rate of decay up to which eigenvalues are followed to the left; to the right it reaches at least as
/// far as upwards, so that what grows fast is not lost. Its imaginary part holds the frequencies that may grow, and no undamped one. Both ends of the interval are
/// certified as their eigenvalues are: where these are proven, it is a theorem that at `lower` the motions that were found decay and that at `upper` one grows. A growth
/// that begins and ends again within the range is not seen.
///
/// # Errors
/// [`SpeedError::Parameter`] where the function fails, [`SpeedError::Grows`] where a motion grows at the first speed already, [`SpeedError::Neutral`] where one
/// neither grows nor decays at an end of the range, [`SpeedError::Region`] for a region that does not begin at zero, and [`SpeedError::Search`] for a range that is empty or
/// not finite, a region that reaches below the real axis, or a search that fails.
///
/// # Source
/// Signs of the real parts of eigenvalues, which change where a whirl is neither damped nor driven.
pub fn stability_threshold<Y: Spectrum<Parameter = f64> + Spinning>(
    speeds: core::ops::RangeInclusive<f64>,
    whirl: Whirl,
    region: Region<f64>,
    mut build: impl FnMut(f64) -> Result<Rotor<Y>, Y::BuildError>,
) -> Result<Option<Threshold>, SpeedError<Y::BuildError>> {
    let (start, end) = speeds.into_inner();
    if !(start < end && (end - start).is_finite()) {
        return Err(SearchError::Range { start, end }.into());
    }
    let (from, width) = (*region.re.start(), *region.re.end());
    if from != 0.0 {
        return Err(SpeedError::Region { re: from });
    }
    // what grows fast is not lost to the right
    let region = Region { re: -width..=width.max(*region.im.end()), ..region };
    let mut at = |speed: f64| -> Result<AtSpeed, SpeedError<Y::BuildError>> {
        let rotor = build(speed).map_err(|error| SpeedError::Parameter { speed, error })?;
        let roots = rotor.whirl(whirl).eigenvalues::<ROOM>(region.clone())?;
        Ok(AtSpeed::new(speed, &roots))
    };
    let (lower, upper) = (at(start)?, at(end)?);
    match (lower.grows(), upper.grows()) {
        (Some(false), Some(true)) => narrowed(lower, upper, &mut at).map(threshold),
        (Some(false), Some(false)) => Ok(None),
        (Some(true), _) => Err(SpeedError::Grows { speed: start }),
        (None, _) => Err(neutral(&lower)),
        (_, None) => Err(neutral(&upper)),
    }
}

/// Two speeds, between which a motion begins to grow, as close to each other as twice those are at which the signs of growth are not decided.
fn narrowed<E>(
    mut lower: AtSpeed,
    mut upper: AtSpeed,
    at: &mut dyn FnMut(f64) -> Result<AtSpeed, SpeedError<E>>,
) -> Result<[AtSpeed; 2], SpeedError<E>> {
    // the speeds at which nothing is decided
    let mut open: Option<[f64; 2]> = None;
    for step in 0..STEPS {
        let half = |from: f64, to: f64| from + 0.5 * (to - from);
        let speed = match open {
            None if step % 3 == 2 => half(lower.speed, upper.speed),
            None => secant(&lower, &upper).unwrap_or(half(lower.speed, upper.speed)),
            Some([first, last]) => {
                let [below, above] = [first - lower.speed, upper.speed - last];
                if below.max(above) <= last - first {
                    break;
                }
                if below > above { half(lower.speed, first) } else { half(last, upper.speed) }
            }
        };
        let [before, behind] = open.unwrap_or([upper.speed, lower.speed]);
        let is_narrow = upper.speed - lower.speed <= NARROW * f64::EPSILON * upper.speed.abs();
        let is_between = lower.speed < speed && speed < upper.speed && speed != before && speed != behind;
        if is_narrow || !is_between {
            break;
        }
        let middle = at(speed)?;
        match middle.grows() {
            Some(true) => upper = middle,
            Some(false) => lower = middle,
            None => open = Some(open.map_or([speed; 2], |[first, last]| [first.min(speed), last.max(speed)])),
        }
        // what is not decided may be beyond an end that is
        open = open.filter(|[first, last]| lower.speed < *first && *last < upper.speed);
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
    upper.growing.map(|eigenvalue| Threshold { speed, lower: lower.speed, upper: upper.speed, eigenvalue })
}

/// The error of a motion that neither grows nor decays.
fn neutral<E>(at: &AtSpeed) -> SpeedError<E> {
    SpeedError::Neutral { speed: at.speed, omega: at.growing.map_or(0.0, |root| root.lambda.im) }
}
