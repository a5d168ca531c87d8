//! Many frequencies at once give what each gives alone, bit for bit.

mod responses;
#[path = "../support/mod.rs"]
pub mod support;
mod values;
