//! The numbers for which this library compiles what would else be compiled with each model.

/// Calls a macro with each number and its zero, a constant: `f64, 0.0;` and so on.
macro_rules! for_compiled_numbers {
    ($apply:ident) => {
        $apply! {
            f32, 0.0;
            f64, 0.0;
            $crate::DoubleDouble, $crate::DoubleDouble::ZERO;
            $crate::Complex<f32>, $crate::Complex::new(0.0, 0.0);
            $crate::Complex<f64>, $crate::Complex::new(0.0, 0.0);
            $crate::Complex<$crate::DoubleDouble>,
                $crate::Complex::new($crate::DoubleDouble::ZERO, $crate::DoubleDouble::ZERO);
            $crate::Dual<f32>, $crate::Dual { value: 0.0, derivative: 0.0 };
            $crate::Dual<f64>, $crate::Dual { value: 0.0, derivative: 0.0 };
            $crate::Dual<$crate::DoubleDouble>,
                $crate::Dual { value: $crate::DoubleDouble::ZERO, derivative: $crate::DoubleDouble::ZERO };
            $crate::Dual<$crate::Complex<f32>>,
                $crate::Dual { value: $crate::Complex::new(0.0, 0.0), derivative: $crate::Complex::new(0.0, 0.0) };
            $crate::Dual<$crate::Complex<f64>>,
                $crate::Dual { value: $crate::Complex::new(0.0, 0.0), derivative: $crate::Complex::new(0.0, 0.0) };
            $crate::Dual<$crate::Complex<$crate::DoubleDouble>>,
                $crate::Dual {
                    value: $crate::Complex::new($crate::DoubleDouble::ZERO, $crate::DoubleDouble::ZERO),
                    derivative: $crate::Complex::new($crate::DoubleDouble::ZERO, $crate::DoubleDouble::ZERO),
                };
        }
    };
}
pub(crate) use for_compiled_numbers;
