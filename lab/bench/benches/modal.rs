//! What answers about modes cost, beside the search of the modes: participation, a sample of a damped response, a box of tolerances, axial forces. Prints a Markdown table.
//!
//! `cargo bench --bench modal`. Times are the least of many rounds; quote the ratios.

use mstmm::motion::HoldOrder;
use mstmm::prelude::*;
use mstmm::search::ToleranceBox;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement.
const ROUNDS: usize = 41;

system! {
    /// A portal with a machine at a corner.
    struct Portal { ea: f64, ei: f64, m: f64, machine: f64 }
    section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m, axial_force: 0.0 }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0)
        -> beam 3 { ..steel } -> pinned at (4.0, 0.0);
    conn b -> point_mass 4 { mass: machine };
}

system! {
    /// The same without a parameter for axial forces, which searches take at sixteen frequencies at once.
    struct Plain { ea: f64, ei: f64, m: f64, machine: f64 }
    section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0)
        -> beam 3 { ..steel } -> pinned at (4.0, 0.0);
    conn b -> point_mass 4 { mass: machine };
}

/// The least time of a call over rounds, in µs.
fn microseconds<R>(calls: u32, call: impl Fn(u32) -> R) -> f64 {
    let round = |_| {
        let start = Instant::now();
        for k in 0..calls {
            black_box(call(k));
        }
        start.elapsed().as_secs_f64() * 1e6 / f64::from(calls)
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), Failure> {
    let plain =
        |share: f64| Plain { ea: 4e8 * share, ei: 1e6 * share, m: 20.0 / share, machine: 100.0 / share }.build();
    let system = plain(1.0)?;
    let search = microseconds(20, |_| system.first_frequencies::<6>());
    println!("| answer about a portal | µs | searches of six frequencies |\n|---|---|---|");
    let row = |name: &str, time: f64| println!("| {name} | {time:.2} | {:.4} |", time / search);
    row("six frequencies, proven", search);

    let lot = ToleranceBox::between(plain(0.95)?, plain(1.05)?)?;
    row("their ranges over a box of 5 %", microseconds(20, |_| lot.first_frequencies::<6>()));
    row("whether a range is free", microseconds(20, |_| lot.is_free_of(60.0..=150.0)));

    let roots = system.first_frequencies::<10>()?;
    row("participation of ten modes", microseconds(5, |_| system.participation::<10, _>(&roots, Direction::x())));
    row(
        "participation about a foot",
        microseconds(5, |_| system.participation::<10, _>(&roots, Direction::about([0.0, 0.0]))),
    );
    let response = system.modal_response::<10, _>(&roots, Plain::conn_b.force_x(), Plain::conn_b.displacement_x())?;
    let damped = response.with_damping_ratio(0.02)?;
    row(
        "a sample of a response of ten damped modes",
        microseconds(400, |k| damped.at(Complex::new(0.0, 30.0 + f64::from(k)))),
    );
    let mut history = damped.history(1e-3)?;
    let start = Instant::now();
    for k in 0..200_000_u32 {
        black_box(history.next(f64::from(k % 7)));
    }
    row("a step of a history of ten damped modes", start.elapsed().as_secs_f64() * 1e6 / 2e5);
    let space = system.state_space::<10, 1, 1>(&roots, [Plain::conn_b.force_x()], [Plain::conn_b.displacement_x()])?;
    let mut discrete = space.with_damping_ratio(0.02)?.discrete(1e-3, HoldOrder::First)?;
    let mut single = discrete.single();
    let start = Instant::now();
    for k in 0..200_000_u32 {
        black_box(discrete.step(&[f64::from(k % 7)]));
    }
    row("a step of a state space of ten modes", start.elapsed().as_secs_f64() * 1e6 / 2e5);
    let start = Instant::now();
    for k in 0..200_000_u32 {
        black_box(single.step(&[(k % 7) as f32]));
    }
    row("the same in single precision", start.elapsed().as_secs_f64() * 1e6 / 2e5);

    let loaded = Portal { ea: 4e8, ei: 1e6, m: 20.0, machine: 100.0 }.build()?;
    let dead = [(Portal::conn_b.force_y(), -2e5), (Portal::beam_2.uniform_load_y(), -1e4)];
    let forces = loaded.axial_forces(&dead)?;
    row("axial forces under two loads", microseconds(5, |_| loaded.axial_forces(&dead).map(|_| ())));
    row("the structure under them", microseconds(20, |_| loaded.with_axial_forces(&forces)));
    row("and settled", microseconds(5, |_| loaded.settled_under(&dead)));
    row(
        "six frequencies of that",
        microseconds(5, |_| loaded.with_axial_forces(&forces).map(|system| system.first_frequencies::<6>())),
    );
    Ok(())
}
