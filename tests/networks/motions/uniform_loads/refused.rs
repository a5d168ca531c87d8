//! Loads along members that have no meaning.

use mstmm::motion::{MemberLabel, MotionError, PlaneLoad};
use mstmm::network::Freedoms;
use mstmm::prelude::*;

system! {
    struct Line { m: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: m } -> conn a at 1.0;
}

system! {
    /// A mass that hangs from a beam on a path of one motion.
    struct Hanging { m: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 9.0, bending_stiffness: 2.0, mass_per_length: m } -> conn a at (1.0, 0.0);
    conn a <- along (0.0, 1.0) <- spring 2 { stiffness: 1.0 } <- mass 3 { mass: 1.0 } <- free;
}

system! {
    /// A rod that leads up a slope, and one in line with x.
    struct Rods { m: f64 }
    fixed at (0.0, 0.0) -> rod 1 { length: 1.0, axial_stiffness: 2.0, mass_per_length: m } -> conn a at (1.0, 0.0)
        -> beam 3 { axial_stiffness: 9.0, bending_stiffness: 2.0, mass_per_length: m } -> roller at (1.0, 1.0);
    conn a <- rod 2 { length: 1.0, axial_stiffness: 2.0, mass_per_length: m } <- fixed at (2.0, 1.0);
}

#[test]
fn loads_without_a_meaning_are_refused() {
    let line = Line { m: 1.0 }.build().unwrap();
    let at = |load| line.frequency_response(load, Line::conn_a.displacement_y()).unwrap().at(1.0);
    let across = MotionError::NoSuchFreedom { freedom: Freedoms::X };
    assert_eq!(at(Line::beam_1.uniform_load_x()), Err(across));
    assert_eq!(at(PlaneLoad::self_weight_x()), Err(across));
    let other = MemberLabel::<Line, ()>::member(7).uniform_load_y();
    let refused = line.frequency_response(other, Line::conn_a.displacement_y()).map(|_| ());
    assert_eq!(refused, Err(MotionError::NoSuchPoint { index: 7 }));

    let hanging = Hanging { m: 1.0 }.build().unwrap();
    let entry = Hanging::conn_a.displacement_y();
    let at = |load| hanging.frequency_response(load, entry).unwrap().at(1.0);
    assert_eq!(at(PlaneLoad::self_weight_y()), Err(MotionError::NoUniformLoad));
    assert!(at(Hanging::beam_1.uniform_load_y()).is_ok());

    let rods = Rods { m: 1.0 }.build().unwrap();
    let at = |load| rods.frequency_response(load, Rods::conn_a.displacement_x()).unwrap().at(1.0);
    assert!(at(Rods::rod_1.uniform_load_x()).is_ok());
    assert_eq!(at(Rods::rod_2.uniform_load_x()), Err(MotionError::NoSuchFreedom { freedom: Freedoms::Y }));
}
