use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    conn a att (0.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
//         ^^^ did you mean `at`?
    conn a on (0.0, 0.0) -> spring 2 { stiffness: l } -> fixed;
//         ^^ its place is written `conn a at (x, y)`
    roller alnog (1.0, 0.0) -> conn a;
//         ^^^^^ did you mean `along`?
}

fn main() {}
