use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 01 { stiffness: k } -> conn 2nd -> mass 1e3 { mass: m } -> free;
//                  ^^ a decimal number without leading zero or suffix, such as `arm` or `12`
//                                              ^^^ a decimal number without leading zero or suffix, such as `arm` or `12`
//                                                          ^^^ a decimal number without leading zero or suffix, such as `arm` or `12`
    free -> conn 2nd;
//               ^^^ a decimal number without leading zero or suffix, such as `arm` or `12`
}

fn main() {}
