//! What a search for a peak asks of a response.

use crate::model::{MotionError, PeakError};
use crate::search::damped::found::Region;
use num_complex::Complex;

/// A pole of a response where a list has it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ListedPole {
    pub(crate) lambda: Complex<f64>,
    /// Radius of a circle around it that holds the pole.
    pub(crate) radius: f64,
    pub(crate) multiplicity: u64,
}

/// A response of a system, or two of one system.
pub(crate) trait Source {
    /// Whether it is two responses, whose ratio is asked for.
    fn is_ratio(&self) -> bool;

    /// The responses at λ; 1 in the place of a missing second one.
    fn values(&self, lambda: Complex<f64>) -> Result<[Complex<f64>; 2], MotionError>;

    /// What rounding may leave at λ of responses that symmetry makes zero.
    fn noise(&self, lambda: Complex<f64>) -> [f64; 2];

    /// Hands on the poles of the list, mirror images among them.
    fn for_each_pole(&self, hand_on: &mut dyn FnMut(ListedPole));

    /// Refuses a box of λ that holds poles that are not in the list, or for all that is known may hold some.
    fn check_box(&self, region: &Region<f64>, listed: u64) -> Result<(), PeakError>;
}
