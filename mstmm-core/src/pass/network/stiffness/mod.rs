//! Networks by dynamic stiffnesses: an evaluation that chooses no pivots, at several frequencies at once.
//!
//! It is fast, and as good as the members are far from frequencies at which they vibrate between held ends. Searches approach roots by it,
//! and take its counts where rounding cannot have decided the sign of a pivot; all else goes by fronts.

mod arrangement;
mod assembly;
mod block;
mod front;
mod group;
mod joined;
mod member;
mod model;
mod node;
mod numbers;
mod pass;
mod precise;
mod precise_count;
mod released;
mod total;
mod waves;

#[cfg(test)]
mod tests;

pub(crate) use block::StiffnessBlock;
pub use model::StiffnessModel;
pub(crate) use model::StiffnessRoom;
pub use precise::precise_counts;
pub use precise_count::PreciseCount;
