//! Networks: plane structures of members between nodes, with closed loops, evaluated by fronts.

mod error;
mod evaluate;
mod member;
mod motion;
mod node;
mod skeleton;
mod sketch;
mod structure;

pub use error::NetworkError;
pub use evaluate::{Placed, PlacedCharts, in_way_back, network_pass};
pub(crate) use motion::{NetworkMotion, motion};
pub use member::{End, Member, Placement};
pub use node::{Motions, Node};
pub use skeleton::{Skeleton, build_member, estimate_member};
pub use sketch::{Axis, Located, NetworkSketch, SketchedBody, SketchedEnd, SketchedMember, SketchedNode};
pub use structure::{InNetwork, Network, NetworkRoom};
