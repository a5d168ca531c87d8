//! Plane frames that several benchmarks measure.

use mstmm::prelude::*;

system! {
    /// A portal of steel, clamped.
    #[derive(Debug)]
    pub struct Plain {
        /// Axial stiffness [N].
        pub ea: f64,
        /// Bending stiffness [N m²].
        pub ei: f64,
        /// Mass per length [kg/m].
        pub m: f64,
    }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, 4.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (6.0, 4.0)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (6.0, 0.0);
}

system! {
    /// A portal with a hinge in a corner, a braced foot and a machine on its girder.
    #[derive(Debug)]
    pub struct Workshop {
        /// Axial stiffness [N].
        pub ea: f64,
        /// Bending stiffness [N m²].
        pub ei: f64,
        /// Mass per length [kg/m].
        pub m: f64,
        /// Stiffness of the brace [N/m].
        pub brace: f64,
        /// Mass of the machine [kg].
        pub machine: f64,
    }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, 3.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn girder at (2.0, 3.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (4.0, 3.0)
        -> pin 4 {}
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn foot at (4.0, 0.0)
        <- pinned;
    conn girder -> rigid_body 6 { mass: machine, inertia: 40.0, centre: (2.0, 3.4) };
    conn b -> spring 7 { stiffness: brace } -> conn foot;
}
