//! State spaces: values of the file, the same as histories, matrices as they are printed, single precision.

use crate::models::{Cantilever, assert_close, number, reference};
use mstmm::elements::Spring;
use mstmm::frame::{Frame, Plane, Section};
use mstmm::motion::{HoldOrder, MotionError};
use mstmm::network::Support;
use mstmm::prelude::*;

/// The sum of an entry of the file and its imaginary part.
fn pair(value: &serde_json::Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

#[test]
fn steps_of_a_cantilever_are_those_of_the_file() {
    let part = reference("state_space");
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let tip = Cantilever::conn_tip;
    let space = cantilever.state_space::<3, 1, 1>(&roots, [tip.force()], [tip.deflection()]).unwrap();
    let space = space.with_damping_ratio(number(&part["ratio"])).unwrap();
    assert_close(space.d(0, 0), number(&part["D"]), 1e-11);
    let dt = number(&part["dt"]);
    let [zero, first] = [HoldOrder::Zero, HoldOrder::First].map(|order| space.discrete(dt, order).unwrap());
    for (mode, known) in part["modes"].as_array().unwrap().iter().enumerate() {
        let [re, im] = pair(&known["growth"]);
        assert_close(zero.e(2 * mode, 2 * mode), re, 1e-15);
        assert_close(zero.e(2 * mode + 1, 2 * mode), im, 1e-14);
        assert_close(zero.e(2 * mode, 2 * mode + 1), -im, 1e-14);
        // shapes have any sign, and outputs with them
        let sign = (zero.c(0, 2 * mode) * number(&known["output"])).signum();
        assert_close(sign * zero.c(0, 2 * mode), number(&known["output"]), 1e-13);
        let growth = mstmm::Complex::new(re, im);
        let [input, before, after] = ["zoh_input", "foh_before", "foh_after"].map(|name| {
            let [re, im] = pair(&known[name]);
            mstmm::Complex::new(re, im)
        });
        let found = |space: &mstmm::motion::DiscreteStateSpace<f64, 3, 1, 1>| {
            mstmm::Complex::new(space.g(2 * mode, 0), space.g(2 * mode + 1, 0)) * sign
        };
        assert_close(found(&zero), input, 1e-12);
        assert_close(found(&first), before + growth * after, 1e-12);
    }
    let mut pulse = zero;
    let values: Vec<f64> = (0..=60).map(|k| pulse.step(&[if k < 20 { 1.0 } else { 0.0 }])[0]).collect();
    for (step, known) in part["zoh_pulse_of_20_steps"].as_object().unwrap() {
        assert_close(values[step.parse::<usize>().unwrap()], number(known), 1e-13);
    }
    // at rest again, and the same once more
    pulse.reset();
    assert_eq!(pulse.step(&[1.0])[0], values[0]);
}

/// A frame with two loads and three entries, one of them an internal force: steps are those of histories, of all together.
#[test]
fn steps_are_those_of_histories() {
    let mut frame = Frame::<Plane>::new();
    let [foot, corner, tip] = [[0.0, 0.0], [0.0, 2.0], [1.5, 2.5]].map(|place| frame.point(place));
    let steel = Section::new().axial_stiffness(1e5).bending_stiffness(300.0).mass_per_length(2.0);
    let column = frame.member(foot, corner, steel);
    frame.member(corner, tip, steel);
    frame.mass(tip, 3.0);
    frame.hold(foot, Support::Fixed);
    let system = frame.build().unwrap();
    let roots = system.frequencies(5).unwrap();
    let loads = [tip.force_y(), PlaneLoad::base_acceleration(Direction::x())];
    let entries = [tip.displacement_y(), corner.displacement_x(), column.input().moment()];
    let ratios = [0.01, 0.02, 0.03, 0.02, 0.05];
    let space = system.state_space::<6, 2, 3>(&roots, loads, entries).unwrap().with_damping_ratios(&ratios).unwrap();
    let mut discrete = space.discrete(0.013, HoldOrder::First).unwrap();
    let mut single = discrete.single();
    let mut histories = entries.map(|entry| {
        loads.map(|load| {
            let response = system.modal_response::<6, _>(&roots, load, entry).unwrap();
            response.with_damping_ratios(&ratios).unwrap().history(0.013).unwrap()
        })
    });
    let mut sizes = [0.0_f64; 3];
    for k in 0..400 {
        let inputs = [(0.3 * f64::from(k)).sin(), if k % 50 < 20 { 1.0 } else { -0.5 }];
        let found = discrete.step(&inputs);
        let short = single.step(&inputs.map(|input| input as f32));
        for (entry, histories) in histories.iter_mut().enumerate() {
            let expected: f64 = histories.iter_mut().zip(inputs).map(|(history, input)| history.next(input)).sum();
            sizes[entry] = sizes[entry].max(expected.abs());
            assert!((found[entry] - expected).abs() < 1e-12 * sizes[entry], "{k}: {} {expected}", found[entry]);
            assert!(
                (f64::from(short[entry]) - expected).abs() < 1e-3 * sizes[entry],
                "{k}: {} {expected}",
                short[entry]
            );
        }
    }

    // the response in frequency by the matrices, `C (iω - A)⁻¹ B + D`, block by block
    let x = mstmm::Complex::new(0.0, 1.3 * roots[0].omega);
    let matrices = space.matrices();
    assert_eq!([matrices.a.len(), matrices.b[0].len(), matrices.c.len(), matrices.d[0].len()], [10, 2, 3, 2]);
    for (input, load) in loads.into_iter().enumerate() {
        for (output, entry) in entries.into_iter().enumerate() {
            let mut sum = mstmm::Complex::from(matrices.d[output][input]);
            for mode in 0..5 {
                let [k, next] = [2 * mode, 2 * mode + 1];
                let [a, b, c, d] =
                    [(k, k), (k, next), (next, k), (next, next)].map(|(row, column)| matrices.a[row][column]);
                let determinant = (x - a) * (x - d) - b * c;
                let first = ((x - d) * matrices.b[k][input] + b * matrices.b[next][input]) / determinant;
                sum += first * matrices.c[output][k];
            }
            let response =
                system.modal_response::<6, _>(&roots, load, entry).unwrap().with_damping_ratios(&ratios).unwrap();
            assert_close(sum, response.at(x).unwrap(), 1e-11);
        }
    }
    assert_eq!([space.a(0, 2), space.a(20, 20), space.b(0, 2), space.c(3, 0), space.d(0, 2)], [0.0; 5]);
}

/// What moves off: a free mass, under both holds, by closed forms.
#[test]
fn rigid_bodies_move_off() {
    let mut frame = Frame::<Plane>::new();
    let [one, other] = [[0.0, 0.0], [1.0, 0.0]].map(|place| frame.point(place));
    frame.member(one.along([1.0, 0.0]), other.along([1.0, 0.0]), Spring { stiffness: 50.0 });
    frame.mass(one, 2.0);
    frame.mass(other, 2.0);
    for point in [one, other] {
        frame.hold(point, mstmm::network::Freedoms::Y);
    }
    let system = frame.build().unwrap();
    let roots = system.frequencies(2).unwrap();
    assert_eq!(roots[0].omega, 0.0);
    let both = [one.force_x(), other.force_x()];
    let space = system.state_space::<2, 2, 1>(&roots, both, [one.displacement_x()]).unwrap();
    // equal forces on both: the spring rests, and a = F/m
    for (order, force) in [(HoldOrder::Zero, 1.0), (HoldOrder::First, 1.0)] {
        let mut discrete = space.discrete(0.1, order).unwrap();
        for k in 0..20 {
            let time = 0.1 * f64::from(k);
            let [found] = discrete.step(&[force; 2]);
            assert!((found - 0.25 * time * time).abs() < 1e-13, "{order:?} {k}: {found}");
        }
    }
}

#[test]
fn what_is_no_state_space_is_told() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let tip = Cantilever::conn_tip;
    let of = |load| cantilever.state_space::<3, 1, 1>(&roots, [load], [tip.deflection()]);
    assert_eq!(of(Cantilever::beam_1.input().slip()).unwrap_err(), MotionError::NotModal);
    let few = cantilever.state_space::<2, 1, 1>(&roots, [tip.force()], [tip.deflection()]);
    assert_eq!(few.unwrap_err(), MotionError::Capacity { capacity: 2 });
    let space = of(tip.force()).unwrap();
    assert_eq!(space.with_damping_ratio(1.0).unwrap_err(), MotionError::DampingRatio { ratio: 1.0 });
    assert_eq!(space.with_damping_ratios(&[0.1]).unwrap_err(), MotionError::DampingRatios { given: 1, needed: 3 });
    assert!(space.with_damping_ratios_by(|omega| 1e-4 * omega).is_ok());
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(space.discrete(step, HoldOrder::Zero), Err(MotionError::TimeStep { .. })));
    }
}
