//! The overall transfer equation of a network that is a list.

use crate::element::MemberElement;
use crate::model::MemberPlane;
use crate::number::{Frequency, Scaled, Single};
use crate::pass::network::error::NetworkError;
use crate::pass::network::memory::Memory;
use crate::pass::network::overall::{PlacedTransfers, overall_determinant, overall_matrix};
use crate::pass::network::placed::{PerNode, Placed, together};
use crate::pass::network::structure::Network;
use crate::pass::overall::evaluate::Evaluate;
use mstmm_plan::{Freedoms, PathMember, PathNode, lead_paths, unknowns};
use nalgebra::SMatrix;

/// A network with its paths, along which the overall transfer equation is assembled; `N` is the number of its unknowns.
#[derive(Clone, Debug)]
pub struct OverallNetwork<'n, Y: Placed, const N: usize> {
    network: &'n Y,
    paths: PerNode<Y, PathNode>,
}

impl<E: MemberElement, M: Memory> Network<E, M> {
    /// The overall transfer equation `U_all z_all = 0`, with `overall_matrix` and `overall_determinant`.
    ///
    /// `N` unknowns are half of the entries of a state at each support, at the free tips of paths and at the root, all `2n` entries of the
    /// state of a member with `n` freedoms at each cut, and a jump for each released freedom.
    ///
    /// ```
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{Arrays, Evaluate, Member, Network, Node, Section, UndampedMember};
    ///
    /// // a free square: one cut, and three displacements of the root
    /// let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Node::at);
    /// let section = Section { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 };
    /// let members = [[0, 1], [1, 2], [2, 3], [3, 0]].map(|[from, to]| Member::<UndampedMember<f64>>::new(from, to, section));
    /// let square = Network::<_, Arrays<18, 4, 4>>::in_arrays(&nodes, &members)?;
    /// let equation = square.overall::<9>()?;
    /// let first = square.first_frequencies::<5>().unwrap()[1];
    /// let [below, above] = [0.99, 1.01].map(|part| equation.overall_determinant(part * first.omega).mantissa());
    /// assert!(below * above < 0.0);
    /// # Ok::<(), mstmm_core::NetworkError>(())
    /// ```
    ///
    /// # Errors
    /// [`NetworkError::Unknowns`] for another `N` than that of the network.
    pub fn overall<const N: usize>(&self) -> Result<OverallNetwork<'_, Self, N>, NetworkError> {
        OverallNetwork::new(self)
    }
}

impl<'n, Y: Placed, const N: usize> OverallNetwork<'n, Y, N> {
    pub(crate) fn new(network: &'n Y) -> Result<Self, NetworkError> {
        let [node_count, member_count] = network.sizes();
        let is_in_space = (0..member_count).any(|member| network.placement(member).plane() != MemberPlane::Structure);
        let all = if is_in_space { Freedoms::SPACE } else { Freedoms::PLANE };
        let mut members = network.per_member(PathMember::NONE);
        let members = &mut members.as_mut()[..member_count];
        for (index, member) in members.iter_mut().enumerate() {
            let (placement, parts) = (network.placement(index), network.parts_from(index));
            let released = |part: usize| [0, 1].map(|end| network.placement(part).released_freedoms(end).count());
            if !parts.is_empty() {
                *member = PathMember {
                    nodes: [0, 1].map(|end| placement.node_of(end)),
                    freedoms: together(network, parts.clone(), |part| part.freedoms),
                    released: parts.flat_map(released).sum(),
                };
            }
        }
        let mut paths = network.per_node(PathNode::NONE);
        let nodes = &mut paths.as_mut()[..node_count];
        for (index, path) in nodes.iter_mut().enumerate() {
            let here = members.iter().filter(|member| member.nodes.contains(&index));
            // axes of members are not those of nodes
            let brought = here.fold(Freedoms::NONE, |sum, member| sum.union(member.freedoms.in_any_axes()));
            let node = network.node(index).0;
            let freedoms = all.without(node.held).union(brought.intersection(all));
            *path = PathNode::new(freedoms, node.held.intersection(all), node.skew.is_some());
        }
        lead_paths(nodes, members);
        match unknowns(nodes, members) {
            needed if needed == N => Ok(OverallNetwork { network, paths }),
            needed => Err(NetworkError::Unknowns { needed }),
        }
    }

    fn paths(&self) -> &[PathNode] {
        &self.paths.as_ref()[..self.network.sizes()[0]]
    }
}

impl<Y, S, const N: usize> Evaluate<S> for OverallNetwork<'_, Y, N>
where
    Y: PlacedTransfers<S>,
    S: Frequency<Y::Parameter> + Single,
{
    type Matrix = SMatrix<S, N, N>;

    fn overall_matrix(&self, x: S) -> SMatrix<S, N, N> {
        overall_matrix(self.network, self.paths(), x)
    }

    fn overall_determinant(&self, x: S) -> Scaled<S> {
        overall_determinant::<N, Y, S>(self.network, self.paths(), x)
    }
}
