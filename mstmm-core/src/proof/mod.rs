//! The proof of natural frequencies.

pub(crate) mod ball;
pub(crate) mod bending;
pub(crate) mod constants;
pub(crate) mod front;
pub(crate) mod functions;
pub(crate) mod line;
pub(crate) mod member;
pub(crate) mod number;
pub(crate) mod tapered;
pub(crate) mod word;

#[cfg(test)]
mod tests;
