//! Many frequencies at once give what each gives alone, bit for bit.

mod responses;
mod searches;
#[path = "../support/mod.rs"]
pub mod support;
#[path = "../support/undamped_models.rs"]
mod undamped_models;
mod values;
