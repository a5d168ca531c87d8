//! The overall transfer equation of a skeleton: its root, the members that are cut, and the number of unknowns.

use super::Skeleton;
use crate::keywords::Dimension;
use mstmm_plan::{PathMember, PathNode, is_cut, lead_paths, unknowns};

/// What the documentation of a built system says of the overall transfer equation.
pub(crate) struct Overall<'s> {
    /// The width of the overall matrix.
    pub(crate) unknowns: usize,
    /// The node at which all paths end.
    pub(super) root: &'s str,
    /// The members that are cut, since they close loops.
    pub(super) cuts: Vec<&'s str>,
}

impl Skeleton<'_> {
    /// The overall transfer equation; none in space, and where rustc alone knows the freedoms of a member. The skeleton hangs together.
    pub(crate) fn overall(&self) -> Option<Overall<'_>> {
        if self.dimension == Dimension::Space {
            return None;
        }
        let node = |(index, node): (usize, &super::Node<'_>)| {
            let [freedoms, held] = node.known()?;
            // what ends do not share with it is there, and held where it has it not
            let here = self.members.iter().filter(|member| self.nodes_of(member).contains(&index));
            let freedoms = here.fold(freedoms, |sum, member| sum.union(member.released()));
            Some(PathNode::new(freedoms, held, node.skew.is_some()))
        };
        let mut nodes = self.nodes.iter().enumerate().map(node).collect::<Option<Vec<PathNode>>>()?;
        let member = |member: &super::Member<'_>| {
            let freedoms = member.freedoms.as_known()?;
            Some(PathMember { nodes: self.nodes_of(member), freedoms, released: 2 * member.released().count() })
        };
        let members = self.members.iter().map(member).collect::<Option<Vec<PathMember>>>()?;
        lead_paths(&mut nodes, &members);
        let cut = (0..members.len()).filter(|&member| is_cut(&nodes, &members, member));
        let root = nodes.iter().position(|node| node.leaving().is_none()).unwrap_or_default();
        Some(Overall {
            unknowns: unknowns(&nodes, &members),
            root: &self.nodes[root].name,
            cuts: cut.map(|member| self.members[member].name.as_str()).collect(),
        })
    }
}
