use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    pinned at (0.0, 0.0, 0.0) -> spring 1 { stiffness: l } -> conn a at (l, 0.0, 0.0)
//                                                            ^^^^^^ `conn a` moves freely in directions of which no path is: hold it, give it members or mass, or leave it without
        -> spring 2 { stiffness: l } -> pinned at (l, l, 0.0);
}

fn main() {}
