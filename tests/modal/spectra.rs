//! Response spectra: values of the file, of oscillators on a ground that moves, and what is refused.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{Cantilever, Portal, assert_close, number, oscillator, reference, three_spokes};
use mstmm::motion::{
    Combination, Directions, ResponseSpectrum, SpectrumError, SpectrumTable, combined, oscillator_peak, record_spectrum,
};
use mstmm::prelude::*;
use std::f64::consts::{PI, TAU};

/// The table of the file, times a factor.
fn table(factor: f64) -> Vec<(f64, f64)> {
    let part = reference("response_spectrum")["cantilever"]["table_hz"].clone();
    part.as_array().unwrap().iter().map(|row| (number(&row[0]), factor * number(&row[1]))).collect()
}

#[test]
fn peaks_of_a_cantilever_are_those_of_the_file() {
    let part = reference("response_spectrum")["cantilever"].clone();
    let rows = table(1.0);
    let spectrum = SpectrumTable::hertz(&rows).unwrap();
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<4>().unwrap();
    let ground = Load::base_acceleration(Direction::y());
    let entries =
        [("tip deflection", Cantilever::conn_tip.deflection()), ("base moment", Cantilever::beam_1.input().moment())];
    for (name, entry) in entries {
        let known = &part["answers"][name];
        let response = cantilever.modal_response::<4, _>(&roots, ground, entry).unwrap();
        let response = response.with_damping_ratio(number(&part["ratio"])).unwrap();
        let peak = |combination| response.spectral_peak(&spectrum, combination).unwrap();
        let modes = peak(Combination::SumOfSquares);
        assert_eq!(modes.modes().len(), 4);
        let sign = (modes.modes()[0].value * number(&known["modal"][0])).signum();
        for (mode, value) in modes.modes().iter().zip(known["modal"].as_array().unwrap()) {
            assert_close(mode.value * sign, number(value), 1e-10);
            assert_close(mode.omega, roots[mode.root].omega, 1e-15);
            assert_close(mode.ratio, 0.05, 1e-14);
        }
        assert_close(modes.missing.abs(), number(&known["missing"]), 1e-9);
        for (combination, own, total) in [
            (Combination::SumOfSquares, "srss", "srss_with_missing"),
            (Combination::CompleteQuadratic, "cqc", "cqc_with_missing"),
            (Combination::AbsoluteSum, "abs", "abs_with_missing"),
        ] {
            assert_close(peak(combination).of_modes(), number(&known[own]), 1e-11);
            assert_close(peak(combination).total(), number(&known[total]), 1e-11);
        }
    }
}

#[test]
fn peaks_of_a_portal_in_two_directions_are_those_of_the_file() {
    let part = reference("response_spectrum")["portal"]["answers"].clone();
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<6>().unwrap();
    let (along_x, along_y) = (table(1.0), table(2.0 / 3.0));
    for (name, entry) in
        [("displacement x B", Portal::conn_b.displacement_x()), ("foot moment A", Portal::beam_1.input().moment())]
    {
        let peak = |direction, rows: &[(f64, f64)]| {
            let response =
                portal.modal_response::<6, _>(&roots, PlaneLoad::base_acceleration(direction), entry).unwrap();
            let response = response.with_damping_ratio(0.05).unwrap();
            let spectrum = SpectrumTable::hertz(rows).unwrap();
            response.spectral_peak(&spectrum, Combination::CompleteQuadratic).unwrap().total()
        };
        let peaks = [peak(Direction::x(), &along_x), peak(Direction::y(), &along_y)];
        assert_close(peaks[0], number(&part[name]["x"]), 1e-10);
        assert_close(peaks[1], number(&part[name]["y"]), 1e-9);
        assert_close(combined(&peaks, Directions::SumOfSquares), number(&part[name]["srss"]), 1e-10);
        assert_close(combined(&peaks, Directions::HundredThirty), number(&part[name]["hundred_thirty"]), 1e-10);
    }
}

#[test]
fn spectra_of_records_are_those_of_the_file() {
    let base = reference("base_acceleration");
    let record: Vec<f64> = base["a_g"].as_array().unwrap().iter().map(number).collect();
    let dt = number(&base["dt"]);
    let file = reference("response_spectrum");
    for row in file["of_record"].as_array().unwrap() {
        let (omega, ratio) = (TAU * number(&row["hertz"]), number(&row["ratio"]));
        let peak = oscillator_peak(&record, dt, omega, ratio).unwrap();
        assert_close(peak.deflection, number(&row["deflection"]), 1e-13);
        assert_close(peak.deflection * omega * omega, number(&row["pseudo_acceleration"]), 1e-13);
        assert_eq!(record_spectrum(&record, dt, [omega], ratio).unwrap(), [peak]);
    }
}

/// Beside the history of one mass, sample by sample, in steps that are a thousand times as short: nothing between the samples of the record is missed.
#[test]
fn no_extreme_between_samples_is_missed() {
    let record =
        [-0.027, 1.823, 1.626, -0.909, -0.934, -1.446, -0.388, -0.712, 1.925, 0.838, -0.32, 0.237, -1.224, 0.542];
    let dt = 0.05;
    for (omega, ratio) in [(3.0, 0.0), (31.0, 0.02), (65.0, 0.3), (200.0, 0.05), (900.0, 0.1), (12.0, 0.9)] {
        let (frame, [_, mass]) = oscillator(omega * omega, 1.0);
        let system = frame.build().unwrap();
        let roots = system.first_frequencies::<1>().unwrap();
        let ground = PlaneLoad::base_acceleration(Direction::x());
        let response = system.modal_response::<2, _>(&roots, ground, mass.displacement_x()).unwrap();
        let response = response.with_damping_ratio(ratio).unwrap();
        let parts = 2000;
        let mut relative = response.history(dt / f64::from(parts)).unwrap();
        let mut absolute = response.absolute().unwrap().history(dt / f64::from(parts)).unwrap();
        let (mut deflection, mut velocity, mut acceleration) = (0.0_f64, 0.0_f64, 0.0_f64);
        let mut take = |sample: f64| {
            let (one, other) = (relative.next_motion(sample), absolute.next_motion(sample));
            deflection = deflection.max(one.value.abs());
            velocity = velocity.max(one.rate.abs());
            acceleration = acceleration.max(other.acceleration.abs());
        };
        take(record[0]);
        for pair in record.windows(2) {
            (1..=parts).for_each(|k| take(pair[0] + (pair[1] - pair[0]) * f64::from(k) / f64::from(parts)));
        }
        let peak = oscillator_peak(&record, dt, omega, ratio).unwrap();
        // of a curve the largest sample is below the peak, by the square of the step
        let apart = (omega * dt / f64::from(parts)).powi(2);
        for (found, sampled) in
            [(peak.deflection, deflection), (peak.velocity, velocity), (peak.absolute_acceleration, acceleration)]
        {
            assert!(found >= sampled * (1.0 - 1e-9), "{omega} {ratio}: {found} {sampled}");
            assert!(found <= sampled * (1.0 + apart + 1e-9), "{omega} {ratio}: {found} {sampled}");
        }
    }
}

/// Closed forms: a constant acceleration, and one that grows from zero.
#[test]
fn oscillators_on_simple_grounds() {
    let (omega, ratio) = (7.0, 0.1);
    let slowed = omega * (1.0_f64 - ratio * ratio).sqrt();
    let peak = oscillator_peak(&[2.0; 101], 0.01, omega, ratio).unwrap();
    let overshoot = (-ratio * omega * PI / slowed).exp();
    assert_close(peak.deflection, 2.0 / (omega * omega) * (1.0 + overshoot), 1e-14);
    assert_close(peak.time, PI / slowed, 1e-12);
    // one long step is as good as many short ones
    let long = oscillator_peak(&[2.0, 2.0], 1.0, omega, ratio).unwrap();
    assert_close(long.deflection, peak.deflection, 1e-14);
    assert_close(long.velocity, peak.velocity, 1e-13);
    assert_close(long.absolute_acceleration, peak.absolute_acceleration, 1e-13);
    // without damping the acceleration in space is that of the spring
    let undamped = oscillator_peak(&[0.0, 1.0, -2.0, 0.0, 0.0, 0.0], 0.2, omega, 0.0).unwrap();
    assert_close(undamped.absolute_acceleration, undamped.deflection * omega * omega, 1e-13);
    // a stiff oscillator goes with the ground, a soft one stays
    let record = [0.0, 1.0, -2.0, 0.5, 0.0];
    let stiff = oscillator_peak(&record, 0.2, 1e5, 0.05).unwrap();
    assert_close(stiff.absolute_acceleration, 2.0, 1e-3);
    assert_eq!(oscillator_peak::<f64>(&[], 0.2, 1.0, 0.05).unwrap().deflection, 0.0);
}

/// A slow oscillator in short steps, whose deflection over that at rest would cancel: two integrals of the record.
#[test]
fn slow_oscillators_lose_no_digits() {
    for (omega, ratio) in [(1e-3, 0.7), (1e-6, 0.0), (1e-9, 0.3)] {
        let dt = 0.01_f64;
        let square = dt * dt;
        // a ramp from 1 to -1: u = t²/2 - t³/(3 dt)
        let ramp = oscillator_peak(&[1.0, -1.0], dt, omega, ratio).unwrap();
        assert_close(ramp.deflection, square / 6.0, 1e-4);
        assert_close(ramp.velocity, dt / 4.0, 1e-4);
        let constant = oscillator_peak(&[1.0, 1.0, 1.0], dt, omega, ratio).unwrap();
        assert_close(constant.deflection, 2.0 * square, 1e-4);
        let pulse = oscillator_peak(&[0.0, 1.0, 0.0, 0.0, 0.0], dt, omega, ratio).unwrap();
        assert_close(pulse.deflection, 3.0 * square, 1e-4);
    }
}

/// A spectrum of the record and the history of the record are the same for one mode.
#[test]
fn one_mode_by_its_spectrum_is_its_history() {
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<1>().unwrap();
    let ground = Load::base_acceleration(Direction::y());
    let record: Vec<f64> = (0..200).map(|n| (0.11 * f64::from(n)).sin() + (0.3 * f64::from(n)).cos()).collect();
    let response = cantilever.modal_response::<1, _>(&roots, ground, Cantilever::conn_tip.deflection()).unwrap();
    let damped = response.with_damping_ratio(0.03).unwrap();
    let largest = record.iter().fold(0.0_f64, |most, sample| most.max(sample.abs()));
    let spectrum = (
        |omega: f64, ratio: f64| oscillator_peak(&record, 0.01, omega, ratio).unwrap().deflection * omega * omega,
        largest,
    );
    let peak = damped.spectral_peak(&spectrum, Combination::SumOfSquares).unwrap();
    let residual = damped.to_step(0.0);
    assert_close(peak.missing, residual * largest, 1e-14);
    let mut history = damped.history(0.01).unwrap();
    let most = record.iter().map(|sample| (history.next(*sample) - residual * sample).abs()).fold(0.0, f64::max);
    assert!(most <= peak.of_modes() && most > 0.98 * peak.of_modes(), "{most} {}", peak.of_modes());
}

/// Shapes of a double root count together: the peak does not depend on how they are chosen.
#[test]
fn a_double_root_has_one_peak() {
    let (system, middle) = three_spokes();
    let roots = system.first_frequencies::<3>().unwrap();
    let response =
        system.modal_response::<8, _>(&roots, PlaneLoad::base_acceleration(Direction::x()), middle.displacement_x());
    let response = response.unwrap().with_damping_ratio(0.05).unwrap();
    let peak = response.spectral_peak(&(|_, _| 2.0, 1.0), Combination::SumOfSquares).unwrap();
    assert_eq!(peak.modes().len(), 2);
    // nothing of it goes along y
    let across =
        system.modal_response::<8, _>(&roots, PlaneLoad::base_acceleration(Direction::x()), middle.displacement_y());
    let across = across.unwrap().spectral_peak(&(|_, _| 2.0, 1.0), Combination::AbsoluteSum).unwrap();
    assert!(across.total() < 1e-12 * peak.total(), "{}", across.total());
    // modes of one frequency go together
    assert_close(
        peak.total(),
        response.spectral_peak(&(|_, _| 2.0, 1.0), Combination::CompleteQuadratic).unwrap().total(),
        1e-3,
    );
}

#[test]
fn tables_and_what_is_no_spectrum() {
    let rows = [(0.1, 4.0), (0.5, 2.0), (2.0, 0.5)];
    let by_periods = SpectrumTable::periods(&rows).unwrap();
    assert_close(by_periods.acceleration(TAU / 0.5, 0.05), 2.0, 1e-15);
    assert_close(by_periods.acceleration(TAU, 0.05), 1.0, 1e-14);
    assert_close(by_periods.linear().acceleration(TAU, 0.05), 1.5, 1e-15);
    assert_eq!(
        [by_periods.at_zero_period(), by_periods.acceleration(1e9, 0.0), by_periods.acceleration(1e-9, 0.0)],
        [4.0, 4.0, 0.5]
    );
    assert_eq!(SpectrumTable::<f64>::hertz(&[]).err(), Some(SpectrumError::Empty));
    assert_eq!(SpectrumTable::hertz(&[(1.0, 1.0), (1.0, 2.0)]).err(), Some(SpectrumError::Order { row: 1 }));
    assert_eq!(SpectrumTable::hertz(&[(0.0, 1.0)]).err(), Some(SpectrumError::Order { row: 0 }));
    assert_eq!(SpectrumTable::hertz(&[(1.0, 0.0)]).err(), Some(SpectrumError::Acceleration { acceleration: 0.0 }));
    assert_eq!(
        SpectrumTable::hertz(&[(1.0, f64::INFINITY)]).err(),
        Some(SpectrumError::Acceleration { acceleration: f64::INFINITY })
    );

    assert_eq!(oscillator_peak(&[1.0, f64::NAN], 0.1, 1.0, 0.0), Err(SpectrumError::Sample { sample: 1 }));
    assert_eq!(oscillator_peak(&[1.0], 0.0, 1.0, 0.0), Err(SpectrumError::TimeStep { step: 0.0 }));
    assert_eq!(oscillator_peak(&[1.0], 0.1, 1.0, 1.0), Err(SpectrumError::Oscillator { omega: 1.0, ratio: 1.0 }));
    assert!(oscillator_peak(&[1.0], 0.1, f64::NAN, 0.1).is_err());
    assert!(matches!(oscillator_peak(&[1.0, 2.0], 1.0, 1e9, 0.1), Err(SpectrumError::Stiff { .. })));
    assert!(matches!(oscillator_peak(&[1e308, -1e308], 1e-300, 1e-160, 0.1), Err(SpectrumError::Overflow { .. })));

    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<2>().unwrap();
    let tip = Cantilever::conn_tip;
    let of = |load| cantilever.modal_response::<4, _>(&roots, load, tip.deflection()).unwrap();
    let spectrum = (|_: f64, _: f64| 2.0, 1.0);
    let refused = |error: Result<_, SpectrumError>| error.map(|_: mstmm::motion::SpectralPeak<f64, 4>| ()).unwrap_err();
    let forced = of(tip.force()).spectral_peak(&spectrum, Combination::SumOfSquares);
    assert_eq!(refused(forced), SpectrumError::NotRelative);
    let ground = of(Load::base_acceleration(Direction::y()));
    let absolute = ground.absolute().unwrap().spectral_peak(&spectrum, Combination::SumOfSquares);
    assert_eq!(refused(absolute), SpectrumError::NotRelative);
    let rate = ground.rate().unwrap().spectral_peak(&spectrum, Combination::SumOfSquares);
    assert_eq!(refused(rate), SpectrumError::NotRelative);
    let none = ground.spectral_peak(&(|_: f64, _: f64| f64::NAN, 1.0), Combination::SumOfSquares);
    assert!(matches!(refused(none), SpectrumError::Acceleration { .. }));
    let stopped = mstmm::search::ProportionalDamping::new(500.0, 0.0, 0.0).unwrap();
    let creeping = ground.with_damping(&stopped).unwrap().spectral_peak(&spectrum, Combination::SumOfSquares);
    assert!(matches!(refused(creeping), SpectrumError::NoVibration { .. }));
}
