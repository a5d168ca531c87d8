//! Critical speeds: where a multiple of the speed of a rotor is one of its frequencies, certified by counts.

use crate::model::{SearchError, SpeedError};
use crate::number::List;
use crate::number::double_double::DoubleDouble;
use crate::pass::searched::Undamped;
use crate::proof::prover::Prover;
use crate::proof::visit::{Knowledge, knowledge_of};
use crate::search::by_factor::{Crossing, Sample, crossings};
use crate::search::closed_range::ClosedRange;
use crate::search::rotor::{Rotor, Spinning, Whirl};
use crate::search::undamped::proven::Parts;
use core::ops::Deref;

/// A speed Ω at which a rotor has a frequency `ω = nΩ`: of the rotor at `lower` at most `index - 1` frequencies are below n times its speed, of
/// that at `upper` at least `index + multiplicity - 1`. Both counts are proven, whatever the bearings do between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CriticalSpeed {
    /// The speed [rad/s].
    pub speed: f64,
    /// Lower end of the certified interval.
    pub lower: f64,
    /// Upper end of the certified interval.
    pub upper: f64,
    /// Index of the first frequency that is at its multiple of the speed there, from 1 on.
    pub index: u64,
    /// Number of them.
    pub multiplicity: u64,
    /// Whether both counts are proven: those of elements that are known by their transfer matrix alone are not.
    pub is_proven: bool,
}

/// Critical speeds in ascending order; dereferences to a slice.
#[derive(Clone, Copy, Debug)]
pub struct CriticalSpeeds<const CAP: usize>(List<CriticalSpeed, CAP>);

impl<const CAP: usize> Deref for CriticalSpeeds<CAP> {
    type Target = [CriticalSpeed];

    fn deref(&self) -> &[CriticalSpeed] {
        &self.0
    }
}

/// Every speed of a range \[rad/s\] at which a whirl of a rotor has a frequency of an order n, `ω = nΩ`, each certified, with multiplicity. The order of
/// synchronous whirl, as an unbalance excites, is 1.
///
/// The function builds the rotor at a speed. It may change bearings with the speed: an interval is a theorem about the two rotors at its ends. The list is
/// complete where speeds alone change, in proportion. Then `L = K - ω² (M - G/n)`, whose negative eigenvalues do not become fewer as ω grows, since
/// K is positive.
///
/// # Errors
/// [`SpeedError::Parameter`] where the function fails, [`SpeedError::Order`] for an order that is not positive, [`SpeedError::Negative`] for a range that begins below zero, [`SpeedError::Falls`] where fewer frequencies
/// are below the line of the order at a larger speed, and [`SpeedError::Search`] for a range that is empty or not finite, more than `CAP` speeds, a
/// rotor that nothing holds, [`Zero`](SearchError::Zero), or with motions that grow at rest, [`Unstable`](SearchError::Unstable).
///
/// # Source
/// Wittrick and Williams for gyroscopic systems: with K positive the count at ω is the number of frequencies of a whirl below it.
pub fn critical_speeds<const CAP: usize, Y: Undamped<Parameter = f64> + Spinning>(
    speeds: impl ClosedRange<f64>,
    whirl: Whirl,
    order: f64,
    mut build: impl FnMut(f64) -> Result<Rotor<Y>, Y::BuildError>,
) -> Result<CriticalSpeeds<CAP>, SpeedError<Y::BuildError>> {
    let built = |speed: f64| {
        build(speed).map(|rotor| rotor.into_whirl(whirl)).map_err(|error| SpeedError::Parameter { speed, error })
    };
    critical_speeds_of(speeds, order, built)
}

/// The critical speeds of whirls of rotors that are built at a speed, or refused.
pub(super) fn critical_speeds_of<const CAP: usize, Y: Undamped<Parameter = f64>, E>(
    speeds: impl ClosedRange<f64>,
    order: f64,
    mut built: impl FnMut(f64) -> Result<Y, SpeedError<E>>,
) -> Result<CriticalSpeeds<CAP>, SpeedError<E>> {
    let (start, end) = speeds.closed().into_inner();
    if !(order > 0.0 && order.is_finite()) {
        return Err(SpeedError::Order { order });
    }
    if start < 0.0 {
        return Err(SpeedError::Negative { speed: start });
    }
    let mut is_proven = true;
    let sample = |speed: f64| {
        let rotor = built(speed)?;
        let parts = Parts(&rotor);
        let mut prover = Prover::new(&parts);
        check_held(&mut prover)?;
        is_proven &= knowledge_of(&parts) == Knowledge::Numbers;
        // exactly n times the speed, in two words
        let ([least, most], bound) = prover.bounds_with_delta(DoubleDouble::from_product(order, speed), 1.0);
        Ok(Sample { factor: speed, least: least.unwrap_or(0), most: most.unwrap_or(u64::MAX), bound: Some(bound) })
    };
    let found = crossings([start, end], sample, |speed| SpeedError::Falls { speed })?;
    Ok(CriticalSpeeds(found.map(|Crossing { factor: speed, lower, upper, multiplicity, index }| CriticalSpeed {
        speed,
        lower,
        upper,
        index,
        multiplicity,
        is_proven,
    })))
}

/// Refuses a rotor whose stiffness at rest is not positive: there a count is no number of frequencies.
fn check_held(prover: &mut Prover<'_>) -> Result<(), SearchError> {
    match prover.bounds(0.0, 1.0) {
        [Some(0), Some(0)] => Ok(()),
        [Some(modes), _] if modes > 0 => Err(SearchError::Unstable { modes }),
        _ => Err(SearchError::Zero { points: 1, at: Some(prover.spot(prover.smallest_at)) }),
    }
}
