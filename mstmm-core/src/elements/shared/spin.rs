//! What spins about the axis of a line: its gyroscopic moments.

use crate::element::SpinNumbers;
use crate::elements::shared::line_forms::half;
use crate::model::{FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, Oscillation, Parameter, Real, Truth};

/// A polar inertia that spins with a speed Ω, seen from a whirl: the angular momentum `H = ±I_p Ω` adds `H ω` to the dynamic stiffness of its
/// rotation.
///
/// With `u = v + iw` and `θ = θ_z - iθ_y` both bending planes of a shaft on isotropic bearings are one, and the moment of a rotation that turns with
/// `e^{iωt}` is real. Backward whirl is forward whirl with the other sign of all speeds.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    not(feature = "std"),
    expect(unreachable_pub, reason = "frames alone have gyroscopes, which are built as it")
)]
pub struct Spin<T> {
    /// Polar moment of inertia I_p, or that per length.
    pub(crate) polar_inertia: T,
    /// Speed Ω.
    pub(crate) speed: T,
    /// 1 for forward whirl, -1 for backward whirl.
    sense: T,
}

impl<T: Parameter> Spin<T> {
    /// What spins, seen from forward whirl.
    pub(crate) fn new(polar_inertia: T, speed: T) -> Self {
        Spin { polar_inertia, speed, sense: T::one() }
    }

    /// Checks both parameters, given the name of the polar inertia.
    pub(crate) fn check(&self, polar_inertia: &'static str) -> Result<(), InvalidParameter> {
        Requirement::NonNegative.check(polar_inertia, self.polar_inertia)?;
        Requirement::Finite.check("speed", self.speed)
    }

    /// Adds what spins to the estimates of searches, given its length or 1. Beside an inertia and a stiffness an angular momentum is as a damping: nutation is
    /// at H over the inertia, precession at the stiffness over H.
    pub(crate) fn estimate(&self, estimates: &mut FrequencyEstimates, length: f64) {
        let momentum = self.polar_inertia * self.speed;
        if !momentum.vanishes().all() {
            estimates.whirl();
            estimates.torsional_damping(momentum.to_f64().abs() * length);
        }
    }

    /// The same seen from the other whirl.
    #[must_use]
    pub(crate) fn turned_round(self) -> Self {
        Spin { sense: T::zero() - self.sense, ..self }
    }

    /// 1 for forward whirl, -1 for backward whirl.
    pub(crate) fn sense(&self) -> T {
        self.sense
    }

    /// The speed as this whirl sees it.
    pub(crate) fn signed_speed(&self) -> T {
        self.sense * self.speed
    }

    /// Its numbers.
    pub(crate) fn numbers(&self) -> SpinNumbers {
        SpinNumbers { polar_inertia: self.polar_inertia.words(), speed: self.signed_speed().words() }
    }

    /// The angular momentum `H = ±I_p Ω`. In extended precision it has all digits of the product.
    #[inline]
    pub(crate) fn momentum<S: Frequency<T>>(&self) -> S {
        S::from_parameter(self.signed_speed()) * self.polar_inertia
    }
}

impl<T: Real> Spin<T> {
    /// Whether the second of two motions is one of the other whirl: the conjugate of a motion is.
    pub(crate) fn is_of_other_whirl<S: Oscillation<T>>([first, second]: [S; 2]) -> bool {
        let [first, second] = [first, second].map(|x| x.to_complex().im);
        (first < T::zero()) != (second < T::zero())
    }

    /// The form of first order of two motions, given that of rotations, `Θ₁ Θ₂` or its integral. The work has `H ω` times that of rotations: ω times
    /// `H` at a real frequency, λ times `-iH` at an eigenvalue.
    pub(crate) fn form<S: Oscillation<T>>(&self, rotations: S) -> S {
        self.momentum::<S>() * rotations * S::one().signed_omega()
    }

    /// `∂L/∂I_p` and `∂L/∂Ω` for the form of rotations of a motion at a frequency.
    pub(crate) fn gradient<S: Oscillation<T>>(&self, x: S, rotations: S) -> [S; 2] {
        let work = half(rotations) * x.signed_omega();
        [work * self.signed_speed(), work * (self.sense * self.polar_inertia)]
    }
}
