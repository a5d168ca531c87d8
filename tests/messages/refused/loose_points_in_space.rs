use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    pinned at (0.0, 0.0, 0.0) -> spring 1 { stiffness: l } -> conn a at (l, 0.0, 0.0)
        -> spring 2 { stiffness: l } -> pinned at (l, l, 0.0);
}

fn main() {}
