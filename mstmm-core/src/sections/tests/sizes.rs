//! Sizes that no section has.

use super::*;
use crate::model::error::{InvalidParameter, Requirement};
use crate::number::Partials;
use std::string::{String, ToString};
use std::vec::Vec;

type Results = (Result<Properties<f64>, InvalidParameter>, Result<ShearCoefficients<f64>, InvalidParameter>);

/// A section by its sizes, and the names of these.
struct Case {
    names: &'static [&'static str],
    sizes: &'static [f64],
    of: fn(&[f64], f64) -> Results,
    formulas: fn(&[f64], f64) -> [f64; 6],
}

macro_rules! case {
    ($section:ident { $($name:ident: $size:expr),* }, $properties:ident, $shear:ident) => {
        Case {
            names: &[$(stringify!($name)),*],
            sizes: &[$($size),*],
            of: |sizes, nu| {
                let &[$($name),*] = sizes else { panic!("as many sizes as names") };
                let section = $section { $($name),* };
                (section.properties(), section.shear_coefficients(nu))
            },
            formulas: |sizes, nu| {
                let &[$($name),*] = sizes else { panic!("as many sizes as names") };
                let ((a, b, c, d), (y, z)) = ($properties($($name),*), $shear($($name,)* nu));
                [a, b, c, d, y, z]
            },
        }
    };
}

fn cases() -> [Case; 5] {
    [
        case!(Round { diameter: 0.5 }, round, round_shear),
        case!(Tube { outer: 0.5, inner: 0.25 }, tube, tube_shear),
        case!(Rectangle { width: 0.5, height: 0.25 }, rectangle, rectangle_shear),
        case!(BoxSection { width: 0.5, height: 0.25, wall: 0.0625 }, box_section, box_shear),
        case!(ISection { width: 0.5, height: 0.25, flange: 0.0625, web: 0.03125 }, i_section, i_shear),
    ]
}

#[test]
fn every_size_is_checked_by_its_name() {
    for case in cases() {
        assert!((case.formulas)(case.sizes, 0.3).iter().all(|number| *number > 0.0));
        for (k, name) in case.names.iter().enumerate() {
            for wrong in [f64::NAN, -0.25, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e-60, 1e60] {
                if *name == "inner" && (wrong == 0.0 || wrong == 1e-60) {
                    continue;
                }
                let mut sizes = case.sizes.to_vec();
                sizes[k] = wrong;
                let (properties, shear) = (case.of)(&sizes, 0.3);
                let error = properties.unwrap_err();
                assert_eq!(shear.unwrap_err().to_string(), error.to_string());
                // an inner circle that is too large is told of the outer one
                let told = if (*name, wrong) == ("inner", 1e60) { ("outer", 0.5) } else { (*name, wrong) };
                assert_eq!(error.parameter, told.0);
                assert!(error.value == told.1 || error.value.is_nan() && told.1.is_nan(), "{error}");
                assert!((case.formulas)(&sizes, 0.3).iter().all(|number| number.is_nan()));
            }
        }
        for wrong in [f64::NAN, -0.1, 0.51, f64::INFINITY] {
            let (properties, shear) = (case.of)(case.sizes, wrong);
            assert!(properties.is_ok());
            let error = shear.unwrap_err();
            assert_eq!(error.parameter, "poisson_ratio");
            assert_eq!(error.requirement, Requirement::Between { least: 0.0, most: 0.5 });
        }
    }
}

#[test]
fn walls_leave_room() {
    let message = |result: Result<Properties<f64>, InvalidParameter>| result.unwrap_err().to_string();
    let post = |width, height, wall| message(BoxSection { width, height, wall }.properties());
    assert_eq!(post(0.5, 1.0, 0.25), "width is 0.5, but must be finite and greater than 2 wall = 0.5");
    assert_eq!(post(1.0, 0.5, 0.3), "height is 0.5, but must be finite and greater than 2 wall = 0.6");
    let girder = |flange, web| message(ISection { width: 0.5, height: 1.0, flange, web }.properties());
    assert_eq!(girder(0.5, 0.1), "height is 1, but must be finite and greater than 2 flange = 1");
    assert_eq!(girder(0.1, 0.5), "width is 0.5, but must be finite and greater than web = 0.5");
    let ring = message(Tube { outer: 0.5, inner: 0.5 }.properties());
    assert_eq!(ring, "outer is 0.5, but must be finite and greater than inner = 0.5");
    let tiny = message(Round { diameter: 1e-51 }.properties());
    assert_eq!(tiny, "diameter is 1e-51, but must be from 1e-50 to 1e50");
    let partial = Round { diameter: Partials::<1>::variable(-2.0, 0) }.properties().map(|found| found.area.value);
    assert_eq!(partial.unwrap_err().to_string(), "diameter is -2, but must be positive and finite");
}

#[test]
fn sizes_at_the_ends_of_their_range_have_results() {
    for scale in [1e-50_f64, 1e50] {
        for (case, unit) in cases().into_iter().zip([1.0, 1.0, 2.0, 2.0, 2.0]) {
            // the largest or the smallest size is the end itself
            let bound = case.sizes.iter().copied().fold(case.sizes[0], if scale < 1.0 { f64::min } else { f64::max });
            let sizes: Vec<f64> = case.sizes.iter().map(|size| (scale / bound * size).clamp(1e-50, 1e50)).collect();
            let found = (case.formulas)(&sizes, unit / 8.0);
            let report: String = std::format!("{sizes:?}: {found:?}");
            assert!(found.iter().all(|number| number.is_normal() && *number > 0.0), "{report}");
        }
    }
    let blade = Rectangle { width: 1e-50, height: 1e50 }.properties().unwrap();
    assert_near(blade.torsion / 1e-100, 1.0 / 3.0, 1e-14);
}
