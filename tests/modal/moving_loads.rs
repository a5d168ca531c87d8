//! Forces that move along a track: exact values, closed forms of one span, quadrature of the modes, influence lines, and bad input.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{assert_close, number, reference};
use core::f64::consts::PI;
use mstmm::elements::TaperedBeam;
use mstmm::frame::{Frame, Line, Member, OfBeam, Point, Section, Structure};
use mstmm::motion::{Crossing, MotionError, NotATrack, TrackError};
use mstmm::network::Support;
use mstmm::prelude::*;

system! {
    /// The bridge of the file: spans of 12 and 8 m, and a point 5 m from its begin.
    struct Bridge {}
    section girder { bending_stiffness: 5e8, mass_per_length: 1500.0, axial_stiffness: 1e14 }
    pinned at (0.0, 0.0) -> beam 1 { ..girder } -> conn at_five at (5.0, 0.0) -> beam 2 { ..girder } -> conn pier at (12.0, 0.0)
        -> beam 3 { ..girder } -> conn end at (20.0, 0.0);
    roller -> conn pier;
    roller -> conn end;
}

/// A span along x with members of some lengths, the supports at its ends, and what else is held.
fn span(lengths: &[f64], section: Section) -> (Structure<Line>, Vec<Point<Line>>, Vec<Member<OfBeam>>) {
    let mut frame = Frame::new();
    let mut place = 0.0;
    let mut points = vec![frame.point(place)];
    let mut members = Vec::new();
    for length in lengths {
        place += length;
        points.push(frame.point(place));
        members.push(frame.member(points[points.len() - 2], points[points.len() - 1], section));
    }
    frame.hold(points[0], Support::Pinned);
    frame.hold(points[points.len() - 1], Support::Pinned);
    (frame.build().unwrap(), points, members)
}

/// The six times of the file, with 4 modes and with 12.
#[test]
fn the_bridge_of_the_file() {
    let file = reference("moving_load");
    let bridge = Bridge {}.build().unwrap();
    let members = [Bridge::beam_1, Bridge::beam_2, Bridge::beam_3];
    let roots = bridge.first_frequencies::<12>().unwrap();
    for (root, expected) in roots.iter().zip(file["omega"].as_array().unwrap()) {
        assert_close(root.omega, number(expected), 1e-14);
    }
    let rows = file["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 12);
    for row in rows {
        let listed =
            &roots[..row["N"].as_str().map_or_else(|| row["N"].as_u64().unwrap() as usize, |n| n.parse().unwrap())];
        let time = number(&row["t"]);
        for (entry, name) in
            [(Bridge::conn_at_five.displacement_y(), "deflection"), (Bridge::beam_2.output().moment(), "moment")]
        {
            let load = bridge.moving_load::<12, _>(listed, &members, entry).unwrap();
            let crossing = load.with_damping_ratio(0.01).unwrap().at_speed(30.0).unwrap();
            println!("{name} {time} {} {}", 1e5 * crossing.after(time), number(&row[name]));
            assert_close(1e5 * crossing.after(time), number(&row[name]), 1e-9);
        }
    }
}
