use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, up: (0.0, 1.0) } -> conn a at (l, 0.0, 0.0)
//                                                    ^^^^^^^^^^ `up` has three parts in space, which are written as a tuple, `up: (dx, dy, dz)`
        -> rigid_body 2 { mass: l, inertia: l, centre: (l, 0.0) };
//                                          ^ `inertia` is a tensor in space: `inertia: (xx, yy, zz)`, or with `xy, yz, zx`
//                                                     ^^^^^^^^ `centre` has three parts in space, which are written as a tuple, `centre: (x, y, z)`
    conn a -> beam 3 { ..steel } -> conn b at (l, l);
//                                            ^^^^^^ the place of `conn b` has two coordinates, that of `fixed` three: all points of a model have equally many
    conn a <- along (1.0, 0.0) <- spring 4 { stiffness: l } <- fixed;
//                  ^^^^^^^^^^ a direction in space has three parts, `along (dx, dy, dz)`
}

fn main() {}
