//! Points and ends of members of models in space as values.

use crate::model::asked::{asked_along_x, asked_along_y, asked_in_space};
use crate::model::plain::plain;
use crate::model::plane_label::{MemberEnd, PlaneEntry, PlaneLoad, PlanePoint, Tied};

/// A model whose points have three coordinates, or may have.
pub trait InSpace {}

/// A point of a model `M` in space: a connection, or a point of a rigid body.
pub struct SpacePoint<M> {
    label: PlanePoint<M>,
}

plain!(SpacePoint<M>, label);

impl<M> SpacePoint<M> {
    /// For emitted code: a place that a node ties rigidly.
    #[doc(hidden)]
    pub const fn tied(tied: Tied) -> Self {
        SpacePoint { label: PlanePoint::tied(tied) }
    }

    const fn label(self) -> PlanePoint<M> {
        self.label
    }
}

impl<M> From<SpacePoint<M>> for PlanePoint<M> {
    fn from(point: SpacePoint<M>) -> Self {
        point.label
    }
}

asked_along_y!([M] SpacePoint<M>, M);
asked_along_x!([M] SpacePoint<M>, M);
asked_in_space!([M] SpacePoint<M>, M);

/// Ends of members in space; a frame in the plane has none of these motions.
impl<M: InSpace> MemberEnd<M> {
    /// The displacement along z \[m\].
    pub const fn displacement_z(self) -> PlaneEntry<M> {
        self.as_point().displaced(3)
    }

    /// The rotation about x \[rad\], right-handed.
    pub const fn rotation_x(self) -> PlaneEntry<M> {
        self.as_point().displaced(4)
    }

    /// The rotation about y \[rad\], right-handed.
    pub const fn rotation_y(self) -> PlaneEntry<M> {
        self.as_point().displaced(5)
    }

    /// A force of 1 N along z.
    pub const fn force_z(self) -> PlaneLoad<M> {
        self.as_point().forced(3)
    }

    /// A moment of 1 N m about x, right-handed.
    pub const fn torque_x(self) -> PlaneLoad<M> {
        self.as_point().forced(4)
    }

    /// A moment of 1 N m about y, right-handed.
    pub const fn torque_y(self) -> PlaneLoad<M> {
        self.as_point().forced(5)
    }

    /// The shear force along y of the member, `Qy = Mz'` \[N\]: [`shear`](MemberEnd::shear).
    pub const fn shear_y(self) -> PlaneEntry<M> {
        self.internal_in(0, 1)
    }

    /// The shear force along z of the member, `Qz = -My'` \[N\].
    pub const fn shear_z(self) -> PlaneEntry<M> {
        self.internal_in(1, 1)
    }

    /// The bending moment about z of the member, `Mz = EI_z Θz'` [N m]: [`moment`](MemberEnd::moment).
    pub const fn moment_z(self) -> PlaneEntry<M> {
        self.internal_in(0, 2)
    }

    /// The bending moment about y of the member, `My = EI_y Θy'` [N m].
    pub const fn moment_y(self) -> PlaneEntry<M> {
        self.internal_in(1, 2)
    }

    /// The torque about x of the member, `Mx = GJ Θx'` [N m].
    pub const fn torque(self) -> PlaneEntry<M> {
        self.internal_in(2, 2)
    }
}
