use mstmm::prelude::*;
use mstmm::element::{Element, InvalidParameter, SMatrix, TransferMatrix, Translation};
use mstmm::number::{Frequency, Parameter};

struct Rope<T> {
    length: T,
}

impl<T: Parameter> Element for Rope<T> {
    type State = Translation;
    type Built = Self;
//               ^^^^ the trait bound `Rope<T>: Clone` is not satisfied
//               ^^^^ `Rope<T>` doesn't implement `Debug`

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

impl<T: Parameter, S: Frequency<T>> TransferMatrix<S> for Rope<T> {
    fn transfer_matrix(_: &Self, _: S) -> SMatrix<S, 2, 2> {
        SMatrix::identity()
    }
}

system! {
    struct Hanging { length: f64 }

    fixed -> self::Rope 1 { length } -> fixed;
//                 ^^^^ the trait bound `Rope<T>: Clone` is not satisfied
//                 ^^^^ `Rope<T>` doesn't implement `Debug`
}

fn main() {}
