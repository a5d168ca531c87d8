//! Whether a system bears axial forces.

use crate::element::{Exact, MemberNumbers};
use crate::model::MemberPlane;
use crate::pass::characteristic::System;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visitor};
use mstmm_plan::{Freedoms, Space, Support};

/// Whether a member of a system bears an axial force.
pub(crate) fn bears_axial_force<Y: System + ?Sized>(system: &Y) -> bool {
    let mut forces = AxialForces { are_there: false };
    system.name_parts(&mut forces);
    forces.are_there
}

/// A visitor that looks for axial forces.
struct AxialForces {
    are_there: bool,
}

impl AxialForces {
    fn look_at(&mut self, numbers: &MemberNumbers) {
        let force = match numbers.parted().0 {
            MemberNumbers::Beam(beam) => beam.axial_force,
            MemberNumbers::Body(body) => body.axial_force,
            MemberNumbers::Tapered(beam) if beam.rotation_speed == [0.0; 2] => beam.axial_force,
            // a rotating blade is stiffened by its own forces
            MemberNumbers::Tapered(beam) => beam.rotation_speed,
            _ => [0.0; 2],
        };
        self.are_there |= force != [0.0; 2];
    }
}

impl Visitor for AxialForces {
    fn tip(&mut self, _: usize, _: Support) {}

    fn element(&mut self, _: usize, _: usize, _: Space, numbers: &MemberNumbers) {
        self.look_at(numbers);
    }

    fn connection(&mut self, _: usize, _: &[usize], _: Option<Space>) {}

    fn root(&mut self, _: usize, _: Support) {}

    fn member(
        &mut self,
        _: (usize, Freedoms, MemberPlane<Exact>),
        numbers: &MemberNumbers,
        _: &[MemberEnd; 2],
        _: usize,
    ) {
        self.look_at(numbers);
    }

    fn body(&mut self, _: &NodeNumbers, _: Exact, _: &[Exact; 6], _: [Exact; 3]) {}

    fn leave(&mut self, _: usize) {}
}
