use mstmm::prelude::*;

mod shop {
    pub struct Rope<T> {
        pub length: T,
    }
}

system! {
    struct Hanging { length: f64 }
//         ^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//         ^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`

    fixed -> shop::Rope 1 { length } -> fixed;
//           ^^^^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//           ^^^^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//           ^^^^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//           ^^^^^^^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//                 ^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//                 ^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
//                 ^^^^ an element of your own is a struct `Cable<T>` that implements `mstmm::element::Element`
}

fn main() {}
