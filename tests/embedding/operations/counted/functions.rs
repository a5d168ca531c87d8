//! The counting scalar as a scalar of the library.

use super::Counted;
use super::tape::{self, Operation, Origin};
use mstmm::Complex;
use mstmm::number::{EvenWaves, Parameter, Real, Scalar, WaveFunctions};

impl Counted {
    /// A function of one number.
    pub(super) fn unary(self, operation: Operation, value: f64) -> Self {
        self.binary(operation, self, value)
    }

    /// A function of two.
    pub(super) fn binary(self, operation: Operation, other: Self, value: f64) -> Self {
        Counted { value, origin: tape::result(operation, [self.origin, other.origin], value) }
    }
}

impl Scalar for Counted {
    type Truth = bool;
    type Size = f64;
    const EPSILON: f64 = <f64 as Scalar>::EPSILON;
    const WAVE_LIMIT: f64 = f64::WAVE_LIMIT;
    const SERIES_TERMS: usize = f64::SERIES_TERMS;

    fn from_f64(value: f64) -> Self {
        Counted::from(value)
    }

    fn reciprocal_factorial(n: usize) -> Self {
        let value = f64::reciprocal_factorial(n);
        Counted { value, origin: Origin::Constant(value) }
    }

    fn sqrt(self) -> Self {
        self.unary(Operation::SquareRoot, self.value.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        // one needs the other: which of the two polynomials is the sine depends on the quadrant
        let circle = self.unary(Operation::Circle, sin);
        (circle.unary(Operation::Free, sin), circle.unary(Operation::Free, cos))
    }

    fn sinh_cosh(self) -> (Self, Self) {
        let exponential = Real::exp(self);
        let (sinh, cosh) = (self.value.sinh(), self.value.cosh());
        (exponential.unary(Operation::Free, sinh), exponential.unary(Operation::Free, cosh))
    }

    fn wave_functions(self) -> WaveFunctions<Self> {
        WaveFunctions::of_real(self)
    }

    fn even_waves(self) -> EvenWaves<Self> {
        EvenWaves::of_real(self)
    }

    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }

    fn vanishes(self) -> bool {
        self.value == 0.0
    }

    fn is_negative(self) -> bool {
        tape::look_at(self.origin);
        self.value < 0.0
    }

    fn size(self) -> f64 {
        tape::look_at(self.origin);
        self.value.abs()
    }

    fn times_power_of_two(self, exponent: i32) -> Self {
        self.unary(Operation::Free, self.value.times_power_of_two(exponent))
    }

    fn scaled(self, power: f64) -> Self {
        self.unary(Operation::Free, self.value.scaled(power))
    }
}

impl Parameter for Counted {
    fn abs(self) -> Self {
        self.unary(Operation::Free, self.value.abs())
    }

    fn to_f64(self) -> f64 {
        tape::look_at(self.origin);
        self.value
    }
}

impl Real for Counted {
    type Extended = Self;
    type ExtendedComplex = Complex<Self>;

    fn exp(self) -> Self {
        self.unary(Operation::Exponential, self.value.exp())
    }
}
