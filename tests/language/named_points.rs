//! A connection with one input is a name for a point: it adds no unknown and changes no result.

use mstmm::prelude::*;

/// A beam with a body and a sprung mass beside it, written with and without names of points.
macro_rules! tip_mass {
    ($fields:tt $($model:ident { $($paths:tt)* })*) => {$(
        system! {
            #[derive(Clone, Copy, Debug)]
            struct $model $fields
            $($paths)*
        }
    )*};
}

tip_mass! {
    { length: f64, ei: f64, m: f64, mass: f64, k: f64 }
    Unnamed {
        fixed -> beam a { length, bending_stiffness: ei, mass_per_length: m }
              -> beam b { length: 0.5 * length, bending_stiffness: ei, mass_per_length: m }
              -> conn a -> point_mass 1 { mass, inertia: 0.0 } -> free;
        fixed -> spring 2 { stiffness: k } -> mass 3 { mass } -> spring 4 { stiffness: k } -> conn a;
    }
    Named {
        fixed -> beam a { length, bending_stiffness: ei, mass_per_length: m }
              -> conn b -> beam b { length: 0.5 * length, bending_stiffness: ei, mass_per_length: m }
              -> conn a -> conn nose -> point_mass 1 { mass } -> conn tip -> free;
        fixed -> spring 2 { stiffness: k } -> conn 2 -> mass 3 { mass } -> spring 4 { stiffness: k } -> conn 4 -> conn a;
    }
}

fn numbers() -> (Unnamed, Named) {
    let [length, ei, m, mass, k] = [0.8, 1.3, 0.7, 0.4, 2.0];
    (Unnamed { length, ei, m, mass, k }, Named { length, ei, m, mass, k })
}

#[test]
fn names_of_points_add_no_unknowns_and_change_no_frequency() {
    let (unnamed, named) = numbers();
    let (unnamed, named) = (unnamed.build().unwrap(), named.build().unwrap());
    assert_eq!(UnnamedSystem::N, NamedSystem::N);
    let [without, with] = [unnamed.first_frequencies::<8>().unwrap(), named.first_frequencies::<8>().unwrap()];
    for (without, with) in without.iter().zip(&with) {
        assert!(with.is_proven && without.is_proven);
        assert!(with.lower <= without.upper && without.lower <= with.upper, "{with} and {without}");
    }
    for omega in [0.5, 2.0, 9.0] {
        let [without, with] = [unnamed.overall_determinant(omega), named.overall_determinant(omega)].map(|d| d.value());
        assert!((without - with).abs() <= 1e-12 * without.abs(), "{without} and {with} at {omega}");
        assert_eq!(unnamed.count_below(omega).unwrap(), named.count_below(omega).unwrap());
    }
}

/// The state of the name is that of the elements around it: a force there moves it as it moves the end of the beam.
#[test]
fn a_named_point_has_the_motion_and_the_loads_of_the_elements_around_it() {
    let (_, named) = numbers();
    let system = named.build().unwrap();
    let root = system.first_frequencies::<2>().unwrap()[1];
    let shape = system.mode_shape(&root).unwrap();
    let size = shape.state(Named::beam_a.output()).y.abs();
    let states = [
        (Named::beam_a.output(), Named::conn_b),
        (Named::beam_b.output(), Named::conn_nose),
        (Named::point_mass_1.output(), Named::conn_tip),
    ];
    for (end, point) in states.map(|(end, point)| (shape.state(end), shape.state(point))) {
        assert!((end.y - point.y).abs() <= 1e-12 * size, "{end:?} and {point:?}");
        assert!((end.theta - point.theta).abs() <= 1e-11 * size, "{end:?} and {point:?}");
    }
    assert!(shape.state(Named::conn_tip).m.abs() <= 1e-9 * shape.state(Named::beam_a.output()).m.abs());
    let [at_name, at_end] = [Named::conn_b.force(), Named::beam_a.output().force()]
        .map(|load| system.frequency_response(load, Named::conn_tip.deflection()).unwrap().at(3.0).unwrap());
    assert!((at_name - at_end).abs() <= 1e-12 * at_end.abs(), "{at_name} and {at_end}");
}
