use mstmm::prelude::*;

system! {
    struct Bar { length: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> conn a at (length, 0.0);
}

system! {
    struct Damped { c: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> conn a at (1.0, 0.0);
    conn a <- along (0.0, 1.0) <- damper 2 { damping: c } <- fixed;
}

fn main() {
    let bar = Bar { length: 1.0 }.build().unwrap();
    let _ = bar.frequency_response(Bar::conn_a.force_y(), Damped::conn_a.displacement_y());
//                                                        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ expected `PlaneEntry<Bar>`
    let _ = bar.frequency_response(Bar::conn_a.force_y(), Bar::conn_a.moment());
//                                                                    ^^^^^^ method not found in `PlanePoint<Bar>`
    let damped = Damped { c: 0.1 }.build().unwrap();
    let response = damped.frequency_response(Damped::conn_a.force_y(), Damped::conn_a.displacement_y()).unwrap();
    let _ = response.at(2.0);
//                      ^^^ a system with a damper moves at a complex λ
}
