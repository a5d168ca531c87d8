//! The plane structures of tests/data/frames.json as sketches, and their numbers.

use mstmm::prelude::*;

system! {
    /// A pin-ended cross in its plane.
    pub(crate) struct NafemsCross { pub(crate) length: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    pinned at (length, 0.0)
        <- beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- conn c at (0.0, 0.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pinned at (0.0, length);
    pinned at (-length, 0.0)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- conn c
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pinned at (0.0, -length);
}

system! {
    /// A free square frame.
    pub(crate) struct NafemsSquare { pub(crate) side: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    conn a at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (side, 0.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (side, side)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn d at (0.0, side)
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a;
}

system! {
    /// Two beams at a right angle.
    pub(crate) struct LFrame { pub(crate) height: f64, pub(crate) width: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn corner at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> free at (width, height);
}

system! {
    /// A portal with clamped feet.
    pub(crate) struct Portal { pub(crate) side: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, side)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (side, side)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (side, 0.0);
}

system! {
    /// Two leaning legs with a hinge at the top.
    pub(crate) struct HingedFrame { pub(crate) height: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn top at (0.75 * height, height)
        <- pin 2 {} <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        <- pinned at (1.5 * height, 0.0);
}

system! {
    /// A beam whose right end rolls on an incline.
    pub(crate) struct InclinedRoller { pub(crate) length: f64, pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> roller at (length, 0.0) along (12.0, 5.0);
}

system! {
    /// A rigid body with three ports: two beams and a spring.
    pub(crate) struct ThreePorts { pub(crate) ea: f64, pub(crate) ei: f64, pub(crate) m: f64, pub(crate) stiffness: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn a at (1.0, 0.0) -> rigid_body 2 { mass: 4.0, inertia: 0.2, centre: (1.2, 0.05) } -> conn b at (1.4, 0.3)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> free at (2.4, 0.9);
    rigid_body 2 <- conn c at (1.2, -0.2) <- along (0.0, 1.0) <- spring 4 { stiffness } <- fixed;
}

system! {
    /// Two strings that stretch, from the ground to a mass between them: across and along themselves.
    pub(crate) struct StringAndRod { pub(crate) left: f64, pub(crate) right: f64, pub(crate) tension: f64, pub(crate) ea: f64, pub(crate) m: f64, pub(crate) mass: f64 }

    conn c at (left, 0.0) -> point_mass 1 { mass };
    conn c <- along (0.0, 1.0) <- string 2 { length: left, tension, mass_per_length: m } <- fixed;
    conn c <- along (0.0, 1.0) <- string 3 { length: right, tension, mass_per_length: m } <- fixed;
    conn c <- along (1.0, 0.0) <- rod 4 { length: left, axial_stiffness: ea, mass_per_length: m } <- fixed;
    conn c <- along (1.0, 0.0) <- rod 5 { length: right, axial_stiffness: ea, mass_per_length: m } <- fixed;
}
