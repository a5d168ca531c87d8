//! Which numbers stand in lanes on which instruction set.
//!
//! In debug builds none does: there every operation on a vector keeps memory of its own, and a pass would take many times the stack.

use crate::number::double_double::DoubleDouble;
use crate::number::dual::Dual;
use crate::number::frequency::Real;
use crate::number::scalar::{Scalar, Single};
use crate::number::value::Value;
use num_complex::Complex;

/// Numbers of type `T` in lanes, or one of them.
pub trait Packed<T>: Scalar {
    /// Number of lanes.
    const LANES: usize;

    /// The first numbers of a slice; the last one fills the lanes beyond its end.
    fn load(numbers: &[T]) -> Self;

    /// Writes as many lanes as there is room for.
    fn store(self, numbers: &mut [T]);

    /// Writes as many lanes of a size as there is room for.
    fn store_size(size: Self::Size, numbers: &mut [f64]);

    /// A bit per lane of a truth, that of the first lane last.
    fn bits(truth: Self::Truth) -> u8;
}

impl<T: Single> Packed<T> for T {
    const LANES: usize = 1;

    #[inline(always)]
    fn load(numbers: &[T]) -> T {
        numbers[0]
    }

    #[inline(always)]
    fn store(self, numbers: &mut [T]) {
        numbers[0] = self;
    }

    #[inline(always)]
    fn store_size(size: f64, numbers: &mut [f64]) {
        numbers[0] = size;
    }

    #[inline(always)]
    fn bits(truth: bool) -> u8 {
        u8::from(truth)
    }
}

/// A number with its lanes on each instruction set.
pub trait InLanes: Single {
    /// Whether this is `f64`.
    const IS_DOUBLE: bool = false;

    /// Numbers in lanes of AVX-512.
    type OnAvx512: Packed<Self>;

    /// Numbers in lanes of AVX2.
    type OnAvx2: Packed<Self>;
}

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
mod vectors {
    use crate::number::lanes::Waving;
    use crate::number::packed::Packed;
    use mstmm_lanes::{Lanes, Truths};

    impl<V: Waving> Packed<f64> for Lanes<V> {
        const LANES: usize = V::LANES;

        #[inline(always)]
        fn load(numbers: &[f64]) -> Self {
            Lanes(V::load(numbers))
        }

        #[inline(always)]
        fn store(self, numbers: &mut [f64]) {
            self.0.store(numbers);
        }

        #[inline(always)]
        fn store_size(size: Self, numbers: &mut [f64]) {
            size.0.store(numbers);
        }

        #[inline(always)]
        fn bits(truth: Truths<V>) -> u8 {
            truth.bits()
        }
    }

    impl super::InLanes for f64 {
        const IS_DOUBLE: bool = true;
        type OnAvx512 = Lanes<mstmm_lanes::Eight>;
        type OnAvx2 = Lanes<mstmm_lanes::Four>;
    }

    /// Parameters of as many models as AVX-512 has lanes.
    pub(crate) type Parameters = Lanes<mstmm_lanes::Plain>;
}
#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
pub(crate) use vectors::Parameters;

/// Parameters of one model, where none stand in lanes.
#[cfg(not(all(feature = "std", target_arch = "x86_64", not(debug_assertions))))]
pub(crate) type Parameters = f64;

/// Numbers that stand in no lanes: each is evaluated alone.
macro_rules! alone {
    ($($(#[$condition:meta])* [$($parameter:tt)*] $type:ty $(, $is_double:literal)?;)*) => {$(
        $(#[$condition])*
        impl<$($parameter)*> InLanes for $type {
            $(const IS_DOUBLE: bool = $is_double;)?
            type OnAvx512 = Self;
            type OnAvx2 = Self;
        }
    )*};
}
alone! {
    #[cfg(not(all(feature = "std", target_arch = "x86_64", not(debug_assertions))))] [] f64, true;
    [] f32;
    [] DoubleDouble;
    [T: Real] Complex<T>;
    [S: Single] Dual<S>;
    [S: Single] Value<S>;
}
