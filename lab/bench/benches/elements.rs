//! What an evaluation of a chain of four general beams costs, in evaluations of the same chain of Euler-Bernoulli beams, in one run. Prints a
//! Markdown table.
//!
//! `cargo bench --bench elements`

use mstmm::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Rounds of each measurement.
const ROUNDS: usize = 41;
/// Evaluations in a round.
const CALLS: u32 = 2000;

system! {
    struct Plain { ei: f64, m: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: ei, mass_per_length: m }
        -> beam 2 { length: 1.1, bending_stiffness: ei, mass_per_length: m }
        -> beam 3 { length: 1.2, bending_stiffness: ei, mass_per_length: m }
        -> beam 4 { length: 1.3, bending_stiffness: ei, mass_per_length: m } -> free
}

system! {
    #[derive(Clone, Copy)]
    struct General { ei: f64, m: f64, f: f64, r: f64, n: f64, k: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: ei, mass_per_length: m, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n, foundation_stiffness: k }
        -> beam 2 { length: 1.1, bending_stiffness: ei, mass_per_length: m, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n, foundation_stiffness: k }
        -> beam 3 { length: 1.2, bending_stiffness: ei, mass_per_length: m, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n, foundation_stiffness: k }
        -> beam 4 { length: 1.3, bending_stiffness: ei, mass_per_length: m, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n, foundation_stiffness: k } -> free
}

/// Time of a round in ns, at frequencies of a decade.
fn round(characteristic: impl Fn(f64) -> mstmm::number::Scaled<f64>, omega: f64) -> f64 {
    let start = Instant::now();
    for k in 0..CALLS {
        black_box(characteristic(omega * (1.0 + f64::from(k) / f64::from(CALLS))));
    }
    start.elapsed().as_secs_f64()
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let zero = General { ei: 1.0, m: 1.0, f: 0.0, r: 0.0, n: 0.0, k: 0.0 };
    let stocky = General { f: 0.02, r: 0.005, ..zero };
    let cases = [
        ("without any, low", zero, 0.1),
        ("without any", zero, 100.0),
        ("shear and rotary inertia", stocky, 60.0),
        ("the same, above the cut-off", stocky, 300.0),
        ("tension", General { n: 300.0, ..zero }, 100.0),
        ("foundation, below the cut-on", General { k: 1e6, ..zero }, 300.0),
        ("foundation, above it", General { k: 1e4, ..zero }, 300.0),
        ("all", General { n: 50.0, k: 500.0, ..stocky }, 80.0),
    ];
    let plain = Plain { ei: 1.0, m: 1.0 }.build()?;
    println!("| four general beams | times Euler-Bernoulli |");
    println!("|---|---|");
    for (name, model, omega) in cases {
        let system = model.build()?;
        let ratio =
            |_| round(|x| system.characteristic(x), omega) / round(|x| plain.characteristic(x), omega.max(10.0));
        let mut ratios: Vec<f64> = (0..ROUNDS).map(ratio).collect();
        ratios.sort_by(f64::total_cmp);
        println!("| {name} | {:.2} |", ratios[ROUNDS / 2]);
    }
    Ok(())
}
