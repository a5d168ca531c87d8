//! The frequencies at which plane structures move.

use crate::number::{Dual, ExtendedOf, Frequency, FrequencyPowers, Oscillation, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::placed::{PlacedCharts, PlacedMotions};
use crate::structure::StructureScalar;
use num_complex::Complex;

/// A frequency at which motions of plane structures are computed: a real ω, or a complex λ.
pub trait PlaneFrequency<T: Real>: Oscillation<T, Extended: StructureScalar> + StructureScalar {
    /// The frequency of a steady vibration at `2^exponent` rad/s in extended precision.
    fn steady(exponent: i32) -> Self::Extended {
        Self::of_omega(T::from_f64(1.0)).to_extended().times_power_of_two(exponent)
    }

    /// The frequency with its slope.
    type WithSlope: Frequency<T>;

    /// A number as one with a slope of zero.
    fn constant(self) -> Self::WithSlope;

    /// The slope of a number.
    fn slope(number: Self::WithSlope) -> Self;

    /// The powers of the frequency with slopes in λ².
    fn powers_in_square(self) -> FrequencyPowers<Self::WithSlope>;
}

/// The powers of a frequency with slopes in λ².
fn powers<T: Real, S: Oscillation<T>>(x: S) -> FrequencyPowers<Dual<S>>
where
    Dual<S>: Frequency<T>,
{
    let derivative = if x.is_zero() { S::zero() } else { S::one() / x.slope_of_lambda_squared() };
    let powers = FrequencyPowers::new(Dual { value: x, derivative }, true);
    // at rest x has no slope in λ², and waves are short: nothing but λ² counts
    FrequencyPowers { lambda_squared: Dual { derivative: S::one(), ..powers.lambda_squared }, ..powers }
}

impl<T: Real<Extended: StructureScalar> + StructureScalar> PlaneFrequency<T> for T {
    type WithSlope = Dual<T>;

    fn constant(self) -> Dual<T> {
        Dual::constant(self)
    }

    fn slope(number: Dual<T>) -> T {
        number.derivative
    }

    fn powers_in_square(self) -> FrequencyPowers<Dual<T>> {
        powers::<T, T>(self)
    }
}

impl<T: Real<ExtendedComplex: StructureScalar>> PlaneFrequency<T> for Complex<T>
where
    Complex<T>: StructureScalar<Size = f64, Truth = bool>,
{
    type WithSlope = Dual<Complex<T>>;

    fn constant(self) -> Dual<Complex<T>> {
        Dual::constant(self)
    }

    fn slope(number: Dual<Complex<T>>) -> Complex<T> {
        number.derivative
    }

    fn powers_in_square(self) -> FrequencyPowers<Dual<Complex<T>>> {
        powers::<T, Complex<T>>(self)
    }
}

/// The frequency of a plane structure `Y` with its slope.
type WithSlope<Y, S> = <S as PlaneFrequency<<Y as System>::Parameter>>::WithSlope;

/// A plane structure whose motions are known at a frequency, and in its extended precision.
#[diagnostic::on_unimplemented(
    message = "the motions of `{Self}` are not known at a frequency of type `{S}`",
    note = "a system with a damper moves at a complex λ only: pass `Complex::new(re, im)` for λ [1/s], and search its `eigenvalues` \
            instead of `natural_frequencies`; an element of your own implements `mstmm::element::MemberMotion<S>`"
)]
pub trait MovingNetwork<S>:
    PlacedCharts<S>
    + PlacedCharts<WithSlope<Self, S>>
    + PlacedCharts<ExtendedOf<S, <Self as System>::Parameter>>
    + PlacedMotions<S>
where
    S: PlaneFrequency<<Self as System>::Parameter>,
{
}

#[diagnostic::do_not_recommend]
impl<Y, S> MovingNetwork<S> for Y
where
    S: PlaneFrequency<<Y as System>::Parameter>,
    Y: PlacedCharts<S>
        + PlacedCharts<WithSlope<Y, S>>
        + PlacedCharts<ExtendedOf<S, <Y as System>::Parameter>>
        + PlacedMotions<S>,
{
}
