use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }
//         ^^^^^ write a path such as `fixed -> beam 1 { .. } -> free;`


}

fn main() {}
