//! Motions: the states that belong to a root or to a load, and what follows from them.

mod candidates;
mod covector;
mod curve;
mod element;
mod energy;
mod error;
mod field;
mod forms;
mod inside;
mod label;
pub(crate) mod line_motions;
mod motions;
mod multiple;
mod passes;
mod response;
mod root;
mod sensitivity;
mod shape;
mod source;
mod spread;
mod tree;

pub use covector::Covector;
pub use curve::Sample;
pub use element::{Ends, Inside, Motion};
pub use energy::EnergyShares;
pub use error::MotionError;
pub use field::Field;
pub use label::{Entry, Label, Load, Point};
pub use motions::Motions;
pub use response::FrequencyResponse;
pub use root::Root;
pub use sensitivity::Sensitivities;
pub use shape::{ModeShape, ShapeList};
pub use tree::{Planned, Tree, Visit, VisitAt};
