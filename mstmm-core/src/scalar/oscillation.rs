//! Frequencies at which motions are computed: plain numbers, not those that carry derivatives.

use super::{Frequency, Real, Scalar, WaveFunctions};
use num_complex::Complex;

/// A frequency at which motions are computed.
pub trait Oscillation<T: Real>: Frequency<T> {
    /// Sine, cosine and their hyperbolic kin, free of overflow.
    fn wave_functions(self) -> WaveFunctions<Self>;

    /// The number as a complex one.
    fn to_complex(self) -> Complex<T>;

    /// Back from a complex number, which is real where this one is.
    fn from_complex(value: Complex<T>) -> Self;

    /// The complex conjugate; of a real frequency itself.
    fn conjugate(self) -> Self;

    /// The frequency of a steady vibration at ω [rad/s]: ω itself or iω.
    fn of_omega(omega: T) -> Self;

    /// Derivative of λ² with respect to the frequency: `-2ω` or `2λ`.
    fn slope_of_lambda_squared(self) -> Self;

    /// λ, which a damping form multiplies; a real frequency has none.
    fn lambda(self) -> Self;

    /// Points about a frequency at a distance, each with the weight of `(x - x0) f(x)` in the residue of f at its simple pole
    /// x0: the rest of f enters with the fourth power of the distance.
    fn around(self, distance: T) -> [(Self, Self); 4];
}

impl<T: Real> Oscillation<T> for T {
    fn wave_functions(self) -> WaveFunctions<T> {
        WaveFunctions::of_real(self)
    }

    fn to_complex(self) -> Complex<T> {
        Complex::new(self, T::zero())
    }

    fn from_complex(value: Complex<T>) -> T {
        value.re
    }

    fn conjugate(self) -> T {
        self
    }

    fn of_omega(omega: T) -> T {
        omega
    }

    fn slope_of_lambda_squared(self) -> T {
        -(self + self)
    }

    fn lambda(self) -> T {
        T::zero()
    }

    fn around(self, distance: T) -> [(T, T); 4] {
        let (near, far) = (T::from_f64(2.0) / T::from_f64(3.0), -T::one() / T::from_f64(6.0));
        let twice = distance + distance;
        [(self + distance, near), (self - distance, near), (self + twice, far), (self - twice, far)]
    }
}

impl<T: Real> Oscillation<T> for Complex<T> {
    fn wave_functions(self) -> WaveFunctions<Complex<T>> {
        WaveFunctions::of_complex(self)
    }

    fn to_complex(self) -> Complex<T> {
        self
    }

    fn from_complex(value: Complex<T>) -> Complex<T> {
        value
    }

    fn conjugate(self) -> Complex<T> {
        self.conj()
    }

    fn of_omega(omega: T) -> Complex<T> {
        Complex::new(T::zero(), omega)
    }

    fn slope_of_lambda_squared(self) -> Complex<T> {
        self + self
    }

    fn lambda(self) -> Complex<T> {
        self
    }

    fn around(self, distance: T) -> [(Complex<T>, Complex<T>); 4] {
        let (zero, quarter) = (T::zero(), Complex::from_f64(0.25));
        let points = [(distance, zero), (zero, distance), (-distance, zero), (zero, -distance)];
        points.map(|(re, im)| (self + Complex::new(re, im), quarter))
    }
}
