//! Boxes of tolerances: what they say of critical loads and speeds, of loads at rest, of bodies and of speeds.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::assert_close;
use crate::numbers::Random;
use mstmm::elements::Spring;
use mstmm::frame::{Frame, Member, OfBeam, Plane, Point, Section, Structure};
use mstmm::motion::{Compliance, MotionError};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::{
    LoadError, Rotor, SearchError, SpeedError, ToleranceBox, ToleranceError, critical_loads, critical_speed_ranges,
    critical_speeds,
};

system! {
    /// A shaft with a disc that overhangs, each parameter by itself.
    #[derive(Clone, Copy)]
    struct Overhung { ei: f64, m: f64, mass: f64, disc: f64, polar: f64, k: f64, speed: f64 }
    free -> conn a -> beam 1 {
            length: 0.6, bending_stiffness: ei, mass_per_length: m, rotary_inertia: 2.4e-3, polar_inertia_per_length: 4.8e-3, speed
        } -> conn b -> beam 2 {
            length: 0.4, bending_stiffness: ei, mass_per_length: m, rotary_inertia: 2.4e-3, polar_inertia_per_length: 4.8e-3, speed
        } -> disc 3 { mass, inertia: disc, polar_inertia: polar, speed } -> free;
    fixed -> spring 4 { stiffness: k } -> conn a;
    fixed -> spring 5 { stiffness: k } -> conn b;
}

impl Overhung {
    /// A rotor with parameters at shares of their tolerances, from -1 for the soft end to 1 for the stiff one; its polar inertia stiffens forward whirl.
    fn at(speed: f64, whirl: Whirl, mut share: impl FnMut() -> f64) -> Self {
        let mut up = |value: f64| value * (1.0 + 0.05 * share());
        let (ei, k) = (up(6.5e4), up(2e6));
        let [m, mass, disc] = [15.3, 30.0, 0.3].map(|value: f64| 1.0 / up(1.0 / value));
        let polar = if whirl == Whirl::Forward { up(0.5) } else { 1.0 / up(1.0 / 0.5) };
        Overhung { ei, m, mass, disc, polar, k, speed }
    }
}

/// Speeds and polar inertias have tolerances, too: they stiffen forward whirl and soften backward whirl.
#[test]
fn speeds_have_tolerances() {
    let mut random = Random(11);
    for whirl in [Whirl::Forward, Whirl::Backward] {
        let of = |share: &mut dyn FnMut() -> f64| {
            let faster = if whirl == Whirl::Forward { 1.0 } else { -1.0 };
            let speed = 300.0 * (1.0 + 0.1 * faster * share());
            Overhung::at(speed, whirl, share).build().unwrap().into_whirl(whirl)
        };
        let lot = ToleranceBox::between(of(&mut || -1.0), of(&mut || 1.0)).unwrap();
        let ranges = lot.first_frequencies::<5>().unwrap();
        for _ in 0..40 {
            let roots = of(&mut || 2.0 * random.unit() - 1.0).first_frequencies::<5>().unwrap();
            for (root, range) in roots.iter().zip(&ranges) {
                assert!(root.omega > range.lowest.omega && root.omega < range.highest.omega, "{whirl:?}");
            }
        }
        // a polar inertia that acts against the speed
        let wrong =
            |polar: f64| Overhung { polar, ..Overhung::at(300.0, whirl, || 0.0) }.build().unwrap().into_whirl(whirl);
        let [small, large] = [wrong(0.4), wrong(0.6)];
        let refused = match whirl {
            Whirl::Forward => ToleranceBox::between(large, small),
            Whirl::Backward => ToleranceBox::between(small, large),
        };
        assert!(matches!(refused.map(|_| ()), Err(ToleranceError::NotOrdered { parameter: "polar_inertia", .. })));
    }
}

/// Critical speeds of ten lots of rotors: none outside, both ends attained.
#[test]
fn critical_speeds_have_ranges() {
    let mut random = Random(12);
    for rotor in 0..10 {
        let whirl = if rotor % 2 == 0 { Whirl::Forward } else { Whirl::Backward };
        let centre = 0.7 + 0.06 * f64::from(rotor);
        let at = |speed: f64, share: &mut dyn FnMut() -> f64| {
            let own = Overhung::at(speed, whirl, share);
            Overhung { k: own.k * centre, mass: own.mass / centre, ..own }.build()
        };
        let ends = |speed: f64| Ok([at(speed, &mut || -1.0)?, at(speed, &mut || 1.0)?]);
        let ranges = critical_speed_ranges::<8, _>(0.0..=1200.0, whirl, 1.0, ends).unwrap();
        assert!(ranges.len() >= 2, "{rotor}: {ranges:?}");
        let soft = critical_speeds::<8, _>(0.0..=1200.0, whirl, 1.0, |speed| at(speed, &mut || -1.0)).unwrap();
        assert_eq!(ranges[0].lowest, soft[0]);
        for _ in 0..6 {
            let seed = 1 + random.below(1 << 30) as u64;
            let of = |speed: f64| {
                let mut own = Random(seed);
                at(speed, &mut || 2.0 * own.unit() - 1.0)
            };
            let speeds = critical_speeds::<8, _>(0.0..=1200.0, whirl, 1.0, of).unwrap();
            for (speed, range) in speeds.iter().zip(&ranges) {
                assert!(speed.upper >= range.lowest.lower && speed.lower <= range.highest.upper, "{rotor}");
            }
        }
        // soft and stiff exchanged
        let refused = critical_speed_ranges::<8, _>(0.0..=1200.0, whirl, 1.0, |speed| {
            ends(speed).map(|[soft, stiff]: [Rotor<_>; 2]| [stiff, soft])
        });
        assert!(matches!(refused, Err(SpeedError::NotABox { .. })), "{refused:?}");
    }
}

system! {
    /// A body whose mass centre is beside its input end, its inertia about the input.
    struct Beside { mass: f64, inertia: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> body 2 { mass, inertia_about_input: inertia, output_x: 0.1, centre_x: -0.9 } -> free;
}

/// The inertia about the mass centre falls with the mass: `J - m c²`.
#[test]
fn bodies_are_compared_about_their_mass_centres() {
    let of = |mass: f64, central: f64| Beside { mass, inertia: central + 0.81 * mass }.build().unwrap();
    let lot = ToleranceBox::between(of(1.1, 0.22), of(0.9, 0.18)).unwrap();
    let ranges = lot.first_frequencies::<6>().unwrap();
    for (mass, central) in [(1.1, 0.18), (0.9, 0.22), (1.0, 0.2), (1.07, 0.181), (0.92, 0.219)] {
        for (root, range) in of(mass, central).first_frequencies::<6>().unwrap().iter().zip(&ranges) {
            assert!(root.omega > range.lowest.omega && root.omega < range.highest.omega, "{mass} {central}");
        }
    }
    // what is lighter, and turns more about its mass centre
    let refused = ToleranceBox::between(of(1.1, 0.18), of(0.9, 0.22)).map(|_| ()).unwrap_err();
    assert!(matches!(refused, ToleranceError::NotOrdered { parameter: "inertia_about_input", .. }), "{refused}");
}

/// A portal with a spring beside it, at shares of its tolerances.
fn portal(mut share: impl FnMut() -> f64) -> (Structure<Plane>, [Point<Plane>; 4], Member<OfBeam>) {
    let mut up = |value: f64| value * (1.0 + 0.08 * share());
    let mut frame = Frame::new();
    let points @ [a, b, c, d] = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.0], [4.0, 0.0]].map(|place| frame.point(place));
    let mut section =
        || Section::new().axial_stiffness(up(4e8)).bending_stiffness(up(1e6)).mass_per_length(1.0 / up(0.05));
    frame.member(a, b, section());
    let girder = frame.member(b, c, section());
    frame.member(c, d, section());
    frame.hold(a, Support::Fixed);
    frame.hold(d, Support::Pinned);
    let stiffness = up(2e5);
    frame.member(b.along([1.0, 0.0]), a.along([1.0, 0.0]), Spring { stiffness });
    (frame.build().unwrap(), points, girder)
}

/// Critical loads and compliances lie between those of the soft and of the stiff frame.
#[test]
fn critical_loads_and_compliances_have_ranges() {
    let (soft, [a, b, c, _], girder) = portal(|| -1.0);
    let lot = ToleranceBox::between(soft, portal(|| 1.0).0).unwrap();
    let loads = [(b.force_y(), -1e5), (c.force_y(), -2e5)];
    let forces = lot.soft().axial_forces(&loads).unwrap();
    let ranges =
        lot.critical_loads::<8, _>(0.0..=40.0, |system, factor| system.with_axial_forces(&(&forces * factor))).unwrap();
    assert!(ranges.len() >= 3, "{ranges:?}");
    let [sway, sag] = [lot.compliance(b.force_x()).unwrap(), lot.compliance(girder.uniform_load_y()).unwrap()];
    let mut random = Random(21);
    for _ in 0..30 {
        let (between, places, beam) = portal(|| 2.0 * random.unit() - 1.0);
        let factors =
            critical_loads::<8, _>(0.0..=40.0, |factor| between.with_axial_forces(&(&forces * factor))).unwrap();
        for (factor, range) in factors.iter().zip(&ranges) {
            assert!(factor.factor > range.lowest.factor && factor.factor < range.highest.factor);
        }
        assert!(sway.contains(&between.compliance(places[1].force_x()).unwrap()));
        assert!(sag.contains(&between.compliance(beam.uniform_load_y()).unwrap()));
    }
    // the displacement at the place of the load
    let response = lot.soft().frequency_response(b.force_x(), b.displacement_x()).unwrap();
    assert_eq!(*sway.end(), response.at(0.0).unwrap());

    // what is heavier has another weight, and a moved support another reaction
    for load in [PlaneLoad::self_weight_y(), a.motion_x()] {
        assert_eq!(lot.compliance(load), Err(ToleranceError::Motion(MotionError::NotModal)));
    }
    let exchanged = lot.critical_loads::<8, _>(0.0..=40.0, |system, factor| {
        // what one system may not have
        let more = if core::ptr::eq(system, lot.soft()) { 1.0 } else { 2.0 };
        system.with_axial_forces(&(&forces * (more * factor)))
    });
    assert!(matches!(exchanged, Err(LoadError::NotABox { .. })), "{exchanged:?}");
    let fallen = [lot.soft(), lot.stiff()].map(|system| system.with_axial_forces(&(&forces * 30.0)).unwrap());
    let [soft, stiff] = fallen;
    let refused = ToleranceBox::between(soft, stiff).unwrap().compliance(b.force_x());
    assert!(matches!(refused, Err(ToleranceError::Search(SearchError::Unstable { .. }))), "{refused:?}");
}

/// Closed forms of paths: a spring, and the tip of a cantilever.
#[test]
fn compliances_of_paths_are_closed_forms() {
    system! {
        struct Pile { k: f64, ei: f64 }
        fixed -> beam 1 { length: 2.0, bending_stiffness: ei, mass_per_length: 1.0 } -> conn tip -> free;
        fixed -> spring 2 { stiffness: k } -> conn tip;
    }
    let of = |k: f64, ei: f64| Pile { k, ei }.build().unwrap();
    let lot = ToleranceBox::between(of(90.0, 180.0), of(110.0, 220.0)).unwrap();
    let range = lot.compliance(Pile::conn_tip.force()).unwrap();
    for (found, (k, ei)) in [(*range.end(), (90.0, 180.0)), (*range.start(), (110.0, 220.0))] {
        assert_close(found, 1.0 / (k + 3.0 * ei / 8.0), 1e-13);
    }
    assert_eq!(of(90.0, 180.0).compliance(Pile::beam_1.uniform_load()), Err(MotionError::NoUniformLoad));
    assert_eq!(of(90.0, 180.0).compliance(Pile::beam_1.output().kink()), Err(MotionError::NotModal));
}
