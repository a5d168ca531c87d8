//! Complex scalars over any real one.

use crate::number::columns::InColumns;
use crate::number::exponent::binary_exponent;
use crate::number::frequency::{ComplexEigenvalue, Frequency, Real};
use crate::number::scalar::Scalar;
use crate::number::wave_functions::WaveFunctions;
use num_complex::Complex;
use num_traits::Zero;

impl<T: Real> Scalar for Complex<T> {
    type Plain = Self;
    const EPSILON: f64 = T::EPSILON;
    const WAVE_LIMIT: f64 = T::WAVE_LIMIT;
    const SERIES_TERMS: usize = T::SERIES_TERMS;
    const LONGEST_IN_LINE: usize = T::LONGEST_IN_LINE;

    #[inline]
    fn from_f64(value: f64) -> Self {
        Complex::new(T::from_f64(value), T::zero())
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        Complex::new(T::reciprocal_factorial(n), T::zero())
    }

    #[inline]
    fn sqrt(self) -> Self {
        if self.is_zero() {
            return self;
        }
        // the modulus squares the parts, which overflows or vanishes at half the range: the root is taken near 1
        let half_exponent = binary_exponent(self.size()) / 2;
        self.times_power_of_two(-2 * half_exponent).moderate_sqrt().times_power_of_two(half_exponent)
    }

    #[inline(always)]
    fn is_plain(self) -> bool {
        let limit = if T::EPSILON > 1e-10 { 1e15 } else { 1e100 };
        let is_fine = |part: f64| (part == 0.0) | (part > 1.0 / limit);
        let (re, im) = (self.re.size(), self.im.size());
        is_fine(re) & is_fine(im) & (re + im > 0.0) & (re + im < limit)
    }

    #[inline(always)]
    fn moderate_sqrt(self) -> Self {
        let half = T::from_f64(0.5);
        let modulus = (self.re * self.re + self.im * self.im).sqrt();
        let larger = ((self.re.abs() + modulus) * half).sqrt();
        let smaller = self.im.abs() * half / larger;
        let (re, im) = if self.re < T::zero() { (smaller, larger) } else { (larger, smaller) };
        Complex::new(re, if self.im < T::zero() { -im } else { im })
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.re.sin_cos();
        let (sh, ch) = self.im.sinh_cosh();
        (Complex::new(s * ch, c * sh), Complex::new(c * ch, -(s * sh)))
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        let (sh, ch) = self.re.sinh_cosh();
        let (s, c) = self.im.sin_cos();
        (Complex::new(sh * c, ch * s), Complex::new(ch * c, sh * s))
    }

    #[inline]
    fn wave_functions(self) -> WaveFunctions<Self> {
        WaveFunctions::of_parts(&WaveFunctions::of_real(self.re), &WaveFunctions::of_real(self.im))
    }

    #[inline(always)]
    fn moderate_wave_functions(self) -> WaveFunctions<Self> {
        WaveFunctions::of_parts(&WaveFunctions::of_moderate(self.re), &WaveFunctions::of_moderate(self.im))
    }

    #[inline(always)]
    fn functions<const N: usize, R>(
        self,
        values: impl FnOnce(Self) -> ([Self; N], R),
        _slopes: impl FnOnce([Self; N]) -> [Self; N],
    ) -> ([Self; N], R) {
        values(self)
    }

    #[inline(always)]
    fn constant(value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        false
    }

    #[inline]
    fn size(self) -> f64 {
        let (re, im) = (self.re.size(), self.im.size());
        // `>` is false for a NaN on either side, and a NaN must come through
        if re.is_nan() || re > im { re } else { im }
    }

    #[inline(always)]
    fn or_nan(self, condition: bool) -> Self {
        Complex::new(self.re.or_nan(condition), self.im.or_nan(condition))
    }

    #[inline]
    fn times_power_of_two(self, exponent: i32) -> Self {
        Complex::new(self.re.times_power_of_two(exponent), self.im.times_power_of_two(exponent))
    }

    #[inline]
    fn times_normal_power_of_two(self, exponent: i32) -> Self {
        Complex::new(self.re.times_normal_power_of_two(exponent), self.im.times_normal_power_of_two(exponent))
    }
}

impl<S: Real + InColumns> InColumns for Complex<S> {
    type Columns<const N: usize> = [S::Columns<N>; 2];

    #[inline]
    fn columns<const N: usize>(self) -> [S::Columns<N>; 2] {
        [self.re.columns(), self.im.columns()]
    }

    #[inline(always)]
    fn get<const N: usize>([re, im]: &[S::Columns<N>; 2], place: usize) -> Self {
        Complex { re: S::get(re, place), im: S::get(im, place) }
    }

    #[inline(always)]
    fn put<const N: usize>(self, [re, im]: &mut [S::Columns<N>; 2], place: usize) {
        self.re.put(re, place);
        self.im.put(im, place);
    }
}

impl<T: Real> Frequency<T> for Complex<T> {
    type Meaning = ComplexEigenvalue;

    #[inline]
    fn lambda_squared(self) -> Self {
        self * self
    }

    #[inline]
    fn omega(self) -> Self {
        Complex::new(self.im, -self.re)
    }

    #[inline]
    fn from_parameter(parameter: T) -> Self {
        Complex::new(parameter, T::zero())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::tolerance::assert_close;
    use num_traits::One;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn square_root_squares_back_and_is_principal(re in -1e3..1e3f64, im in -1e3..1e3f64) {
            let z = Complex::new(re, im);
            let root = Scalar::sqrt(z);
            assert!(root.re >= 0.0);
            assert_close((root * root - z).size(), 0.0, z.size(), 8.0);
        }

        #[test]
        fn circular_and_hyperbolic_functions_obey_pythagoras_and_rotate_into_each_other(re in -3.0..3.0f64, im in -3.0..3.0f64) {
            let z = Complex::new(re, im);
            let (s, c) = Scalar::sin_cos(z);
            let (sh, ch) = Scalar::sinh_cosh(z);
            let scale = (s * s).size() + (sh * sh).size() + 1.0;
            assert_close((s * s + c * c - Complex::one()).size(), 0.0, scale, 16.0);
            assert_close((ch * ch - sh * sh - Complex::one()).size(), 0.0, scale, 16.0);
            let (rotated, _) = Scalar::sin_cos(Complex::<f64>::i() * z);
            assert_close((rotated - Complex::<f64>::i() * sh).size(), 0.0, scale, 16.0);
        }
    }

    /// Closed form: `((1 + i) a)² = 2i a²`, and `a² < 0` on the other side of the cut.
    #[test]
    fn the_square_root_has_the_full_range() {
        for a in [1e-150, 1e-100, 1.0, 1e100, 1e150] {
            let root = Scalar::sqrt(Complex::new(0.0, 2.0 * a * a));
            assert_close((root - Complex::new(a, a)).size(), 0.0, a, 8.0);
            let root = Scalar::sqrt(Complex::new(-a * a, 0.0));
            assert_close((root - Complex::new(0.0, a)).size(), 0.0, a, 8.0);
        }
        for size in [5e-324, 1e-200, 1e200, f64::MAX] {
            let root: Complex<f64> = Scalar::sqrt(Complex::new(size, size));
            let expected = Complex::new(1.0, 1.0).sqrt() * size.sqrt();
            assert_close((root - expected).size(), 0.0, expected.size(), 8.0);
        }
    }

    #[test]
    fn size_shows_a_nan_in_either_part() {
        assert!(Complex::new(f64::NAN, 1.0).size().is_nan());
        assert!(Complex::new(1.0, f64::NAN).size().is_nan());
        assert_eq!(Complex::new(-3.0, 2.0).size(), 3.0);
    }
}
