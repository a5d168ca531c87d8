//! Rotors: shafts and discs by their radii, orbits that go round with the whirl, Campbell diagrams.

use mstmm::prelude::*;
use mstmm::search::{campbell, critical_speeds};
use mstmm_drawing::{CampbellDiagram, Drawing, DrawingError};
use roxmltree::{Document, Node};

system! {
    /// A stepped shaft with an overhung disc.
    struct Stepped { speed: f64 }
    section s { bending_stiffness: 6e4, mass_per_length: 15.0, speed }
    fixed -> beam 1 { ..s, length: 0.6, rotary_inertia: 15.0 * 0.25 * 0.03 * 0.03, polar_inertia_per_length: 15.0 * 0.5 * 0.03 * 0.03 }
        -> beam 2 { ..s, length: 0.6, rotary_inertia: 15.0 * 0.25 * 0.015 * 0.015, polar_inertia_per_length: 15.0 * 0.5 * 0.015 * 0.015 }
        -> disc 3 { mass: 30.0, inertia: 0.3, polar_inertia: 0.5 * 30.0 * 0.1 * 0.1, speed } -> free;
}

/// The points of a path.
fn points(path: &Node<'_, '_>) -> Vec<[f64; 2]> {
    let data = path.attribute("d").unwrap().replace(['M', 'L'], "\n").replace('Z', "");
    let point = |line: &str| {
        let mut numbers = line.split_whitespace().map(|number| number.parse().unwrap());
        [numbers.next().unwrap(), numbers.next().unwrap()]
    };
    data.lines().filter(|line| !line.trim().is_empty()).map(point).collect()
}

/// The height of what is drawn of a part at rest.
fn height(document: &Document<'_>, name: &str) -> f64 {
    let part = document.descendants().find(|node| node.attribute("data-name") == Some(name)).unwrap();
    let all: Vec<f64> =
        part.children().filter(Node::is_element).flat_map(|path| points(&path)).map(|[_, y]| y).collect();
    all.iter().copied().fold(f64::NEG_INFINITY, f64::max) - all.iter().copied().fold(f64::INFINITY, f64::min)
}

#[test]
fn a_shaft_without_mass_is_drawn() {
    system! {
        /// A coupling without mass before a shaft.
        struct Coupled { speed: f64 }
        section s { bending_stiffness: 6e4, rotary_inertia: 0.0, polar_inertia_per_length: 0.0, speed }
        fixed -> beam 1 { ..s, length: 0.2, mass_per_length: 0.0 } -> beam 2 { ..s, length: 0.6, mass_per_length: 15.0 } -> free;
    }
    let rotor = Coupled { speed: 100.0 }.build().unwrap();
    let svg = Drawing::of(rotor.whirl(Whirl::Forward)).unwrap().to_string();
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
}

#[test]
fn shafts_and_discs_have_their_diameters() {
    let rotor = Stepped { speed: 100.0 }.build().unwrap();
    let svg = Drawing::of(rotor.whirl(Whirl::Forward)).unwrap().to_string();
    let document = Document::parse(&svg).unwrap();
    let scale: f64 = document.root_element().attribute("data-scale").unwrap().parse().unwrap();
    for (name, diameter) in [("beam 1", 0.06), ("beam 2", 0.03), ("disc 3", 0.2)] {
        let height = height(&document, name);
        assert!(
            (height / scale - diameter).abs() < 0.02 / scale + 1e-12,
            "{name}: {} instead of {diameter}",
            height / scale
        );
    }
}

/// Twice the area that a line goes round, positive where it goes round clockwise on the paper.
fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|([x, y], [to_x, to_y])| x * to_y - to_x * y).sum()
}

#[test]
fn orbits_go_round_with_the_whirl() {
    let rotor = Stepped { speed: 100.0 }.build().unwrap();
    let areas = [Whirl::Forward, Whirl::Backward].map(|whirl| {
        let system = rotor.whirl(whirl);
        let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
        let svg = Drawing::of(system).unwrap().mode(&shape).unwrap().orbits(whirl).to_string();
        let document = Document::parse(&svg).unwrap();
        let orbits = document.descendants().find(|node| node.attribute("class") == Some("orbits")).unwrap();
        let circles = orbits
            .children()
            .filter(|path| path.attribute("d").is_some_and(|data| data.ends_with('Z') && !data.contains('a')));
        let areas: Vec<f64> = circles.map(|circle| area(&points(&circle))).collect();
        assert!(areas.len() > 6);
        areas
    });
    // of what does not move at the clamp there is no area
    let signs = areas.map(|areas| {
        areas.iter().filter(|area| area.abs() > 1.0).map(|area| area.signum()).sum::<f64>() / areas.len() as f64
    });
    assert!(signs[0].abs() > 0.7 && signs[0] == -signs[1], "{signs:?}");
}

#[test]
fn a_campbell_diagram_has_its_curves_its_orders_and_its_critical_speeds() {
    let build = |speed| Stepped { speed }.build();
    let at_speeds: Vec<_> =
        campbell::<3, _>((0..=10).map(|k| 60.0 * f64::from(k)), build).collect::<Result<_, _>>().unwrap();
    let critical = critical_speeds::<8, _>(1.0..=600.0, Whirl::Backward, 1.0, build).unwrap();
    let svg = CampbellDiagram::of(&at_speeds).unwrap().order(1.0).order(2.0).critical(1.0, &critical).to_string();
    let document = Document::parse(&svg).unwrap();
    let of_class = |class: &str| -> Vec<Vec<[f64; 2]>> {
        let paths = document
            .descendants()
            .filter(|node| node.tag_name().name() == "path" && node.attribute("class") == Some(class));
        let long = paths
            .map(|path| path.attribute("d").unwrap().contains('a').then(Vec::new).unwrap_or_else(|| points(&path)));
        long.collect()
    };
    // three curves and the sample above the diagram
    for class in ["forward", "backward"] {
        let curves = of_class(class);
        assert_eq!(curves.iter().filter(|curve| curve.len() == 11).count(), 3, "{curves:?}");
    }
    let frame = &of_class("frame")[0];
    let [top, corner, right] = [frame[0], frame[1], frame[2]];
    let most =
        at_speeds.iter().flat_map(|at| [&at.forward, &at.backward].map(|list| list[2].omega)).fold(0.0, f64::max);
    let last = at_speeds[10].forward[0].omega;
    let first_curve = &of_class("forward")[0];
    let found = (corner[1] - first_curve[10][1]) / (corner[1] - top[1]);
    assert!((found - last / most).abs() < 1e-4, "{found} instead of {}", last / most);
    assert!((first_curve[10][0] - right[0]).abs() < 0.01);
    let orders = of_class("order");
    let slope = |line: &Vec<[f64; 2]>| (corner[1] - line[1][1]) / (line[1][0] - corner[0]);
    assert!((slope(&orders[1]) / slope(&orders[0]) - 2.0).abs() < 1e-3, "{orders:?}");
    assert_eq!(of_class("critical").len(), critical.len());
    assert!(matches!(CampbellDiagram::of::<3>(&[]), Err(DrawingError::Empty)));
}

/// A disc tilts with its shaft: its sides stay as they are, and turn.
#[test]
fn discs_tilt_with_the_shaft() {
    let rotor = Stepped { speed: 100.0 }.build().unwrap();
    let system = rotor.whirl(Whirl::Forward);
    let shape = system.mode_shape(&system.first_frequencies::<1>().unwrap()[0]).unwrap();
    let svg = Drawing::of(system).unwrap().mode(&shape).unwrap().to_string();
    let document = Document::parse(&svg).unwrap();
    let disc = |class: &str| {
        let group = document.descendants().find(|node| node.attribute("class") == Some(class)).unwrap();
        let part = group.descendants().find(|node| node.attribute("data-name") == Some("disc 3")).unwrap();
        points(&part.children().find(Node::is_element).unwrap())
    };
    let side = |corners: Vec<[f64; 2]>| [corners[2][0] - corners[1][0], corners[2][1] - corners[1][1]];
    let (rest, moved) = (side(disc("model rest")), side(disc("mode still")));
    assert!(rest[0].abs() < 0.02 && moved[0].abs() > 1.0, "{rest:?} {moved:?}");
    assert!((moved[1] - rest[1]).abs() < 0.03, "{rest:?} {moved:?}");
}
