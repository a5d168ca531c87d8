//! Numbers: real, complex, dual, double-double and without branches; nothing here knows mechanics.

pub(crate) mod branch_free;
pub(crate) mod columns;
pub(crate) mod complex;
pub(crate) mod double_double;
pub(crate) mod doubt;
pub(crate) mod dual;
pub(crate) mod exponent;
pub(crate) mod exponentials;
pub(crate) mod fixed_list;
pub(crate) mod floats;
pub(crate) mod frequency;
pub(crate) mod frequency_powers;
pub(crate) mod kernel;
pub(crate) mod oscillation;
pub(crate) mod partials;
pub(crate) mod scalar;
pub(crate) mod scaled;
#[cfg(test)]
pub(crate) mod tolerance;
pub(crate) mod wave_functions;
pub(crate) mod waves;

pub(crate) use branch_free::BranchFree;
pub(crate) use columns::InColumns;
#[cfg(test)]
pub(crate) use double_double::DoubleDouble;
pub(crate) use doubt::{
    CONDITION, MISFIT, NEARLY_ZERO_EXPONENT, NOISE, REFUSED_MISFIT, ROUNDINGS, STRAIGHT, TOUCHING, UNPROVEN_WIDTH,
    USUAL_ERROR, is_extended, is_ill_conditioned, is_last, largest_loss, may_be_lost, refuses_doubt,
};
pub(crate) use dual::Dual;
pub(crate) use exponent::binary_exponent;
pub(crate) use exponentials::{exponential, phi_1, phi_2};
pub(crate) use fixed_list::List;
pub(crate) use floats::{argument, elementary};
pub(crate) use frequency::{
    ComplexEigenvalue, ComplexFrequency, ExtendedOf, Frequency, Oscillation, Real, RealFrequency, larger, modulus,
    smaller,
};
pub(crate) use frequency_powers::FrequencyPowers;
pub(crate) use partials::Partials;
pub(crate) use scalar::{Branches, Scalar, is_moderate};
pub(crate) use scaled::{Magnitude, Scaled};
#[cfg(test)]
pub(crate) use tolerance::assert_close;
pub(crate) use wave_functions::WaveFunctions;
