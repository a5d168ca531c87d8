use mstmm::prelude::*;

system! {
    struct Model { l: f64, k: f64 }

    section steel { bending_stiffness: k, mass_per_length: k, torsional_stiffness: k, length: 2 }
//                                                            ^^^^^^^^^^^^^^^^^^^ `beam 1` has no parameter `torsional_stiffness`
    section heavy { mass_per_length: 2.0 * k }

    fixed -> beam 1 { ..steel, length: l } -> hinge 2 {} -> beam 3 { length: l, ..steel, ..heavy }
//                                            ^^^^^^^ write `stiffness_rz: 0.0`
//                                                                                         ^^^^^ name it in `beam 3` itself
        -> spring 4 { ..soft } -> free;
//                      ^^^^ there are `steel` and `heavy`
}

fn main() {}
