//! Shear coefficients by Cowper's definition, from solutions of his boundary value problem.
//!
//! For deflections along z the function W with `∇²W = 2 z` and `∂W/∂n = ν G·n` at the outline, `G = (-y z, (y² - z²)/2)` along (y, z), has
//! `k = 2 (1 + ν) I_y/(ν/2 (I_z - I_y) - A/I_y ∫ z W dA)`. The field `∇W - ν G` has the divergence `2 (1 + ν) z` and nothing through the outline.

use super::*;

/// Cowper's definition, given the area, `∫ z²`, `∫ y²` and `∫ z W`.
fn cowper(nu: f64, [area, along, across]: [f64; 3], work: f64) -> f64 {
    2.0 * (1.0 + nu) * along / (nu / 2.0 * (across - along) - area / along * work)
}

const RATIOS: [f64; 4] = [0.0, 0.2, 0.3, 0.5];

/// `W = w(r) sin θ`, `w = r³/4 + a r + b/r` with `w' = -ν r²/2` at both radii.
#[test]
fn rings_of_any_thickness_solve_the_problem() {
    for nu in RATIOS {
        for inner in [0.2, 0.5, 0.8, 0.99] {
            let slope = -(nu / 2.0 + 0.75);
            let (a, b) = (slope * (1.0 + inner * inner), slope * inner * inner);
            // π ∫ w r² dr
            let powers = |n: i32| (1.0 - inner.powi(n)) / f64::from(n);
            let work = PI * (powers(6) / 4.0 + a * powers(4) + b * powers(2));
            let tube = Tube { outer: 2.0, inner: 2.0 * inner };
            let found = tube.properties().unwrap();
            let exact = cowper(nu, [found.area, found.i_y, found.i_z], work);
            let k = tube.shear_coefficients(nu).unwrap();
            assert_near(k.z, exact, 1e-10);
            assert_eq!(k.y, k.z);
        }
        // a full circle: b = 0
        let work = PI * (1.0 / 24.0 - (nu / 2.0 + 0.75) / 4.0);
        let exact = cowper(nu, [PI, PI / 4.0, PI / 4.0], work);
        assert_near(Round { diameter: 2.0 }.shear_coefficients(nu).unwrap().z, exact, 1e-14);
    }
}

/// Green's theorem with `z³/6` and `z` makes `∫ z W` integrals of what is known at the outline.
#[test]
fn rectangles_solve_the_problem() {
    for nu in RATIOS {
        for (width, height) in [(1.0, 1.0), (0.5, 3.0), (4.0, 0.25)] {
            let (b, h): (f64, f64) = (width / 2.0, height / 2.0);
            let moment = |n: i32, half: f64| 2.0 * half.powi(n + 1) / f64::from(n + 1);
            // ∮ f(z) G·n: above and below ±(y² - z²)/2 with an odd f, at the sides ∓y z
            let along = |f: &dyn Fn(f64) -> f64, f_z: f64| f(h) * (moment(2, b) - h * h * moment(0, b)) - 2.0 * b * f_z;
            let (of_line, of_cube) = (along(&|z| z, moment(2, h)), along(&|z| z * z * z / 6.0, moment(4, h) / 6.0));
            let (second, fourth) = (moment(0, b) * moment(2, h), moment(0, b) * moment(4, h));
            // 0 = 2 ∫ z² + ∮ (W n_z - z ∂W/∂n), then ∫ z W = ∫ z⁴/3 + ∮ (W z²/2 n_z - z³/6 ∂W/∂n)
            let through = nu * of_line - 2.0 * second;
            let work = fourth / 3.0 + h * h / 2.0 * through - nu * of_cube;
            let exact = cowper(nu, [4.0 * b * h, second, moment(2, b) * moment(0, h)], work);
            let k = Rectangle { width, height }.shear_coefficients(nu).unwrap();
            assert_near(k.z, exact, 1e-12);
            assert_eq!(k.y, k.z);
        }
    }
}

/// The middle line of a wall in the plane (y, z), and its thickness.
struct Wall {
    from: [f64; 2],
    to: [f64; 2],
    thickness: f64,
}

/// Area and moments of walls in a row, and `∫ z W`, given the flow `t (∇W - ν G)` into the first of them; W is zero where the last one ends.
fn row(nu: f64, walls: &[Wall], mut flow: f64) -> ([f64; 3], f64) {
    const STEPS: u32 = 2000;
    let (mut sums, mut line) = ([0.0; 3], std::vec::Vec::new());
    let mut w = 0.0;
    for wall in walls {
        let [dy, dz] = [0, 1].map(|k| (wall.to[k] - wall.from[k]) / f64::from(STEPS));
        let length = dy.hypot(dz);
        for step in 0..STEPS {
            let part = f64::from(step) + 0.5;
            let [y, z] = [wall.from[0] + part * dy, wall.from[1] + part * dz];
            let area = wall.thickness * length;
            let along = [-y * z * dy, (y * y - z * z) / 2.0 * dz].iter().sum::<f64>();
            // at the middle of the step
            let half = (1.0 + nu) * z * area;
            let rise = (flow + half) / wall.thickness * length + nu * along;
            line.push((z * area, w + rise / 2.0));
            w += rise;
            flow += 2.0 * half;
            for (sum, factor) in sums.iter_mut().zip([1.0, z * z, y * y]) {
                *sum += factor * area;
            }
        }
    }
    let work = line.iter().map(|(weight, value)| weight * (value - w)).sum();
    (sums, work)
}

#[test]
fn boxes_solve_the_problem_of_thin_walls() {
    for nu in RATIOS {
        for (b, h) in [(1.0, 1.0), (0.4, 1.0), (3.0, 1.0)] {
            // a quarter: half of the upper wall, which no flow enters, and the upper half of the right one
            let (y, z) = (b / 2.0, h / 2.0);
            let quarter = [
                Wall { from: [0.0, z], to: [y, z], thickness: 1e-3 },
                Wall { from: [y, z], to: [y, 0.0], thickness: 1e-3 },
            ];
            let (sums, work) = row(nu, &quarter, 0.0);
            let exact = cowper(nu, sums.map(|sum| 4.0 * sum), 4.0 * work);
            let section = BoxSection { width: b + 1e-3, height: h + 1e-3, wall: 1e-3 };
            assert_near(section.shear_coefficients(nu).unwrap().z, exact, 2e-6);
            let turned = BoxSection { width: section.height, height: section.width, wall: section.wall };
            assert_eq!(turned.shear_coefficients(nu).unwrap().y, section.shear_coefficients(nu).unwrap().z);
        }
    }
    // Cowper's square
    let square = BoxSection { width: 1.0, height: 1.0, wall: 0.01 }.shear_coefficients(0.3).unwrap();
    assert_near(square.z, 26.0 / 59.7, 1e-14);
}

#[test]
fn i_sections_solve_the_problem_of_thin_walls() {
    for nu in RATIOS {
        for (b, h, flange, web) in [(1.0, 1.0, 1e-3, 1e-3), (0.5, 2.0, 3e-3, 1e-3), (2.0, 1.0, 1e-3, 4e-3)] {
            let (y, z) = (b / 2.0, h / 2.0);
            // half of the upper flange from its free end, where nothing flows, to the web; the web gets both halves' flow
            let half = [Wall { from: [y, z], to: [0.0, z], thickness: flange }];
            let (flange_sums, flange_work) = row(nu, &half, 0.0);
            let inflow = 2.0 * 2.0 * (1.0 + nu) * z * y * flange;
            let (web_sums, web_work) = row(nu, &[Wall { from: [0.0, z], to: [0.0, 0.0], thickness: web }], inflow);
            // W of the flange is that of the web where they meet; `row` has it as zero
            let top = web_start(nu, z, inflow / web);
            let work = 4.0 * (flange_work + z * y * flange * top) + 2.0 * web_work;
            let sums = [0, 1, 2].map(|k| 4.0 * flange_sums[k] + 2.0 * web_sums[k]);
            let section = ISection { width: b, height: h + flange, flange, web };
            assert_near(section.shear_coefficients(nu).unwrap().z, cowper(nu, sums, work), 2e-6);
        }
    }
}

/// W at the top of a web, `-∫ W' ds` down to z = 0, given the flow per thickness into it.
fn web_start(nu: f64, z: f64, inflow: f64) -> f64 {
    // W' = inflow + 2 (1 + ν) (z s - s²/2) + ν (z - s)²/2
    -(inflow * z + 2.0 * (1.0 + nu) * (z.powi(3) / 2.0 - z.powi(3) / 6.0) + nu * z.powi(3) / 6.0)
}

/// Flanges that are all of the section are two rectangles, and a web takes its part of the area.
#[test]
fn flanges_carry_shear_along_them() {
    let section = ISection { width: 1.0, height: 2.0, flange: 0.25, web: 0.5 };
    let k = section.shear_coefficients(0.0).unwrap();
    assert_near(k.y, 5.0 / 6.0 * 0.5 / 1.25, 1e-15);
}
