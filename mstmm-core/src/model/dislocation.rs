//! Dislocations: unit jumps of displacements at a section, each the load that works with an internal force.
//!
//! At rest a dislocation has the influence line of its force as its motion; at a held end it is the motion of the support. On a mode it works the internal force.

use crate::model::label::{Load, Point};
use crate::model::plane_label::{MemberEnd, PlaneActing, PlaneEntry, PlaneLoad, Quantity};
use crate::model::space_point::InSpace;
use mstmm_plan::Coordinate;

impl<M> Point<M> {
    /// A jump of 1 rad of the rotation at this point, which works with the bending moment there.
    pub const fn kink(self) -> Load<M> {
        Load::at(self, Coordinate::Theta)
    }

    /// A jump of 1 m of the deflection at this point, which works with the shear force there: where a support is before the point the motion of the support
    /// by -1 m.
    pub const fn slip(self) -> Load<M> {
        Load::at(self, Coordinate::Y)
    }
}

impl<M> MemberEnd<M> {
    /// A jump of 1 rad of the rotation between this end and its point, which works with the bending [`moment`](MemberEnd::moment).
    pub const fn kink(self) -> PlaneLoad<M> {
        self.dislocated(0, 2)
    }

    /// A jump of 1 m across the member between this end and its point, which works with the [`shear`](MemberEnd::shear) force.
    pub const fn slip(self) -> PlaneLoad<M> {
        self.dislocated(0, 1)
    }

    /// A jump of 1 m along the member between this end and its point, which works with the [`axial_force`](MemberEnd::axial_force): the member is too long by
    /// 1 m, as where it is warm.
    pub const fn stretch(self) -> PlaneLoad<M> {
        self.dislocated(0, 0)
    }
}

impl<M: InSpace> MemberEnd<M> {
    /// A jump of 1 rad about y of the member, which works with [`moment_y`](MemberEnd::moment_y).
    pub const fn kink_y(self) -> PlaneLoad<M> {
        self.dislocated(1, 2)
    }

    /// A jump of 1 m along z of the member, which works with [`shear_z`](MemberEnd::shear_z).
    pub const fn slip_z(self) -> PlaneLoad<M> {
        self.dislocated(1, 1)
    }

    /// A jump of 1 rad about the axis of the member, which works with the [`torque`](MemberEnd::torque).
    pub const fn twist(self) -> PlaneLoad<M> {
        self.dislocated(2, 2)
    }
}

impl<M> PlaneLoad<M> {
    /// The entry that the load works with; none of a load along members and of the motion of a support.
    pub(crate) const fn dual(self) -> Option<PlaneEntry<M>> {
        match self.acting {
            PlaneActing::Force(site, axis) => Some(PlaneEntry::of(Quantity::Displacement(site, axis))),
            PlaneActing::Dislocation(member, end, force) => {
                Some(PlaneEntry::of(Quantity::Internal { member, end, force }))
            }
            PlaneActing::Motion(..) | PlaneActing::Spread(_) => None,
        }
    }
}

impl<M> PlaneLoad<M> {
    /// Whether it acts along members.
    pub(crate) const fn is_spread(self) -> bool {
        matches!(self.acting, PlaneActing::Spread(_))
    }
}

impl<M> PlaneEntry<M> {
    /// The load that works with the entry; none of a reaction, which works with the motion of a support.
    pub(crate) const fn dual(self) -> Option<PlaneLoad<M>> {
        match self.quantity {
            Quantity::Displacement(site, axis) => Some(PlaneLoad::new(PlaneActing::Force(site, axis))),
            Quantity::Internal { member, end, force } => {
                Some(PlaneLoad::new(PlaneActing::Dislocation(member, end, force)))
            }
            Quantity::Reaction(..) => None,
        }
    }
}
