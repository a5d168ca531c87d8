#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod anchors;
mod depth;
mod diagram;
mod diagram_in_space;
mod drawing;
mod error;
mod figure;
mod frame;
mod grips;
mod in_space;
mod ink;
mod kind;
mod labels;
mod lanes;
mod loose;
mod motion;
mod outline;
mod path_places;
mod picture;
mod pose;
mod projection;
mod scene;
mod shape;
mod sketched;
mod solid;
mod spatial_kind;
mod supports;
mod symbols;
mod tree;
mod tree_places;
mod triad;
mod vector;
mod vector3;
mod view;
mod write;
mod write_in_space;

pub use diagram::Force;
pub use drawing::Drawing;
pub use error::DrawingError;
pub use shape::Shape;
pub use sketched::{Frame, Sketched, Tree};
pub use view::View;
