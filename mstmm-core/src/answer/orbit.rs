//! Responses of rotors: to unbalance, and the orbits of points under forces that do not turn.

use crate::answer::questions::ModalAnalysis;
use crate::model::{Entry, Load, MotionError};
use crate::number::{Oscillation, Real, modulus};
use crate::pass::characteristic::System;
use crate::pass::tree::{ExtendedTree, Planned};
use crate::search::rotor::{Rotor, Spinning, Whirl};
use num_complex::Complex;
use num_traits::Zero;

/// Questions about a whirl of a rotor.
pub trait WhirlAnalysis: Spinning + Planned {
    /// The steady motion of an entry under unbalances at a speed Ω [rad/s], as a complex amplitude of `u = v + iw` in the frame that turns with the rotor:
    /// `Σ U Ω² H(iΩ)`. Ask forward whirl.
    ///
    /// Each unbalance U is a load with a complex size, whose argument is its angle on the rotor: a mass times its eccentricity [kg m] at a force, such a
    /// product per length \[kg\] at a load along a shaft, and for a disc that is skew by a small angle τ the couple `(I_d - I_p) τ` [kg m²] at a torque.
    ///
    /// The speed is that of the model that was built; a negative one turns backward.
    ///
    /// # Errors
    /// As [`FrequencyResponse::at`](crate::FrequencyResponse::at). Beside an undamped critical speed the motion is as large as the distance from it is small.
    fn unbalance<T>(
        &self,
        speed: T,
        unbalances: &[(Load<Self::Model>, Complex<T>)],
        entry: Entry<Self::Model>,
    ) -> Result<Complex<T>, MotionError>
    where
        T: Real,
        Complex<T>: Oscillation<T>,
        Self: System<Parameter = T> + ExtendedTree<Complex<T>> + Sized,
    {
        steady_motion(speed, unbalances, |load, lambda| self.frequency_response(load, entry)?.at(lambda))
    }
}

/// The sum of the responses at `λ = iΩ` to unbalances, each `Ω²` times as large.
pub(crate) fn steady_motion<T, L>(
    speed: T,
    unbalances: &[(L, Complex<T>)],
    response: impl Fn(L, Complex<T>) -> Result<Complex<T>, MotionError>,
) -> Result<Complex<T>, MotionError>
where
    T: Real,
    Complex<T>: Oscillation<T>,
    L: Copy,
{
    let mut sum = Complex::zero();
    if speed.is_zero() {
        return Ok(sum);
    }
    for (load, size) in unbalances {
        sum += response(*load, Complex::<T>::of_omega(speed))? * *size * (speed * speed);
    }
    Ok(sum)
}

impl<Y: Spinning + Planned> WhirlAnalysis for Y {}

/// The path of a point of a rotor in steady motion, `u(t) = v + iw = f e^{iωt} + b e^{-iωt}`: an ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit<T> {
    /// The part f that whirls forward.
    pub forward: Complex<T>,
    /// The part b that whirls backward.
    pub backward: Complex<T>,
}

impl<T: Real> Orbit<T> {
    /// The orbit under a load that does not turn, of which half excites each whirl, given the response of a whirl at λ.
    pub(crate) fn of_whirls(
        omega: T,
        response: impl Fn(Whirl, Complex<T>) -> Result<Complex<T>, MotionError>,
    ) -> Result<Self, MotionError>
    where
        Complex<T>: Oscillation<T>,
    {
        let half = T::from_f64(0.5);
        let of = |whirl| response(whirl, Complex::<T>::of_omega(omega)).map(|value| value * half);
        // backward whirl sees the conjugate motion
        Ok(Orbit { forward: of(Whirl::Forward)?, backward: of(Whirl::Backward)?.conj() })
    }

    /// Half the axes of the ellipse, the longer one first; the second is negative where the point goes round backward.
    pub fn semi_axes(&self) -> [T; 2] {
        let [forward, backward] = [self.forward, self.backward].map(modulus);
        [forward + backward, forward - backward]
    }

    /// The displacements `[v, w]` at an angle `ωt`.
    pub fn at(&self, angle: T) -> [T; 2] {
        let (sin, cos) = angle.sin_cos();
        let turn = Complex::new(cos, sin);
        let u = self.forward * turn + self.backward * turn.conj();
        [u.re, u.im]
    }
}

impl<T, Y> Rotor<Y>
where
    T: Real,
    Complex<T>: Oscillation<T>,
    Y: System<Parameter = T> + ExtendedTree<Complex<T>>,
{
    /// The orbit of an entry under a load of 1 that vibrates at ω [rad/s] in the direction of v and does not turn: half of it excites each whirl.
    ///
    /// # Errors
    /// As [`FrequencyResponse::at`](crate::FrequencyResponse::at), of either whirl.
    pub fn orbit(&self, load: Load<Y::Model>, entry: Entry<Y::Model>, omega: T) -> Result<Orbit<T>, MotionError> {
        Orbit::of_whirls(omega, |whirl, lambda| self.whirl(whirl).frequency_response(load, entry)?.at(lambda))
    }
}
