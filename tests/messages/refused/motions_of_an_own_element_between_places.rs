use mstmm::prelude::*;
use mstmm::element::{Chart, Charted, Element, FrequencyPowers, InvalidParameter, Translation};
use mstmm::number::{Frequency, Parameter};

#[derive(Clone, Debug)]
struct Pad<T> {
    stiffness: T,
}

impl<T: Parameter> Element for Pad<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

impl<T: Parameter, S: Frequency<T>> Charted<S> for Pad<T> {
    fn chart(pad: &Self, _at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
        Chart::spring(S::from_parameter(pad.stiffness))
    }
}

system! {
    struct Padded { stiffness: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn a at (3.0, 4.0);
    conn a <- along (0.0, 1.0) <- self::Pad 2 { stiffness } <- fixed;
}

fn main() {
    let system = Padded { stiffness: 1.0 }.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    let _ = system.mode_shape(&root);
//          ^^^^^^ an element of your own implements `mstmm::element::MemberMotion<S>`
    let _ = system.sensitivity(&root);
//                 ^^^^^^^^^^^ sensitivities of frames need it; an element of your own implements `mstmm::element::MemberGradient<S>`
//          ^^^^^^ an element of your own implements `mstmm::element::MemberMotion<S>`
}
