use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn b at (l, l) -> pin 3 {}
        -> beam 4 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn c at (0.0, l);
    conn a -> spring 5 { stiffness: l } -> fixed;
//         ^^ say it, `conn a <- along (dx, dy) <- ..`
    conn a -> mass 6 { mass: l } -> free;
//         ^^ write `point_mass`, which moves in all
    conn a -> spring 7 { stiffness: l } -> conn u;
    conn b -> spring 8 { stiffness: l } -> conn u;
    conn c -> spring 9 { stiffness: l } -> conn u;
//         ^^ say `along` at each of them, `conn c <- along (dx, dy) <- ..`
    conn a -> along (1.0, 0.0) -> spring 10 { stiffness: l } -> conn b;
//                                                           ^^ say it here too, `conn b <- along (dx, dy) <- ..`
    conn c -> spring 11 { stiffness: l } -> damper 12 { damping: l } -> conn c;
//                                                                   ^^ say `along` at both ends
}

fn main() {}
