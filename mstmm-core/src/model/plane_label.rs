//! Points of plane models as values: a point of another model does not compile.

use crate::model::direction::Direction;
use crate::model::plain::plain;
use core::marker::PhantomData;
use mstmm_plan::Freedoms;

/// A point of a plane model `M`: a connection, or a point of a rigid body.
pub struct PlanePoint<M> {
    pub(crate) site: Site,
    of: PhantomData<fn() -> M>,
}

/// The number of a point or of a member of a list, a sketch or a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Handle {
    pub(crate) index: usize,
    /// The number of its frame; zero of a list and of a sketch.
    pub(crate) frame: u32,
}

impl Handle {
    /// What has an index in a list or a sketch.
    pub(crate) const fn listed(index: usize) -> Self {
        Handle { index, frame: 0 }
    }

    /// What has an index in a frame.
    #[cfg(feature = "std")]
    pub(crate) const fn in_frame(index: usize, frame: u32) -> Self {
        Handle { index, frame }
    }
}

/// The end of a member of a plane model `M`.
pub struct MemberEnd<M> {
    pub(crate) member: Handle,
    pub(crate) end: usize,
    of: PhantomData<fn() -> M>,
}

/// The label of a member of type `E` of a plane model `M`, such as `Portal::beam_1`.
pub struct MemberLabel<M, E> {
    member: Handle,
    of: PhantomData<fn() -> (M, E)>,
}

/// A harmonic load of 1 on a plane model: a force or a moment at a point, a motion of its support, a load all along a member, or the weight
/// of all of them.
pub struct PlaneLoad<M> {
    pub(crate) acting: PlaneActing,
    of: PhantomData<fn() -> M>,
}

/// Where a load acts, and along which axis: x, y or the rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlaneActing {
    /// A force or a moment at a point.
    Force(Site, usize),
    /// A motion of the support of a point.
    Motion(Site, usize),
    /// A dislocation between the end of a member and its point, which works with an internal force.
    Dislocation(Handle, usize, usize),
    /// A load along members.
    Spread(SpreadLoad),
}

/// A load along members, in x or in y.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SpreadLoad {
    /// The member that has 1 N/m of it; all members and bodies have their mass per length, and their mass, where there is none.
    pub(crate) member: Option<Handle>,
    /// The axis, x or y.
    pub(crate) axis: usize,
    /// Whether it is the inertia of all where the ground has an acceleration: the weight with the other sign.
    pub(crate) is_inertia: bool,
}

/// What a motion of a plane model is asked for.
pub struct PlaneEntry<M> {
    pub(crate) quantity: Quantity,
    of: PhantomData<fn() -> M>,
}

/// Where a point of a plane model is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Site {
    /// The point of a list or of a frame.
    Point(Handle),
    /// At a place that a node ties rigidly.
    Tied(Tied),
    /// Where a member ends.
    End { member: Handle, end: usize },
}

/// A place that a node ties rigidly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tied {
    /// Index of the node.
    pub node: usize,
    /// Index of the place; none at that of the node.
    pub place: Option<usize>,
    /// The freedoms that elements bring there.
    pub freedoms: Freedoms,
    /// The support there.
    pub hold: Option<Hold>,
}

/// What a support holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hold {
    /// Index of the node.
    pub node: usize,
    /// The freedoms in which it may hold that; along a direction it does not.
    pub freedoms: Freedoms,
}

/// A quantity of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// The displacement of a point along x or y, or its rotation.
    Displacement(Site, usize),
    /// A force of the support of a point along x or y, or its moment.
    Reaction(Site, usize),
    /// An internal force at the end of a member: axial, shear, moment; in space these of its first, its second and its third part.
    Internal { member: Handle, end: usize, force: usize },
}

impl Tied {
    /// A node of a list, which brings all freedoms and may be held in each.
    pub(crate) const fn node(node: usize) -> Self {
        let hold = Hold { node, freedoms: Freedoms::PLANE };
        Tied { node, place: None, freedoms: Freedoms::PLANE, hold: Some(hold) }
    }
}

impl<M> PlanePoint<M> {
    const fn of(site: Site) -> Self {
        PlanePoint { site, of: PhantomData }
    }

    /// A node of a list, by its index.
    pub const fn node(node: usize) -> Self {
        PlanePoint::of(Site::Point(Handle::listed(node)))
    }

    /// The point of a frame.
    #[cfg(feature = "std")]
    pub(crate) const fn handle(point: Handle) -> Self {
        PlanePoint::of(Site::Point(point))
    }

    /// For emitted code: a place that a node ties rigidly.
    #[doc(hidden)]
    pub const fn tied(tied: Tied) -> Self {
        PlanePoint::of(Site::Tied(tied))
    }
}

impl<M> MemberEnd<M> {
    const fn point(self) -> PlanePoint<M> {
        PlanePoint::of(Site::End { member: self.member, end: self.end })
    }

    const fn internal(self, force: usize) -> PlaneEntry<M> {
        PlaneEntry::of(Quantity::Internal { member: self.member, end: self.end, force })
    }

    /// The axial force \[N\], tension positive.
    pub const fn axial_force(self) -> PlaneEntry<M> {
        self.internal(0)
    }

    /// The shear force `Q = M'` \[N\], with x from the input end to the output end.
    pub const fn shear(self) -> PlaneEntry<M> {
        self.internal(1)
    }

    /// The bending moment `M = EI Θ'` [N m].
    pub const fn moment(self) -> PlaneEntry<M> {
        self.internal(2)
    }
}

/// The motions of a point and the loads on it, in global axes.
macro_rules! in_global_axes {
    ($type:ident, $self:ident => $site:expr) => {
        impl<M> $type<M> {
            /// The displacement along x \[m\].
            pub const fn displacement_x($self) -> PlaneEntry<M> {
                PlaneEntry::of(Quantity::Displacement($site, 0))
            }

            /// The displacement along y \[m\].
            pub const fn displacement_y($self) -> PlaneEntry<M> {
                PlaneEntry::of(Quantity::Displacement($site, 1))
            }

            /// The rotation \[rad\], anticlockwise.
            pub const fn rotation_z($self) -> PlaneEntry<M> {
                PlaneEntry::of(Quantity::Displacement($site, 2))
            }

            /// A force of 1 N along x.
            pub const fn force_x($self) -> PlaneLoad<M> {
                PlaneLoad::new(PlaneActing::Force($site, 0))
            }

            /// A force of 1 N along y.
            pub const fn force_y($self) -> PlaneLoad<M> {
                PlaneLoad::new(PlaneActing::Force($site, 1))
            }

            /// A moment of 1 N m, anticlockwise.
            pub const fn torque_z($self) -> PlaneLoad<M> {
                PlaneLoad::new(PlaneActing::Force($site, 2))
            }
        }
    };
}

/// The freedoms of points, by their places among all.
impl<M> PlanePoint<M> {
    /// A displacement or a rotation.
    pub(crate) const fn displaced(self, place: usize) -> PlaneEntry<M> {
        PlaneEntry::of(Quantity::Displacement(self.site, place))
    }

    /// A force or a moment on it.
    pub(crate) const fn forced(self, place: usize) -> PlaneLoad<M> {
        PlaneLoad::new(PlaneActing::Force(self.site, place))
    }

    /// A force or a moment of its support.
    pub(crate) const fn held(self, place: usize) -> PlaneEntry<M> {
        self.reaction(place)
    }

    /// A motion of its support.
    pub(crate) const fn shaken(self, place: usize) -> PlaneLoad<M> {
        self.motion(place)
    }
}

impl<M> MemberEnd<M> {
    /// A dislocation that works with an internal force of a part of a member.
    pub(crate) const fn dislocated(self, part: usize, force: usize) -> PlaneLoad<M> {
        PlaneLoad::new(PlaneActing::Dislocation(self.member, self.end, 3 * part + force))
    }

    /// The end as a point.
    pub(crate) const fn as_point(self) -> PlanePoint<M> {
        self.point()
    }

    /// An internal force of a part of a member in space: axial, shear, moment.
    pub(crate) const fn internal_in(self, part: usize, force: usize) -> PlaneEntry<M> {
        self.internal(3 * part + force)
    }
}

impl<M> From<MemberEnd<M>> for PlanePoint<M> {
    fn from(end: MemberEnd<M>) -> Self {
        end.point()
    }
}

in_global_axes!(PlanePoint, self => self.site);
in_global_axes!(MemberEnd, self => self.point().site);

impl<M> PlanePoint<M> {
    const fn reaction(self, axis: usize) -> PlaneEntry<M> {
        PlaneEntry::of(Quantity::Reaction(self.site, axis))
    }

    const fn motion(self, axis: usize) -> PlaneLoad<M> {
        PlaneLoad::new(PlaneActing::Motion(self.site, axis))
    }

    /// A motion of 1 m of the support along x, which takes with it what it holds.
    pub const fn motion_x(self) -> PlaneLoad<M> {
        self.motion(0)
    }

    /// A motion of 1 m of the support along y, which takes with it what it holds.
    pub const fn motion_y(self) -> PlaneLoad<M> {
        self.motion(1)
    }

    /// A rotation of 1 rad of the support about the point, anticlockwise.
    pub const fn motion_z(self) -> PlaneLoad<M> {
        self.motion(2)
    }

    /// The force of the support along x on the point \[N\].
    pub const fn reaction_x(self) -> PlaneEntry<M> {
        self.reaction(0)
    }

    /// The force of the support along y on the point \[N\].
    pub const fn reaction_y(self) -> PlaneEntry<M> {
        self.reaction(1)
    }

    /// The moment of the support on the point [N m].
    pub const fn reaction_z(self) -> PlaneEntry<M> {
        self.reaction(2)
    }
}

impl<M> PlaneEntry<M> {
    pub(crate) const fn of(quantity: Quantity) -> Self {
        PlaneEntry { quantity, of: PhantomData }
    }
}

impl<M> PlaneLoad<M> {
    pub(crate) const fn new(acting: PlaneActing) -> Self {
        PlaneLoad { acting, of: PhantomData }
    }

    /// A load of 1 per length along a member.
    pub(crate) const fn along(member: Handle, axis: usize) -> Self {
        PlaneLoad::new(PlaneActing::Spread(SpreadLoad { member: Some(member), axis, is_inertia: false }))
    }

    /// The weight of the whole model along an axis.
    pub(crate) const fn weight(axis: usize) -> Self {
        PlaneLoad::new(PlaneActing::Spread(SpreadLoad { member: None, axis, is_inertia: false }))
    }

    /// An acceleration of 1 m/s² of the ground, to which all supports belong. Entries are relative to the ground, as whose part a mass m bears the force `-m a`;
    /// [`absolute`](crate::ModalResponse::absolute) adds the motion of the ground. A support that moves beside others is
    /// [`motion_x`](PlanePoint::motion_x).
    pub const fn base_acceleration(direction: Direction<M>) -> Self {
        let axis = direction.axis;
        PlaneLoad::new(PlaneActing::Spread(SpreadLoad { member: None, axis, is_inertia: true }))
    }

    /// The weight of the whole model under an acceleration of 1 m/s² along x: each member is loaded by its mass per length, each rigid body
    /// and point mass in its mass centre.
    pub const fn self_weight_x() -> Self {
        PlaneLoad::weight(0)
    }

    /// The weight of the whole model under an acceleration of 1 m/s² along z, as [`self_weight_x`](PlaneLoad::self_weight_x): in space.
    pub const fn self_weight_z() -> Self {
        PlaneLoad::weight(3)
    }

    /// The weight of the whole model under an acceleration of 1 m/s² along y, as [`self_weight_x`](PlaneLoad::self_weight_x); on the earth,
    /// with y upwards, responses are -9.81 times as large.
    pub const fn self_weight_y() -> Self {
        PlaneLoad::weight(1)
    }
}

impl<M, E> MemberLabel<M, E> {
    /// The number of the member.
    pub(crate) const fn handle(self) -> Handle {
        self.member
    }

    /// The member of an index, of a list.
    pub const fn member(member: usize) -> Self {
        MemberLabel::of(Handle::listed(member))
    }

    /// The member of a number.
    pub(crate) const fn of(member: Handle) -> Self {
        MemberLabel { member, of: PhantomData }
    }

    /// The label without the type of its member, so that those of members of several types stand in one list.
    pub const fn of_any_type(self) -> MemberLabel<M, ()> {
        MemberLabel::of(self.member)
    }

    /// The input end.
    pub const fn input(self) -> MemberEnd<M> {
        MemberEnd { member: self.member, end: 0, of: PhantomData }
    }

    /// The output end.
    pub const fn output(self) -> MemberEnd<M> {
        MemberEnd { member: self.member, end: 1, of: PhantomData }
    }
}

plain!(PlanePoint<M>, site);
plain!(MemberEnd<M>, member, end);
plain!(MemberLabel<M, E>, member);
plain!(PlaneLoad<M>, acting);
plain!(PlaneEntry<M>, quantity);
