//! Eigenvalues in regions of the complex plane: the trait that users call.

use crate::model::SearchError;
use crate::number::{Dual, Frequency, List, Parameter, Real, Scalar};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::found::{Eigenvalue, EigenvalueList, Region};
use crate::search::damped::session::EigenvalueSearch;
use num_complex::Complex;

/// A system that can be searched for eigenvalues: it has Δ and its derivative in the precision of the parameters and in extended
/// precision.
///
/// Every system without planar elements is one.
pub trait Spectrum:
    System
    + Characteristic<Dual<Complex<<Self as System>::Parameter>>>
    + Characteristic<Dual<Complex<<<Self as System>::Parameter as Real>::Extended>>>
{
}

impl<Y> Spectrum for Y where
    Y: System
        + Characteristic<Dual<Complex<<Y as System>::Parameter>>>
        + Characteristic<Dual<Complex<<<Y as System>::Parameter as Real>::Extended>>>
        + ?Sized
{
}

/// The certified searches of damped systems; undamped ones have them, too.
///
/// A search whose result is doubtful (sums cancel, roots coincide or nearly do, rounding has widened circles) is made again in
/// extended precision: double-double for `f64`. Without the feature `judge` wide circles stay.
///
/// Where something has a loss factor, regions lie above the real axis, below which no motion has it, and no eigenvalue has a mirror image. Where
/// a member has a time c of Kelvin and Voigt, regions keep away from `λ = -1/c`, and so do the first eigenvalues.
///
/// A thread of 192 kB is enough, of 768 kB in debug builds.
pub trait Eigenvalues: System {
    /// Number of eigenvalues in a region, with multiplicity; those on its edges belong to it.
    ///
    /// # Errors
    /// [`SearchError::Range`] for a region that is empty or not finite; [`SearchError::NotANumber`] for a Δ that is not finite on
    /// its contour; [`SearchError::Unresolved`] for roots that cannot be told apart from the contour;
    /// [`SearchError::Capacity`] where more than 256 eigenvalues, of each pair one, had to be found to tell;
    /// [`SearchError::Effort`] where it took too many evaluations; [`SearchError::Zero`] for a model in which something is
    /// held twice; [`SearchError::LossFactor`] and [`SearchError::Accumulation`] for regions that damping of materials excludes.
    ///
    /// # Source
    /// The argument principle on the pole-free Δ(λ), with steps that the derivative controls; known roots are divided out.
    fn count_in(&self, region: Region<Self::Parameter>) -> Result<u64, SearchError>
    where
        Self: Spectrum,
    {
        let (plain, asks_extended) = searched(self, |search| search.count(&region));
        if !asks_extended {
            return plain;
        }
        let region = region.map(exactly);
        searched::<Self, ExtendedOf<Self>, _>(self, |search| search.count(&region)).0
    }

    /// Every eigenvalue in a region, each certified, with multiplicity: by ascending imaginary part.
    ///
    /// # Errors
    /// As `count_in`, and [`SearchError::Capacity`] if there are more than `CAP` entries, or more than 256 with those close to the
    /// region, of each pair one.
    fn eigenvalues<const CAP: usize>(
        &self,
        region: Region<Self::Parameter>,
    ) -> Result<EigenvalueList<Self::Parameter, CAP>, SearchError>
    where
        Self: Spectrum,
    {
        judged(self, |search| search.in_region(&region), |search| search.in_region(&region.clone().map(exactly)))
    }

    /// The eigenvalues of least modulus in the closed upper half plane, by ascending modulus: the fewest entries whose
    /// multiplicities add up to at least `N`, up to 256.
    ///
    /// # Errors
    /// [`SearchError::TooFewRoots`] if the system has no more than it says; [`SearchError::Capacity`] for an `N` beyond 256; else
    /// as `eigenvalues`.
    fn first_eigenvalues<const N: usize>(&self) -> Result<EigenvalueList<Self::Parameter, N>, SearchError>
    where
        Self: Spectrum,
    {
        judged(self, |search| search.first(), |search| search.first())
    }
}

/// The extended precision of a system's parameters.
type ExtendedOf<Y> = <<Y as System>::Parameter as Real>::Extended;

/// A list of eigenvalues, or the error of a search for them.
type Found<T, const CAP: usize> = Result<EigenvalueList<T, CAP>, SearchError>;

/// A number in extended precision.
fn exactly<T: Real>(number: T) -> T::Extended {
    <T::Extended as Frequency<T>>::from_parameter(number)
}

/// The result of a search, or where that is doubtful the result in extended precision.
fn judged<Y: Spectrum + ?Sized, const CAP: usize>(
    system: &Y,
    plain: impl FnOnce(&mut EigenvalueSearch<'_, Y, Y::Parameter>) -> Found<Y::Parameter, CAP>,
    judge: impl FnOnce(&mut EigenvalueSearch<'_, Y, ExtendedOf<Y>>) -> Found<ExtendedOf<Y>, CAP>,
) -> Found<Y::Parameter, CAP> {
    let (found, asks_extended) = searched(system, plain);
    if !asks_extended {
        return found;
    }
    let plain = found.map_or(0, |found| found.evaluations);
    let judged = searched(system, judge).0?;
    let mut eigenvalues = List::new();
    for root in &judged {
        let plainly = |x: ExtendedOf<Y>| <Y::Parameter as Scalar>::from_f64(x.to_f64());
        let lambda = Complex::new(plainly(root.lambda.re), plainly(root.lambda.im));
        let root = Eigenvalue { lambda, error: plainly(root.error), multiplicity: root.multiplicity };
        eigenvalues.push(root).map_err(|_| SearchError::Capacity { capacity: CAP })?;
    }
    Ok(EigenvalueList { eigenvalues, evaluations: plain + judged.evaluations })
}

/// Runs a search, and tells whether it has to be repeated in extended precision. Not inlined, so that its memory is freed.
#[inline(never)]
fn searched<'a, Y, T, R>(system: &'a Y, run: impl FnOnce(&mut EigenvalueSearch<'a, Y, T>) -> R) -> (R, bool)
where
    T: Real,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    let mut search = EigenvalueSearch::new(system);
    let found = run(&mut search);
    (found, search.asks_extended())
}

impl<Y: System + ?Sized> Eigenvalues for Y {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::assert_close;

    fn eigenvalue(re: f64, im: f64) -> Eigenvalue<f64> {
        Eigenvalue { lambda: Complex::new(re, im), error: 0.0, multiplicity: 1 }
    }

    /// Oracle: the motion `e^{λt}` itself, one period and one decay time later; and the textbook's `2πζ/sqrt(1 - ζ²)`.
    #[test]
    fn measures_of_damping_are_those_of_the_motion() {
        for (re, im) in [(-0.3, 2.0), (-1e-3, 0.7), (-5.0, -1.0), (0.02, 3.0)] {
            let root = eigenvalue(re, im);
            let period = core::f64::consts::TAU / im.abs();
            let after = |time: f64| (root.lambda * time).exp().norm();
            assert_close(after(period), (-root.logarithmic_decrement()).exp(), 1.0, 64.0);
            assert_close(after(root.decay_time()), (-1.0_f64).exp(), 1.0, 8.0);
            let ratio = root.damping_ratio();
            let textbook = core::f64::consts::TAU * ratio / (1.0 - ratio * ratio).sqrt();
            // near the critical damping 1 - ζ² cancels, here to a 26th
            assert_close(root.logarithmic_decrement(), textbook, textbook.abs(), 128.0);
        }
    }

    #[test]
    fn measures_of_damping_at_their_limits() {
        let (undamped, overdamped, rest) = (eigenvalue(0.0, 2.0), eigenvalue(-3.0, 0.0), eigenvalue(0.0, 0.0));
        assert_eq!((undamped.logarithmic_decrement(), undamped.decay_time()), (0.0, f64::INFINITY));
        assert_eq!((overdamped.logarithmic_decrement(), overdamped.decay_time()), (f64::INFINITY, 1.0 / 3.0));
        assert_eq!((rest.logarithmic_decrement(), rest.damping_ratio()), (0.0, 0.0));
        assert_eq!(eigenvalue(-0.0, 2.0).decay_time(), f64::INFINITY);
    }
}
