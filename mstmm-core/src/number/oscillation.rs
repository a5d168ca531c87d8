//! Plain real and complex numbers as frequencies at which motions are computed.

use crate::number::frequency::{Frequency, Oscillation, Parameter, Real};
use crate::number::scalar::Scalar;
use num_complex::Complex;

impl<T: Real> Oscillation<T> for T {
    type Extended = T::Extended;
    const HAS_EXTENDED: bool = T::HAS_EXTENDED;

    fn to_extended(self) -> T::Extended {
        <T::Extended as Frequency<T>>::from_parameter(self)
    }

    fn from_extended(value: T::Extended) -> T {
        T::from_f64(value.to_f64())
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

    /// Interpolation by the polynomial of degree 7 through `±1, ±2, ±3, ±4` distances.
    fn around(self, distance: T) -> [(T, T); 8] {
        let weights = [28.0, -14.0, 4.0, -0.5].map(|weight| T::from_f64(weight) / T::from_f64(35.0));
        core::array::from_fn(|k| {
            let away = distance * T::from_f64((k / 2 + 1) as f64);
            (if k % 2 == 0 { self + away } else { self - away }, weights[k / 2])
        })
    }
}

impl<T: Real> Oscillation<T> for Complex<T> {
    type Extended = T::ExtendedComplex;
    const HAS_EXTENDED: bool = T::HAS_EXTENDED;

    fn to_extended(self) -> T::ExtendedComplex {
        Complex::new(self.re.to_extended(), self.im.to_extended()).into()
    }

    fn from_extended(value: T::ExtendedComplex) -> Self {
        let Complex { re, im }: Complex<T::Extended> = value.into();
        Complex::new(T::from_extended(re), T::from_extended(im))
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

    /// The mean over a circle.
    fn around(self, distance: T) -> [(Complex<T>, Complex<T>); 8] {
        let (zero, eighth) = (T::zero(), Complex::from_f64(0.125));
        let diagonal = distance * T::from_f64(core::f64::consts::FRAC_1_SQRT_2);
        let points = [
            (distance, zero),
            (diagonal, diagonal),
            (zero, distance),
            (-diagonal, diagonal),
            (-distance, zero),
            (-diagonal, -diagonal),
            (zero, -distance),
            (diagonal, -diagonal),
        ];
        points.map(|(re, im)| (self + Complex::new(re, im), eighth))
    }
}
