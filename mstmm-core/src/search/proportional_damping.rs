//! Damping in proportion to all inertias and all stiffnesses: eigenvalues from natural frequencies.

use crate::model::{InvalidParameter, Requirement};
use crate::number::{Real, Scalar, modulus};
use crate::search::damped::found::Eigenvalue;
use crate::search::undamped::found::NaturalFrequency;
use num_complex::Complex;
use num_traits::Zero;

/// Damping in proportion to all inertias and all stiffnesses of a system: `C = α M + β K` and `K (1 + iη)`.
///
/// The shapes stay those of the system without damping, and each natural frequency gives its eigenvalues in closed form, so that no complex
/// search is needed: `λ² + α λ + (1 + β λ)(1 + iη) ω² = 0`. An axial force is a stiffness without damping: in a system with one, mass alone
/// damps in proportion.
///
/// ```
/// use mstmm_core::search::{NaturalFrequency, ProportionalDamping};
///
/// // a share of 2 % at 50 rad/s by the masses, and as much at 200 rad/s by the stiffnesses
/// let damping = ProportionalDamping::new(2.0_f64, 2e-4, 0.0)?;
/// let root = NaturalFrequency { omega: 50.0, lower: 50.0, upper: 50.0, multiplicity: 1, ..NaturalFrequency::default() };
/// let [first, second] = damping.eigenvalues(&root);
/// let share = (2.0 / 50.0 + 2e-4 * 50.0) / 2.0;
/// assert!((first.unwrap().damping_ratio() - share).abs() < 1e-15);
/// assert_eq!(second.unwrap().lambda, first.unwrap().lambda.conj());
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
///
/// # Source
/// Rayleigh's damping; structural damping by a loss factor, for motions `e^{iωt}` with ω > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProportionalDamping<T = f64> {
    mass: T,
    stiffness: T,
    loss_factor: T,
}

impl<T: Real> ProportionalDamping<T> {
    /// Damping by α [1/s] of the inertias, β \[s\] of the stiffnesses and a loss factor η of the stiffnesses.
    ///
    /// # Errors
    /// [`InvalidParameter`] names the first of `alpha`, `beta` and `loss_factor` that is not zero or positive.
    pub fn new(alpha: T, beta: T, loss_factor: T) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("alpha", alpha)?;
        Requirement::NonNegative.check("beta", beta)?;
        Requirement::NonNegative.check("loss_factor", loss_factor)?;
        Ok(ProportionalDamping { mass: alpha, stiffness: beta, loss_factor })
    }

    /// The eigenvalues of a natural frequency: a conjugate pair, two that are real, or one where there is a loss factor, since that
    /// describes motions with `Im λ > 0` alone. Their errors follow from the certified interval of the frequency.
    ///
    /// A frequency of zero, that of a rigid body, has 0 and -α.
    pub fn eigenvalues(&self, root: &NaturalFrequency<T>) -> [Option<Eigenvalue<T>>; 2] {
        let ends = [root.lower, root.upper].map(|omega| self.eigenvalues_at(omega));
        let at = self.eigenvalues_at(root.omega);
        let eigenvalue = |k: usize| {
            let lambda = at[k];
            let away = |end: &[Complex<T>; 2]| modulus(end[k] - lambda);
            let [below, above] = [away(&ends[0]), away(&ends[1])];
            let rounding = modulus(lambda) * T::from_f64(8.0 * T::EPSILON);
            let error = if below > above { below } else { above } + rounding;
            Eigenvalue { lambda, error, multiplicity: root.multiplicity, is_proven: false }
        };
        let second = self.loss_factor.is_zero().then(|| eigenvalue(1));
        [Some(eigenvalue(0)), second]
    }

    /// α of the inertias [1/s].
    pub(crate) fn of_inertias(&self) -> T {
        self.mass
    }

    /// β of the stiffnesses \[s\].
    pub(crate) fn of_stiffnesses(&self) -> T {
        self.stiffness
    }

    /// The loss factor η of the stiffnesses.
    pub(crate) fn loss_factor(&self) -> T {
        self.loss_factor
    }

    /// The roots at a frequency, first that with the larger imaginary part, or of two real ones that which decays faster.
    pub(crate) fn eigenvalues_at(&self, omega: T) -> [Complex<T>; 2] {
        let square = omega * omega;
        let stiffness = Complex::new(square, self.loss_factor * square);
        let half = T::from_f64(0.5);
        let damping = (Complex::from(self.mass) + stiffness * self.stiffness) * half;
        let root = Scalar::sqrt(damping * damping - stiffness);
        // the larger root has no cancellation, and the other one is the product over it
        let [sum, difference] = [damping + root, damping - root];
        let larger = if modulus(sum) < modulus(difference) { -difference } else { -sum };
        if larger.is_zero() {
            return [larger; 2];
        }
        let other = stiffness / larger;
        if larger.im >= other.im { [larger, other] } else { [other, larger] }
    }
}
