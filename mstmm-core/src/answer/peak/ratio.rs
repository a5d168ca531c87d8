//! Ratios of two responses: transmissibilities.

use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::network::response::PlaneResponse;
use crate::answer::peak::of_response::{BandResponse, Listed};
use crate::answer::peak::result::{Peak, least, peak};
use crate::answer::root::Root;
use crate::model::PeakError;
use crate::number::{Oscillation, Real};
use crate::pass::network::Placed;
use crate::pass::tree::Planned;
use crate::search::ClosedRange;
use num_complex::Complex;

/// The ratio of two responses of one system, such as how much of a motion or of a force arrives somewhere else.
#[derive(Clone, Copy, Debug)]
pub struct ResponseRatio<'r, R> {
    response: &'r R,
    divisor: &'r R,
}

impl<Y: Planned + ?Sized> FrequencyResponse<'_, Y> {
    /// The ratio of this response to another one of the same system.
    pub fn over<'r>(&'r self, divisor: &'r Self) -> ResponseRatio<'r, Self> {
        ResponseRatio { response: self, divisor }
    }
}

impl<Y: Placed> PlaneResponse<'_, Y> {
    /// The ratio of this response to another one of the same structure.
    ///
    /// ```
    /// use mstmm_core::elements::{Spring, SpringDamper};
    /// use mstmm_core::frame::{Frame, Ground};
    /// use mstmm_core::search::{Eigenvalues, Region};
    /// use mstmm_core::FrameAnalysis;
    ///
    /// // a machine on a damped mount, on a floor
    /// let mut frame = Frame::new();
    /// let [machine, floor] = [0.0, 1.0].map(|place| frame.point(place));
    /// frame.member(machine, floor, SpringDamper { stiffness: 4e4, damping: 60.0 });
    /// frame.member(floor, Ground, SpringDamper { stiffness: 9e6, damping: 2e3 });
    /// frame.mass(machine, 20.0);
    /// frame.mass(floor, 300.0);
    /// let house = frame.build_damped()?;
    /// let roots = house.eigenvalues_in(Region { re: -500.0..=0.0, im: 0.0..=500.0 })?;
    /// let of_floor = house.frequency_response(machine.force_y(), floor.displacement_y())?;
    /// let of_machine = house.frequency_response(machine.force_y(), machine.displacement_y())?;
    /// let ratio = of_floor.over(&of_machine).peak(10.0..=300.0, &roots, 1e-6)?;
    /// // the floor moves most at its own frequency, with the machine held
    /// assert!((ratio.omega - (9.04e6_f64 / 300.0).sqrt()).abs() < 1.0, "{ratio:?}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn over<'r>(&'r self, divisor: &'r Self) -> ResponseRatio<'r, Self> {
        ResponseRatio { response: self, divisor }
    }
}

impl<R> ResponseRatio<'_, R> {
    /// The largest size of the ratio over a range of ω [rad/s], as [`peak`](FrequencyResponse::peak) has that of a response. Poles of both are the same and
    /// fall out of it; what makes the ratio large are frequencies at which its divisor is small.
    ///
    /// # Errors
    /// As [`peak`](FrequencyResponse::peak), and [`PeakError::Infinite`] where the divisor changes its sign, [`PeakError::OtherSystem`] for two systems.
    pub fn peak<T>(
        &self,
        range: impl ClosedRange<T>,
        roots: &[impl Root<T>],
        tolerance: f64,
    ) -> Result<Peak<T>, PeakError>
    where
        T: Real,
        Complex<T>: Oscillation<T>,
        R: BandResponse<Number = T>,
    {
        peak(&self.listed(roots)?, range, tolerance)
    }

    /// The least size of the ratio over a range of ω [rad/s].
    ///
    /// # Errors
    /// As [`peak`](FrequencyResponse::peak), and [`PeakError::OtherSystem`] for two systems.
    pub fn least<T>(
        &self,
        range: impl ClosedRange<T>,
        roots: &[impl Root<T>],
        tolerance: f64,
    ) -> Result<Peak<T>, PeakError>
    where
        T: Real,
        Complex<T>: Oscillation<T>,
        R: BandResponse<Number = T>,
    {
        least(&self.listed(roots)?, range, tolerance)
    }

    /// Both responses with the roots of their system.
    fn listed<'r, T, Q>(&'r self, roots: &'r [Q]) -> Result<Listed<'r, R, Q>, PeakError>
    where
        T: Real,
        R: BandResponse<Number = T>,
        Q: Root<T>,
    {
        if !self.response.is_of_the_same(self.divisor) {
            return Err(PeakError::OtherSystem);
        }
        Ok(Listed { response: self.response, divisor: Some(self.divisor), roots })
    }
}
