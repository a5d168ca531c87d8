//! Other ways to the same roots, and what they cost: for measurements, not for users.

mod run;

pub use run::Run;
