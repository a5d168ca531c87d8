use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    pinned -> spring 1 { stiffness: k } -> conn 2 <- mass 3 { mass: m } <- roller;
//  ^^^^^^ a translation path ends in `fixed` or `free` only
//                                         ^^^^^^ give it a free tip, `free -> conn ..`
//                                                                         ^^^^^^ a translation path ends in `fixed` or `free` only
    conn 2 -> torsion_spring 4 { stiffness: k } -> inertia 5 { inertia: m }
           -> beam 6 { length: 1.0, bending_stiffness: k, mass_per_length: m } -> free;
//         ^^ put a connection with a free tip between these two elements, `-> conn .. ->` and `free ->
}

fn main() {}
