//! Supports of frames.

use crate::frame::assembly::{Assembly, at_node};
use crate::frame::dimension::Dimension;
use crate::frame::error::Mistake;
use crate::frame::joints::rigid;
use crate::model::{Hold, Skew, Tied};
use crate::pass::network::{self, PlacedNode, SpatialEnd};
use mstmm_plan::Freedoms;

impl<D: Dimension> Assembly<'_, D> {
    /// A support holds the node of its point. A second one on a body holds another place of it, by a rigid joint with the ground.
    pub(super) fn hold(&mut self, point: usize) {
        let hold = match self.frame.points[point].holds.as_slice() {
            [] => return,
            [hold] => *hold,
            _ => return self.fail(self.point_name(point), Mistake::HeldTwice),
        };
        let Tied { node, .. } = self.points[point];
        let place = self.place(point);
        let is_second = (0..point).any(|other| self.points[other].node == node && self.points[other].hold.is_some());
        if !hold.has_direction {
            return self.fail(self.point_name(point), Mistake::NoWay);
        }
        if hold.skew.is_some_and(|skew| !network::is_direction(*skew.direction())) {
            return self.fail(self.point_name(point), Mistake::Direction);
        }
        let held = match hold.skew {
            None => hold.freedoms,
            // across a direction it is held, or along it
            Some(Skew::Along(_)) => {
                hold.freedoms.union(Freedoms::DISPLACEMENTS.without(Freedoms::X).intersection(D::FREEDOMS))
            }
            Some(Skew::Normal(_)) => hold.freedoms.union(Freedoms::X),
        };
        let holding = if is_second {
            let name = self.point_name(point);
            let ground = self.add_node(PlacedNode::at(place).held(Freedoms::SPACE), name.clone(), false);
            let axis = hold.skew.map_or([1.0, 0.0, 0.0], |skew| *skew.direction());
            let of_body = SpatialEnd { place: Some(place), ..at_node(node) };
            let ends = [at_node(ground), of_body].map(|end| SpatialEnd { along: Some(axis), ..end });
            let failed = self.join(&name, ends, &rigid(held)).err();
            failed.into_iter().for_each(|mistake| self.fail(name.clone(), mistake));
            ground
        } else {
            let own = &mut self.nodes[node];
            (own.held, own.skew) = (hold.freedoms, hold.skew);
            node
        };
        let skewed =
            if hold.skew.is_some() { Freedoms::DISPLACEMENTS.intersection(D::FREEDOMS) } else { Freedoms::NONE };
        self.points[point].hold = Some(Hold { node: holding, freedoms: hold.freedoms.union(skewed) });
    }
}
