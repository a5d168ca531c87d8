//! Campbell diagrams: the frequencies of both whirls of a rotor at many speeds.

use crate::pass::searched::Undamped;
use crate::search::rotor::{Rotor, Spinning, Whirl};
use crate::search::undamped::found::FrequencyList;
use crate::search::undamped::natural::NaturalFrequencies;
use crate::search::undamped::sweep::SweepError;

/// The lowest frequencies of a rotor at a speed.
#[derive(Clone, Copy, Debug)]
pub struct AtSpeed<const N: usize> {
    /// The speed [rad/s].
    pub speed: f64,
    /// The frequencies of forward whirl.
    pub forward: FrequencyList<f64, N>,
    /// The frequencies of backward whirl.
    pub backward: FrequencyList<f64, N>,
}

/// The lowest frequencies of both whirls at some speeds \[rad/s\], each proven, one speed after the other.
///
/// The function builds the rotor at a speed, and may change bearings with it. A curve of the diagram goes by the whirl and the number of a frequency, so
/// that no shapes are compared. Where curves of one whirl cross, as they may in a rotor of mirror symmetry, a number changes its mode.
///
/// # Errors
/// The items are errors, [`SweepError`], of a speed at which the function fails, or a search.
pub fn campbell<const N: usize, Y: Undamped<Parameter = f64> + Spinning>(
    speeds: impl IntoIterator<Item = f64>,
    mut build: impl FnMut(f64) -> Result<Rotor<Y>, Y::BuildError>,
) -> impl Iterator<Item = Result<AtSpeed<N>, SweepError<Y::BuildError>>> {
    speeds.into_iter().map(move |speed| {
        let rotor = build(speed).map_err(SweepError::Parameter)?;
        let frequencies = |whirl| rotor.whirl(whirl).first_frequencies::<N>().map_err(SweepError::Search);
        Ok(AtSpeed { speed, forward: frequencies(Whirl::Forward)?, backward: frequencies(Whirl::Backward)? })
    })
}
