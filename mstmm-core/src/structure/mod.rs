//! Answers by the dynamic stiffness of a structure, eliminated without pivoting, in numbers of enough digits.
//!
//! The unknowns are the motions of nodes. A member adds its stiffness over the displacements of its ends. Beside a frequency with held ends
//! that has a pole. There a force of the member stays an unknown, a border: `[[R, gᵀ], [g, -σ]]`, whose elimination gives the stiffness
//! `R + gᵀ g/σ` back. R, g and σ are entire.
//!
//! | file | what it has |
//! |---|---|
//! | [`chart`], [`path_chart`] | a member as its element gives it; of one motion, from a transfer matrix |
//! | [`units`], [`triangle`] | units of charts; places of entries in a triangle |
//! | [`member`] | the chart of a member in displacements, with its borders; its motion, once unknowns are known |
//! | [`join`] | a member joins the factor by the rows of its ends |
//! | [`node_unknowns`] | the unknowns of a node; nodes that a rigid joint ties share unknowns |
//! | [`factor`], [`shear`] | the matrix of the unknowns that have not left; an unknown leaves; two whose pivots are small |
//! | [`total`] | Δ and the count |
//! | [`everywhere`] | loads on all unknowns |
//! | [`memory`] | memory on the stack or on the heap, and the numbers that the factor is compiled for |

pub(crate) mod chart;
mod everywhere;
pub(crate) mod factor;
pub(crate) mod join;
pub(crate) mod member;
pub(crate) mod memory;
pub(crate) mod node_unknowns;
mod path_chart;
mod shear;
mod tape;
#[cfg(test)]
mod tests;
mod total;
pub(crate) mod triangle;
mod units;

pub(crate) use chart::{Chart, JoinedEnd, MOST_MOTIONS, MOST_VARIABLES};
pub(crate) use factor::{Factor, LOADS, LoadEverywhere};
pub(crate) use member::{MemberLoad, MemberStiffness};
#[cfg(feature = "std")]
pub(crate) use memory::on_heap;
pub(crate) use memory::{StructureScalar, in_memory, with_many};
pub(crate) use node_unknowns::NodeUnknowns;
pub(crate) use total::Total;
pub(crate) use units::{Units, unit_of};
