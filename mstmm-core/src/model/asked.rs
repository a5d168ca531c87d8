//! What points are asked for, and what acts on them: declarations for points of all kinds.

/// What is asked about a point and what acts on it, as far as it has the motion: by the place of that among the freedoms.
macro_rules! asked {
    ([$($generics:tt)*] $type:ty, $model:ty: $($(#[$doc:meta])* $name:ident -> $kind:ident = $of:ident($place:literal);)*) => {
        impl<$($generics)*> $type {
            $(
                $(#[$doc])*
                pub const fn $name(self) -> $crate::model::$kind<$model> {
                    self.label().$of($place)
                }
            )*
        }
    };
}

/// What points of all dimensions have.
macro_rules! asked_along_y {
    ([$($generics:tt)*] $type:ty, $model:ty) => {
        $crate::model::asked::asked! {
            [$($generics)*] $type, $model:
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
    };
}

/// What points with two coordinates and more have.
macro_rules! asked_along_x {
    ([$($generics:tt)*] $type:ty, $model:ty) => {
        $crate::model::asked::asked! {
            [$($generics)*] $type, $model:
            /// The displacement along x \[m\].
            displacement_x -> PlaneEntry = displaced(0);
            /// The force of the support along x on the point \[N\].
            reaction_x -> PlaneEntry = held(0);
            /// A force of 1 N along x.
            force_x -> PlaneLoad = forced(0);
            /// A motion of 1 m of the support along x, which takes with it what it holds.
            motion_x -> PlaneLoad = shaken(0);
        }
    };
}

/// What points of the plane and of lines were asked by other names.
#[cfg(feature = "std")]
macro_rules! asked_in_plane {
    ([$($generics:tt)*] $type:ty, $model:ty) => {
        $crate::model::asked::asked! {
            [$($generics)*] $type, $model:
            /// The moment of the support on the point [N m]: [`reaction_torque_z`](Self::reaction_torque_z).
            reaction_z -> PlaneEntry = held(2);
            /// A rotation of 1 rad of the support about the point: [`motion_rotation_z`](Self::motion_rotation_z).
            motion_z -> PlaneLoad = shaken(2);
        }
    };
}

/// What points in space have besides.
macro_rules! asked_in_space {
    ([$($generics:tt)*] $type:ty, $model:ty) => {
        $crate::model::asked::asked! {
            [$($generics)*] $type, $model:
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
    };
}

pub(crate) use asked;
#[cfg(feature = "std")]
pub(crate) use asked_in_plane;
pub(crate) use {asked_along_x, asked_along_y, asked_in_space};
