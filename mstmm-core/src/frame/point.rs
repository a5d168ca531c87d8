//! The points of a frame: what loads and answers are asked about.

use crate::element::CarriesLoad;
use crate::frame::dimension::{Line, Plane, Space};
use crate::model::{Handle, MemberEnd, MemberLabel, PlaneEntry, PlaneLoad, PlanePoint};
use core::fmt::{self, Debug};
use core::marker::PhantomData;

/// The points and members of frames.
#[derive(Clone, Copy, Debug)]
pub enum InFrame {}

/// A point of a frame, with a place.
pub struct Point<D> {
    pub(crate) handle: Handle,
    of: PhantomData<fn() -> D>,
}

impl<D> Clone for Point<D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for Point<D> {}

impl<D> Debug for Point<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Point").field("handle", &self.handle).finish()
    }
}

impl<D> Point<D> {
    pub(crate) fn new(handle: Handle) -> Self {
        Point { handle, of: PhantomData }
    }

    const fn label(self) -> PlanePoint<InFrame> {
        PlanePoint::handle(self.handle)
    }
}

impl<D> From<Point<D>> for PlanePoint<InFrame> {
    fn from(point: Point<D>) -> Self {
        point.label()
    }
}

/// What is asked about a point and what acts on it, as far as it has the motion: by the place of that among the freedoms.
macro_rules! asked {
    ($type:ty: $($(#[$doc:meta])* $name:ident -> $kind:ident = $of:ident($place:literal);)*) => {
        impl $type {
            $(
                $(#[$doc])*
                pub const fn $name(self) -> $kind<InFrame> {
                    self.label().$of($place)
                }
            )*
        }
    };
}

/// What points of all dimensions have.
macro_rules! asked_everywhere {
    ($($dimension:ty),*) => {$(
        asked! {
            Point<$dimension>:
            /// The displacement along y \[m\].
            displacement_y -> PlaneEntry = displaced(1);
            /// The rotation about z \[rad\], anticlockwise.
            rotation_z -> PlaneEntry = displaced(2);
            /// The force of the support along y on the point \[N\].
            reaction_y -> PlaneEntry = held(1);
            /// The moment of the support about z on the point [N m].
            reaction_torque_z -> PlaneEntry = held(2);
            /// A force of 1 N along y.
            force_y -> PlaneLoad = forced(1);
            /// A moment of 1 N m about z, anticlockwise.
            torque_z -> PlaneLoad = forced(2);
            /// A motion of 1 m of the support along y, which takes with it what it holds.
            motion_y -> PlaneLoad = shaken(1);
            /// A rotation of 1 rad of the support about z through the point, anticlockwise.
            motion_rotation_z -> PlaneLoad = shaken(2);
        }
    )*};
}
asked_everywhere!(Line, Plane, Space);

/// What points with two coordinates and more have.
macro_rules! asked_along_x {
    ($($dimension:ty),*) => {$(
        asked! {
            Point<$dimension>:
            /// The displacement along x \[m\].
            displacement_x -> PlaneEntry = displaced(0);
            /// The force of the support along x on the point \[N\].
            reaction_x -> PlaneEntry = held(0);
            /// A force of 1 N along x.
            force_x -> PlaneLoad = forced(0);
            /// A motion of 1 m of the support along x, which takes with it what it holds.
            motion_x -> PlaneLoad = shaken(0);
        }
    )*};
}
asked_along_x!(Plane, Space);

/// What points of the plane and of lines were asked by other names.
macro_rules! asked_in_plane {
    ($($dimension:ty),*) => {$(
        asked! {
            Point<$dimension>:
            /// The moment of the support on the point [N m]: [`reaction_torque_z`](Self::reaction_torque_z).
            reaction_z -> PlaneEntry = held(2);
            /// A rotation of 1 rad of the support about the point: [`motion_rotation_z`](Self::motion_rotation_z).
            motion_z -> PlaneLoad = shaken(2);
        }
    )*};
}
asked_in_plane!(Line, Plane);

asked! {
    Point<Space>:
    /// The displacement along z \[m\].
    displacement_z -> PlaneEntry = displaced(3);
    /// The rotation about x \[rad\], right-handed.
    rotation_x -> PlaneEntry = displaced(4);
    /// The rotation about y \[rad\], right-handed.
    rotation_y -> PlaneEntry = displaced(5);
    /// The force of the support along z on the point \[N\].
    reaction_z -> PlaneEntry = held(3);
    /// The moment of the support about x on the point [N m].
    reaction_torque_x -> PlaneEntry = held(4);
    /// The moment of the support about y on the point [N m].
    reaction_torque_y -> PlaneEntry = held(5);
    /// A force of 1 N along z.
    force_z -> PlaneLoad = forced(3);
    /// A moment of 1 N m about x, right-handed.
    torque_x -> PlaneLoad = forced(4);
    /// A moment of 1 N m about y, right-handed.
    torque_y -> PlaneLoad = forced(5);
    /// A motion of 1 m of the support along z, which takes with it what it holds.
    motion_z -> PlaneLoad = shaken(3);
    /// A rotation of 1 rad of the support about x through the point, right-handed.
    motion_rotation_x -> PlaneLoad = shaken(4);
    /// A rotation of 1 rad of the support about y through the point, right-handed.
    motion_rotation_y -> PlaneLoad = shaken(5);
}

/// Ends of members of a frame in space; in a plane structure there are none of these.
impl MemberEnd<InFrame> {
    /// The displacement along z \[m\].
    pub const fn displacement_z(self) -> PlaneEntry<InFrame> {
        self.as_point().displaced(3)
    }

    /// The rotation about x \[rad\], right-handed.
    pub const fn rotation_x(self) -> PlaneEntry<InFrame> {
        self.as_point().displaced(4)
    }

    /// The rotation about y \[rad\], right-handed.
    pub const fn rotation_y(self) -> PlaneEntry<InFrame> {
        self.as_point().displaced(5)
    }

    /// A force of 1 N along z.
    pub const fn force_z(self) -> PlaneLoad<InFrame> {
        self.as_point().forced(3)
    }

    /// A moment of 1 N m about x, right-handed.
    pub const fn torque_x(self) -> PlaneLoad<InFrame> {
        self.as_point().forced(4)
    }

    /// A moment of 1 N m about y, right-handed.
    pub const fn torque_y(self) -> PlaneLoad<InFrame> {
        self.as_point().forced(5)
    }

    /// The shear force along y of the member, `Qy = Mz'` \[N\]: [`shear`](MemberEnd::shear).
    pub const fn shear_y(self) -> PlaneEntry<InFrame> {
        self.internal_in(0, 1)
    }

    /// The shear force along z of the member, `Qz = -My'` \[N\].
    pub const fn shear_z(self) -> PlaneEntry<InFrame> {
        self.internal_in(1, 1)
    }

    /// The bending moment about z of the member, `Mz = EI_z Θz'` [N m]: [`moment`](MemberEnd::moment).
    pub const fn moment_z(self) -> PlaneEntry<InFrame> {
        self.internal_in(0, 2)
    }

    /// The bending moment about y of the member, `My = EI_y Θy'` [N m].
    pub const fn moment_y(self) -> PlaneEntry<InFrame> {
        self.internal_in(1, 2)
    }

    /// The torque about x of the member, `Mx = GJ Θx'` [N m].
    pub const fn torque(self) -> PlaneEntry<InFrame> {
        self.internal_in(2, 2)
    }
}

impl<K: CarriesLoad> MemberLabel<InFrame, K> {
    /// A load of 1 N/m along z all along the member, in space.
    pub const fn uniform_load_z(self) -> PlaneLoad<InFrame> {
        PlaneLoad::along(self.handle(), 3)
    }
}
