//! What modes and loads tell: work on shapes, damping of each mode, sums in frequency.

mod base;
mod damping;
mod dislocations;
mod models;
mod participation;
mod random;
mod ranges;
mod spectra;
mod supports;
mod truncation;
mod work;
