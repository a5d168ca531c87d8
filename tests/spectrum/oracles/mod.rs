//! Models of trees that share no formula with the library.

pub(crate) mod chain_matrix;
pub(crate) mod dynamic_stiffness;
pub(crate) mod finite_elements;
pub(crate) mod legendre_beam;
pub(crate) mod many_digits;
pub(crate) mod polynomial_beams;
pub(crate) mod quadratic;
pub(crate) mod short_pieces;
pub(crate) mod sylvester;
pub(crate) mod wave_lines;
