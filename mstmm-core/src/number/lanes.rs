//! Numbers in lanes as scalars: the frequencies of several evaluations at once.
//!
//! Each lane has the bits of a number alone, or is NaN where that would need a branch: where waves have to be scaled, entries
//! shifted into the range, or sums cancel. Such a frequency is evaluated alone.

use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{Frequency, Parameter, RealFrequency};
use crate::number::kernel::{self, Rounding};
use crate::number::scalar::{Scalar, short_wave_products};
use crate::number::truth::{Size, Truth};
use crate::number::wave_functions::WaveFunctions;
use mstmm_lanes::{Eight, Four, Lanes, Part, Plain, Truths, Vector};
use num_traits::One;

impl<V: Vector> Truth for Truths<V> {
    #[inline(always)]
    fn of(truth: bool) -> Self {
        Truths::splat(truth)
    }
    #[inline(always)]
    fn all(self) -> bool {
        self.all()
    }
    #[inline(always)]
    fn any(self) -> bool {
        self.any()
    }
}

impl<V: Vector> Size for Lanes<V> {
    type Truth = Truths<V>;

    #[inline(always)]
    fn of(number: f64) -> Self {
        Lanes::splat(number)
    }
    #[inline(always)]
    fn first(self) -> f64 {
        self.to_array()[0]
    }
    #[inline(always)]
    fn is_below(self, limit: Self) -> Truths<V> {
        self.is_less(limit)
    }
    #[inline(always)]
    fn choose(truth: Truths<V>, first: Self, second: Self) -> Self {
        Lanes::select(truth, first, second)
    }
    #[inline(always)]
    fn whole(self) -> (Self, Truths<V>) {
        let whole = Lanes(self.0.floor());
        // the last bit of a whole number below 2^51 is the last one of this sum
        (whole, Truths((whole + Lanes::splat(kernel::ROUNDER)).0.last_bit()))
    }
    #[inline(always)]
    fn excess(self) -> (i32, Truths<V>) {
        (0, self.is_moderate())
    }
    #[inline(always)]
    fn exponent(self) -> Option<i32> {
        Some(0)
    }
}

impl<V: Vector> Rounding for Lanes<V> {
    #[inline(always)]
    fn of(number: f64) -> Self {
        Lanes::splat(number)
    }

    #[inline(always)]
    fn turned(bits: Self, sin: Self, cos: Self) -> [Self; 2] {
        let is_odd = Truths(bits.0.last_bit());
        let (sin, cos) = (Lanes::select(is_odd, cos, sin), Lanes::select(is_odd, sin, cos));
        [Lanes(sin.0.signed_by(bits.0, 0)), Lanes(cos.0.signed_by(bits.0, 1))]
    }

    #[inline(always)]
    fn halves_of_powers(bits: Self) -> [Self; 2] {
        let [up, down] = bits.0.powers();
        [Lanes(up), Lanes(down)]
    }
}

/// A vector with the functions of waves, compiled once with this crate, since each beam of each model would repeat them.
pub trait Waving: Vector {
    /// Sine, cosine, hyperbolic sine and cosine.
    fn waves(x: &Lanes<Self>, values: &mut [Lanes<Self>; 4]);

    /// See [`Scalar::even_waves`].
    fn even_waves(square: &Lanes<Self>, values: &mut [Lanes<Self>; 2]);

    /// See [`Scalar::short_wave_products`].
    fn short_wave_products(x: &Lanes<Self>, products: &mut [Lanes<Self>; 5]);
}

/// The functions of long waves.
struct Waves<'a, V>(&'a Lanes<V>, &'a mut [Lanes<V>; 4]);

impl<V: Vector> Part for Waves<'_, V> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        *self.1 = kernel::circular_and_hyperbolic(*self.0);
    }
}

/// The functions of waves of a square.
struct SquareWaves<'a, V>(&'a Lanes<V>, &'a mut [Lanes<V>; 2]);

impl<V: Waving> Part for SquareWaves<'_, V> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let square = *self.0;
        let EvenWaves { cosh, sinhc, .. } = EvenWaves::of_short(square);
        let root = square.size().sqrt();
        let is_travelling = square.is_negative();
        let [angles, waves] = [kernel::LARGEST_ANGLE, <f64 as Scalar>::WAVE_LIMIT].map(Lanes::splat);
        let limit = Lanes::select(is_travelling, angles, waves);
        let [sin, cos, sh, ch] = kernel::circular_and_hyperbolic(root.valid_if(root.is_less(limit)));
        let [odd, even] = [Lanes::select(is_travelling, sin, sh), Lanes::select(is_travelling, cos, ch)];
        let is_long = Lanes::splat(1.0).is_less(square.size());
        *self.1 = [Lanes::select(is_long, even, cosh), Lanes::select(is_long, odd / root, sinhc)];
    }
}

/// The products of short waves.
struct ShortWaves<'a, V>(&'a Lanes<V>, &'a mut [Lanes<V>; 5]);

impl<V: Waving> Part for ShortWaves<'_, V> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        *self.1 = short_wave_products(*self.0);
    }
}

macro_rules! waving {
    ($($vector:ty),*) => {$(
        impl Waving for $vector {
            #[inline(never)]
            fn waves(x: &Lanes<Self>, values: &mut [Lanes<Self>; 4]) {
                Self::call(Waves(x, values));
            }

            #[inline(never)]
            fn even_waves(square: &Lanes<Self>, values: &mut [Lanes<Self>; 2]) {
                Self::call(SquareWaves(square, values));
            }

            #[inline(never)]
            fn short_wave_products(x: &Lanes<Self>, products: &mut [Lanes<Self>; 5]) {
                Self::call(ShortWaves(x, products));
            }
        }
    )*};
}
waving!(Eight, Four, Plain);

impl<V: Waving> Scalar for Lanes<V> {
    type Truth = Truths<V>;
    type Size = Self;
    const IN_LANES: bool = true;
    const EPSILON: f64 = <f64 as Scalar>::EPSILON;
    const WAVE_LIMIT: f64 = <f64 as Scalar>::WAVE_LIMIT;
    const SERIES_TERMS: usize = <f64 as Scalar>::SERIES_TERMS;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Lanes::splat(value)
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        Lanes::splat(<f64 as Scalar>::reciprocal_factorial(n))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Lanes(self.0.root())
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let moderate = self.valid_if(self.size().is_less(Lanes::splat(kernel::LARGEST_ANGLE)));
        let [sin, cos] = kernel::circular(moderate);
        (sin, cos)
    }

    #[inline(always)]
    fn sinh_cosh(self) -> (Self, Self) {
        let waves = self.wave_functions();
        (waves.sh, waves.ch)
    }

    #[inline(always)]
    fn wave_functions(self) -> WaveFunctions<Self> {
        let mut waves = [self; 4];
        V::waves(&self.valid_if(is_short_of_limit(self)), &mut waves);
        let [sin, cos, sh, ch] = waves;
        WaveFunctions { sin, cos, sh, ch, one: Lanes::one(), exponents: [0; 2] }
    }

    #[inline(always)]
    fn even_waves(self) -> EvenWaves<Self> {
        let mut values = [self; 2];
        V::even_waves(&self, &mut values);
        let [cosh, sinhc] = values;
        EvenWaves::unscaled(cosh, sinhc)
    }

    #[inline(always)]
    fn short_wave_products(self) -> [Self; 5] {
        let mut products = [self; 5];
        V::short_wave_products(&self, &mut products);
        products
    }

    #[inline(always)]
    fn select(truth: Truths<V>, first: Self, second: Self) -> Self {
        Lanes::select(truth, first, second)
    }

    #[inline(always)]
    fn is_negative(self) -> Truths<V> {
        Truths(self.0.has_minus())
    }

    #[inline(always)]
    fn vanishes(self) -> Truths<V> {
        Truths(self.0.is_nought())
    }

    #[inline(always)]
    fn size(self) -> Self {
        Lanes(self.0.magnitude())
    }

    #[inline(always)]
    fn times_power_of_two(self, exponent: i32) -> Self {
        self * Lanes::splat(1.0.times_power_of_two(exponent))
    }

    #[inline(always)]
    fn scaled(self, power: f64) -> Self {
        self * Lanes::splat(power)
    }

    #[inline(always)]
    fn valid_if(self, condition: Truths<V>) -> Self {
        Lanes::select(condition, self, Lanes::splat(f64::NAN))
    }
}

/// Where waves need not be scaled.
#[inline(always)]
fn is_short_of_limit<V: Waving>(number: Lanes<V>) -> Truths<V> {
    number.size().is_less(Lanes::splat(<f64 as Scalar>::WAVE_LIMIT))
}

/// Frequencies of systems with such parameters, given how these become numbers in lanes.
macro_rules! frequency {
    ($([$($generic:tt)*] $vector:ty, $parameter:ty, $load:expr;)*) => {$(
        impl<$($generic)*> Frequency<$parameter> for Lanes<$vector> {
            type Meaning = RealFrequency;

            #[inline(always)]
            fn lambda_squared(self) -> Self {
                -(self * self)
            }

            #[inline(always)]
            fn omega(self) -> Self {
                Lanes(self.0.magnitude())
            }

            #[inline(always)]
            fn signed_omega(self) -> Self {
                self
            }

            #[inline(always)]
            fn from_parameter(parameter: $parameter) -> Self {
                $load(parameter)
            }
        }
    )*};
}
frequency! {
    // those of one system
    [V: Waving] V, f64, Lanes::splat;
    // those of a system per lane
    [] Eight, Lanes<Plain>, |parameter: Lanes<Plain>| Lanes(Eight::load(parameter.0.numbers()));
}

/// What a function makes of the numbers in each lane.
fn each<const FROM: usize, const TO: usize>(
    numbers: [Lanes<Plain>; FROM],
    of: impl Fn([f64; FROM]) -> [f64; TO],
) -> [Lanes<Plain>; TO] {
    let mut results = [[0.0; Plain::LANES]; TO];
    for lane in 0..Plain::LANES {
        for (result, number) in results.iter_mut().zip(of(numbers.map(|number| number.0.numbers()[lane]))) {
            result[lane] = number;
        }
    }
    results.map(|result| Lanes(Plain::load(&result)))
}

impl Parameter for Lanes<Plain> {
    fn abs(self) -> Self {
        Lanes(self.0.magnitude())
    }

    fn to_f64(self) -> f64 {
        self.0.numbers()[0]
    }

    fn minus_product(self, [a, b, c]: [Self; 3]) -> [Self; 2] {
        each([self, a, b, c], |[number, a, b, c]| number.minus_product([a, b, c]))
    }

    fn difference(self, other: Self) -> [Self; 2] {
        each([self, other], |[number, other]| number.difference(other))
    }
}
