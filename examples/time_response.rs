//! A cantilever in time: hit by an impulse, loaded by a step, and struck by a hammer for a millisecond.

use mstmm::prelude::*;
use std::error::Error;
use std::f64::consts::PI;

system! {
    /// Cantilever with a point for loads at its middle.
    struct Cantilever { half: f64, ei: f64, m: f64 }

    fixed -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m }
          -> beam 2 { length: half, bending_stiffness: ei, mass_per_length: m }
          -> free;
}

/// Deflections of the tip [m]: after an impulse of 1 N s, under a force of 1 N, and struck by a hammer with 1 N s.
pub type Deflections = [f64; 3];

/// Force of the hammer [N] at a time [s]: half a sine of 1 ms.
fn hammer(time: f64) -> f64 {
    if time < 1e-3 { 0.5e3 * PI * (1e3 * PI * time).sin() } else { 0.0 }
}

/// The deflections at as many times, a tenth of a millisecond apart. All loads act at the middle.
pub fn deflections(times: u32) -> Result<Vec<(f64, Deflections)>, Box<dyn Error>> {
    // a steel strip, 30 mm by 6 mm
    let system = Cantilever { half: 0.4, ei: 113.4, m: 1.413 }.build()?;
    let roots = system.first_frequencies::<30>()?;
    let (load, entry) = (Cantilever::beam_1.output().force(), Cantilever::beam_2.output().deflection());
    // every mode decays with 1 % of its critical damping
    let response = system.modal_response::<30, _>(&roots, load, entry)?.with_damping_ratio(0.01)?;
    let (step, mut struck) = (1e-4, response.history(1e-4)?);
    let times = (0..times).map(|index| f64::from(index) * step);
    Ok(times
        .map(|time| (time, [response.to_impulse(time), response.to_step(time), struck.next(hammer(time))]))
        .collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("Deflection of the tip under loads at the middle");
    println!("time [ms]   impulse of 1 N s [mm]   step of 1 N [mm]   hammer with 1 N s [mm]");
    for (time, deflections) in deflections(1001)?.iter().step_by(50) {
        let [impulse, step, struck] = deflections.map(|metres| 1e3 * metres);
        println!("{:9.1} {impulse:23.4} {step:18.5} {struck:24.4}", 1e3 * time);
    }
    Ok(())
}
