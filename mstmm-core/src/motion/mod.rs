//! Motions: the states that belong to a root or to a load, and what follows from them.

mod covector;
mod element;

pub use covector::Covector;
pub use element::{Ends, Motion};
