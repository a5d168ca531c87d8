//! Double-double numbers as frequencies of systems with `f64` parameters: their extended precision.

use crate::number::double_double::DoubleDouble;
use crate::number::frequency::Oscillation;
use crate::number::frequency::Parameter;
use crate::number::scalar::Scalar;
use crate::number::value::Value;
use num_complex::Complex;

/// What a number has that is extended precision itself.
macro_rules! is_extended {
    () => {
        type Extended = Self;
        const HAS_EXTENDED: bool = false;

        fn to_extended(self) -> Self {
            self
        }

        fn from_extended(value: Self) -> Self {
            value
        }
    };
}

impl Oscillation<f64> for DoubleDouble {
    is_extended!();

    /// The number rounded to `f64`: the interior of a beam is not computed in extended precision.
    fn to_complex(self) -> Complex<f64> {
        Complex::new(self.to_f64(), 0.0)
    }

    fn from_complex(value: Complex<f64>) -> Self {
        DoubleDouble::from_f64(value.re)
    }

    fn conjugate(self) -> Self {
        self
    }

    fn of_omega(omega: f64) -> Self {
        DoubleDouble::from_f64(omega)
    }

    fn slope_of_lambda_squared(self) -> Self {
        Oscillation::<DoubleDouble>::slope_of_lambda_squared(self)
    }

    fn lambda(self) -> Self {
        Oscillation::<DoubleDouble>::lambda(self)
    }

    fn around(self, distance: f64) -> [(Self, Self); 8] {
        Oscillation::<DoubleDouble>::around(self, DoubleDouble::from_f64(distance))
    }
}

/// A complex frequency with the digits of double-double numbers.
type Precise = Complex<DoubleDouble>;

impl Oscillation<f64> for Value<Precise> {
    is_extended!();

    /// The number rounded to `f64`, as that of a real one.
    fn to_complex(self) -> Complex<f64> {
        Complex::new(self.0.re.to_f64(), self.0.im.to_f64())
    }

    fn from_complex(value: Complex<f64>) -> Self {
        Value(Complex::new(DoubleDouble::from_f64(value.re), DoubleDouble::from_f64(value.im)))
    }

    fn conjugate(self) -> Self {
        Value(self.0.conj())
    }

    fn of_omega(omega: f64) -> Self {
        Value(Precise::of_omega(DoubleDouble::from_f64(omega)))
    }

    fn slope_of_lambda_squared(self) -> Self {
        self + self
    }

    fn lambda(self) -> Self {
        self
    }

    fn around(self, distance: f64) -> [(Self, Self); 8] {
        let all = Oscillation::<DoubleDouble>::around(self.0, DoubleDouble::from_f64(distance));
        all.map(|(point, weight)| (Value(point), Value(weight)))
    }
}
