//! Masses of frames: on the motions of paths, and at points in a direction or about an axis.

use crate::frame::assembly::{Assembly, at_node};
use crate::frame::bodies::is_mass;
use crate::frame::dimension::Dimension;
use crate::frame::ends::{End, Seat};
use crate::frame::error::Mistake;
use crate::frame::joints::rigid;
use crate::pass::network::{PlacedNode, SpatialEnd};
use mstmm_plan::Freedoms;
use std::string::String;

impl<D: Dimension> Assembly<'_, D> {
    /// A mass on the motion of a path, or on that of a point in a direction.
    pub(super) fn add_mass(&mut self, on: &End<D>, mass: f64) {
        let part = String::from("a mass");
        if !is_mass(mass) {
            return self.fail(part, Mistake::Mass);
        }
        match on.seat {
            Seat::Ground => self.fail(part, Mistake::NoPlace),
            Seat::Path(handle) => match self.frame.own(handle, self.paths.len()) {
                Some(path) => self.add_to_node(self.paths[path], mass),
                None => self.fail(part, Mistake::OtherFrame),
            },
            Seat::Point(handle) => {
                let Some(point) = self.frame.own(handle, self.frame.points.len()) else {
                    return self.fail(part, Mistake::OtherFrame);
                };
                let arm = on.place.is_some_and(|place| D::in_space(place) != self.place(point));
                let brought = if on.turns { Freedoms::ROTATIONS } else { Freedoms::DISPLACEMENTS };
                self.bring(point, if arm { brought.union(Freedoms::ROTATIONS) } else { brought });
                let (node, place) = (self.points[point].node, on.place.map_or(self.place(point), D::in_space));
                let Some(direction) = on.along else {
                    self.nodes[node] = self.nodes[node].and_body(mass, [0.0; 6], place);
                    return;
                };
                // the motion of the mass is that along x of a node of its own, or about z
                let (motion, own_axis, tied) = if on.turns {
                    (Freedoms::RZ, [0.0, 0.0, 1.0], Freedoms::RX)
                } else {
                    (Freedoms::X, [1.0, 0.0, 0.0], Freedoms::X)
                };
                let held = Freedoms::SPACE.without(motion);
                let own = self.add_node(PlacedNode::at(place).held(held), part.clone(), true);
                self.add_to_node(own, mass);
                let of_node = SpatialEnd { place: Some(place), along: Some(direction), ..at_node(node) };
                let ends = [SpatialEnd { along: Some(own_axis), ..at_node(own) }, of_node];
                let failed = self.join(&part, ends, &rigid(tied)).err();
                failed.into_iter().for_each(|mistake| self.fail(part.clone(), mistake));
            }
        }
    }

    /// Adds a mass to the motion of a path.
    fn add_to_node(&mut self, node: usize, mass: f64) {
        let turns = !self.nodes[node].held.contains(Freedoms::RZ);
        let own = self.nodes[node];
        let inertia = if turns { [0.0, 0.0, mass, 0.0, 0.0, 0.0] } else { [0.0; 6] };
        self.nodes[node] = own.and_body(if turns { 0.0 } else { mass }, inertia, own.position);
    }
}
