//! What is drawn of a built frame: its members as they are described, however many parts they have.

use crate::element::MemberElement;
use crate::frame::dimension::Dimension;
use crate::frame::point::InFrame;
use crate::frame::structure::Framework;
use crate::model::{Handle, MemberLabel, PlanePoint, Spot, Tied};
use crate::pass::network::{
    Drawn, DrawnBody, DrawnEnd, DrawnMember, DrawnPoint, DrawnSupport, Placed, stiffest, together,
};
use mstmm_plan::Freedoms;

impl<D: Dimension, E: MemberElement<Parameter = f64>> Drawn for Framework<D, E> {
    const IS_IN_SPACE: bool = D::FREEDOMS.contains(Freedoms::Z);

    fn points(&self) -> impl Iterator<Item = DrawnPoint<InFrame, f64>> {
        self.points.iter().enumerate().map(|(index, point)| DrawnPoint {
            name: Spot::Point(index),
            position: self.places[index],
            node: point.node,
            freedoms: point.freedoms,
            label: PlanePoint::handle(Handle::in_frame(index, self.number)),
        })
    }

    fn members(&self) -> impl Iterator<Item = DrawnMember<InFrame, f64>> {
        let parts = self.first_parts.windows(2).map(|pair| pair[0]..pair[1]).enumerate();
        parts.filter(|(_, parts)| !parts.is_empty()).map(|(index, parts)| {
            let label = MemberLabel::of(Handle::in_frame(index, self.number));
            let placement = self.placement(parts.start);
            let point = |end: usize| {
                let at = |point: &Tied| point.node == placement.node_of(end);
                let here = |point: usize| at(&self.points[point]) && self.places[point] == placement.place_of(end);
                (0..self.points.len()).find(|point| here(*point)).or_else(|| self.points.iter().position(at))
            };
            let ends = [0, 1].map(|end| {
                let released = together(self, parts.clone(), |part| part.released(end));
                DrawnEnd { released, ..DrawnEnd::of(placement, label, end, point(end)) }
            });
            DrawnMember {
                name: Spot::Member(index),
                kind: self.network.kinds()[parts.start],
                freedoms: together(self, parts.clone(), |part| part.freedoms),
                axes: placement.drawn_axes(),
                bending_stiffness: stiffest(self.numbers(), parts),
                ends,
                label,
            }
        })
    }

    fn bodies(&self) -> impl Iterator<Item = DrawnBody<f64>> {
        let nodes = (0..self.sizes()[0]).map(|node| (node, self.node(node)));
        nodes.filter(|(_, (node, _))| node.has_body()).map(|(index, (node, motions))| DrawnBody {
            name: self.spot(index),
            mass: node.mass,
            inertia: node.about_z(),
            centre: (!motions.is_of_path).then_some(node.centre),
            node: index,
        })
    }

    fn supports(&self) -> impl Iterator<Item = DrawnSupport<f64>> {
        self.supports.iter().map(|(point, held, skew)| DrawnSupport {
            name: Spot::Point(*point),
            point: *point,
            position: self.places[*point],
            held: *held,
            skew: *skew,
        })
    }
}
