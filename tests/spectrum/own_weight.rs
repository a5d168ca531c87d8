//! Columns under their own weight: Greenhill's load, frequencies of an independent field, pieces, columns from both ends.

use mstmm::prelude::*;
use mstmm::search::critical_loads;

system! {
    /// A column that stands on its clamped input end.
    #[derive(Clone, Copy)]
    struct Column { load: f64, height: f64 }
    fixed -> tapered_beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: height, axial_load: -load
    } -> free;
}

system! {
    /// The same from its top to its foot, where its whole weight is.
    struct Downwards { load: f64, height: f64 }
    let h = 1.0 - height;
    free -> tapered_beam 1 {
        length: 1.0, bending_stiffness: h * h * h, mass_per_length: h, height_taper: -height / h, axial_force: -load, axial_load: load
    } -> fixed;
}

system! {
    /// The same in two pieces, of which the lower one bears the upper one.
    struct Pieces { load: f64, height: f64, cut: f64 }
    let h = 1.0 - height * cut;
    fixed -> tapered_beam 1 {
        length: cut, bending_stiffness: 1.0, mass_per_length: 1.0, height_taper: height * cut, axial_load: -load, axial_force: -load * (1.0 - cut)
    } -> tapered_beam 2 {
        length: 1.0 - cut, bending_stiffness: h * h * h, mass_per_length: h, height_taper: height * (1.0 - cut) / h, axial_load: -load
    } -> free;
}

system! {
    /// Uniform pieces, each with the mean of its axial force.
    struct Mean { load: f64 }
    fixed -> beam 1 { length: 0.25, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -0.875 * load }
        -> beam 2 { length: 0.25, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -0.625 * load }
        -> beam 3 { length: 0.25, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -0.375 * load }
        -> beam 4 { length: 0.25, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -0.125 * load } -> free;
}

/// Greenhill (1881): `9 j²/4` with the first zero j of the Bessel function of order -1/3.
#[test]
fn a_column_buckles_under_its_weight_as_greenhill_says() {
    let exact = 7.837_347_438_943_484;
    let own = critical_loads::<1, _>(0.0..=20.0, |load| Column { load, height: 0.0 }.build()).unwrap()[0];
    assert!((own.factor / exact - 1.0).abs() < 1e-14, "{}", own.factor);
    assert!(own.lower <= exact && exact <= own.upper);
}

/// Exact fields of 40 digits, and how far they are from four pieces with mean forces.
#[test]
fn a_column_under_half_of_its_load_has_the_frequencies_of_the_file() {
    let exact = [2.462_967_204_600_383, 21.234_328_165_674_02, 60.882_009_064_837_39];
    let roots = Column { load: 4.0, height: 0.0 }.build().unwrap().first_frequencies::<3>().unwrap();
    for (root, exact) in roots.iter().zip(exact) {
        assert!((root.omega / exact - 1.0).abs() < 4e-16 && root.is_proven, "{root} {exact}");
    }
    let mean = Mean { load: 4.0 }.build().unwrap().first_frequencies::<1>().unwrap()[0];
    assert!(((mean.omega / exact[0] - 1.0).abs() - 0.01362).abs() < 5e-6, "{mean}");
}

/// Tapered columns from both ends and in pieces are one, loaded, hanging and beyond buckling.
#[test]
fn columns_from_both_ends_and_in_pieces_are_one() {
    for (load, height) in [(4.0, 0.0), (-60.0, 0.5), (3.0, 0.6), (2.5, -1.5), (500.0, 0.2)] {
        let column = Column { load, height }.build().unwrap();
        let downwards = Downwards { load, height }.build().unwrap();
        let pieces = Pieces { load, height, cut: 0.37 }.build().unwrap();
        let counts =
            [column.unstable_modes().unwrap(), downwards.unstable_modes().unwrap(), pieces.unstable_modes().unwrap()];
        assert_eq!(counts, [counts[0]; 3], "{load} {height}");
        if load > 100.0 {
            assert!(counts[0] > 3);
            continue;
        }
        assert_eq!(counts[0], 0, "{load} {height}");
        let roots = column.first_frequencies::<8>().unwrap();
        for other in [downwards.first_frequencies::<8>().unwrap(), pieces.first_frequencies::<8>().unwrap()] {
            for (one, other) in roots.iter().zip(&other) {
                assert!(one.is_proven && other.is_proven);
                assert!((one.omega / other.omega - 1.0).abs() < 1e-13, "{load} {height}: {one} {other}");
            }
        }
    }
}

/// The slope of a frequency with the load, and with the length through the load, beside differences.
#[test]
fn loads_have_sensitivities() {
    let at = |load: f64| Column { load, height: 0.3 }.build().unwrap().first_frequencies::<1>().unwrap()[0].omega;
    let column = Column { load: 2.0, height: 0.3 }.build().unwrap();
    let root = column.first_frequencies::<1>().unwrap()[0];
    let slope = column.sensitivity(&root).unwrap().get("load").unwrap();
    let step = 1e-4;
    let difference = (at(2.0 + step) - at(2.0 - step)) / (2.0 * step);
    assert!((slope / difference - 1.0).abs() < 1e-8, "{slope} {difference}");
}
