use mstmm::prelude::*;

system! {
    struct Model<T> { k: f64, m: f64 }
//              ^^^ its fields are all `f64`

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {}
