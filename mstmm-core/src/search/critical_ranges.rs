//! Ranges of critical loads and of critical speeds over boxes of tolerances.
//!
//! Of a system that lies between two at each factor, its axial forces among its parameters, no more motions grow than of the soft one, and no fewer than of the stiff one. So its critical factors lie between theirs, number by
//! number. Below the critical speed of a number fewer frequencies are below the line of the order: the soft rotor reaches it first.

use crate::model::{LoadError, ParameterError, SpeedError, ToleranceError};
use crate::number::{List, Parameter};
use crate::pass::characteristic::System;
use crate::pass::searched::Undamped;
use crate::search::closed_range::ClosedRange;
use crate::search::critical_loads::{CriticalLoad, CriticalLoads, critical_loads_of};
use crate::search::critical_speeds::{CriticalSpeed, CriticalSpeeds, critical_speeds_of};
use crate::search::rotor::{Rotor, Spinning, Whirl};
use crate::search::undamped::tolerance_box::{ToleranceBox, collected, of_number};
use core::ops::RangeInclusive;

/// The range of a critical load of one number over a box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CriticalLoadRange<T = f64> {
    /// That of the soft system.
    pub lowest: CriticalLoad<T>,
    /// That of the stiff system.
    pub highest: CriticalLoad<T>,
}

/// The range of a critical speed of one number over a box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CriticalSpeedRange {
    /// That of the soft rotor.
    pub lowest: CriticalSpeed,
    /// That of the stiff rotor.
    pub highest: CriticalSpeed,
}

impl<Y: Undamped> ToleranceBox<Y> {
    /// The ranges of the critical factors of axial forces, given what a system of the box is under a factor of these; of those numbers of which both systems have one in the range of factors.
    ///
    /// They hold for all systems of the box under the same forces, or under forces between those of both ends. Under loads the forces of a structure that is not statically determinate depend on
    /// its stiffnesses: a column that is stiffer than its neighbours takes more of a load, and the structure may buckle outside of the range then.
    ///
    /// ```
    /// use mstmm_core::Support;
    /// use mstmm_core::FrameAnalysis;
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::ToleranceBox;
    ///
    /// let column = |stiffness: f64| {
    ///     let mut frame = Frame::new();
    ///     let [foot, top] = [[0.0, 0.0], [0.0, 2.0]].map(|place| frame.point(place));
    ///     frame.member(foot, top, Section::new().axial_stiffness(1e9).bending_stiffness(stiffness).mass_per_length(4.0));
    ///     frame.hold(foot, Support::Fixed);
    ///     (frame.build(), top)
    /// };
    /// let (soft, top) = column(0.9e5);
    /// let lot = ToleranceBox::between(soft?, column(1.1e5).0?)?;
    /// let forces = lot.soft().axial_forces(&[(top.force_y(), -1.0)])?;
    /// let ranges = lot.critical_loads::<1, _>(0.0..=1e5, |column, load| column.with_axial_forces(&(&forces * load)))?;
    /// let euler = |stiffness: f64| stiffness * (core::f64::consts::PI / 4.0).powi(2);
    /// assert!((ranges[0].lowest.factor / euler(0.9e5) - 1.0).abs() < 1e-14);
    /// assert!((ranges[0].highest.factor / euler(1.1e5) - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LoadError::NotABox`] where both systems under a factor are no box; else as [`critical_loads`](crate::search::critical_loads) of both.
    pub fn critical_loads<const CAP: usize, F>(
        &self,
        factors: impl ClosedRange<Y::Parameter>,
        mut build: F,
    ) -> Result<List<CriticalLoadRange<Y::Parameter>, CAP>, LoadError>
    where
        F: FnMut(&Y, Y::Parameter) -> Result<Y, ParameterError>,
    {
        let factors = factors.closed();
        let mut under = |end: usize, factor: Y::Parameter| {
            let mut built = |system: &Y| {
                build(system, factor).map_err(|error| LoadError::Parameter { factor: factor.to_f64(), error })
            };
            let both = [built(self.soft())?, built(self.stiff())?];
            one_of(both, end).map_err(|error| LoadError::NotABox { factor: factor.to_f64(), error })
        };
        let soft: CriticalLoads<_, CAP> = critical_loads_of(factors.clone(), |factor| under(0, factor))?;
        let stiff: CriticalLoads<_, CAP> = critical_loads_of(factors, |factor| under(1, factor))?;
        let of = |loads: &[CriticalLoad<Y::Parameter>], number: u64| {
            of_number(loads, number, |load| [load.index, load.multiplicity])
        };
        let range = |number: u64| Some(CriticalLoadRange { lowest: of(&soft, number)?, highest: of(&stiff, number)? });
        Ok(collected(soft.first().map_or(1, |load| load.index), range))
    }
}

/// The ranges of the critical speeds of a whirl and an order over all rotors between a soft and a stiff one, given both at a speed; of those numbers of which both have one in the range of
/// speeds.
///
/// # Errors
/// [`SpeedError::NotABox`] where both rotors at a speed are no box; else as [`critical_speeds`](crate::search::critical_speeds) of both.
pub fn critical_speed_ranges<const CAP: usize, Y>(
    speeds: impl ClosedRange<f64>,
    whirl: Whirl,
    order: f64,
    mut build: impl FnMut(f64) -> Result<[Rotor<Y>; 2], Y::BuildError>,
) -> Result<List<CriticalSpeedRange, CAP>, SpeedError<Y::BuildError>>
where
    Y: Undamped<Parameter = f64> + Spinning,
{
    let speeds: RangeInclusive<f64> = speeds.closed();
    let mut at = |end: usize, speed: f64| {
        let both = build(speed).map_err(|error| SpeedError::Parameter { speed, error })?;
        one_of(both.map(|rotor| rotor.into_whirl(whirl)), end).map_err(|error| SpeedError::NotABox { speed, error })
    };
    let soft: CriticalSpeeds<CAP> = critical_speeds_of(speeds.clone(), order, |speed| at(0, speed))?;
    let stiff: CriticalSpeeds<CAP> = critical_speeds_of(speeds, order, |speed| at(1, speed))?;
    let of =
        |speeds: &[CriticalSpeed], number: u64| of_number(speeds, number, |speed| [speed.index, speed.multiplicity]);
    let range = |number: u64| Some(CriticalSpeedRange { lowest: of(&soft, number)?, highest: of(&stiff, number)? });
    Ok(collected(soft.first().map_or(1, |speed| speed.index), range))
}

/// The one or the other system of a box.
fn one_of<Y: System>([soft, stiff]: [Y; 2], end: usize) -> Result<Y, ToleranceError> {
    let (soft, stiff) = ToleranceBox::between(soft, stiff)?.into_ends();
    Ok(if end == 0 { soft } else { stiff })
}
