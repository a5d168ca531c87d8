//! Each support has the symbol of what it holds, at its point, turned as it is in the model.

use crate::frames::for_each_frame;
use crate::reading::{Picture, Shown};
use mstmm::motion::{Drawn, Skew};
use mstmm::network::Freedoms;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use paper::models;

/// The symbol of what is held, and the direction across which its ground lies, where it has one.
fn expected(held: Freedoms, skew: Option<Skew<f64>>, is_plane: bool) -> (&'static str, Option<[f64; 2]>) {
    let [x, y, rz] = [Freedoms::X, Freedoms::Y, Freedoms::RZ].map(|freedom| held.contains(freedom));
    let along = skew.map(|skew| match skew {
        Skew::Along([x, y, _]) => [x, y],
        Skew::Normal([x, y, _]) => [-y, x],
    });
    match (along, [x || !is_plane, y, rz]) {
        (Some(along), [_, _, false]) => ("roller", Some(along)),
        (Some(along), [_, _, true]) => ("guided", Some(along)),
        (None, [true, true, true]) => ("fixed", None),
        (None, [true, true, false]) => ("pinned", None),
        (None, [true, false, false]) => ("roller", Some([0.0, 1.0])),
        (None, [false, true, false]) => ("roller", Some([1.0, 0.0])),
        (None, [true, false, true]) => ("guided", Some([0.0, 1.0])),
        (None, [false, true, true]) => ("guided", Some([1.0, 0.0])),
        (None, [false, false, _]) => ("rotation", None),
    }
}

fn check_frame<Y>(name: &str, frame: &Y)
where
    Y: Drawn<Parameter = f64> + FrameAnalysis,
{
    let picture = Picture::of(Drawing::of(frame).unwrap());
    let supports = picture.shown("supports");
    let shown: Vec<&Shown> = supports.iter().filter(|support| !support.name.starts_with("ground of")).collect();
    let sketch = FrameAnalysis::sketch(frame);
    let is_plane = sketch.points().any(|point| point.freedoms.contains(Freedoms::X));
    let holding: Vec<_> =
        sketch.supports().filter(|support| !support.held.is_empty() || support.skew.is_some()).collect();
    assert_eq!(shown.len(), holding.len(), "{name}");
    for (support, drawn) in holding.iter().zip(shown) {
        let own = support.name.to_string();
        assert_eq!(drawn.name, own);
        let (symbol, along) = expected(support.held, support.skew, is_plane);
        // at a point that no element turns a clamp holds displacements alone
        let symbol = if own.starts_with("fixed") { "fixed" } else { symbol };
        assert_eq!(drawn.kind, symbol, "{name}: {own}");
        let [x, y] = picture.in_model(drawn.at.unwrap());
        assert!((x - support.position[0]).abs() < 1e-9, "{name}: {own}");
        assert!(!is_plane || (y - support.position[1]).abs() < 1e-9, "{name}: {own}");
        let ground = drawn.ground.unwrap();
        assert!((ground[0].hypot(ground[1]) - 1.0).abs() < 1e-12, "{name}: {own}");
        if let Some([dx, dy]) = along {
            // the ground is across the direction of motion, with y of the paper downwards
            let lean = (dx * ground[0] - dy * ground[1]) / dx.hypot(dy);
            assert!(lean.abs() < 1e-12, "{name}: {own} leans by {lean}");
        }
        check_symbol(drawn);
    }
}

/// The symbol itself is turned as it says: what it draws of the ground is a line across the way to it, on that side.
fn check_symbol(drawn: &Shown) {
    let (at, ground) = (drawn.at.unwrap(), drawn.ground.unwrap());
    let line = drawn
        .paths
        .iter()
        .find(|path| path.len() == 2 && (path[0][0] - path[1][0]).hypot(path[0][1] - path[1][1]) > 29.0);
    let [from, to] = line.unwrap()[..] else { panic!("the ground is a line") };
    let way = |point: [f64; 2]| (point[0] - at[0]) * ground[0] + (point[1] - at[1]) * ground[1];
    assert!((way(from) - way(to)).abs() < 0.02, "{}", drawn.name);
    let distance = match drawn.kind.as_str() {
        "fixed" => 0.0,
        "pinned" => 15.0,
        "roller" => 19.6,
        "guided" => 7.0,
        _ => 8.0,
    };
    assert!((way(from) - distance).abs() < 0.02, "{}: {}", drawn.name, way(from));
    let middle = [0.5 * (from[0] + to[0]) - at[0], 0.5 * (from[1] + to[1]) - at[1]];
    assert!((middle[0] * ground[1] - middle[1] * ground[0]).abs() < 0.02, "{}", drawn.name);
}

#[test]
fn supports_stand_at_their_points_turned_as_they_are() {
    for_each_frame!(|name, frame| check_frame(name, frame));
}

/// Skew supports: the ground of a roller that climbs by 3 in 4 lies below it, and that of a clamp behind its beam.
#[test]
fn skew_supports_are_turned() {
    let picture = Picture::of(Drawing::of(&crate::frames::girder()).unwrap());
    let supports = picture.shown("supports");
    let [pin, roller] = &supports[..] else { panic!("two supports") };
    assert_eq!(pin.ground, Some([0.0, 1.0]));
    let ground = roller.ground.unwrap();
    assert!((ground[0] - 0.6).abs() < 1e-12 && (ground[1] - 0.8).abs() < 1e-12, "{ground:?}");
    let star = Picture::of(Drawing::of(&crate::frames::star()).unwrap());
    let supports = star.shown("supports");
    let of = |part: &str| supports.iter().find(|support| support.name.ends_with(part)).unwrap();
    let is = |support: &Shown, [x, y]: [f64; 2]| {
        let ground = support.ground.unwrap();
        assert!((ground[0] - x).abs() < 1e-9 && (ground[1] - y).abs() < 1e-9, "{}: {ground:?}", support.name);
    };
    is(of("beam w"), [-1.0, 0.0]);
    is(of("beam e"), [1.0, 0.0]);
    is(of("beam ne"), [0.8, 0.6]);
    is(of("beam nw"), [-1.0, 0.0]);
    is(of("beam sw"), [-0.6, 0.8]);
}

#[test]
fn the_systems_of_the_paper_stand_on_their_supports() {
    let below = |kind: &str| (kind.to_owned(), [0.0, 1.0]);
    let kinds = |text: String| -> Vec<(String, [f64; 2])> {
        let shown = Picture::of(text).shown("supports");
        shown.iter().for_each(check_symbol);
        shown.iter().map(|support| (support.kind.clone(), support.ground.unwrap())).collect()
    };
    let drawn = Drawing::of(&models::light_tip_body().build().unwrap()).unwrap().to_string();
    assert_eq!(kinds(drawn), [("fixed".to_owned(), [-1.0, 0.0])]);
    let drawn = Drawing::of(&models::restrained_beam().build().unwrap()).unwrap().to_string();
    assert_eq!(kinds(drawn), [below("fixed"), below("fixed")]);
    let drawn = Drawing::of(&models::spring_and_mass().build().unwrap()).unwrap().to_string();
    assert_eq!(kinds(drawn), [below("pinned"), below("fixed"), below("pinned")]);
    let drawn = Drawing::of(&models::two_spans().build().unwrap()).unwrap().to_string();
    assert_eq!(kinds(drawn), [below("pinned"), below("pinned"), below("pinned")]);
    let drawn = Drawing::of(&models::damped_oscillator().build().unwrap()).unwrap().to_string();
    assert_eq!(kinds(drawn), [below("pinned"), below("fixed"), below("fixed"), below("pinned")]);
}
