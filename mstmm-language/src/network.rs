//! Networks: models whose points have locations. The hand-over from the checks to the emission.
//!
//! Tokens become a [`Graph`] of nodes and arrows, its [`Points`] and its [`Paths`]; `check` refuses what is wrong with these,
//! and a [`Network`] names what is left by indices.

mod assemble;
mod classes;
mod freedoms;
mod graph;
mod hand_over;
mod paths;
mod points;
#[cfg(test)]
mod text;

pub(crate) use classes::Classes;
pub(crate) use freedoms::{FreedomSet, freedoms};
pub(crate) use graph::{Edge, Graph, Location, Named};
pub(crate) use hand_over::{
    Direction, Holds, Joint, Member, Network, PathContact, PathElement, Support, Suspicion, TransferPath,
};
pub(crate) use paths::{Contact, Path, PathMotion, Paths};
pub(crate) use points::Points;
