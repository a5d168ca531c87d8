use mstmm::prelude::*;
use mstmm::element::{Element, InvalidParameter, Translation};
use mstmm::number::Real;

#[derive(Clone, Debug)]
struct Rope<T> {
    length: T,
}

impl<T: Real> Element for Rope<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

system! {
    struct Hanging { length: f64 }

    fixed -> self::Rope 1 { length } -> fixed;
//                 ^^^^ an element of your own is generic over `T: mstmm::number::Parameter`
//                 ^^^^ an element of your own is generic over `T: mstmm::number::Parameter`
//                 ^^^^ an element of your own is generic over `T: mstmm::number::Parameter`
//                 ^^^^ an element of your own is generic over `T: mstmm::number::Parameter`
}

fn main() {}
