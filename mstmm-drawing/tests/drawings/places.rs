//! Points and members stand where the model says, after the scale is undone.

use crate::frames::for_each_frame;
use crate::reading::{Picture, Shown};
use mstmm::motion::{Drawn, Extent};
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use paper::models;

/// Half of the last digit of a path, and rounding, on the paper.
const DIGIT: f64 = 0.0051;

/// Models with one coordinate whose paths lie side by side: their y says which of them.
const SIDE_BY_SIDE: &[&str] = &["double_beam"];

fn close(picture: &Picture, drawn: [f64; 2], place: [f64; 3]) -> bool {
    let tolerance = DIGIT / picture.number("data-scale");
    let [x, y] = picture.in_model(drawn);
    (x - place[0]).abs() <= tolerance && (y - place[1]).abs() <= tolerance && place[2] == 0.0
}

/// The first and the last corner of a part.
fn ends(shown: &Shown) -> [[f64; 2]; 2] {
    let path = &shown.paths[0];
    [path[0], path[path.len() - 1]]
}

fn find<'a>(all: &'a [Shown], name: &str) -> &'a Shown {
    let mut found = all.iter().filter(|shown| shown.name == name);
    let first = found.next().unwrap_or_else(|| panic!("{name} is not drawn"));
    assert!(found.next().is_none(), "{name} is drawn twice");
    first
}

fn check_frame<Y>(name: &str, frame: &Y)
where
    Y: Drawn<Parameter = f64> + FrameAnalysis,
{
    let picture = Picture::of(Drawing::of(frame).unwrap());
    let shown = picture.shown("model");
    let sketch = FrameAnalysis::sketch(frame);
    let points: Vec<_> = sketch.points().collect();
    let at = |drawn: [f64; 2], place: [f64; 3]| {
        let lane = if SIDE_BY_SIDE.contains(&name) { picture.in_model(drawn)[1] } else { place[1] };
        assert!(close(&picture, drawn, [place[0], lane, 0.0]), "{name}: {:?} and {place:?}", picture.in_model(drawn));
    };
    let mut count = 0;
    for point in &points {
        let own = point.name.to_string();
        if own.starts_with("conn ") || own.starts_with("node ") {
            // the body of a node of a list has its name
            let drawn = shown.iter().find(|shown| shown.name == own && shown.kind == "point");
            at(drawn.unwrap().at.unwrap(), point.position);
            count += 1;
        }
    }
    for member in sketch.members() {
        let own = member.name.to_string();
        let drawn = find(&shown, &own);
        assert_eq!(drawn.kind, member.kind, "{name}: {own}");
        let places = member.ends.map(|end| end.position);
        if member.kind == "slider" {
            let corners = &drawn.paths[0];
            let middle =
                [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / corners.len() as f64);
            at(middle, places[0].unwrap());
            continue;
        }
        // a spring that is doubled by its damper begins with its leads
        if let ([Some(from), Some(to)], false) = (places, member.kind.contains("SpringDamper")) {
            let [start, end] = ends(drawn);
            at(start, from);
            at(end, to);
            count += 1;
        }
    }
    for body in sketch.bodies().filter(|body| body.name.to_string().starts_with("rigid_body")) {
        let drawn = find(&shown, &body.name.to_string());
        at(drawn.paths[2][0], body.centre.unwrap());
        for tied in sketch.points_of(body.node) {
            // within the convex hull, whose corners are points of the body and its mass centre
            let is_corner = drawn.paths[0].iter().any(|corner| close(&picture, *corner, tied.position));
            assert!(is_corner || drawn.paths[0].len() > 2, "{name}: {}", tied.name);
        }
        count += 1;
    }
    assert!(count > 0, "{name}");
}

#[test]
fn frames_are_where_their_points_are() {
    for_each_frame!(|name, frame| check_frame(name, frame));
}

/// Lanes keep parallel beams apart, and each in one line.
#[test]
fn parallel_beams_lie_side_by_side() {
    let picture = Picture::of(Drawing::of(&crate::frames::double_beam()).unwrap());
    let shown = picture.shown("model");
    let height = |name: String| ends(find(&shown, &name)).map(|end| end[1]);
    let [upper, lower] = [1, 5].map(|first| height(format!("beam {first}"))[0]);
    assert!(lower - upper > 50.0, "{upper} and {lower}");
    for k in 0..4 {
        assert_eq!([height(format!("beam {}", 1 + k)), height(format!("beam {}", 5 + k))], [[upper; 2], [lower; 2]]);
    }
    for spring in ["spring 9", "spring 10", "spring 11"] {
        assert_eq!(height(spring.to_owned()), [upper, lower]);
    }
}

/// The elements of a tree that lie along x: where each begins and ends [m], from the fields of the model.
fn check_tree(drawing: String, along: &[(&str, f64, f64)]) {
    let picture = Picture::of(drawing);
    let shown = picture.shown("model");
    for &(name, from, to) in along {
        let [start, end] = ends(find(&shown, name));
        assert!(
            close(&picture, start, [from, 0.0, 0.0]) && close(&picture, end, [to, 0.0, 0.0]),
            "{name}: {:?}",
            picture.in_model(end)
        );
    }
}

#[test]
fn the_systems_of_the_paper_have_their_lengths() {
    let draw = |text: Result<String, mstmm_drawing::DrawingError>| text.unwrap();
    for model in [models::light_tip_body(), models::heavy_tip_body()] {
        let picture = draw(Drawing::of(&model.build().unwrap()).map(|drawing| drawing.to_string()));
        check_tree(picture.clone(), &[("beam 1", 0.0, model.length)]);
        let picture = Picture::of(picture);
        let shown = picture.shown("model");
        let body = find(&shown, "body 2");
        let corners: Vec<[f64; 2]> = body.paths[0].iter().map(|corner| picture.in_model(*corner)).collect();
        let far = corners.iter().map(|corner| corner[0]).fold(0.0, f64::max);
        assert!((far - model.length - model.depth).abs() < 1e-4, "{far}");
        assert!(close(&picture, body.paths[2][0], [model.length + model.eccentricity, 0.0, 0.0]));
    }
    let model = models::restrained_beam();
    let picture = draw(Drawing::of(&model.build().unwrap()).map(|drawing| drawing.to_string()));
    check_tree(picture, &[("beam 3", 0.0, model.length)]);
    let model = models::spring_and_mass();
    let picture = draw(Drawing::of(&model.build().unwrap()).map(|drawing| drawing.to_string()));
    let (spring, mass) = (model.spring_position, model.mass_position);
    check_tree(picture, &[("beam 1", 0.0, spring), ("beam 4", spring, mass), ("beam 7", mass, model.length)]);
    let model = models::two_spans();
    let picture = draw(Drawing::of(&model.build().unwrap()).map(|drawing| drawing.to_string()));
    let (support, spring) = (model.support_position, model.spring_position);
    check_tree(picture, &[("beam 1", 0.0, support), ("beam 3", support, spring), ("beam 7", spring, model.length)]);
    let model = models::damped_oscillator();
    let picture = draw(Drawing::of(&model.build().unwrap()).map(|drawing| drawing.to_string()));
    let [one, two, three] = [model.spring_position, model.oscillator_position, model.torsion_position];
    let along = [("beam 1", 0.0, one), ("beam 4", one, two), ("beam 8", two, three), ("beam 11", three, model.length)];
    check_tree(picture, &along);
}

/// Springs and masses hang below their points, each element at the end of the one before.
#[test]
fn translation_paths_hang_across_the_beam() {
    let picture = Picture::of(Drawing::of(&models::two_spans().build().unwrap()).unwrap());
    let shown = picture.shown("model");
    let spring = ends(find(&shown, "spring 5"));
    let [top, bottom] = if spring[0][1] < spring[1][1] { spring } else { [spring[1], spring[0]] };
    let connection = find(&shown, "conn 4").at.unwrap();
    assert!((top[0] - connection[0]).abs() < DIGIT && (top[1] - connection[1]).abs() < DIGIT);
    assert!((bottom[0] - connection[0]).abs() < DIGIT && bottom[1] > top[1] + 20.0);
    let mass = &find(&shown, "mass 6").paths[0];
    let middle = [0, 1].map(|axis| mass.iter().map(|corner| corner[axis]).sum::<f64>() / mass.len() as f64);
    assert!((middle[0] - bottom[0]).abs() < 0.02 && (middle[1] - bottom[1]).abs() < 0.02);
}

/// A path that joins another from the same side has a lane of its own, with the same x.
#[test]
fn paths_of_a_tree_lie_side_by_side() {
    let picture = Picture::of(Drawing::of(&crate::trees::fork()).unwrap());
    let shown = picture.shown("model");
    let [one, five] = ["beam 1", "beam 5"].map(|name| ends(find(&shown, name)));
    assert!((one[1][0] - five[1][0]).abs() < DIGIT, "{one:?} and {five:?}");
    assert!((one[1][1] - five[1][1]).abs() > 30.0);
    assert!((picture.in_model(five[1])[0] - picture.in_model(five[0])[0] - 1.4).abs() < 1e-4);
    let chain = Picture::of(Drawing::of(&crate::trees::chain()).unwrap());
    let shown = chain.shown("model");
    let mut heights: Vec<f64> = ["spring 1", "damper 7", "spring 8"].map(|name| ends(find(&shown, name))[0][1]).into();
    heights.sort_by(f64::total_cmp);
    assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > 30.0), "{heights:?}");
}

/// The sketch itself has the arms of a planar body, and the drawing goes there.
#[test]
fn planar_trees_are_drawn_with_the_arms_of_bodies() {
    let system = crate::trees::plane();
    let extents: Vec<Extent> = ModalAnalysis::sketch(&system)
        .steps()
        .filter_map(|step| match step.part {
            mstmm::motion::DrawnPart::Element { extent, .. } => Some(extent),
            _ => None,
        })
        .collect();
    let [before, body, behind] = extents[..] else { panic!("three elements") };
    assert_eq!((before.output, before.centre), ([1.0, 0.0], None));
    assert_eq!((body.output, body.centre), ([0.3, 0.5], Some([0.2, 0.2])));
    assert_eq!(behind.output, [1.0, 0.0]);
    let picture = Picture::of(Drawing::of(&system).unwrap());
    let shown = picture.shown("model");
    let [start, end] = ends(find(&shown, "beam 3"));
    assert!(close(&picture, start, [1.3, 0.5, 0.0]) && close(&picture, end, [2.3, 0.5, 0.0]));
}

system! {
    /// Two beams with a link between their ends.
    struct Linked { l: f64 }
    section piece { axial_stiffness: 1e6, bending_stiffness: 1e3, mass_per_length: 1.0 }
    fixed at (0.0, 0.0) -> beam 1 { ..piece } -> conn a at (l, 0.0) -> rigid_link 2 {};
    rigid_link 2 -> conn b at (l, 0.5 * l) -> beam 3 { ..piece } -> free at (2.0 * l, 0.5 * l);
}

/// A rigid link is a line between the points that it ties, without the centre that a body has.
#[test]
fn a_link_leads_from_point_to_point() {
    let linked = Linked { l: 2.0 }.build().unwrap();
    let picture = Picture::of(Drawing::of(&linked).unwrap());
    let shown = picture.shown("model");
    let [from, to] = ends(find(&shown, "rigid_link 2"));
    assert!(close(&picture, from, [2.0, 0.0, 0.0]) && close(&picture, to, [2.0, 1.0, 0.0]), "{from:?} {to:?}");
    assert_eq!(find(&shown, "rigid_link 2").kind, "rigid_link");
}
