use mstmm::prelude::*;

system! {
    struct Frame { length: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> conn a at (length, 0.0) -> damper 2 { damping: 1.0 } -> pinned at (length, 1.0);
}

fn main() {
    let system = Frame { length: 1.0 }.build().unwrap();
    system.overall_determinant(1.0);
//                             ^^^ needs a complex λ
}
