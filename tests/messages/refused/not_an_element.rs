use mstmm::prelude::*;

mod shop {
    pub struct Rope<T> {
        pub length: T,
    }
}

system! {
    struct Hanging { length: f64 }

    fixed -> shop::Rope 1 { length } -> fixed;
}

fn main() {}
