//! Eigenvalues in regions of the complex plane: the trait that users call.

use crate::model::SearchError;
use crate::number::{Dual, List, Parameter, Real, Scalar, Store};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::searched::Spectrum;
use crate::search::damped::found::{Eigenvalue, EigenvalueList, Found, Region, exactly};
use crate::search::damped::proven::prove_all;
use crate::search::damped::session::EigenvalueSearch;
use crate::search::room::add;
use num_complex::Complex;

/// The certified searches of damped systems; undamped ones have them, too.
///
/// Eigenvalues that rounding has blurred (circles are wide, others are close) are found again in extended precision: double-double for
/// `f64`. A search in which sums cancel or eigenvalues coincide is made again in it. Without the feature `proof` wide circles stay.
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
        let (plain, asks_extended) = searched::<_, _, Known<_>, _>(self, |search| search.count(&region));
        if !asks_extended {
            return plain;
        }
        let region = region.map(exactly);
        searched::<Self, ExtendedOf<Self>, Known<_>, _>(self, |search| search.count(&region)).0
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
        in_region::<_, Known<_>, List<_, CAP>>(self, region).map(EigenvalueList::from)
    }

    /// Every eigenvalue in a region, as [`eigenvalues`](Eigenvalues::eigenvalues) finds them, in a vector, which holds as many as there
    /// are; the search itself has room for as many, too.
    ///
    /// ```
    /// use mstmm_core::elements::{Mass, SpringDamper};
    /// use mstmm_core::search::{Eigenvalues, Region};
    /// use mstmm_core::{AnyElement, ListStep, StepList, Support};
    ///
    /// let steps = [
    ///     ListStep::Tip(Support::Fixed),
    ///     ListStep::Element(AnyElement::try_from(SpringDamper { stiffness: 25.0_f64, damping: 6.0 })?),
    ///     ListStep::Element(Mass { mass: 1.0 }.try_into()?),
    ///     ListStep::Root(Support::Free),
    /// ];
    /// let found = StepList::new(&steps)?.eigenvalues_in(Region { re: -5.0..=0.0, im: -10.0..=10.0 })?;
    /// // λ² + 6 λ + 25 = 0
    /// assert_eq!(found.iter().map(|root| root.lambda.im.round()).collect::<Vec<_>>(), [-4.0, 4.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As `count_in`, but for its limit of 256; [`SearchError::Capacity`] only where memory ends.
    #[cfg(feature = "std")]
    fn eigenvalues_in(
        &self,
        region: Region<Self::Parameter>,
    ) -> Result<std::vec::Vec<Eigenvalue<Self::Parameter>>, SearchError>
    where
        Self: Spectrum,
    {
        use std::vec::Vec;
        in_region::<_, Vec<_>, Vec<_>>(self, region).map(|found| found.eigenvalues)
    }

    /// The eigenvalues of least modulus in the closed upper half plane, by ascending modulus: the fewest entries whose
    /// multiplicities add up to at least `N`, up to 256.
    ///
    /// A rigid body at rest has `λ = 0` twice, so each rigid-body mode is two eigenvalues, where it is one of the natural frequencies.
    ///
    /// # Errors
    /// [`SearchError::TooFewRoots`] if the system has no more than it says; [`SearchError::Capacity`] for an `N` beyond 256; else
    /// as `eigenvalues`.
    fn first_eigenvalues<const N: usize>(&self) -> Result<EigenvalueList<Self::Parameter, N>, SearchError>
    where
        Self: Spectrum,
    {
        if N > ROOM {
            return Err(SearchError::Capacity { capacity: ROOM });
        }
        judged::<_, Known<_>, List<_, N>>(self, |search| search.first(), |search| search.first())
            .map(EigenvalueList::from)
    }
}

/// The extended precision of a system's parameters.
type ExtendedOf<Y> = <<Y as System>::Parameter as Real>::Extended;

/// Room for the eigenvalues of a search while it runs.
const ROOM: usize = 256;

/// The eigenvalues of a search while it runs.
type Known<T> = List<Eigenvalue<T>, ROOM>;

/// The result of a search that collects eigenvalues in a list of type `L`.
type Searched<L> = Result<Found<L>, SearchError>;

/// A list of the same kind in extended precision.
type Extended<L, Y> = <L as Store<Eigenvalue<<Y as System>::Parameter>>>::Of<Eigenvalue<ExtendedOf<Y>>>;

/// Every eigenvalue in a region; the search keeps those that it knows in a list of type `K`.
fn in_region<Y, K, L>(system: &Y, region: Region<Y::Parameter>) -> Searched<L>
where
    Y: Spectrum + ?Sized,
    K: Store<Eigenvalue<Y::Parameter>>,
    L: Store<Eigenvalue<Y::Parameter>>,
{
    let exact = region.clone().map(exactly);
    judged::<_, K, L>(system, |search| search.in_region(&region), |search| search.in_region(&exact))
}

/// The result of a search, or where that is doubtful the result in extended precision.
fn judged<Y, K, L>(
    system: &Y,
    plain: impl FnOnce(&mut EigenvalueSearch<'_, Y, Y::Parameter, K>) -> Searched<L>,
    judge: impl FnOnce(&mut EigenvalueSearch<'_, Y, ExtendedOf<Y>, Extended<K, Y>>) -> Searched<Extended<L, Y>>,
) -> Searched<L>
where
    Y: Spectrum + ?Sized,
    K: Store<Eigenvalue<Y::Parameter>>,
    L: Store<Eigenvalue<Y::Parameter>>,
{
    let (found, asks_extended) = searched(system, plain);
    if !asks_extended {
        return found.map(|found| proven(system, found));
    }
    let plain = found.map_or(0, |found| found.evaluations);
    let judged = searched(system, judge).0?;
    let mut eigenvalues = L::empty();
    for root in judged.eigenvalues.iter() {
        let plainly = |x: ExtendedOf<Y>| <Y::Parameter as Scalar>::from_f64(x.to_f64());
        let lambda = Complex::new(plainly(root.lambda.re), plainly(root.lambda.im));
        let (error, multiplicity) = (plainly(root.error), root.multiplicity);
        add(&mut eigenvalues, Eigenvalue { lambda, error, multiplicity, is_proven: false })?;
    }
    Ok(proven(system, Found { eigenvalues, evaluations: plain + judged.evaluations }))
}

/// What was found, proven as far as that can be.
fn proven<Y, L>(system: &Y, mut found: Found<L>) -> Found<L>
where
    Y: System + ?Sized,
    L: Store<Eigenvalue<Y::Parameter>>,
{
    prove_all(system, found.eigenvalues.values());
    found
}

/// Runs a search, and tells whether it has to be repeated in extended precision. Not inlined, so that its memory is freed.
#[inline(never)]
fn searched<'a, Y, T, K, R>(system: &'a Y, run: impl FnOnce(&mut EigenvalueSearch<'a, Y, T, K>) -> R) -> (R, bool)
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    let mut search = EigenvalueSearch::new(system);
    search.evaluation.look_elsewhere::<T>();
    let found = run(&mut search);
    (found, search.asks_extended())
}

impl<Y: System + ?Sized> Eigenvalues for Y {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::assert_close;

    fn eigenvalue(re: f64, im: f64) -> Eigenvalue<f64> {
        Eigenvalue { lambda: Complex::new(re, im), multiplicity: 1, ..Eigenvalue::default() }
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
        for still in [overdamped, rest] {
            assert_eq!((still.hertz(), still.rpm(), still.period()), (0.0, 0.0, f64::INFINITY));
        }
        assert_eq!(eigenvalue(-0.1, -2.0).period(), eigenvalue(-0.1, 2.0).period());
    }
}
