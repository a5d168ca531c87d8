//! Networks: plane structures of members between nodes, with closed loops, evaluated by their dynamic stiffness.

mod chart_load;
mod drawn;
mod error;
mod evaluate;
mod frame;
mod frequency;
mod loading;
mod member;
mod memory;
mod motion;
mod motions;
mod moving_mass;
mod node;
mod numbers;
mod order;
mod overall;
mod overall_network;
mod own;
mod part;
mod path_state;
mod placed;
mod placed_node;
mod placement;
mod prestress;
mod products;
mod skeleton;
mod sketch;
#[cfg(feature = "std")]
mod spinning;
pub(crate) mod stiffness;
mod structure;
#[cfg(test)]
mod tests;
mod ties;
pub(crate) mod vector;
mod visit;

pub(crate) use chart_load::{load_on_chart, load_work};
#[cfg(feature = "std")]
pub(crate) use drawn::stiffest;
pub use drawn::{Drawn, DrawnBody, DrawnEnd, DrawnMember, DrawnPoint, DrawnSupport};
pub use error::NetworkError;
pub use evaluate::network_pass;
pub use frequency::{MovingNetwork, PlaneFrequency};
pub(crate) use loading::{ActingLoad, JumpAt, LoadAt, Loading};
pub use member::{End, Member};
#[cfg(feature = "std")]
pub use memory::Vectors;
pub use memory::{Arrays, Memory};
pub(crate) use motion::{NetworkMotion, Wanted, longest, motion_under, motions_under, size_on_node};
pub use motions::Motions;
pub(crate) use moving_mass::mass_of_bodies;
pub use node::Node;
pub(crate) use numbers::NumberPlaces;
pub use overall::{PlacedTransfers, overall_determinant, overall_matrix};
pub use overall_network::OverallNetwork;
pub use own::OwnMembers;
#[cfg(feature = "std")]
pub(crate) use part::Part;
#[cfg(feature = "std")]
pub(crate) use placed::together;
pub use placed::{PerMember, PerNode, Placed, PlacedCharts, PlacedMotions};
pub use placed_node::PlacedNode;
pub use placement::Placement;
#[cfg(feature = "std")]
pub(crate) use placement::SpatialEnd;
pub use prestress::Prestressed;
pub(crate) use products::{mass_product, mass_product_of_two};
pub use skeleton::{Skeleton, build_member};
pub use sketch::{
    Axis, NetworkSketch, Seat, SketchedBody, SketchedDirection, SketchedEnd, SketchedMember, SketchedNode,
    SketchedPlane, SketchedPoint, SketchedSkew, SketchedSupport, SketchedUp,
};
pub use stiffness::StiffnessModel;
#[cfg(feature = "std")]
pub(crate) use structure::is_direction;
pub use structure::{InNetwork, Network};
pub use visit::visit_network;
