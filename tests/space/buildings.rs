//! Buildings of some hundred motions on a small stack.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a building stands")]

use mstmm::frame::{Frame, Point, Section, Space};
use mstmm::network::Support;
use mstmm::prelude::*;

/// A thread's stack [bytes].
const STACK: usize = 2 << 20;

/// A building of so many bays and storeys, and two of its corners.
fn building([bays_x, bays_y, storeys]: [usize; 3]) -> (Frame<Space>, [Point<Space>; 2]) {
    let steel = Section::new()
        .axial_stiffness(6e8)
        .bending_stiffness_y(4e6)
        .bending_stiffness_z(2e6)
        .torsional_stiffness(1e6)
        .mass_per_length(60.0)
        .polar_inertia_per_length(0.3);
    let mut frame = Frame::new();
    let mut below: Vec<Point<Space>> = Vec::new();
    let place = |x: usize, y: usize| x * (bays_y + 1) + y;
    for storey in 0..=storeys {
        let plan = (0..=bays_x).flat_map(|x| (0..=bays_y).map(move |y| [x, y]));
        let floor: Vec<_> =
            plan.clone().map(|[x, y]| frame.point([4.0 * x as f64, 3.5 * y as f64, 3.0 * storey as f64])).collect();
        for [x, y] in plan {
            let own = floor[place(x, y)];
            if storey == 0 {
                frame.hold(own, Support::Fixed);
                continue;
            }
            frame.member(below[place(x, y)], own, steel.up([1.0, 0.0, 0.0]));
            if x < bays_x {
                frame.member(own, floor[place(x + 1, y)], steel);
            }
            if y < bays_y {
                frame.member(own, floor[place(x, y + 1)], steel);
            }
        }
        below = floor;
    }
    let corners = [below[0], below[below.len() - 1]];
    (frame, corners)
}

/// Twenty frequencies, a shape, a response and a step in time, on a thread of two megabytes.
fn asked(size: [usize; 3], count: usize) {
    let work = move || {
        let (frame, [load, read]) = building(size);
        let building = frame.build().unwrap();
        let roots = building.frequencies(count).unwrap();
        assert!(roots.iter().all(|root| root.is_proven));
        let last = roots.last().unwrap();
        assert_eq!(building.count_below(last.upper).unwrap(), last.index + last.multiplicity - 1);
        let shape = building.mode_shape(&roots[0]).unwrap();
        assert!((shape.modal_mass() - 1.0).abs() < 1e-12);
        let (load, entry) = (load.force_x(), read.displacement_x());
        let response = building.frequency_response(load, entry).unwrap();
        let at_rest = response.at(0.0).unwrap();
        let modal = building.modal_response::<64, _>(&roots, load, entry).unwrap();
        assert!((modal.static_value().unwrap() / at_rest - 1.0).abs() < 1e-9 && modal.to_step(0.7).is_finite());
    };
    std::thread::Builder::new().stack_size(STACK).spawn(work).unwrap().join().unwrap_or_else(|_| panic!("{size:?}"));
}

#[test]
fn a_house_is_asked_on_a_small_stack() {
    asked([1, 1, 2], 6);
}

/// Some six hundred motions.
#[test]
#[ignore = "long: run by .ci/long"]
fn a_building_of_any_parameters_is_asked_on_a_small_stack() {
    asked([3, 2, 10], 20);
}
