use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
}

fn main() {
    let _ = M::conn_a.displacement_z();
//                    ^^^^^^^^^^^^^^ no method named `displacement_z` found for struct `PlanePoint<M>` in the current scope
    let _ = M::beam_1.input().torque();
//                            ^^^^^^ the method `torque` exists for struct `MemberEnd<M>`, but its trait bounds were not satisfied
}
