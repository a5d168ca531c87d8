//! What a response costs in a path, by minors, and in the same model with places, by stiffnesses: in 32 digits and in those of the model, at a real
//! and at a complex frequency. Prints a Markdown table.
//!
//! `cargo bench --bench responses`. Times are the least of many rounds; quote the ratios.

use mstmm::prelude::*;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement, and calls of each round.
const ROUNDS: usize = 21;
const CALLS: u32 = 400;

mod path {
    use mstmm::prelude::*;

    system! {
        pub(super) struct Cantilever { pub(super) length: f64, pub(super) mass: f64 }
        fixed -> beam 1 { length, bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn tip -> point_mass 2 { mass } -> free;
    }

    system! {
        pub(super) struct Spans { pub(super) length: f64, pub(super) loss_factor: f64 }
        fixed -> beam 1 { length, bending_stiffness: 2.0, mass_per_length: 0.5, loss_factor } -> conn a
            -> beam 2 { length, bending_stiffness: 4.0, mass_per_length: 0.5, loss_factor } -> conn b
            -> beam 3 { length: 1.5 * length, bending_stiffness: 6.0, mass_per_length: 0.5, loss_factor } -> pinned;
        conn a <- spring 4 { stiffness: 1e3 } <- fixed;
        conn b <- spring 5 { stiffness: 1e3 } <- mass 6 { mass: 0.5 } <- free;
    }
}

mod line {
    use mstmm::prelude::*;

    system! {
        pub(super) struct Cantilever { pub(super) length: f64, pub(super) mass: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 0.5 } -> conn tip at length -> point_mass 2 { mass } -> free;
    }

    system! {
        pub(super) struct Spans { pub(super) length: f64, pub(super) loss_factor: f64 }
        fixed at 0.0 -> beam 1 { bending_stiffness: 2.0, mass_per_length: 0.5, loss_factor } -> conn a at length
            -> beam 2 { bending_stiffness: 4.0, mass_per_length: 0.5, loss_factor } -> conn b at 2.0 * length
            -> beam 3 { bending_stiffness: 6.0, mass_per_length: 0.5, loss_factor } -> pinned at 3.5 * length;
        conn a <- spring 4 { stiffness: 1e3 } <- fixed;
        conn b <- spring 5 { stiffness: 1e3 } <- mass 6 { mass: 0.5 } <- free;
    }
}

/// The least time of a call over rounds, in µs.
fn microseconds<R>(call: impl Fn(f64) -> R) -> f64 {
    let round = |_| {
        let start = Instant::now();
        for k in 0..CALLS {
            black_box(call(1.0 + 0.37 * f64::from(k)));
        }
        start.elapsed().as_secs_f64() * 1e6 / f64::from(CALLS)
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}

/// Times in 32 digits and in those of the model, at frequencies that a function makes of numbers.
macro_rules! times {
    ($response:expr, $frequency:expr) => {
        [microseconds(|k| $response.at($frequency(k))), microseconds(|k| $response.at_speed($frequency(k)))]
    };
}

fn main() -> Result<(), Failure> {
    println!("| response | beams | path [µs] | with places [µs] | path, `at_speed` | with places, `at_speed` |");
    println!("|---|---|---|---|---|---|");
    let row = |name: &str, beams: usize, path: [f64; 2], line: [f64; 2]| {
        println!("| {name} | {beams} | {:.2} | {:.2} | {:.2} | {:.2} |", path[0], line[0], path[1], line[1]);
    };
    let (length, mass) = (1.0, 0.3);
    let path = path::Cantilever { length, mass }.build()?;
    let path = path.frequency_response(path::Cantilever::conn_tip.force(), path::Cantilever::conn_tip.deflection())?;
    let line = line::Cantilever { length, mass }.build()?;
    let (load, entry) = (line::Cantilever::conn_tip.force_y(), line::Cantilever::conn_tip.displacement_y());
    let line = line.frequency_response(load, entry)?;
    row("cantilever with a mass, real", 1, times!(path, |k: f64| k), times!(line, |k: f64| k));
    let decaying = |k: f64| Complex::new(-0.1, k);
    row("the same, complex", 1, times!(path, decaying), times!(line, decaying));

    let loss_factor = 0.02;
    let path = path::Spans { length, loss_factor }.build()?;
    let path = path.frequency_response(path::Spans::conn_a.force(), path::Spans::conn_b.deflection())?;
    let line = line::Spans { length, loss_factor }.build()?;
    let line = line.frequency_response(line::Spans::conn_a.force_y(), line::Spans::conn_b.displacement_y())?;
    let steady = |k: f64| Complex::new(0.0, k);
    row("three spans with a loss factor", 3, times!(path, steady), times!(line, steady));
    Ok(())
}
