//! Each method against the exact roots, with the rate at which it converges.

#![expect(clippy::unwrap_used, reason = "a test that cannot be set up fails")]

use rivals::elements::solver::Problem;
use rivals::scenes::{self, Scene};

fn scenes_named(names: &[&str]) -> Vec<Scene> {
    let mut scenes = scenes::all().unwrap();
    scenes.retain(|scene| names.contains(&scene.name));
    assert_eq!(scenes.len(), names.len());
    scenes
}

/// All paper examples and the close pair.
const ORDINARY: [&str; 6] = ["4.1a", "4.2", "4.3", "4.4", "4.5", "close pair"];

/// The certified search loses no more than the last digits: 32 eps is the width of its intervals.
#[test]
fn the_certified_search_has_all_digits() {
    for scene in scenes::all().unwrap() {
        let error = (scene.certified)().error(&scene.exact);
        assert!(error <= 16.0 * f64::EPSILON, "{}: {error:e}", scene.name);
    }
}

/// Cubics leave an error of the order h⁴ in eigenvalues ω², and as much in ω: halving h divides it by 16, within a quarter
/// for the terms of higher order.
#[test]
fn hermite_elements_gain_a_factor_of_16_with_each_cut() {
    for scene in scenes_named(&ORDINARY) {
        let error = |parts| Problem::new(&scene, parts, 3).solve(scene.exact.len()).error(&scene.exact);
        let (coarse, fine) = (error(8), error(16));
        assert!((12.0..20.0).contains(&(coarse / fine)), "{}: {coarse:e}, {fine:e}", scene.name);
    }
}

/// Degrees gain digits geometrically: four more at least a factor of 1000, where rounding does not end it, down to 1e-12.
#[test]
fn degrees_gain_digits_until_rounding_ends_it() {
    for scene in scenes_named(&ORDINARY) {
        let error = |degree| Problem::new(&scene, 1, degree).solve(scene.exact.len()).error(&scene.exact);
        let (coarse, fine) = (error(9), error(13));
        assert!(fine <= (1e-3 * coarse).max(1e-12), "{}: {coarse:e}, {fine:e}", scene.name);
        assert!(error(16) <= 1e-12, "{}: {:e}", scene.name, error(16));
    }
}

/// The hundredth mode needs two and more degrees a half-wave.
#[test]
fn one_element_reaches_the_hundredth_mode() {
    let scene = &scenes_named(&["mode 100"])[0];
    let error = |degree| Problem::new(scene, 1, degree).solve(1).error(&scene.exact);
    assert!(error(150) > 1e-4);
    assert!(error(185) < 1e-11, "{:e}", error(185));
}

/// A stiffness of 1e12 beside one of 1 leaves four of the sixteen digits of the sum, whatever is refined.
#[test]
fn elements_lose_soft_beams_beside_stiff_ones() {
    let scene = &scenes_named(&["stiff"])[0];
    assert!(Problem::new(scene, 1, 12).solve(3).error(&scene.exact) > 1e-6);
}

/// Iterations end within their tolerance; the determinant has rounding of its own, e^{βl} eps, 1e-10 at most here.
#[test]
fn the_plain_method_keeps_its_tolerance() {
    for scene in scenes_named(&["4.1a", "4.2", "4.3", "4.4", "4.5", "stiff"]) {
        for tolerance in [1e-4, 1e-8] {
            let error = (scene.plain)(tolerance).error(&scene.exact);
            assert!(error <= tolerance + 1e-10, "{}: {error:e}", scene.name);
        }
    }
}

/// Noise has zeros, and a close pair has no sign change between two points of a grid.
#[test]
fn the_plain_method_fails_at_extremes() {
    for scene in scenes_named(&["mode 100", "close pair"]) {
        assert!((scene.plain)(1e-12).error(&scene.exact) > 1e-4, "{}", scene.name);
    }
}

/// The tolerance of a scan is relative to the end of its range, and the point found is off by it at most.
#[test]
fn the_scan_for_minima_keeps_its_tolerance() {
    let ends = [("4.1a", 1700.0), ("4.2", 3000.0), ("4.3", 2000.0), ("4.4", 17_500.0), ("4.5", 12_000.0)];
    for (scene, (name, end)) in scenes_named(&ends.map(|entry| entry.0)).iter().zip(ends) {
        assert_eq!(scene.name, name);
        let error = (scene.scan)(1e-8).error(&scene.exact);
        assert!(error <= 1e-8 * end / scene.exact[0].norm(), "{name}: {error:e}");
    }
}

/// The trapezoidal rule gains digits geometrically, here a factor of 80 with four nodes of half the contour, until the residues of very
/// different size end it beyond 1e-9.
#[test]
fn the_contour_integral_converges_geometrically() {
    let scene = &scenes_named(&["4.5"])[0];
    let contour = scene.contour.as_ref().unwrap();
    let errors = [12, 16, 20, 24, 28].map(|nodes| contour(nodes).error(&scene.exact));
    assert!(errors.windows(2).take(3).all(|pair| pair[1] < pair[0] / 40.0), "{errors:?}");
    assert!(errors[4] < 1e-9, "{errors:?}");
}
