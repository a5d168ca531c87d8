//! Derivatives by sizes and by the Poisson ratio against central differences.

use super::*;
use crate::number::Partials;
use std::vec::Vec;

/// The results of a section whose sizes are the first numbers of four, with the ratio as the fifth.
fn results<T: Number>(kind: usize, [a, b, c, d, nu]: [T; 5]) -> Vec<T> {
    let (properties, shear) = match kind {
        0 => (round(a), round_shear(a, nu)),
        1 => (tube(a, b), tube_shear(a, b, nu)),
        2 => (rectangle(a, b), rectangle_shear(a, b, nu)),
        3 => (box_section(a, b, c), box_shear(a, b, c, nu)),
        _ => (i_section(a, b, c, d), i_shear(a, b, c, d, nu)),
    };
    [properties.0, properties.1, properties.2, properties.3, shear.0, shear.1].into()
}

fn assert_derivatives(kind: usize, sizes: [f64; 5]) {
    let found = results(kind, core::array::from_fn(|k| Partials::<5>::variable(sizes[k], k)));
    let values = results(kind, sizes);
    for (k, size) in sizes.into_iter().enumerate() {
        let step = 1e-5 * size;
        let at = |change: f64| {
            let mut sizes = sizes;
            sizes[k] += change;
            results(kind, sizes)
        };
        for (row, (more, less)) in at(step).into_iter().zip(at(-step)).enumerate() {
            assert_eq!(found[row].value, values[row]);
            let difference = (more - less) / (2.0 * step);
            let error = (found[row].partials[k] - difference).abs() * size;
            assert!(error < 1e-8 * values[row], "section {kind}, result {row}, size {k}: {found:?}");
        }
    }
}

#[test]
fn derivatives_are_those_of_differences() {
    for (kind, sizes) in [
        (0, [0.2, 1.0, 1.0, 1.0, 0.3]),
        (1, [0.2, 0.15, 1.0, 1.0, 0.3]),
        (2, [0.2, 0.3, 1.0, 1.0, 0.2]),
        // the sides change places as to which one is the longer
        (2, [0.3, 0.3, 1.0, 1.0, 0.2]),
        (2, [0.9, 0.2, 1.0, 1.0, 0.4]),
        (3, [0.2, 0.3, 0.01, 1.0, 0.3]),
        (3, [0.2, 0.2, 0.05, 1.0, 0.3]),
        (4, [0.2, 0.3, 0.01, 0.006, 0.3]),
        (4, [0.3, 0.2, 0.04, 0.02, 0.1]),
    ] {
        assert_derivatives(kind, sizes);
    }
}

/// Closed form: `J = l s³/3 - 62 ζ(5)/π⁵ s⁴`, where terms of the series vanish.
#[test]
fn slender_rectangles_have_derivatives() {
    for long in [100.0, 1e10, 1e40] {
        let (long_side, short) = (Partials::<2>::variable(long, 0), Partials::<2>::variable(1.0, 1));
        for torsion in [rectangle(long_side, short).3, rectangle(short, long_side).3] {
            let rest = 62.0 * 1.036_927_755_143_37 / PI.powi(5);
            assert_near(torsion.value, long / 3.0 - rest, 1e-15);
            assert_near(torsion.partials[0], 1.0 / 3.0, 1e-14);
            assert_near(torsion.partials[1], long - 4.0 * rest, 1e-14);
        }
    }
}
