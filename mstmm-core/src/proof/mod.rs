//! The proof of natural frequencies.

pub(crate) mod ball;
pub(crate) mod bending;
pub(crate) mod bisection;
pub(crate) mod certificate;
pub(crate) mod constants;
pub(crate) mod count;
pub(crate) mod four_words;
pub(crate) mod frame;
pub(crate) mod front;
pub(crate) mod functions;
pub(crate) mod general_bending;
pub(crate) mod joining;
pub(crate) mod line;
pub(crate) mod member;
pub(crate) mod number;
pub(crate) mod row;
pub(crate) mod tapered;
pub(crate) mod tree;
pub(crate) mod visit;
pub(crate) mod word;

#[cfg(test)]
mod tests;
