//! Trees that are drawn beside those of the paper: paths of all kinds.

use mstmm::prelude::*;

system! {
    /// A chain of masses between walls, with a spring and a damper in parallel.
    pub(crate) struct Chain { k: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> conn a -> spring 3 { stiffness: k } -> conn b -> mass 4 { mass: 2.0 }
        -> spring 5 { stiffness: k, damping: 1.0 } -> mass 6 { mass: 1.0 } -> free;
    fixed -> damper 7 { damping: 0.5 } -> conn a;
    fixed -> spring 8 { stiffness: k } -> mass 9 { mass: 1.0 } -> spring 10 { stiffness: k } -> conn b;
}

system! {
    /// Two beams side by side that end in one, which a hinge divides, with a lever.
    pub(crate) struct Fork { l: f64 }

    fixed -> beam 1 { length: l, bending_stiffness: 1e4, mass_per_length: 2.0 } -> conn a
          -> beam 2 { length: l, bending_stiffness: 1e4, mass_per_length: 2.0 } -> hinge 3 { stiffness_rz: 0.0 }
          -> beam 4 { length: 0.5 * l, bending_stiffness: 1e4, mass_per_length: 2.0 } -> conn b -> guided;
    free -> beam 5 { length: 0.7 * l, bending_stiffness: 1e4, mass_per_length: 2.0, shear_stiffness: 1e6, rotary_inertia: 0.01 } -> conn a;
    free -> point_mass 6 { mass: 3.0, inertia: 0.1 } -> rigid_link 7 { output_x: -0.4 * l } -> conn b;
}

system! {
    /// A shaft with two discs, held by a torsion spring.
    pub(crate) struct Shafts { l: f64 }

    fixed -> torsion_spring 1 { stiffness: 1e4 } -> inertia 2 { inertia: 0.5 } -> shaft 3 { length: l, torsional_stiffness: 1e4, inertia_per_length: 0.1 }
        -> inertia 4 { inertia: 1.0 } -> free;
}

system! {
    /// A string with a mass on a spring.
    pub(crate) struct Wire { l: f64 }

    fixed -> string 1 { length: l, tension: 100.0, mass_per_length: 0.1 } -> conn a -> string 2 { length: 0.6 * l, tension: 100.0, mass_per_length: 0.1 } -> fixed;
    conn a <- spring 3 { stiffness: 50.0 } <- mass 4 { mass: 0.2 } <- free;
}

system! {
    /// A planar path with a body aside, on a roller.
    pub(crate) struct Plane { l: f64 }

    fixed -> beam 1 { length: l, axial_stiffness: 1e6, bending_stiffness: 1e4, mass_per_length: 2.0 }
        -> body 2 { mass: 1.0, inertia_about_input: 2.0, output_x: 0.3 * l, output_y: 0.5 * l, centre_x: 0.2 * l, centre_y: 0.2 * l }
        -> beam 3 { length: l, axial_stiffness: 1e6, bending_stiffness: 1e4, mass_per_length: 2.0 } -> roller;
}

pub(crate) fn chain() -> ChainSystem {
    Chain { k: 100.0 }.build().unwrap()
}

pub(crate) fn fork() -> ForkSystem {
    Fork { l: 2.0 }.build().unwrap()
}

pub(crate) fn shafts() -> ShaftsSystem {
    Shafts { l: 1.5 }.build().unwrap()
}

pub(crate) fn wire() -> WireSystem {
    Wire { l: 1.0 }.build().unwrap()
}

pub(crate) fn plane() -> PlaneSystem {
    Plane { l: 1.0 }.build().unwrap()
}
