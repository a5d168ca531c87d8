//! Proofs of eigenvalues: complex numbers and members against many digits, discs against eigenvalues of 32 digits.

mod campaign;
mod closed_forms;
mod complex;
mod exact_complex;
mod members;
