use mstmm::prelude::*;

mod own {
    pub use mstmm::elements::{Beam, Spring, TorsionSpring};
}

system! {
    struct Bends { k: f64 }

    fixed at 0.0 -> own::Beam 1 { length: 2.0, bending_stiffness: k, mass_per_length: k } -> pinned at 2.0;
//                       ^^^^ between places stand elements of one motion
}

system! {
    struct Undirected { k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn a at (k, 0.0);
    conn a -> own::Spring 2 { stiffness: k } -> fixed;
//         ^^ the direction of `Spring 2` is unknown, since its path meets one point with a place: say it
    conn a <- along (1.0, 0.0) <- own::TorsionSpring 3 { stiffness: k } <- fixed;
//            ^^^^^ a path of torsion elements turns about z, the one axis of the plane: remove `along`
}

system! {
    struct Mixed { k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> conn a at (k, 0.0);
    conn a <- along (1.0, 0.0) <- spring 2 { stiffness: k } <- own::TorsionSpring 3 { stiffness: k } <- fixed;
//                                                             ^^^^^^^^^^^^^^^^^^^^ `TorsionSpring 3` turns and `spring 2` moves
    conn a <- own::TorsionSpring 4 { stiffness: k } <- own::Spring 5 { stiffness: k } <- fixed;
//                                                     ^^^^^^^^^^^^^ `TorsionSpring 4` turns and `Spring 5` moves
}

system! {
    struct Loose { k: f64 }

    fixed at (0.0, 0.0) -> own::Spring 1 { stiffness: k } -> conn a at (k, 0.0);
//                                                           ^^^^^^ nothing holds `conn a` across the path of `Spring 1`
}

system! {
    struct HeldInVain { k: f64 }

    fixed at (0.0, 0.0) -> own::Spring 1 { stiffness: k } -> conn a at (k, 0.0);
    conn a <- held(y, rz);
//                    ^^ no element at `conn a` has the freedom `rz`: remove it
    conn a -> own::Spring 2 { stiffness: k } -> fixed at (k, k);
}

fn main() {}
