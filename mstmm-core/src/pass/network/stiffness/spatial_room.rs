//! What a structure in space has besides what one in the plane has, for its stiffness pass.

use crate::number::Real;
use crate::pass::network::motions::Motions;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::placement::Placement;
use crate::pass::network::vector::Six;
use crate::structure::triangle::{place, row};
use std::vec::Vec;

/// Of each end of a part, what the displacements along and across it and its rotation are of the motions of its node.
pub(super) type Rows = [[Six<f64>; 3]; 2];

/// Entries of the lower triangle of a mass matrix.
const MASSES: usize = row(6);

/// What nodes and members have in space besides.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpatialRoom {
    pub(super) rows: Vec<Rows>,
    /// The lower triangles of mass matrices over motions, of nodes with a body.
    pub(super) masses: Vec<Option<[f64; MASSES]>>,
}

impl SpatialRoom {
    /// What nodes and parts of members have.
    pub(super) fn new<T: Real>(nodes: &[PlacedNode<T>], motions: &[Motions<T>], placements: &[Placement<T>]) -> Self {
        let masses = |(node, motions): (&PlacedNode<T>, &Motions<T>)| {
            let rows = motions.masses::<T>(node);
            let mut masses = [0.0; MASSES];
            for (k, own) in rows.iter().enumerate() {
                own[..=k].iter().enumerate().for_each(|(l, entry)| masses[place(k, l)] = entry.to_f64());
            }
            node.has_body().then_some(masses)
        };
        let rows = |placement: &Placement<T>| placement.rows().map(|rows| rows.map(|row| row.map(T::to_f64)));
        SpatialRoom {
            rows: placements.iter().map(rows).collect(),
            masses: nodes.iter().zip(motions).map(masses).collect(),
        }
    }
}
