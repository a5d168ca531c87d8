//! What keeps damping in proportion to inertias and stiffnesses from a system: axial forces, and damping that it has.

use crate::element::{Exact, MemberNumbers};
use crate::model::MemberPlane;
use crate::pass::characteristic::System;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visitor};
use mstmm_plan::{Freedoms, Space, Support};

/// What a system has that damping in proportion does not go with.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Obstacles {
    /// Whether a member bears an axial force, a stiffness that nothing damps.
    pub(crate) axial_force: bool,
    /// Whether something is damped already.
    pub(crate) damping: bool,
}

impl Obstacles {
    /// What a system has.
    pub(crate) fn of<Y: System + ?Sized>(system: &Y) -> Self {
        let mut found = Obstacles::default();
        system.name_parts(&mut found);
        found
    }

    fn look_at(&mut self, numbers: &MemberNumbers) {
        let (undamped, damping) = numbers.parted();
        self.damping |= !damping.is_none();
        let force = match undamped {
            MemberNumbers::Beam(beam) => beam.axial_force,
            MemberNumbers::Body(body) => body.axial_force,
            MemberNumbers::Tapered(beam) if beam.rotation_speed == [0.0; 2] => beam.axial_force,
            // a rotating blade is stiffened by its own forces
            MemberNumbers::Tapered(beam) => beam.rotation_speed,
            _ => [0.0; 2],
        };
        self.axial_force |= force != [0.0; 2];
    }
}

impl Visitor for Obstacles {
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
