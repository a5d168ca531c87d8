//! Torsion as a membrane under pressure: `∇²φ = -2`, zero at the outline, flat over holes, `J = 2 ∫ φ dA`. Differences on a grid, which share nothing
//! with series and formulas of thin walls.

use super::*;
use std::vec;
use std::vec::Vec;

/// What a point of the grid is.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Outside,
    Material,
    Hole,
}

/// The torsion constant of parts on a grid of unit width, by relaxation.
///
/// Over a hole the membrane is one plate: what pulls at its rim carries the pressure on it.
fn torsion(width: usize, height: usize, part: impl Fn(usize, usize) -> Part) -> f64 {
    let at = |y: usize, z: usize| z * (width + 1) + y;
    let mut parts = vec![Part::Outside; (width + 1) * (height + 1)];
    for z in 1..height {
        for y in 1..width {
            parts[at(y, z)] = part(y, z);
        }
    }
    let neighbours = |k: usize| [k - 1, k + 1, k - width - 1, k + width + 1];
    let points = |wanted: Part| -> Vec<usize> { (0..parts.len()).filter(|k| parts[*k] == wanted).collect() };
    let (material, hole) = (points(Part::Material), points(Part::Hole));
    let rim: Vec<usize> = hole.iter().flat_map(|k| neighbours(*k)).filter(|k| parts[*k] == Part::Material).collect();
    let mut heights = vec![0.0; parts.len()];
    let mut change = 1.0;
    while change > 1e-9 {
        change = 0.0;
        for &k in &material {
            let balanced = (neighbours(k).iter().map(|k| heights[*k]).sum::<f64>() + 2.0) / 4.0;
            let step = 1.9 * (balanced - heights[k]);
            heights[k] += step;
            change = f64::max(change, step.abs());
        }
        if !rim.is_empty() {
            let pull: f64 = rim.iter().map(|k| heights[*k]).sum();
            let plate = (pull + 2.0 * hole.len() as f64) / rim.len() as f64;
            change = f64::max(change, (plate - heights[hole[0]]).abs());
            hole.iter().for_each(|k| heights[*k] = plate);
        }
    }
    2.0 * heights.iter().sum::<f64>()
}

/// From two grids, whose errors are as the squares of their widths: the parts of each come from its fineness.
fn extrapolated<P: Fn(usize, usize) -> Part>([width, height]: [usize; 2], parts: impl Fn(usize) -> P) -> f64 {
    let [coarse, fine] = [1, 2].map(|n: usize| torsion(width * n, height * n, parts(n)) / (n as f64).powi(4));
    (4.0 * fine - coarse) / 3.0
}

#[test]
fn rectangles_twist_as_membranes_do() {
    for [width, height] in [[20, 20], [16, 40]] {
        let exact = extrapolated([width, height], |_| |_, _| Part::Material);
        let section = Rectangle { width: width as f64, height: height as f64 };
        assert_near(section.properties().unwrap().torsion, exact, 1e-4);
    }
}

/// Walls of a fifteenth of the height: formulas of thin walls are some percent beside.
#[test]
fn thin_walls_twist_nearly_as_membranes_do() {
    let ([width, height], wall) = ([40, 60], 4);
    let post = extrapolated([width, height], |n| {
        let inside = move |place: usize, side: usize| (wall * n..=(side - wall) * n).contains(&place);
        move |y, z| if inside(y, width) && inside(z, height) { Part::Hole } else { Part::Material }
    });
    let section = BoxSection { width: width as f64, height: height as f64, wall: wall as f64 };
    assert_near(section.properties().unwrap().torsion, post, 0.05);

    let girder = extrapolated([width, height], |n| {
        let is_web = move |y: usize| y.abs_diff(n * width / 2) < n * wall / 2;
        let is_flange = move |z: usize| z < n * wall || z > n * (height - wall);
        move |y, z| if is_web(y) || is_flange(z) { Part::Material } else { Part::Outside }
    });
    let section = ISection { width: width as f64, height: height as f64, flange: wall as f64, web: wall as f64 };
    assert_near(section.properties().unwrap().torsion, girder, 0.02);
}
