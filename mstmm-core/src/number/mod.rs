//! Numbers: real, complex, dual and double-double; nothing here knows mechanics.

pub(crate) mod compiled;
pub(crate) mod complex;
pub(crate) mod constants;
pub(crate) mod double_double;
pub(crate) mod doubt;
pub(crate) mod dual;
pub(crate) mod elementary;
pub(crate) mod even_waves;
pub(crate) mod exponent;
pub(crate) mod exponentials;
pub(crate) mod fixed_list;
pub(crate) mod floats;
pub(crate) mod frequency;
pub(crate) mod frequency_powers;
pub(crate) mod gauss;
pub(crate) mod interval;
pub(crate) mod kernel;
#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
pub(crate) mod lanes;
pub(crate) mod logarithms;
pub(crate) mod oscillation;
pub(crate) mod packed;
pub(crate) mod partials;
pub(crate) mod products;
pub(crate) mod scalar;
pub(crate) mod scaled;
pub(crate) mod square_waves;
pub(crate) mod store;
pub(crate) mod task;
#[cfg(test)]
pub(crate) mod tolerance;
pub(crate) mod truth;
pub(crate) mod value;
pub(crate) mod wave_functions;
pub(crate) mod waves;

pub(crate) use compiled::for_compiled_numbers;
#[cfg(test)]
pub(crate) use double_double::DoubleDouble;
pub(crate) use doubt::{
    CONDITION, MISFIT, NOISE, REFUSED_MISFIT, ROUNDINGS, UNPROVEN_WIDTH, USUAL_ERROR, is_extended, is_last,
    largest_loss, may_be_lost,
};
pub(crate) use dual::Dual;
pub(crate) use exponent::{binary_exponent, power_of_two};
pub(crate) use exponentials::{exponential, phi_1, phi_2};
pub(crate) use fixed_list::{List, sort_by};
pub(crate) use floats::{argument, elementary, logarithm};
pub(crate) use frequency::{
    ComplexEigenvalue, ComplexFrequency, ExtendedOf, Frequency, Oscillation, Parameter, Real, RealFrequency, larger,
    modulus, smaller,
};
pub(crate) use frequency_powers::FrequencyPowers;
pub(crate) use logarithms::{angle, logarithm_of_ratio, turn};
pub(crate) use packed::{InLanes, Packed, Parameters};
pub(crate) use partials::Partials;
pub(crate) use products::{Operation, Products};
pub(crate) use scalar::{Scalar, Single, series, twice, with_products};
pub(crate) use scaled::{Magnitude, Scaled};
pub(crate) use store::Store;
pub(crate) use task::{Part, Task, run};
#[cfg(test)]
pub(crate) use tolerance::assert_close;
pub(crate) use truth::{Size, Truth};
pub(crate) use wave_functions::{WaveFunctions, WaveProducts};
