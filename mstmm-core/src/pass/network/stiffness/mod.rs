//! Networks by dynamic stiffnesses: an evaluation that chooses no pivots, at several frequencies at once.
//!
//! It is fast, and as good as the members are far from frequencies at which they vibrate between held ends. Searches propose roots by it.
//! Motions and damped searches go by `structure`.

mod arrangement;
mod assembly;
mod block;
mod front;
mod group;
#[cfg(feature = "std")]
mod in_space;
mod joined;
mod member;
mod model;
mod node;
mod numbers;
mod pass;
mod released;
#[cfg(feature = "std")]
mod spatial_room;
mod total;
mod waves;

#[cfg(test)]
mod tests;

pub(crate) use block::StiffnessBlock;
pub use model::StiffnessModel;
pub(crate) use model::StiffnessRoom;
