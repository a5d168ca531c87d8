use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } - mass 2 { mass: m } -> free;
//                                     ^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
}

fn main() {}
