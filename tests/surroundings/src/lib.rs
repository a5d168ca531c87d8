//! A crate that knows mstmm by another name and passes it on, as a library of plant models would.

/// Everything of the methods, under a path of this crate's own.
pub mod methods {
    pub use vibrations::*;
}
