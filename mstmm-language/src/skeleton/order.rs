//! The order in which an evaluation goes through a skeleton, and its loops.

use super::Skeleton;
use mstmm_plan::{Elimination, NetworkOrder, OrderMemory, apart, in_motion};

impl Skeleton<'_> {
    /// Asks the order of the nodes.
    ///
    /// # Errors
    /// The name of a node that no member joins to the others.
    pub(crate) fn in_order<R>(&self, ask: impl FnOnce(NetworkOrder<'_>) -> R) -> Result<R, String> {
        let pairs: Vec<[usize; 2]> = self.members.iter().map(|member| self.nodes_of(member)).collect();
        if let Some(node) = apart(&pairs, &mut vec![0; self.nodes.len()]) {
            return Err(self.nodes[node].name.clone());
        }
        let rests = |node: usize| self.nodes[node].motions() == 0;
        let pairs: Vec<[usize; 2]> = pairs.into_iter().map(|pair| in_motion(pair, pair.map(rests))).collect();
        let mut ends = vec![[0; 2]; pairs.len()];
        let [mut first_end, mut nodes, mut ranks] = [(); 3].map(|()| vec![0; self.nodes.len()]);
        let memory = OrderMemory {
            ends: &mut ends,
            first_end: &mut first_end,
            nodes: &mut nodes,
            ranks: &mut ranks,
            elimination: &mut vec![Elimination::UNKNOWN; self.nodes.len()],
        };
        Ok(ask(memory.set_in_order(&pairs)))
    }

    /// The largest number of unknowns at once; none where rustc alone knows the freedoms of a member.
    ///
    /// # Errors
    /// As [`in_order`](Self::in_order).
    pub(crate) fn width(&self) -> Result<Option<usize>, String> {
        let freedoms = self.members.iter().map(|member| Some(member.freedoms.as_known()?.count()));
        let freedoms: Option<Vec<usize>> = freedoms.collect();
        let motions: Vec<usize> = self.nodes.iter().map(super::Node::motions).collect();
        self.in_order(|order| Some(order.width(&motions, &freedoms?)))
    }
}
