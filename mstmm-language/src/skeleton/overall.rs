//! The overall transfer equation of a skeleton: its root, the members that are cut, and the number of unknowns.

use super::Skeleton;
use crate::keywords::Dimension;
use mstmm_plan::{Freedoms, PathMember, PathNode, freedoms_of_part, is_cut, lead_paths, unknowns};

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
    /// The overall transfer equation; none where rustc alone knows the freedoms of a member. The skeleton hangs together.
    pub(crate) fn overall(&self) -> Option<Overall<'_>> {
        let is_in_space = self.dimension == Dimension::Space;
        let node = |(index, node): (usize, &super::Node<'_>)| {
            let [freedoms, held] = node.known()?;
            // what ends do not share with it is there, and held where it has it not
            let here = self.members.iter().filter(|member| self.nodes_of(member).contains(&index));
            let released = here.fold(Freedoms::NONE, |sum, member| sum.union(member.released_of_member()));
            let released = if is_in_space { released.in_any_axes() } else { released };
            Some(PathNode::new(freedoms.union(released), held, node.skew.is_some()))
        };
        let mut nodes = self.nodes.iter().enumerate().map(node).collect::<Option<Vec<PathNode>>>()?;
        let members = self.path_members()?;
        lead_paths(&mut nodes, &members);
        let is_there = |member: &usize| !self.members[*member].is_further;
        let cut = (0..members.len()).filter(is_there).filter(|&member| is_cut(&nodes, &members, member));
        let root = nodes.iter().position(|node| node.leaving().is_none()).unwrap_or_default();
        Some(Overall {
            unknowns: unknowns(&nodes, &members),
            root: &self.nodes[root].name,
            cuts: cut.map(|member| self.members[member].name.as_str()).collect(),
        })
    }

    /// The members as paths know them: with all of their parts in the place of the first.
    fn path_members(&self) -> Option<Vec<PathMember>> {
        let mut all = vec![PathMember::NONE; self.members.len()];
        let mut first = 0;
        for (index, member) in self.members.iter().enumerate() {
            if !member.is_further {
                first = index;
                all[first].nodes = self.nodes_of(member);
            }
            let own = freedoms_of_part(member.part()?, member.freedoms.as_known()?);
            all[first].freedoms = all[first].freedoms.union(own);
            all[first].released += 2 * member.released().count();
        }
        Some(all)
    }
}
