use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> fixed -> mass 2 { mass: m } -> free;
//                                        ^^^^^ hold a point in between by a connection, `support -> conn ..`
}

fn main() {}
