//! The numbers for which this library compiles what would else be compiled with each model.

/// Calls a macro with each number: `f32; f64;` and so on.
macro_rules! for_compiled_numbers {
    ($apply:ident) => {
        $apply! {
            f32;
            f64;
            $crate::DoubleDouble;
            $crate::Complex<f32>;
            $crate::Complex<f64>;
            $crate::Complex<$crate::DoubleDouble>;
            $crate::Value<$crate::Complex<$crate::DoubleDouble>>;
            $crate::Dual<f32>;
            $crate::Dual<f64>;
            $crate::Dual<$crate::DoubleDouble>;
            $crate::Dual<$crate::Complex<f32>>;
            $crate::Dual<$crate::Complex<f64>>;
            $crate::Dual<$crate::Complex<$crate::DoubleDouble>>;
        }
    };
}
pub(crate) use for_compiled_numbers;
