use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    conn a at (0.0, 0.0) at (1.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
//                       ^^ remove this `at`
    roller along (1.0, 0.0) at (0.0, 0.0) -> conn a;
//                          ^^ `roller at .. along ..`
    roller at (0.0, 0.0) along (1.0, 0.0) at (0.0, 1.0) -> conn a;
//                                        ^^ remove this `at`
    guided at (0.0, 0.0) along (1.0, 0.0) along (0.0, 1.0) -> conn a;
//                                        ^^^^^ remove this `along`
}

fn main() {}
