//! Critical loads: the factors of a load at which a structure at rest loses its stability, certified by counts.

use crate::model::{LoadError, ParameterError};
use crate::number::{List, Parameter};
use crate::pass::searched::Undamped;
use crate::proof::prover::Prover;
use crate::search::by_factor::{Crossing, Sample, crossings};
use crate::search::closed_range::ClosedRange;
use crate::search::undamped::proven::Parts;
use core::ops::Deref;
use num_traits::Zero;

/// A factor of a load at which stability is lost: of the model at `lower` at most `index - 1` motions grow, of that at `upper` at least
/// `index + multiplicity - 1`. Both counts are proven, whatever the load does between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CriticalLoad<T = f64> {
    /// The load factor.
    pub factor: T,
    /// Lower end of the certified interval.
    pub lower: T,
    /// Upper end of the certified interval.
    pub upper: T,
    /// Number of motions that begin to grow there.
    pub multiplicity: u64,
    /// Index of the first of them, from 1 on: one more than the number of motions that grow under a load just below.
    pub index: u64,
}

/// Critical loads in ascending order; dereferences to a slice.
#[derive(Clone, Copy, Debug)]
pub struct CriticalLoads<T, const CAP: usize>(List<CriticalLoad<T>, CAP>);

impl<T, const CAP: usize> Deref for CriticalLoads<T, CAP> {
    type Target = [CriticalLoad<T>];

    fn deref(&self) -> &[CriticalLoad<T>] {
        &self.0
    }
}

impl<'a, T, const CAP: usize> IntoIterator for &'a CriticalLoads<T, CAP> {
    type Item = &'a CriticalLoad<T>;
    type IntoIter = core::slice::Iter<'a, CriticalLoad<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

/// Every factor of a range at which the structure under that load begins to have a motion that grows, each certified, with multiplicity.
///
/// The function builds the structure under a factor times the load: its axial forces are proportional to the factor. At rest the count of
/// Wittrick and Williams is that of the negative eigenvalues of the stiffness, which grows with the factor where the load compresses all
/// elements on which it acts; so brackets with counts hold all factors, as brackets of frequencies do.
///
/// # Errors
/// [`LoadError::Parameter`] where the function fails, [`LoadError::Falls`] where fewer motions grow under a larger factor, and
/// [`LoadError::Search`] for a range that is empty or not finite, more than `CAP` factors, or a structure that is not held, whose
/// stiffness has no inverse at any factor.
///
/// # Source
/// Wittrick and Williams for buckling: the count of clamped elements and of signs at ω = 0.
pub fn critical_loads<const CAP: usize, Y: Undamped>(
    factors: impl ClosedRange<Y::Parameter>,
    mut build: impl FnMut(Y::Parameter) -> Result<Y, ParameterError>,
) -> Result<CriticalLoads<Y::Parameter, CAP>, LoadError> {
    let built =
        |factor: Y::Parameter| build(factor).map_err(|error| LoadError::Parameter { factor: factor.to_f64(), error });
    critical_loads_of(factors, built)
}

/// The critical loads of structures that are built under a factor, or refused.
pub(super) fn critical_loads_of<const CAP: usize, Y: Undamped>(
    factors: impl ClosedRange<Y::Parameter>,
    mut built: impl FnMut(Y::Parameter) -> Result<Y, LoadError>,
) -> Result<CriticalLoads<Y::Parameter, CAP>, LoadError> {
    let (start, end) = factors.closed().into_inner();
    let sample = |factor: Y::Parameter| {
        let system = built(factor)?;
        let parts = Parts(&system);
        let ([least, most], bound) = Prover::new(&parts).bounds_with_delta(Y::Parameter::zero(), 1.0);
        Ok(Sample { factor, least: least.unwrap_or(0), most: most.unwrap_or(u64::MAX), bound: Some(bound) })
    };
    let found = crossings([start, end], sample, |factor| LoadError::Falls { factor })?;
    Ok(CriticalLoads(found.map(|Crossing { factor, lower, upper, multiplicity, index }| CriticalLoad {
        factor,
        lower,
        upper,
        multiplicity,
        index,
    })))
}
