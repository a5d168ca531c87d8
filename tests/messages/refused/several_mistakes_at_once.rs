use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64, name: String }
//                                       ^^^^^^ compute anything else in a `let` line

    fixd -> sprng 1 { stiffness: k } -> conn 2 -> free;
//  ^^^^ did you mean `fixed`?
//          ^^^^^ did you mean `spring`?
    conn 2 <- mass 2 { mas: m } <- free;
//                     ^^^ did you mean `mass`?
    free -> mass 2 { mass: m } -> conn 2;
//               ^ elements share one set of labels, and an element is written once
    free -> conn 5;
//          ^^^^^^ lead it on to the root
}

fn main() {}
