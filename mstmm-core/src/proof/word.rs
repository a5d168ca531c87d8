//! Words: what numbers with bounds are made of, one `f64` or several in lanes.

use crate::number::{Part, Scalar};
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `2^27 + 1`: a product with it separates the upper 26 bits of a factor from the lower ones.
const SPLITTER: f64 = 134_217_729.0;

/// `1.5 · 2^52`: a sum with it has no bits for a fraction.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// A binary floating-point number with rounding to nearest, alone or in lanes.
pub(crate) trait Word:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Number of lanes.
    const LANES: usize;

    /// A truth per lane.
    type Mask: Copy + Debug;

    /// A number in all lanes.
    fn of(number: f64) -> Self;
    /// A number in each lane; the last one fills the lanes beyond.
    fn load(numbers: &[f64]) -> Self;
    /// Writes as many lanes as there is room for.
    fn store(self, numbers: &mut [f64]);
    /// The absolute value.
    fn size(self) -> Self;
    /// The square root.
    fn root(self) -> Self;
    /// `2^k` for a whole number k within ±1000.
    fn power_of_two(self) -> Self;
    /// Whether a number is less than another; false where one is NaN.
    fn is_less(self, other: Self) -> Self::Mask;
    /// Whether it is zero in all lanes.
    fn vanishes(self) -> bool;
    /// The first number where the truth holds, else the second.
    fn select(truth: Self::Mask, first: Self, second: Self) -> Self;
    /// Whether it holds in all lanes.
    fn all(truth: Self::Mask) -> bool;
    /// Both truths.
    fn both(first: Self::Mask, second: Self::Mask) -> Self::Mask;
    /// The opposite truth.
    fn not(truth: Self::Mask) -> Self::Mask;
    /// Does a part in a function of its own, compiled for the instruction set of the lanes.
    fn call<P: Part>(part: P) -> P::Output;

    /// `a b` less its rounded product, exactly, unless parts of it leave the range (Dekker, Veltkamp).
    #[inline(always)]
    fn product_error(self, other: Self, product: Self) -> Self {
        let split = |factor: Self| {
            let shifted = Self::of(SPLITTER) * factor;
            let upper = shifted - (shifted - factor);
            (upper, factor - upper)
        };
        let ((a, a_rest), (b, b_rest)) = (split(self), split(other));
        (((a * b - product) + a * b_rest) + a_rest * b) + a_rest * b_rest
    }

    /// The whole number that is nearest, for sizes below 2^51.
    #[inline(always)]
    fn nearest(self) -> Self {
        (self + Self::of(SHIFT)) - Self::of(SHIFT)
    }

    /// The larger of two numbers; the second where one is NaN.
    #[inline(always)]
    fn or_larger(self, other: Self) -> Self {
        Self::select(other.is_less(self), self, other)
    }

    /// 1 where the number is negative, else 0.
    #[inline(always)]
    fn one_if_negative(self) -> Self {
        Self::select(self.is_less(Self::of(0.0)), Self::of(1.0), Self::of(0.0))
    }

    /// Whether a whole number is odd, for sizes below 2^51.
    #[inline(always)]
    fn is_odd(self) -> Self::Mask {
        let half = self * Self::of(0.5);
        Self::of(0.25).is_less((half - half.nearest()).size())
    }

    /// The number of a lane.
    #[inline(always)]
    fn lane(self, lane: usize) -> f64 {
        let mut numbers = [0.0; MOST_LANES];
        self.store(&mut numbers);
        numbers[lane]
    }

    /// The number of the first lane.
    #[inline(always)]
    fn first(self) -> f64 {
        self.lane(0)
    }
}

/// A number of each lane; the last one fills the lanes beyond.
#[inline(always)]
pub(crate) fn load<W: Word, A>(lanes: &[A], of: &dyn Fn(&A) -> f64) -> W {
    let mut numbers = [0.0; MOST_LANES];
    numbers.iter_mut().zip(lanes).for_each(|(number, lane)| *number = of(lane));
    W::load(&numbers[..lanes.len().min(MOST_LANES)])
}

/// Most lanes of a word.
pub(crate) const MOST_LANES: usize = 8;

impl Word for f64 {
    const LANES: usize = 1;
    type Mask = bool;

    #[inline(always)]
    fn of(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        numbers[0]
    }

    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self;
    }

    #[inline(always)]
    fn size(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn root(self) -> Self {
        Scalar::sqrt(self)
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        1.0.times_power_of_two(self as i32)
    }

    #[inline(always)]
    fn is_less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn vanishes(self) -> bool {
        self == 0.0
    }

    #[inline(always)]
    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }

    #[inline(always)]
    fn all(truth: bool) -> bool {
        truth
    }

    #[inline(always)]
    fn both(first: bool, second: bool) -> bool {
        first & second
    }

    #[inline(always)]
    fn not(truth: bool) -> bool {
        !truth
    }

    #[inline(never)]
    fn call<P: Part>(part: P) -> P::Output {
        part.run()
    }
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
mod lanes {
    use crate::number::Part;
    use crate::proof::word::{SHIFT, Word};
    use mstmm_lanes::{Lanes, Truths, Vector};

    impl<V: Vector> Word for Lanes<V> {
        const LANES: usize = V::LANES;
        type Mask = Truths<V>;

        #[inline(always)]
        fn of(number: f64) -> Self {
            Lanes::splat(number)
        }

        #[inline(always)]
        fn load(numbers: &[f64]) -> Self {
            Lanes(V::load(numbers))
        }

        #[inline(always)]
        fn store(self, numbers: &mut [f64]) {
            let count = numbers.len().min(V::LANES);
            self.0.store(&mut numbers[..count]);
        }

        #[inline(always)]
        fn size(self) -> Self {
            Lanes(self.0.magnitude())
        }

        #[inline(always)]
        fn root(self) -> Self {
            Lanes(self.0.root())
        }

        /// The last bits of its sum with [`SHIFT`] are k.
        #[inline(always)]
        fn power_of_two(self) -> Self {
            let [half, _] = (self + Lanes::splat(SHIFT)).0.powers();
            Lanes(half) * Lanes::splat(2.0)
        }

        #[inline(always)]
        fn is_less(self, other: Self) -> Truths<V> {
            self.is_less(other)
        }

        #[inline(always)]
        fn vanishes(self) -> bool {
            Truths::<V>(self.0.is_nought()).all()
        }

        #[inline(always)]
        fn select(truth: Truths<V>, first: Self, second: Self) -> Self {
            Lanes::select(truth, first, second)
        }

        #[inline(always)]
        fn all(truth: Truths<V>) -> bool {
            truth.all()
        }

        #[inline(always)]
        fn both(first: Truths<V>, second: Truths<V>) -> Truths<V> {
            first & second
        }

        #[inline(always)]
        fn not(truth: Truths<V>) -> Truths<V> {
            !truth
        }

        #[inline(always)]
        fn product_error(self, other: Self, product: Self) -> Self {
            self.product_error(other, product)
        }

        #[inline(always)]
        fn call<P: Part>(part: P) -> P::Output {
            V::call(part)
        }
    }
}

/// Defines functions that stand apart: each is compiled for the instruction set of the lanes that its numbers have. All functions that it
/// calls have to stand in line or apart.
macro_rules! apart {
    ($(
        $(#[$meta:meta])*
        $visible:vis fn $name:ident<$N:ident: $bound:ident $(, const $C:ident: usize)*>($($argument:ident: $type:ty),* $(,)?)
        $(-> $output:ty)? $body:block
    )*) => {$(
        $(#[$meta])*
        #[inline(always)]
        $visible fn $name<$N: $bound $(, const $C: usize)*>($($argument: $type),*) $(-> $output)? {
            struct Apart<A>(A);

            impl<$N: $bound $(, const $C: usize)*> $crate::number::Part for Apart<($($type,)*)> {
                type Output = $crate::proof::word::output!($($output)?);

                #[inline(always)]
                fn run(self) -> Self::Output {
                    let Apart(($($argument,)*)) = self;
                    $body
                }
            }

            <<$N as $crate::proof::number::Number>::Word as $crate::proof::word::Word>::call(Apart(($($argument,)*)))
        }
    )*};
}
pub(crate) use apart;

/// The type of a result.
macro_rules! output {
    () => {
        ()
    };
    ($output:ty) => {
        $output
    };
}
pub(crate) use output;
