//! Where a load acts, as drawings show it.

use crate::model::label::{Acting, Label, Load, Point, Spread};
use crate::model::plane_label::{MemberLabel, PlaneActing, PlaneLoad, PlanePoint, Site, SpreadLoad};
use mstmm_plan::{Coordinate, Freedoms};

/// The freedom of a place among all.
fn freedom(place: usize) -> Freedoms {
    Freedoms::EACH.get(place).copied().unwrap_or(Freedoms::NONE)
}

impl Site {
    /// Whether it is the place of another one: of a place that a node ties by node and place.
    fn is_at(self, other: Site) -> bool {
        match (self, other) {
            (Site::Tied(one), Site::Tied(other)) => (one.node, one.place) == (other.node, other.place),
            _ => self == other,
        }
    }
}

impl<M> PlaneLoad<M> {
    /// The freedom in which the load is a force or a moment at a point; none where it acts elsewhere or is none, such as a motion of a support.
    ///
    /// ```
    /// use mstmm_core::{Freedoms, InSpace, PlanePoint};
    ///
    /// struct Any;
    /// impl InSpace for Any {}
    /// let [one, other] = [0, 1].map(PlanePoint::<Any>::node);
    /// assert_eq!(one.force_x().at_point(one), Some(Freedoms::X));
    /// assert_eq!(one.torque_z().at_point(one), Some(Freedoms::RZ));
    /// assert!(one.force_x().at_point(other).is_none() && one.motion_x().at_point(one).is_none());
    /// ```
    pub fn at_point(self, point: PlanePoint<M>) -> Option<Freedoms> {
        match self.acting {
            PlaneActing::Force(site, axis) => site.is_at(point.site).then(|| freedom(axis)),
            PlaneActing::Motion(..) | PlaneActing::Dislocation(..) | PlaneActing::Spread(_) => None,
        }
    }

    /// The freedom along which the load acts all along a member, and its sign there: that of an acceleration of the ground is -1. None where it does not.
    ///
    /// ```
    /// use mstmm_core::{Freedoms, MemberLabel, PlaneLoad};
    ///
    /// let member = MemberLabel::<(), ()>::member(2);
    /// assert_eq!(PlaneLoad::self_weight_y().along_member(member), Some((Freedoms::Y, 1.0)));
    /// ```
    pub fn along_member(self, member: MemberLabel<M, ()>) -> Option<(Freedoms, f64)> {
        let PlaneActing::Spread(SpreadLoad { member: own, axis, is_inertia }) = self.acting else { return None };
        let is_there = own.is_none_or(|own| own == member.handle());
        is_there.then(|| (freedom(axis), if is_inertia { -1.0 } else { 1.0 }))
    }

    /// Whether the load is an acceleration [m/s²] of all masses, and no force per length [N/m].
    pub fn is_acceleration(self) -> bool {
        matches!(self.acting, PlaneActing::Spread(SpreadLoad { member: None, .. }))
    }
}

impl<M> Load<M> {
    /// The freedom in which the load is a force or a moment at a point; none where it acts elsewhere, or along elements.
    ///
    /// ```
    /// use mstmm_core::{Freedoms, Label};
    ///
    /// let beam = Label::<(), ()>::new(1, 0);
    /// assert_eq!(beam.output().force().at_point(beam.output()), Some(Freedoms::Y));
    /// assert!(beam.output().torque().at_point(beam.input()).is_none());
    /// ```
    pub fn at_point(self, point: Point<M>) -> Option<Freedoms> {
        match self.acting {
            Acting::At(step, Coordinate::Q) if step == point.step => Some(Freedoms::Y),
            Acting::At(step, Coordinate::M) if step == point.step => Some(Freedoms::RZ),
            Acting::At(..) | Acting::Spread(_) => None,
        }
    }

    /// The freedom along which the load acts all along an element, and its sign there: that of an acceleration of the ground is -1. None where it does not.
    ///
    /// ```
    /// use mstmm_core::{Freedoms, Label, Load};
    ///
    /// let beam = Label::<(), ()>::new(1, 0);
    /// assert_eq!(Load::self_weight().along_element(beam), Some((Freedoms::Y, 1.0)));
    /// ```
    pub fn along_element(self, element: Label<M, ()>) -> Option<(Freedoms, f64)> {
        match self.acting {
            Acting::Spread(Spread::Along(step)) => (step == element.step).then_some((Freedoms::Y, 1.0)),
            Acting::Spread(Spread::Weight) => Some((Freedoms::Y, 1.0)),
            Acting::Spread(Spread::Inertia(axis)) => Some((freedom(axis), -1.0)),
            Acting::At(..) => None,
        }
    }

    /// Whether the load is an acceleration [m/s²] of all masses, and no force per length [N/m].
    pub fn is_acceleration(self) -> bool {
        matches!(self.acting, Acting::Spread(Spread::Weight | Spread::Inertia(_)))
    }
}
