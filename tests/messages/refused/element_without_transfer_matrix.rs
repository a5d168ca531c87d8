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
    struct Hanging { length: f64 }

    fixed -> self::Rope 1 { length } -> fixed;
}

fn main() {
    let system = Hanging { length: 1.0 }.build().unwrap();
    let _ = system.overall_determinant(2.0);
//                 ^^^^^^^^^^^^^^^^^^^ trait bound `Rope<f64>: TransferMatrix<_>` was not satisfied
}
