//! Networks: plane structures of members between nodes, with closed loops, evaluated by fronts.

mod error;
mod evaluate;
mod member;
mod node;
mod skeleton;
mod sketch;
mod structure;

pub use error::NetworkError;
pub use evaluate::{Placed, PlacedCharts, network_pass};
pub use member::{End, Member, Placement};
pub use node::{Motions, Node};
pub use skeleton::{Skeleton, build_member, estimate_member};
pub use sketch::{Axis, Located, NetworkSketch, SketchedBody, SketchedEnd, SketchedMember, SketchedNode};
pub use structure::{Network, NetworkRoom};
