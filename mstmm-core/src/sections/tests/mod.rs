//! Sections against outlines, many digits, membranes and solutions of elasticity; derivatives against differences.

mod derivatives;
mod membrane;
mod shear;
mod sizes;

use super::*;
use core::f64::consts::PI;

#[track_caller]
fn assert_near(found: f64, exact: f64, tolerance: f64) {
    assert!((found / exact - 1.0).abs() <= tolerance, "{found:e} instead of {exact:e}");
}

/// Area, `∫ z² dA` and `∫ y² dA` within a closed polygon of points (y, z), by Green.
fn polygon(points: &[[f64; 2]]) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for (k, &[y, z]) in points.iter().enumerate() {
        let [v, w] = points[(k + 1) % points.len()];
        let cross = y * w - v * z;
        sums[0] += cross / 2.0;
        sums[1] += cross * (z * z + z * w + w * w) / 12.0;
        sums[2] += cross * (y * y + y * v + v * v) / 12.0;
    }
    sums
}

fn sides(width: f64, height: f64) -> [[f64; 2]; 4] {
    let (y, z) = (width / 2.0, height / 2.0);
    [[-y, -z], [y, -z], [y, z], [-y, z]]
}

#[track_caller]
fn assert_outline(found: Properties<f64>, exact: [f64; 3]) {
    for (found, exact) in [found.area, found.i_y, found.i_z].into_iter().zip(exact) {
        assert_near(found, exact, 1e-13);
    }
    assert_near(found.polar(), exact[1] + exact[2], 1e-13);
}

#[test]
fn areas_and_moments_are_those_of_the_outline() {
    let rectangle = Rectangle { width: 0.3, height: 0.7 }.properties().unwrap();
    assert_outline(rectangle, polygon(&sides(0.3, 0.7)));
    let hollow = BoxSection { width: 0.3, height: 0.7, wall: 0.04 }.properties().unwrap();
    let (outer, hole) = (polygon(&sides(0.3, 0.7)), polygon(&sides(0.22, 0.62)));
    assert_outline(hollow, [0, 1, 2].map(|k| outer[k] - hole[k]));
    let girder = ISection { width: 0.3, height: 0.7, flange: 0.05, web: 0.02 }.properties().unwrap();
    let (b, h, w, c) = (0.15, 0.35, 0.01, 0.3);
    let right = [[b, -h], [b, -c], [w, -c], [w, c], [b, c], [b, h]];
    let outline: std::vec::Vec<[f64; 2]> = right.into_iter().chain(right.map(|[y, z]| [-y, -z])).collect();
    assert_outline(girder, polygon(&outline));
}

/// A polygon of n corners on a circle has the area `n sin(2π/n) r²/2` and less than the circle by `(2π/n)²/6`.
#[test]
fn round_sections_are_those_of_polygons_of_many_corners() {
    let circle = |radius: f64| {
        let corner = |k: u32| [radius * (PI * f64::from(k) / 5e3).cos(), radius * (PI * f64::from(k) / 5e3).sin()];
        polygon(&(0..10_000).map(corner).collect::<std::vec::Vec<_>>())
    };
    let (outer, inner) = (circle(0.1), circle(0.08));
    let (rod, tube) = (Round { diameter: 0.2 }, Tube { outer: 0.2, inner: 0.16 });
    for (found, exact) in
        [(rod.properties().unwrap(), outer), (tube.properties().unwrap(), [0, 1, 2].map(|k| outer[k] - inner[k]))]
    {
        for (found, exact) in [found.area, found.i_y, found.i_z, found.torsion / 2.0]
            .into_iter()
            .zip([exact[0], exact[1], exact[2], exact[1]])
        {
            assert_near(found, exact, 1e-6);
        }
    }
    assert_eq!(Tube { outer: 0.2, inner: 0.0 }.properties(), rod.properties());
}

/// `J/(l s³)` by the series along the long side and by that along the short one, which agree in 45 digits.
const TORSION: [(f64, f64); 7] = [
    (1.0, 0.140_577_014_955_153_7),
    (1.2, 0.166_118_910_078_825_12),
    (1.5, 0.195_760_708_875_544_03),
    (2.0, 0.228_681_677_119_570_77),
    (2.5, 0.249_365_074_708_186_4),
    (5.0, 0.291_316_754_187_988_86),
    (10.0, 0.312_325_037_457_205_4),
];

#[test]
fn torsion_of_rectangles_has_all_digits() {
    for (ratio, exact) in TORSION {
        // in units that are exact, and with either side the longer one
        for (width, height) in [(2.0 * ratio, 2.0), (2.0, 2.0 * ratio)] {
            let found = Rectangle { width, height }.properties().unwrap().torsion;
            assert_near(found, 16.0 * ratio * exact, 4.0 * f64::EPSILON);
        }
    }
}

/// Timoshenko and Goodier, Theory of Elasticity, 3rd edition, section 109, table of `k₁`.
#[test]
fn torsion_of_rectangles_is_that_of_the_table() {
    let table = [(1.0, 0.1406), (1.2, 0.166), (1.5, 0.196), (2.0, 0.229), (2.5, 0.249), (3.0, 0.263), (4.0, 0.281)];
    for (ratio, k) in table.into_iter().chain([(5.0, 0.291), (10.0, 0.312), (1e6, 0.333)]) {
        let found = Rectangle { width: 1.0, height: ratio }.properties().unwrap().torsion / ratio;
        assert!((found - k).abs() < 5.1e-4, "{ratio}: {found}");
    }
}

/// Without loss of digits: a thin ring has `A = π d t`, `I = π d³ t/8`, a thin square box `I = 2 s³ t/3`, up to the square of t.
#[test]
fn thin_walls_lose_no_digits() {
    let t = 1.0 / f64::from(1 << 30);
    let ring = Tube { outer: 1.0 + t, inner: 1.0 - t }.properties().unwrap();
    assert_near(ring.area, PI * t, 4.0 * f64::EPSILON);
    assert_near(ring.i_y, PI * t / 8.0, 4.0 * f64::EPSILON);
    let post = BoxSection { width: 1.0 + t, height: 1.0 + t, wall: t }.properties().unwrap();
    assert_near(post.area, 4.0 * t, 4.0 * f64::EPSILON);
    assert_near(post.i_y, 2.0 * t / 3.0, 4.0 * f64::EPSILON);
    assert_near(post.torsion, t, 4.0 * f64::EPSILON);
}
