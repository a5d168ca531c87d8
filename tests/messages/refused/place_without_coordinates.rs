use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at -> beam 1 { } -> conn a at (l, 0.0);
//        ^^ write its coordinates behind, `at (x, y)`
    conn a <- along <- spring 2 { stiffness: l } <- fixed;
//            ^^^^^ write its parts behind, `along (dx, dy)`
    conn a <- roller along;
//                   ^^^^^ write its parts behind, `along (dx, dy)`
    conn a at 2.0 * -> spring 3 { stiffness: l } -> fixed;
//                ^ unexpected end of input, expected an expression
    conn a at;
//         ^^ write its coordinates behind, `at (x, y)`
}

fn main() {}
