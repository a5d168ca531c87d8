//! Tapered beams against Ritz's method in 500 bits: polynomials of high degree in elements of their own, which know no differential equation.

use crate::element::TaperedNumbers;
use crate::element::{Element, TransferMatrix};
use crate::elements::TaperedBeam;
use crate::proof::ball::Ball;
use crate::proof::bending::bending;
use crate::proof::front::{Front, Variable};
use crate::proof::member::place;
use crate::proof::number::{Number, TwoWords};
use crate::proof::tapered::{pieces, places as pieces_with_places};
use ritz::{Exact, big, element, eliminated, energy, ritz};

mod ritz;

type Two = TwoWords<f64>;

const BLADE: TaperedBeam<f64> = TaperedBeam {
    length: 1.3,
    bending_stiffness: 2.0,
    mass_per_length: 0.7,
    width_taper: 0.3,
    height_taper: 0.6,
    rotary_inertia: 0.01,
    axial_force: 0.8,
    axial_load: -0.9,
    rotation_speed: 1.7,
    hub_radius: 0.4,
    setting_angle: 0.9,
    foundation_stiffness: 1.1,
};

const UNIFORM: TaperedBeam<f64> = TaperedBeam {
    width_taper: 0.0,
    height_taper: 0.0,
    rotary_inertia: 0.0,
    axial_force: 0.0,
    axial_load: 0.0,
    rotation_speed: 0.0,
    foundation_stiffness: 0.0,
    ..BLADE
};

fn section(beam: TaperedBeam<f64>) -> TaperedNumbers {
    TaperedNumbers {
        length: [beam.length, 0.0],
        bending_stiffness: [beam.bending_stiffness, 0.0],
        mass_per_length: [beam.mass_per_length, 0.0],
        width_taper: [beam.width_taper, 0.0],
        height_taper: [beam.height_taper, 0.0],
        rotary_inertia: [beam.rotary_inertia, 0.0],
        axial_force: [beam.axial_force, 0.0],
        axial_load: [beam.axial_load, 0.0],
        rotation_speed: [beam.rotation_speed, 0.0],
        hub_radius: [beam.hub_radius, 0.0],
        setting_angle: [beam.setting_angle, 0.0],
        foundation_stiffness: [beam.foundation_stiffness, 0.0],
    }
}

/// The lower triangle of a whole beam from its pieces, its clamped count as that of the negative pivots, and the number of pieces.
fn joined(section: &TaperedNumbers, square: f64) -> ([Ball<Two>; 10], usize, usize) {
    let mut whole: Option<[Ball<Two>; 10]> = None;
    let (mut count, mut negative) = (0, 0);
    pieces::<Two>((section, Ball::of_pair(section.length)), Ball::of(square), &mut |member, _| {
        assert!(member.border.is_none() && member.held == [0.0; 2]);
        count += 1;
        let Some(before) = whole else {
            whole = Some(member.stiffness);
            return;
        };
        let mut all = [[Ball::of(0.0); 6]; 6];
        for row in 0..4 {
            for column in 0..4 {
                all[row][column] = all[row][column] + before[place(row, column)];
                all[row + 2][column + 2] = all[row + 2][column + 2] + member.stiffness[place(row, column)];
            }
        }
        for pivot in [2, 3] {
            let ball = all[pivot][pivot];
            assert!(ball.is_positive() || ball.is_negative(), "pivot {count}: {ball:?}");
            negative += usize::from(ball.is_negative());
            let (own, inverse) = (all[pivot], ball.inverse());
            for row in 0..6 {
                for column in 0..6 {
                    all[row][column] = all[row][column] - own[row] * inverse * own[column];
                }
            }
        }
        let ends = [0, 1, 4, 5];
        let mut triangle = [Ball::of(0.0); 10];
        for row in 0..4 {
            for column in 0..=row {
                triangle[place(row, column)] = all[ends[row]][ends[column]];
            }
        }
        whole = Some(triangle);
    })
    .unwrap();
    (whole.unwrap(), negative, count)
}

/// Entries of some of the pieces of a beam are in their balls, which are narrow beside the stiffnesses of their rows; and none has a
/// frequency below.
#[track_caller]
fn assert_pieces(beam: TaperedBeam<f64>, square: f64, degree: usize, every: usize) {
    let profile = energy(beam, &big(square));
    let (mut count, mut widest, mut used) = (0, 0.0_f64, 0.0_f64);
    pieces_with_places::<Two>(
        (&section(beam), Ball::of(beam.length)),
        Ball::of(square),
        &mut |[start, width], member| {
            count += 1;
            if count % every != 1 % every {
                return;
            }
            let (exact, negative) = element(&profile, beam.length, start, width, degree);
            assert_eq!(negative, 0, "held frequencies of piece {count}");
            for row in 0..4 {
                for column in 0..=row {
                    let ball = member.stiffness[place(row, column)];
                    let off = (big(ball.mid.hi) + big(ball.mid.lo) - &exact[row][column]).to_f64().value().abs();
                    widest = widest.max(ball.rad / (member.sizes[row] * member.sizes[column]).sqrt());
                    used = used.max(off / ball.rad);
                    assert!(off <= ball.rad, "piece {count}, {row} {column}: {off:e} of {ball:?}");
                }
            }
        },
    )
    .unwrap();
    assert!(widest < 3e-27, "{widest:e}");
    std::println!("{count} pieces, radius {widest:.1e}, {used:.1e} of it used");
}

#[test]
fn entries_of_pieces_are_in_their_balls() {
    for case in 0..12 {
        let (beam, square) = one_piece(case);
        assert_pieces(beam, square, 24, 1);
    }
    for square in [30.0, -1e3, 3e4] {
        assert_pieces(BLADE, square, 28, 3);
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn entries_of_many_pieces_are_in_their_balls() {
    for case in 0..1000 {
        let (beam, square) = one_piece(case);
        assert_pieces(beam, square, 30, 1);
    }
}

/// A random beam that is one piece or nearly, and ω².
fn one_piece(case: u32) -> (TaperedBeam<f64>, f64) {
    let mut seed = u64::from(case) * 1000 + 12345;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    next();
    let beam = TaperedBeam {
        length: 0.5 + 0.4 * next(),
        bending_stiffness: 1.5 + next(),
        mass_per_length: 1.5 + next(),
        width_taper: 0.124 * next(),
        height_taper: 0.124 * next(),
        rotary_inertia: 0.02 + 0.02 * next(),
        axial_force: 2.0 * next(),
        axial_load: 3.0 * next(),
        rotation_speed: 1.0 + next(),
        hub_radius: next(),
        setting_angle: 3.0 * next(),
        foundation_stiffness: 20.0 * next(),
    };
    (beam, 50.0 * next())
}

#[test]
fn whole_beams_are_in_their_balls() {
    let (triangle, negative, _) = joined(&section(BLADE), 30.0);
    let (exact, expected) = ritz(BLADE, &big(30.0), 34, 0.34);
    for (ball, exact) in triangle.iter().zip(exact) {
        let off = (big(ball.mid.hi) + big(ball.mid.lo) - exact).to_f64().value().abs();
        assert!(off <= ball.rad, "{off:e} of {ball:?}");
    }
    assert_eq!(negative, expected);
}

#[test]
fn uniform_beams_are_those_of_the_closed_form() {
    for x in [0.0, 0.25, 10.0, 250.0, 1250.0, 2.5e5] {
        let beam = TaperedBeam { length: 1.0, bending_stiffness: 2.0, mass_per_length: 0.5, ..UNIFORM };
        let (triangle, negative, count) = joined(&section(beam), x * 4.0);
        let closed = bending(Ball::<Two>::of(x));
        assert!(closed.border.is_none());
        assert_eq!(closed.held, [negative as f64; 2]);
        assert_eq!(count == 1, x < 290.0, "{count} pieces");
        for (ball, other) in triangle.into_iter().zip(closed.stiffness) {
            let difference = ball - other.scaled(2.0);
            assert!(difference.mid.hi.abs() <= difference.rad, "{ball:?} {other:?}");
            assert!(difference.rad < if count == 1 { 1e-26 } else { 1e-7 } * ball.mid.hi.abs(), "{difference:?}");
        }
    }
}

/// Bounds of the number of frequencies below of a beam with free ends.
fn count_of_free(section: &TaperedNumbers, omega: f64) -> [f64; 2] {
    // bounds from above are those that pivots lowered by their errors give
    [1.0, -1.0].map(|toward| {
        let (mut entries, mut variables) = ([Two::of(0.0); 10], [Variable::none(); 4]);
        let mut front = Front::<Two>::new(&mut entries, &mut variables, toward);
        let mut ends = [front.enter().unwrap(), front.enter().unwrap()];
        pieces((section, Ball::of_pair(section.length)), Ball::of_product(omega, omega), &mut |member, _| {
            let others = [front.enter().unwrap(), front.enter().unwrap()];
            let all = [ends[0], ends[1], others[0], others[1]];
            for row in 0..4 {
                front.grow(all[row], member.sizes[row]);
            }
            for row in 0..4 {
                for column in 0..=row {
                    front.add(all[row], all[column], member.stiffness[place(row, column)]);
                }
            }
            ends.into_iter().for_each(|end| front.leave(end));
            ends = others;
        })
        .unwrap();
        ends.into_iter().for_each(|end| front.leave(end));
        front.total.negative
    })
}

/// The neighbouring floats about a frequency, by bounds that meet.
fn bracket(section: &TaperedNumbers, index: f64, mut range: [f64; 2]) -> [f64; 2] {
    while range[1] > range[0].next_up() {
        let middle = (range[0] + 0.5 * (range[1] - range[0])).clamp(range[0].next_up(), range[1].next_down());
        let [least, most] = count_of_free(section, middle);
        assert_eq!(least, most, "bounds at {middle}");
        range[usize::from(least >= index)] = middle;
    }
    range
}

/// A frequency is proven between neighbouring floats, at which the signs of Ritz's method tell the same numbers.
#[test]
fn frequencies_lie_between_neighbouring_floats() {
    let beam = TaperedBeam { axial_force: -0.5, ..BLADE };
    for (index, degree) in [(3.0, 30), (6.0, 40)] {
        for (end, omega) in bracket(&section(beam), index, [0.1, 1000.0]).into_iter().enumerate() {
            let square = Exact::try_from(omega).unwrap().with_precision(500).value();
            assert_eq!(free_by_ritz(beam, &square * &square, degree, 0.51), index as usize - 1 + end, "{omega}");
        }
    }
}

/// The number of frequencies below of a beam with free ends by Ritz's method.
fn free_by_ritz(beam: TaperedBeam<f64>, square: Exact, degree: usize, share: f64) -> usize {
    let (triangle, held) = ritz(beam, &square, degree, share);
    let mut matrix = (0..4).map(|row| triangle[place(row, 0)..=place(row, row)].to_vec()).collect();
    held + eliminated(&mut matrix, 0)
}

/// The definitions of parameters are those of the element.
#[test]
fn stiffness_is_that_of_the_element() {
    let turned = TaperedBeam { width_taper: -0.7, height_taper: 0.2, hub_radius: -2.0, setting_angle: 2.5, ..BLADE };
    for beam in [BLADE, turned, TaperedBeam { rotation_speed: 9.0, rotary_inertia: 0.1, ..turned }] {
        for omega in [0.3_f64, 4.0, 20.0] {
            let (triangle, ..) = joined(&section(beam), omega * omega);
            let u = TaperedBeam::transfer_matrix(&beam.build().unwrap(), omega);
            let b = [[-u[(0, 3)], u[(0, 2)]], [-u[(1, 3)], u[(1, 2)]]];
            let det = b[0][0] * b[1][1] - b[0][1] * b[1][0];
            let inverse = [[b[1][1] / det, -b[0][1] / det], [-b[1][0] / det, b[0][0] / det]];
            let d = [[u[(3, 3)], -u[(3, 2)]], [-u[(2, 3)], u[(2, 2)]]];
            for i in 0..2 {
                for j in 0..2 {
                    let product = |k: usize| inverse[i][k] * u[(k, j)];
                    let (first, between) = (product(0) + product(1), -inverse[i][j]);
                    let last = d[i][0] * inverse[0][j] + d[i][1] * inverse[1][j];
                    for (row, column, expected) in [(i, j, first), (i, j + 2, between), (i + 2, j + 2, last)] {
                        let found = triangle[place(row, column)].mid.hi;
                        let scale = triangle[0].mid.hi.abs() + triangle[9].mid.hi.abs();
                        assert!((found - expected).abs() < 1e-8 * scale, "{omega} {row} {column}: {found} {expected}");
                    }
                }
            }
        }
    }
}

#[test]
fn too_many_pieces_are_refused() {
    let torn = TaperedBeam { axial_force: -1e50, ..BLADE };
    for (beam, square) in [(BLADE, 1e60), (BLADE, f64::INFINITY), (BLADE, f64::NAN), (torn, 0.0)] {
        assert!(pieces::<Two>((&section(beam), Ball::of(beam.length)), Ball::of(square), &mut |_, _| ()).is_none());
    }
}

/// Sharp wedges, buckled and stretched beams, fast rotors, foundations, ω² of both signs.
#[test]
#[ignore = "long: .ci/long"]
fn entries_of_extreme_beams_are_in_their_balls() {
    let wedge = TaperedBeam { width_taper: 0.999_999, height_taper: 0.999_999, ..UNIFORM };
    let flared = TaperedBeam { width_taper: -1e3, height_taper: -20.0, ..UNIFORM };
    let buckled = TaperedBeam { axial_force: -300.0, ..BLADE };
    let stretched = TaperedBeam { axial_force: 3e3, ..BLADE };
    let hanging = TaperedBeam { axial_force: 0.0, axial_load: 4e3, ..BLADE };
    let standing = TaperedBeam { axial_force: 0.0, axial_load: -400.0, ..BLADE };
    let rotor = TaperedBeam { rotation_speed: 40.0, hub_radius: 0.1, setting_angle: 1.5, ..BLADE };
    let inward = TaperedBeam { rotation_speed: 20.0, hub_radius: -1.5, setting_angle: -0.4, ..BLADE };
    let soft = TaperedBeam { foundation_stiffness: -2e3, ..BLADE };
    let stiff = TaperedBeam { foundation_stiffness: 1e5, rotary_inertia: 0.3, ..BLADE };
    for (name, beam) in [
        ("wedge", wedge),
        ("flared", flared),
        ("buckled", buckled),
        ("stretched", stretched),
        ("hanging", hanging),
        ("standing", standing),
        ("rotor", rotor),
        ("inward", inward),
        ("soft", soft),
        ("stiff", stiff),
    ] {
        for square in [0.0, 20.0, -20.0, 5e3, -5e3, 3e5] {
            std::print!("{name} {square}: ");
            assert_pieces(beam, square, 30, 5);
            let omega = f64::sqrt(f64::abs(square));
            if square > 0.0 {
                let exact = free_by_ritz(beam, big(omega) * big(omega), 34, 0.13);
                assert_eq!(count_of_free(&section(beam), omega), [exact as f64; 2]);
            }
        }
    }
}
