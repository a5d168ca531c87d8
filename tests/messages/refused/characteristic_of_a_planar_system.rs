use mstmm::prelude::*;

system! {
    struct Frame { length: f64, ea: f64, ei: f64, m: f64 }

    fixed -> beam 1 { length, axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> free;
}

fn main() {
    let system = Frame { length: 1.0, ea: 1.0, ei: 1.0, m: 1.0 }.build().unwrap();
    let _ = system.characteristic(2.0);
//                 ^^^^^^^^^^^^^^ trait bound `InPlane<mstmm::elements::Beam<f64>>: PlaneStep<_>` was not satisfied
}
