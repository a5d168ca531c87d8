use mstmm::prelude::*;

system! {
    struct Model { length: f64 }

    let part = length.max(1);
//                        ^ expected `f64`, found integer
    fixed -> spring 1 { stiffness: part } -> free
}

fn main() {}
