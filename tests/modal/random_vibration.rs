//! Random vibrations: values of the file, quadratures of the same integrals, and what is refused.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{Cantilever, assert_close, number, reference};
use mstmm::motion::PowerSpectrum;
use mstmm::prelude::*;
use std::f64::consts::PI;

/// The table of the file, in g²/Hz.
fn rows() -> Vec<(f64, f64)> {
    let part = reference("random_vibration")["base_asd"]["breakpoints_hz_g2"].clone();
    part.as_array().unwrap().iter().map(|row| (number(&row[0]), number(&row[1]))).collect()
}

#[test]
fn vibrations_on_a_shaker_are_those_of_the_file() {
    let part = reference("random_vibration")["base_asd"].clone();
    let (rows, g) = (rows(), number(&part["g"]));
    let shaker = PowerSpectrum::hertz(&rows).unwrap();
    assert_close(shaker.rms(), number(&part["input_rms_g"]), 1e-15);
    let shaker = shaker.times(g * g);
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<8>().unwrap();
    let ground = Load::base_acceleration(Direction::y());
    let entries = [
        ("tip relative deflection", Cantilever::conn_tip.deflection()),
        ("base moment", Cantilever::beam_1.input().moment()),
    ];
    for (name, entry) in entries {
        let known = &part["answers"][name];
        let response = cantilever.modal_response::<8, _>(&roots, ground, entry).unwrap();
        let response = response.with_damping_ratio(number(&part["ratio"])).unwrap();
        let found = response.random(&shaker).unwrap();
        println!(
            "{name} {} {:?} {:?} {}",
            found.rms / number(&known["rms"]) - 1.0,
            found.rate_rms.unwrap() / number(&known["rms_rate"]) - 1.0,
            found.up_crossings_hertz(),
            response.power_at(50.0, &shaker).unwrap() / number(&known["psd_at_50_hz"]) - 1.0
        );
        assert_close(found.rms, number(&known["rms"]), 1e-12);
        assert_close(found.rate_rms.unwrap(), number(&known["rms_rate"]), 1e-12);
        assert_close(found.up_crossings_hertz().unwrap(), number(&known["zero_up_crossings_hz"]), 1e-12);
        assert_close(response.power_at(50.0, &shaker).unwrap(), number(&known["psd_at_50_hz"]), 1e-12);
    }
    let known = &part["answers"]["tip absolute acceleration"];
    let response = cantilever.modal_response::<8, _>(&roots, ground, Cantilever::conn_tip.deflection()).unwrap();
    let response = response.with_damping_ratio(number(&part["ratio"])).unwrap();
    let found = response.absolute().unwrap().acceleration().unwrap().random(&shaker).unwrap();
    println!("{}", found.rms / number(&known["rms"]) - 1.0);
    assert_close(found.rms, number(&known["rms"]), 1e-12);
    assert_close(found.rms / g, number(&known["rms_g"]), 1e-12);
}

#[test]
fn white_noise_is_that_of_the_file() {
    let part = reference("random_vibration")["white_force"].clone();
    let noise = PowerSpectrum::white(4.0 * PI * number(&part["S0_two_sided_per_rad_s"]));
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let (load, entry) = (Cantilever::conn_tip.force(), Cantilever::conn_tip.deflection());
    let response = cantilever.modal_response::<3, _>(&roots, load, entry).unwrap().without_residual().unwrap();
    let found = response.with_damping_ratio(number(&part["ratio"])).unwrap().random(&noise).unwrap();
    assert_close(found.rms * found.rms, number(&part["variance"]), 1e-12);
    let rate = found.rate_rms.unwrap();
    assert_close(rate * rate, number(&part["variance_of_rate"]), 1e-12);
    assert_close(found.up_crossings_hertz().unwrap(), number(&part["zero_up_crossings_hz"]), 1e-12);
    println!(
        "{} {}",
        found.rms * found.rms / number(&part["variance"]) - 1.0,
        rate * rate / number(&part["variance_of_rate"]) - 1.0
    );
}
