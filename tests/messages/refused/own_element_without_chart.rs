use mstmm::prelude::*;
use mstmm::element::{Element, InvalidParameter, Translation};
use mstmm::number::Parameter;

#[derive(Clone, Debug)]
struct Rope<T> {
    length: T,
}

impl<T: Parameter> Element for Rope<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

system! {
    struct Moored { length: f64 }

    fixed at (0.0, 0.0) -> self::Rope 1 { length } -> conn a at (3.0, 4.0);
//                         ^^^^^^^^^^ an element of your own implements `mstmm::element::Charted<S>`
    conn a -> point_mass 2 { mass: 1.0 };
}

fn main() {}
