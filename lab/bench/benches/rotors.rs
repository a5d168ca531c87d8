//! What a Campbell diagram costs: fifty speeds of a rotor with two discs, six frequencies of each whirl, and its critical speeds. Prints a Markdown table.
//!
//! `cargo bench --bench rotors`. Times are the least of some rounds; quote the ratios.

use mstmm::prelude::*;
use mstmm::search::{campbell, critical_speeds};
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

system! {
    /// Example 5.9.1 of Friswell, Penny, Garvey and Lees.
    struct TwoDiscs { speed: f64 }
    section shaft {
        length: 0.5, bending_stiffness: 64733.989, mass_per_length: 15.334899, shear_stiffness: 141308987.0,
        rotary_inertia: 0.002396078, polar_inertia_per_length: 0.004792156, speed,
    }
    free -> conn a -> beam 1 { ..shaft } -> disc 2 { mass: 32.58972765, inertia: 0.17808928, polar_inertia: 0.3295636, speed }
         -> beam 3 { ..shaft } -> disc 4 { mass: 51.52526111, inertia: 0.42358058, polar_inertia: 0.8050822, speed }
         -> beam 5 { ..shaft } -> conn b -> free;
    fixed -> spring 6 { stiffness: 1e6 } -> conn a;
    fixed -> spring 7 { stiffness: 1e6 } -> conn b;
}

/// Rounds of each measurement.
const ROUNDS: usize = 11;

/// Speeds of a diagram [rad/s].
fn speeds() -> impl Iterator<Item = f64> {
    (0..50).map(|k| 20.0 * f64::from(k))
}

/// Microseconds of a function: the least of some rounds.
fn microseconds<R>(mut of: impl FnMut() -> R) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        black_box(of());
        least = least.min(start.elapsed().as_secs_f64());
    }
    1e6 * least
}

/// The sum of the frequencies of all estimates.
fn estimated() -> Result<f64, Failure> {
    let mut sum = 0.0;
    for speed in speeds() {
        let rotor = TwoDiscs { speed }.build()?;
        for whirl in [Whirl::Forward, Whirl::Backward] {
            sum += rotor.whirl(whirl).estimates::<6>()?.iter().map(|root| root.omega).sum::<f64>();
        }
    }
    Ok(sum)
}

fn proven() -> Result<usize, Failure> {
    let mut count = 0;
    for at in campbell::<6, _>(speeds(), |speed| TwoDiscs { speed }.build()) {
        let at = at?;
        count += at.forward.iter().chain(at.backward.iter()).filter(|root| root.is_proven).count();
    }
    Ok(count)
}

fn critical() -> Result<usize, Failure> {
    Ok(critical_speeds::<8, _>(1.0..=1000.0, Whirl::Forward, 1.0, |speed| TwoDiscs { speed }.build())?.len())
}

fn main() -> Result<(), Failure> {
    let count = proven()?;
    let number = critical()?;
    estimated()?;
    println!("| a rotor of three shafts and two discs | time |\n|---|---|");
    println!("| estimates of 50 speeds, six frequencies of each whirl | {:.2} ms |", 1e-3 * microseconds(estimated));
    println!("| the same, {count} frequencies proven | {:.2} ms |", 1e-3 * microseconds(proven));
    println!("| {number} critical speeds, proven | {:.2} ms |", 1e-3 * microseconds(critical));
    let rotor = TwoDiscs { speed: 400.0 }.build()?;
    let forward = rotor.whirl(Whirl::Forward);
    let delta = microseconds(|| {
        (0..1000).map(|k| forward.characteristic(black_box(400.0 + f64::from(k))).mantissa()).sum::<f64>()
    });
    println!("| one evaluation of the determinant | {:.3} µs |", 1e-3 * delta);
    Ok(())
}
