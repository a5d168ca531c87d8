//! Networks: plane structures of members between nodes, with closed loops, evaluated by fronts.

mod error;
mod evaluate;
mod member;
mod node;
mod structure;

pub use error::NetworkError;
pub use member::{End, Member};
pub use node::Node;
pub use structure::{Network, NetworkRoom};
