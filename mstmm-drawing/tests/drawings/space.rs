//! Modes and forces of frames in space: against closed forms, and against the same frame in the plane.

use crate::reading::{Picture, Shown};
use crate::space_frames::{joints, mast, platform, row, tube};
use mstmm::frame::{Frame, Point, Section, Space, Structure};
use mstmm::network::{Freedoms, Support};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError, Force, View};
use std::path::Path;

/// Half of the last digit of a path, of a place and of its displacement.
const DIGIT: f64 = 0.0101;

/// Writes each model from all sides, its third mode and its forces, for those who want to see them.
#[test]
fn the_gallery_in_space_is_written() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    std::fs::create_dir_all(&folder).unwrap();
    for (name, frame) in [("space_row", row()), ("space_joints", joints()), ("space_mast", mast())] {
        let shape = frame.mode_shape(&frame.frequencies(3).unwrap()[2]).unwrap();
        let file = |kind: &str| folder.join(format!("{name}{kind}.svg"));
        Drawing::of(&frame).unwrap().write(file("")).unwrap();
        for (kind, view) in [("_front", View::front()), ("_side", View::side()), ("_plan", View::plan())] {
            Drawing::of(&frame).unwrap().view(view).unwrap().write(file(kind)).unwrap();
        }
        Drawing::of(&frame).unwrap().mode(&shape).unwrap().write(file("_mode")).unwrap();
        for force in [Force::Axial, Force::Shear, Force::Moment, Force::Torque] {
            let drawing = Drawing::of(&frame).unwrap().forces(&shape, force).unwrap();
            drawing.write(file(&format!("_{force:?}").to_lowercase())).unwrap();
        }
    }
    let platform = platform();
    let shape = platform.mode_shape(&platform.first_eigenvalues::<3>().unwrap()[1]).unwrap();
    Drawing::of(&platform).unwrap().write(folder.join("space_platform.svg")).unwrap();
    Drawing::of(&platform).unwrap().mode(&shape).unwrap().write(folder.join("space_platform_mode.svg")).unwrap();
}

/// A cantilever of 3 m along x.
fn cantilever() -> (Structure<Space>, Point<Space>) {
    let mut frame = Frame::new();
    let [foot, tip] = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]].map(|place| frame.point(place));
    frame.member(foot, tip, tube());
    frame.hold(foot, Support::Fixed);
    (frame.build().unwrap(), tip)
}

/// The corners of all lines of a member, from left to right.
fn corners(shown: &[Shown], name: &str) -> Vec<[f64; 2]> {
    let own = shown.iter().filter(|shown| shown.name == name);
    let mut corners: Vec<[f64; 2]> = own.flat_map(|shown| shown.lines(false)).flatten().copied().collect();
    corners.sort_by(|one, other| one[0].total_cmp(&other[0]));
    corners
}

/// A force at the tip, along z or y, bends a cantilever by `F x² (3l - x)/(6EI)`, which is seen from before it or from above.
#[test]
fn deflections_are_those_of_a_cantilever() {
    let (frame, tip) = cantilever();
    for (load, view, other) in
        [(tip.force_z(), View::front(), View::plan()), (tip.force_y(), View::plan(), View::front())]
    {
        let states = frame.frequency_response(load, tip.displacement_x()).unwrap().states(0.0).unwrap();
        let drawing = || Drawing::of(&frame).unwrap().mode(&states).unwrap();
        let picture = Picture::of(drawing().view(view).unwrap());
        let reach = picture.number("data-reach");
        let line = corners(&picture.shown("still"), "member 0");
        assert!(line.len() >= 25);
        for point in line {
            let [x, _] = picture.in_model(point);
            let expected = reach * x * x * (9.0 - x) / (6.0 * 2e6);
            let [_, origin] = picture.in_model([0.0, 0.0]);
            let height = origin * picture.number("data-scale") - point[1];
            assert!((height - expected).abs() < DIGIT, "{x}: {height} and {expected}");
        }
        let flat = Picture::of(drawing().view(other).unwrap());
        let line = corners(&flat.shown("still"), "member 0");
        assert!(line.iter().all(|point| (point[1] - line[0][1]).abs() < DIGIT), "{line:?}");
    }
}

/// The ordinates of a member along x: at which place, how far from it on the paper in units of the force.
fn ordinates(picture: &Picture) -> Vec<[f64; 2]> {
    let force = picture.shown("force");
    let (feet, tips) = force[0].paths[0].split_at(2);
    let unit = picture.number("data-force-scale");
    tips.iter().map(|[x, y]| [picture.in_model([*x, 0.0])[0], (feet[0][1] - y) / unit]).collect()
}

/// The moment under a force upwards, `F (l - x)`, stretches the lower side; what has no part on the paper is seen as a line.
#[test]
fn diagrams_are_those_of_a_cantilever() {
    let (frame, tip) = cantilever();
    let picture = |load, force, view| {
        let states = frame.frequency_response(load, tip.displacement_x()).unwrap().states(0.0).unwrap();
        Picture::of(Drawing::of(&frame).unwrap().forces(&states, force).unwrap().view(view).unwrap())
    };
    let check = |picture: Picture, expected: &dyn Fn(f64) -> f64| {
        let tolerance = 2.0 * DIGIT / picture.number("data-force-scale");
        let found = ordinates(&picture);
        assert!(found.len() >= 25);
        for [x, upwards] in found {
            assert!((upwards - expected(x)).abs() < tolerance, "{x}: {upwards}");
        }
        picture.labels().into_iter().filter(|label| label.class == "value").map(|label| label.text).collect::<Vec<_>>()
    };
    let moment = |x: f64| x - 3.0;
    let upwards = |force, view| picture(tip.force_z(), force, view);
    assert_eq!(check(upwards(Force::Moment, View::front()), &moment), ["3.00"]);
    assert_eq!(check(upwards(Force::Moment, View::plan()), &|_| 0.0), ["3.00"]);
    let backwards = |force, view| picture(tip.force_y(), force, view);
    assert_eq!(check(backwards(Force::Moment, View::plan()), &moment), ["3.00"]);
    // shear forces are derivatives of moments by x: in the plane `M' = F_y`, across it with the other sign of right-handed moments
    assert_eq!(check(backwards(Force::Shear, View::plan()), &|_| -1.0), ["1.00"]);
    assert_eq!(check(upwards(Force::Shear, View::front()), &|_| -1.0), ["1.00"]);
    let turning = picture(tip.torque_x(), Force::Torque, View::front());
    assert_eq!(check(turning, &|_| 1.0), ["1.00"]);
    let pulling = picture(tip.force_x(), Force::Axial, View::front());
    assert_eq!(check(pulling, &|_| 1.0), ["1.00"]);
    let states = frame.frequency_response(tip.force_z(), tip.displacement_x()).unwrap().states(0.0).unwrap();
    let error = Drawing::of(&frame).unwrap().forces(&states, Force::Torque).unwrap_err();
    assert!(matches!(error, DrawingError::NoForce { force: "torque" }), "{error}");
}

/// A portal with a strut, which moves in the plane of x and y alone: how places are written, the section, and what is held everywhere.
macro_rules! portal {
    ($place:expr, $steel:expr, $held:expr) => {{
        let (mut frame, place, steel, held) = (Frame::new(), $place, $steel, $held);
        let points = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.5], [4.0, 0.0]].map(|at| frame.point(place(at)));
        for pair in [[0, 1], [1, 2], [2, 3], [0, 2]] {
            frame.member(points[pair[0]], points[pair[1]], steel);
        }
        let ends = [Freedoms::PLANE, held, held, Freedoms::X.union(Freedoms::Y)];
        for (point, own) in points.into_iter().zip(ends) {
            if !own.union(held).is_empty() {
                frame.hold(point, own.union(held));
            }
        }
        (frame.build().unwrap(), points[1])
    }};
}

/// How far a place is from a line.
pub(crate) fn beside(line: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let from = |pair: &[[f64; 2]]| {
        let ([u, v], [a, b]) = ([pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]], [x - pair[0][0], y - pair[0][1]]);
        let part = ((a * u + b * v) / (u * u + v * v).max(1e-12)).clamp(0.0, 1.0);
        (a - part * u).hypot(b - part * v)
    };
    line.windows(2).map(from).fold(f64::INFINITY, f64::min)
}

/// A frame that moves in a plane is drawn from above as that of the plane.
#[test]
fn frames_in_a_plane_are_drawn_as_those_of_the_plane() {
    let steel = Section::new().axial_stiffness(4e8).bending_stiffness(2e6).mass_per_length(20.0);
    let out_of_plane = Freedoms::Z.union(Freedoms::RX).union(Freedoms::RY);
    let (flat, head) = portal!(|[x, y]: [f64; 2]| [x, y], steel, Freedoms::NONE);
    let (space, above) = portal!(|[x, y]: [f64; 2]| [x, y, 0.0], tube(), out_of_plane);
    let shapes = |mode: usize| {
        // members in space bend across the plane, too
        let one = flat.frequencies(4).unwrap()[mode];
        let all = space.frequencies(16).unwrap();
        let other = *all.iter().find(|other| (one.omega - other.omega).abs() < 1e-9 * one.omega).unwrap();
        (flat.mode_shape(&one).unwrap(), space.mode_shape(&other).unwrap())
    };
    for mode in 0..4 {
        let (one, other) = shapes(mode);
        let expected = Picture::of(Drawing::of(&flat).unwrap().mode(&one).unwrap());
        let found = Picture::of(Drawing::of(&space).unwrap().mode(&other).unwrap().view(View::plan()).unwrap());
        let (expected, found) = (expected.shown("still"), found.shown("still"));
        for member in &expected {
            let own = found.iter().filter(|shown| shown.name == member.name).flat_map(|shown| shown.lines(false));
            let mut count = 0;
            for point in own.flatten() {
                let beside = beside(&member.paths[0], *point);
                assert!(beside < 0.03, "{} in mode {mode}: {beside}", member.name);
                count += 1;
            }
            assert!(count >= 25, "{}", member.name);
        }
    }
    let (one, other) = (
        flat.frequency_response(head.force_x(), head.displacement_x()).unwrap().states(0.0).unwrap(),
        space.frequency_response(above.force_x(), above.displacement_x()).unwrap().states(0.0).unwrap(),
    );
    for force in [Force::Moment, Force::Shear] {
        let expected = Picture::of(Drawing::of(&flat).unwrap().forces(&one, force).unwrap());
        let drawing = Drawing::of(&space).unwrap().forces(&other, force).unwrap();
        let found = Picture::of(drawing.view(View::plan()).unwrap());
        let ratio = found.number("data-force-scale") / expected.number("data-force-scale");
        assert!((ratio - 1.0).abs() < 1e-6);
        for member in expected.shown("force") {
            let own = found.shown("force").into_iter().find(|shown| shown.name == member.name).unwrap();
            let apart = own.paths[0].iter().map(|point| beside(&member.paths[0], *point)).fold(0.0, f64::max);
            assert!(apart < 0.03, "{} of {force:?}: {apart}", member.name);
        }
    }
}

/// Each path swings about itself at rest between two ends, and of a damped motion comes back after a turn.
#[test]
fn modes_swing() {
    let portal = mast();
    let shape = portal.mode_shape(&portal.frequencies(2).unwrap()[1]).unwrap();
    let picture = Picture::of(Drawing::of(&portal).unwrap().mode(&shape).unwrap());
    let animations = picture.animations();
    assert!(animations.len() > 40);
    let mut most = 0.0_f64;
    for (own, moments) in &animations {
        assert!(moments.len() == 3 && moments[0] == *own && moments[2] == *own);
        assert_eq!(moments[1].len(), own.len());
        for (from, to) in own.iter().zip(&moments[1]) {
            most = most.max((from[0] - to[0]).hypot(from[1] - to[1]));
        }
    }
    // the largest displacement is at least 22 units to both sides, if it is not seen from its end
    assert!((20.0..=112.0).contains(&most), "{most}");
    let platform = platform();
    let shape = platform.mode_shape(&platform.first_eigenvalues::<3>().unwrap()[1]).unwrap();
    let animations = Picture::of(Drawing::of(&platform).unwrap().mode(&shape).unwrap()).animations();
    assert!(animations.len() > 20);
    for (own, moments) in animations {
        assert!(moments.len() == 17 && moments[0] == own && moments[16] == own);
        assert!(moments.iter().all(|moment| moment.len() == own.len()));
    }
}

/// Each support has the symbol of what it holds, and its ground is where it is in the model.
#[test]
fn supports_hold_what_their_symbols_say() {
    let picture = Picture::of(Drawing::of(&row()).unwrap().view(View::side()).unwrap());
    let mut supports = picture.shown("supports");
    let index = |shown: &Shown| shown.name.rsplit_once(' ').unwrap().1.parse::<u32>().unwrap();
    supports.sort_by_key(index);
    let kinds: Vec<_> = supports.iter().map(|support| support.kind.as_str()).collect();
    assert_eq!(kinds, ["fixed", "pinned", "roller", "roller", "guided", "guided", "rotation", "roller"]);
    let grounds: Vec<[f64; 2]> = supports.iter().map(|support| support.ground.unwrap()).collect();
    let down = [0.0, 1.0];
    // the fifth is held along (0, 0.6, 0.8), the last one along x, which leads to the reader
    for (found, [x, y]) in grounds.into_iter().zip([down, down, down, down, [-0.6, 0.8], down, down, [0.0, 0.0]]) {
        assert!((found[0] - x).abs() < 1e-12 && (found[1] - y).abs() < 1e-12, "{found:?}");
    }
}

/// The symbols of joints, in the order of the chain, are named by what they tie.
#[test]
fn joints_and_bodies_are_drawn_once() {
    let all = Picture::of(Drawing::of(&joints()).unwrap()).shown("model");
    let drawn = |name: &str| all.iter().filter(|shown| shown.name == format!("member {name}")).count();
    assert_eq!(["1", "4", "7", "10", "13", "16"].map(drawn), [1; 6]);
    assert_eq!(all.iter().filter(|shown| shown.kind == "release").count(), 2);
    let mast = mast();
    let picture = Picture::of(Drawing::of(&mast).unwrap().view(View::front()).unwrap());
    let body = picture.shown("model").into_iter().filter(|shown| shown.kind == "rigid_body").collect::<Vec<_>>();
    // a block around the mass centre, of which one face is seen from before it
    let block: Vec<_> = body.iter().flat_map(|shown| shown.lines(false)).filter(|path| path.len() == 4).collect();
    assert_eq!(block.len(), 1);
    let middle = [0, 1].map(|axis| block[0].iter().map(|corner| corner[axis]).sum::<f64>() / 4.0);
    let [x, z] = picture.in_model(middle);
    assert!((x - 1.1).abs() < 1e-3 && (z - 4.4).abs() < 1e-3, "{x} {z}");
}
