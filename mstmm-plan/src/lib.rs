//! What a model is before any number: freedoms, supports, the steps of an evaluation, their order, and where each stands in the
//! overall equation. All is `const`: the macro asks it while it expands a model, the emitted code in constants, the core at run
//! time.
//!
//! This crate is an implementation detail of `mstmm`, which re-exports what users need.
#![no_std]
#![forbid(unsafe_code)]

mod coordinate;
mod elimination;
mod freedom;
mod layout;
mod network_order;
mod network_paths;
mod order;
mod parts;
mod resolve;
mod rules;
mod scheme;
mod space;
mod step;
mod support;

pub use coordinate::Coordinate;
pub use elimination::{Elimination, Incidence, apart, in_motion};
pub use freedom::Freedoms;
pub use layout::Layout;
pub use network_order::{NetworkOrder, OrderMemory, OrderRoom};
pub use network_paths::{PathMember, PathNode, is_cut, lead_paths, unknowns};
pub use order::inputs_first;
pub use parts::{HINGE_PARTS, MOST_PARTS, freedoms_in_part, freedoms_of_part};
pub use rules::refuse_if;
pub use scheme::{Place, Scheme};
pub use space::{Space, WIDEST};
pub use step::Step;
pub use support::Support;
