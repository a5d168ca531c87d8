#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod anchors;
mod diagram;
mod drawing;
mod error;
mod figure;
mod frame;
mod ink;
mod kind;
mod labels;
mod lanes;
mod motion;
mod outline;
mod path_places;
mod pose;
mod shape;
mod sketched;
mod supports;
mod symbols;
mod tree;
mod tree_places;
mod vector;
mod write;

pub use diagram::Force;
pub use drawing::Drawing;
pub use error::DrawingError;
pub use shape::Shape;
pub use sketched::{Frame, Sketched, Tree};
