//! The skeleton as text: its size, its loops and its nodes in order. The documentation of the built system shows it.

use super::Skeleton;
use crate::keywords::FREEDOMS;
use mstmm_plan::{Freedoms, NetworkOrder};
use std::fmt::{Display, Formatter, Result};

impl Display for Skeleton<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (nodes, members) = (self.nodes.len(), self.members.len());
        write!(f, "# Size\n\n```text\nnodes {nodes}, members {members}")?;
        match (self.width().ok().flatten(), self.overall()) {
            (Some(width), None) => writeln!(f, ", unknowns at once {width}")?,
            (Some(width), Some(overall)) => {
                writeln!(f, ", unknowns at once {width}")?;
                match overall.cuts.as_slice() {
                    [] => writeln!(f, "closed loops 0")?,
                    cuts => writeln!(f, "closed loops {}, cut at {}", cuts.len(), cuts.join(", "))?,
                }
                writeln!(f, "unknowns of the overall transfer equation {}, root {}", overall.unknowns, overall.root)?;
            }
            _ => writeln!(f, "\nthe rest, and each ? below, depends on elements that only the compiler knows")?,
        }
        writeln!(f, "```\n\n# Nodes\n")?;
        writeln!(
            f,
            "In the order of their elimination, with the motions that supports leave, the members that begin there,"
        )?;
        writeln!(
            f,
            "and the number of variables that are left behind each. Points at rest leave with their members.\n\n```text"
        )?;
        let lines = self.in_order(|order| self.lines(order)).unwrap_or_default();
        lines.iter().try_for_each(|line| writeln!(f, "{}", line.trim_end()))?;
        write!(f, "```")
    }
}

impl Skeleton<'_> {
    /// A line per node; what depends on elements that only the compiler knows is a question mark.
    fn lines(&self, order: NetworkOrder<'_>) -> Vec<String> {
        let longest = self.nodes.iter().map(|node| node.name.chars().count()).max().unwrap_or(0);
        let mut left = Some(0);
        let line = |&node: &usize| {
            let mut begin = Vec::new();
            for &end in order.incidence.ends(node) {
                let member = &self.members[end / 2];
                let count = member.freedoms.as_known().map(Freedoms::count);
                if order.is_first_at(end, node) {
                    left = left.zip(count).map(|(left, count)| left + 2 * count);
                    begin.push(member.name.as_str());
                }
                left = left.zip(count).map(|(left, count)| left - count);
            }
            let number = left.map_or_else(|| "?".to_owned(), |left| left.to_string());
            format!("{:longest$}   {:8} {number:>3}   {}", self.nodes[node].name, self.moves(node), begin.join(", "))
        };
        order.nodes.iter().map(line).collect()
    }

    /// The motions of a node.
    fn moves(&self, node: usize) -> String {
        let node = &self.nodes[node];
        let Some([_, held]) = node.known() else { return "?".to_owned() };
        let free = node.all.without(held);
        let of_axes = if node.skew.is_some() { free.intersection(Freedoms::ROTATIONS) } else { free };
        let skewed = node.skew.map(|skew| if skew.is_normal { "across" } else { "along" });
        let own = FREEDOMS.iter().filter(|(_, freedom)| of_axes.contains(*freedom)).map(|(name, _)| *name);
        let names: Vec<&str> = skewed.into_iter().chain(own).collect();
        if names.is_empty() { "held".to_owned() } else { names.join(" ") }
    }
}
