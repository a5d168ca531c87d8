//! Titles, units and loads: what is written, and arrows where loads act, in the sense in which they do.

use crate::reading::Picture;
use mstmm::frame::{Frame, Section};
use mstmm::motion::{Load, PlaneLoad};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, DrawingError, Force, View};
use std::path::Path;

system! {
    /// A portal with a machine on its girder.
    struct Portal { height: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn c at (4.0, height)
        -> beam 3 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> fixed at (4.0, 0.0);
    conn c -> rigid_body 4 { mass: 50.0, inertia: 2.0, centre: (4.0, height + 0.3) };
}

system! {
    struct Shelf { length: f64 }
    fixed -> beam 1 { length, bending_stiffness: 1e4, mass_per_length: 2.0 } -> conn middle
          -> beam 2 { length, bending_stiffness: 1e4, mass_per_length: 2.0 } -> point_mass 3 { mass: 5.0 } -> free;
    conn middle <- spring 4 { stiffness: 1e5 } <- fixed;
}

fn portal() -> PortalSystem {
    Portal { height: 3.0 }.build().unwrap()
}

/// The arrows of a picture: from the tail to the tip of the head, and the place of the tip in the model.
fn arrows(picture: &Picture) -> Vec<([f64; 2], [f64; 2])> {
    let mut found = Vec::new();
    for load in picture.loads() {
        for pair in load.windows(2).filter(|pair| pair[0].len() == 2 && pair[1].len() == 3) {
            let ([tail, tip], head) = ([pair[0][0], pair[1][0]], picture.in_model(pair[1][0]));
            found.push(([tip[0] - tail[0], tail[1] - tip[1]], head));
        }
    }
    found
}

fn near(one: [f64; 2], other: [f64; 2], within: f64) -> bool {
    (one[0] - other[0]).hypot(one[1] - other[1]) < within
}

#[test]
fn forces_are_arrows_that_end_at_their_points() {
    let portal = portal();
    let drawing = |load, amount| Picture::of(Drawing::of(&portal).unwrap().load(load, amount).unwrap());
    for (amount, sign) in [(1000.0, 1.0), (-1000.0, -1.0)] {
        let picture = drawing(Portal::conn_b.force_x(), amount);
        let [(way, tip)] = arrows(&picture).try_into().unwrap();
        assert!(sign * way[0] > 20.0 && way[1].abs() < 0.02, "{way:?}");
        // along the girder there is no room in front of a force to the left, which begins at the point
        let scale = picture.number("data-scale");
        assert!(sign < 0.0 || near(tip, [0.0, 3.0], 6.0 / scale), "{tip:?}");
        assert!(picture.labels().iter().any(|label| label.class == "load" && label.text == "1000 N"));
    }
    // an end of a member is its point
    let picture = drawing(Portal::beam_2.output().force_y(), -2.5);
    let [(way, tip)] = arrows(&picture).try_into().unwrap();
    assert!(way[1] < -20.0 && (tip[0] - 4.0).abs() < 0.01, "{way:?} {tip:?}");
    assert!(picture.labels().iter().any(|label| label.text == "2.50 N"));
}

#[test]
fn arrows_grow_with_their_forces() {
    let portal = portal();
    let drawing = Drawing::of(&portal).unwrap().load(Portal::conn_b.force_x(), 100.0).unwrap();
    let drawing = drawing.load(Portal::conn_c.force_y(), -400.0).unwrap();
    let arrows = arrows(&Picture::of(drawing));
    let length = |k: usize| arrows[k].0[0].hypot(arrows[k].0[1]);
    assert_eq!(arrows.len(), 2);
    assert!(length(1) > length(0) + 15.0, "{arrows:?}");
    // none of zero
    let picture = Picture::of(Drawing::of(&portal).unwrap().load(Portal::conn_b.force_x(), 0.0).unwrap());
    assert!(picture.loads().is_empty() && picture.labels().iter().all(|label| label.class != "load"));
}

/// The arc of a moment goes round its point in its sense, three quarters of a circle.
#[test]
fn moments_are_arcs_in_their_sense() {
    let portal = portal();
    for sense in [1.0, -1.0] {
        let picture = Picture::of(Drawing::of(&portal).unwrap().load(Portal::conn_b.torque_z(), 7.0 * sense).unwrap());
        let load = &picture.loads()[0];
        let centre = picture.shown("model").iter().find(|shown| shown.name == "conn b").unwrap().at.unwrap();
        let angle = |[x, y]: [f64; 2]| (centre[1] - y).atan2(x - centre[0]);
        let turned: f64 = load[0]
            .windows(2)
            .map(|pair| {
                let turn = angle(pair[1]) - angle(pair[0]);
                turn - (turn / std::f64::consts::TAU).round() * std::f64::consts::TAU
            })
            .sum();
        assert!((turned - sense * 1.5 * std::f64::consts::PI).abs() < 0.02, "{turned}");
        assert!(picture.labels().iter().any(|label| label.text == "7.00 N m"));
    }
}

#[test]
fn spread_loads_are_rows_along_their_members() {
    let portal = portal();
    let drawing = Drawing::of(&portal).unwrap().load(Portal::beam_2.uniform_load_y(), -500.0).unwrap();
    let picture = Picture::of(drawing.units("kN", "cm"));
    let row = arrows(&picture);
    assert!(row.len() > 10);
    let scale = picture.number("data-scale");
    for (way, tip) in &row {
        assert!(way[1] < -10.0 && way[0].abs() < 0.02 && (tip[1] - 3.0).abs() < 6.0 / scale, "{way:?} {tip:?}");
        assert!((-0.01..4.01).contains(&tip[0]));
    }
    assert!(picture.labels().iter().any(|label| label.text == "500 kN/cm"));
    // a weight is on all members and on the machine
    let weight = Drawing::of(&portal).unwrap().load(PlaneLoad::self_weight_y(), -9.81).unwrap();
    let picture = Picture::of(weight);
    let all = arrows(&picture);
    assert!(all.iter().all(|(way, _)| way[1] < -10.0));
    for x in [0.0, 2.0, 4.0] {
        assert!(all.iter().any(|(_, tip)| (tip[0] - x).abs() < 0.4), "{x}");
    }
    assert!(all.iter().any(|(_, tip)| near(*tip, [4.0, 3.3], 8.0 / picture.number("data-scale"))));
    assert!(picture.labels().iter().any(|label| label.text == "9.81 m/s²"));
    // the inertia of masses is against the acceleration of their ground
    let shaken = Drawing::of(&portal).unwrap().load(PlaneLoad::base_acceleration(Direction::x()), 2.0).unwrap();
    assert!(arrows(&Picture::of(shaken)).iter().all(|(way, _)| way[0] < -10.0));
}

#[test]
fn loads_of_paths_are_at_their_points() {
    let shelf = Shelf { length: 1.5 }.build().unwrap();
    let drawing = |load| Picture::of(Drawing::of(&shelf).unwrap().load(load, -20.0).unwrap());
    for (load, x) in [
        (Shelf::point_mass_3.output().force(), 3.0),
        (Shelf::beam_2.output().force(), 3.0),
        (Shelf::conn_middle.force(), 1.5),
        (Shelf::beam_2.input().force(), 1.5),
    ] {
        let picture = drawing(load);
        let [(way, tip)] = arrows(&picture).try_into().unwrap();
        assert!(way[1] < -20.0 && (tip[0] - x).abs() < 0.01, "{x} {tip:?}");
    }
    assert_eq!(arrows(&drawing(Shelf::conn_middle.torque())).len(), 0);
    let row = arrows(&drawing(Shelf::beam_2.uniform_load()));
    assert!(row.len() > 5 && row.iter().all(|(way, tip)| way[1] < 0.0 && (1.49..3.01).contains(&tip[0])));
    assert!(arrows(&drawing(Load::self_weight())).len() > row.len());
}

/// In space arrows lead as their axes are seen; one towards the reader is a circle.
#[test]
fn forces_in_space_lead_along_their_axes() {
    let steel = Section::new().axial_stiffness(4e8).torsional_stiffness(4e5).bending_stiffness(2e6);
    let steel = steel.mass_per_length(20.0).polar_inertia_per_length(0.06);
    let mut frame = Frame::new();
    let [foot, head, tip] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 1.0, 3.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, head, steel);
    frame.member(head, tip, steel);
    let crane = frame.build().unwrap();
    let in_view = |load, view| Picture::of(Drawing::of(&crane).unwrap().view(view).unwrap().load(load, -3.0).unwrap());
    let way = |picture: &Picture| arrows(picture)[0].0;
    let down = way(&in_view(tip.force_z(), View::front()));
    assert!(down[1] < -20.0 && down[0].abs() < 0.02, "{down:?}");
    let [x, y] = way(&in_view(tip.force_z(), View::isometric()));
    assert!(y < -15.0 && x.abs() < 0.02, "{x} {y}");
    let from_above = in_view(tip.force_z(), View::plan());
    assert!(arrows(&from_above).is_empty() && from_above.loads()[0].len() == 2);
    // a moment across the view has two heads
    let torque = in_view(tip.torque_x(), View::front());
    let heads = torque.loads()[0].iter().filter(|path| path.len() == 3).count();
    assert_eq!(heads, 2);
    assert!(torque.labels().iter().any(|label| label.text == "3.00 N m"));
}

#[test]
fn what_is_no_load_of_the_drawing_is_refused() {
    let portal = portal();
    let drawing = || Drawing::of(&portal).unwrap();
    let error = drawing().load(Portal::conn_b.force_x(), f64::NAN).unwrap_err();
    assert!(matches!(error, DrawingError::LoadNotFinite { amount } if amount.is_nan()), "{error}");
    let moved = drawing().load(Portal::conn_b.motion_x(), 1.0).unwrap_err();
    assert!(matches!(moved, DrawingError::NoPlace), "{moved}");
}

/// A title is above all, the unit below; any text is a title.
#[test]
fn titles_and_units_are_written() {
    let portal = portal();
    let states = portal.frequency_response(Portal::conn_b.force_x(), Portal::conn_b.displacement_x()).unwrap();
    let states = states.states(0.0).unwrap();
    let title = "Portal <b> & \"friends\"\n\u{0} of a very, very long title that is wider than the picture which it stands above, or so it seems";
    let drawing = Drawing::of(&portal).unwrap().titled(title);
    for (force, unit) in
        [(Force::Moment, "moment [kN mm]"), (Force::Shear, "shear force [kN]"), (Force::Axial, "axial force [kN]")]
    {
        let drawing = Drawing::of(&portal).unwrap().titled(title).forces(&states, force).unwrap().units("kN", "mm");
        let picture = Picture::of(drawing);
        let [left, top, width, height] = picture.view_box();
        let captions = picture.captions();
        let expected = [title.replace(['\n', '\u{0}'], " "), unit.to_owned()];
        assert_eq!(captions.iter().map(|(text, _)| text.clone()).collect::<Vec<_>>(), expected);
        let [above, below] = [captions[0].1, captions[1].1];
        assert!(above[1] > top && above[1] < top + 30.0 && below[1] < top + height && below[1] > top + height - 30.0);
        for label in picture.labels().iter().filter(|label| label.class != "title" && label.class != "unit") {
            assert!(above[1] + 14.0 < label.at[1] && label.at[1] < below[1] - 12.0, "{}", label.name);
        }
        // in letters half as wide as they are high the title is within the picture
        let half = 0.5 * 0.5 * 15.0 * title.chars().count() as f64;
        assert!(above[0] - half > left && above[0] + half < left + width);
    }
    assert_eq!(Picture::of(drawing).captions().len(), 1);
    // of a mode the size says nothing
    let shape = portal.mode_shape(&portal.first_frequencies::<1>().unwrap()[0]).unwrap();
    let picture = Picture::of(Drawing::of(&portal).unwrap().forces(&shape, Force::Moment).unwrap());
    assert_eq!(picture.captions()[0].0, "moment [N m], of a mode, whose size is free");
}

/// Written for those who want to see them.
#[test]
fn the_gallery_of_loads_is_written() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    std::fs::create_dir_all(&folder).unwrap();
    let portal = portal();
    let response = portal.frequency_response(Portal::conn_b.force_x(), Portal::conn_b.displacement_x()).unwrap();
    let states = response.states(0.0).unwrap();
    let drawing =
        Drawing::of(&portal).unwrap().titled("Portal under a force to the right").forces(&states, Force::Moment);
    let drawing = drawing.unwrap().load(Portal::conn_b.force_x(), 1.0).unwrap();
    drawing.write(folder.join("load_force.svg")).unwrap();
    let drawing = Drawing::of(&portal).unwrap().load(PlaneLoad::self_weight_y(), -9.81).unwrap();
    drawing.load(Portal::conn_b.torque_z(), 30.0).unwrap().write(folder.join("load_weight.svg")).unwrap();
    let drawing = Drawing::of(&portal).unwrap().load(Portal::beam_2.uniform_load_y(), -500.0).unwrap();
    let drawing = drawing.load(Portal::conn_b.force_x(), 200.0).unwrap().load(Portal::conn_c.force_x(), 800.0).unwrap();
    drawing.write(folder.join("load_row.svg")).unwrap();
    let shelf = Shelf { length: 1.5 }.build().unwrap();
    let drawing = Drawing::of(&shelf).unwrap().load(Shelf::point_mass_3.output().force(), -20.0).unwrap();
    drawing.load(Shelf::conn_middle.torque(), -4.0).unwrap().write(folder.join("load_shelf.svg")).unwrap();
    let space = crate::pictures::command::space_portal::steel().build().unwrap();
    let weight = Drawing::of(&space).unwrap().load(PlaneLoad::self_weight_z(), -9.81).unwrap();
    weight.titled("Weight").write(folder.join("load_space.svg")).unwrap();
}
