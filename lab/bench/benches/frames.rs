//! What each question to a plane frame costs, in evaluations of Δ, in one run: a portal of three beams, and the portal of the example with
//! a hinge, a machine and a brace; what an evaluation of a portal and of a ring costs for each kind of number; and what a certified search
//! takes on each instruction set. Prints Markdown tables.
//!
//! `cargo bench --bench frames`

use mstmm::__private::System;
use mstmm::motion::{PlaneEntry, PlaneLoad};
use mstmm::number::{DoubleDouble, Dual};
use mstmm::prelude::*;
use mstmm_lanes::InstructionSet;
use std::hint::black_box;
use std::time::Instant;
use subjects::frames::{Plain, PlainSystem, Workshop};

pub mod subjects;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement.
const ROUNDS: usize = 41;

system! {
    /// A clamped portal with legs of different lengths.
    struct Uneven { ea: f64, ei: f64, m: f64 }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, 4.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (6.0, 4.0)
        <- beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } <- fixed at (6.0, -1.0);
}

system! {
    /// A ring of four beams on the ground by a pin and a spring: a closed loop.
    struct Ring { ea: f64, ei: f64, m: f64 }
    conn a
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, 4.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (6.0, 4.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn d at (6.0, 0.0)
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a;
    conn d <- spring 5 { stiffness: ea } <- fixed at (6.0, -1.0);
    pinned -> conn a at (0.0, 0.0);
}

/// Time of one call in ns, of so many calls.
fn nanoseconds<R>(calls: u32, mut call: impl FnMut(f64) -> R) -> f64 {
    let start = Instant::now();
    for k in 0..calls {
        black_box(call(f64::from(k)));
    }
    start.elapsed().as_secs_f64() * 1e9 / f64::from(calls)
}

/// The median over rounds of the time of a call over that of an evaluation of Δ in the same round: other work and the clock of the machine
/// change both.
fn ratio<D, R>(calls: u32, mut delta: impl FnMut(f64) -> D, mut call: impl FnMut(f64) -> R) -> f64 {
    let round = |_| nanoseconds(calls, &mut call) / nanoseconds(8 * calls, &mut delta);
    let mut ratios: Vec<f64> = (0..ROUNDS).map(round).collect();
    ratios.sort_by(f64::total_cmp);
    ratios[ROUNDS / 2]
}

/// The rows of a system, a macro since what it is asked for has bounds of many traits.
macro_rules! rows {
    ($name:literal, $model:ident, $system:expr, $load:expr, $entry:expr) => {{
        let (system, load, entry): (_, PlaneLoad<$model>, PlaneEntry<$model>) = ($system, $load, $entry);
        let roots = system.first_frequencies::<8>()?;
        let omega = |k: f64| 0.3 * roots[0].omega + 0.03 * k * roots[1].omega;
        let response = system.frequency_response(load, entry)?;
        let delta = |k: f64| Characteristic::<f64>::characteristic(&system, omega(k));
        let of_response = ratio(50, delta, |k| response.at(omega(k)));
        let at_speed = ratio(50, delta, |k| response.at_speed(omega(k)));
        let matrix = ratio(50, delta, |k| -> mstmm::number::Scaled<f64> { system.overall_determinant(omega(k)) });
        let eight = ratio(2, delta, |_| system.first_frequencies::<8>());
        for mode in [0, 3, 7] {
            let shape = ratio(20, delta, |_| system.mode_shape(&roots[mode]));
            let sensitivities = ratio(20, delta, |_| system.sensitivity(&roots[mode]));
            println!(
                "| {} | {} | {of_response:.1} | {at_speed:.1} | {shape:.1} | {sensitivities:.1} | {matrix:.1} | {eight:.0} |",
                $name,
                mode + 1
            );
        }
    }};
}

/// What the standard library takes for sine, cosine and exponential of the bending and sine and cosine of the stretching of so many different
/// beams, in ns.
fn functions<const BEAMS: usize>(calls: u32, lengths: [f64; BEAMS]) -> f64 {
    let [bending, stretching] = black_box([(47.1_f64 / 5.25e6).sqrt().sqrt(), (47.1_f64 / 1.26e9).sqrt()]);
    let of_beam = |length: f64, omega: f64| {
        let (z, x) = (bending * omega.sqrt() * length, stretching * omega * length);
        z.sin() + z.cos() + z.exp() + x.sin() + x.cos()
    };
    let all = |k: f64| black_box(lengths.map(|length| of_beam(length, 20.0 + k)));
    (0..ROUNDS).map(|_| nanoseconds(calls, all)).fold(f64::INFINITY, f64::min)
}

/// A row of evaluations of Δ by stiffnesses, as searches take them: the least time over rounds per beam, and in times of the standard functions of
/// the different beams of the frame, on each instruction set.
fn print_stiffnesses<const BEAMS: usize>(
    name: &str,
    system: &impl System<Parameter = f64>,
    beams: usize,
    lengths: [f64; BEAMS],
) -> Result<(), Failure> {
    let model = system.in_numbers().ok_or("a frame of beams is known in numbers")?;
    let standard = functions(400, lengths);
    print!("| {name} | {standard:.0} |");
    for set in InstructionSet::ALL {
        if set > InstructionSet::widest() {
            print!(" |");
            continue;
        }
        set.limit();
        // a block of a search; alone each frequency by itself
        let (mut value, mut below) = ([0.0; 16], [0.0; 16]);
        let round = |_| {
            let block = |k: f64| {
                let omega: [f64; 16] = core::array::from_fn(|lane| 20.0 + k + 7.0 * lane as f64);
                model.evaluate(black_box(&omega), &mut value, &mut below);
                black_box(value[0]);
            };
            nanoseconds(50, block) / 16.0
        };
        let least = (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min);
        print!(" {:.0} ns, {:.1} |", least / beams as f64, least / standard);
    }
    println!();
    Ok(())
}

/// A row of evaluations of Δ: the least time over rounds for each kind of number, in times of the standard functions.
macro_rules! evaluations {
    ($name:literal, $system:expr) => {{
        let system = $system;
        let omega = |k: f64| 20.0 + k;
        let least = |call: &dyn Fn(f64)| (0..ROUNDS).map(|_| nanoseconds(400, call)).fold(f64::INFINITY, f64::min);
        let standard = functions(400, [4.0, 6.0]);
        let times = [
            least(&|k| {
                black_box(Characteristic::<f64>::characteristic(&system, omega(k)));
            }),
            least(&|k| {
                black_box(Characteristic::<Dual<f64>>::characteristic(&system, Dual::variable(omega(k))));
            }),
            least(&|k| {
                black_box(system.characteristic(Complex::new(-0.1 * omega(k), omega(k))));
            }),
            least(&|k| {
                black_box(system.characteristic(DoubleDouble::from(omega(k))));
            }),
        ];
        let [real, dual, complex, extended] = times.map(|time| time / standard);
        println!("| {} | {standard:.0} | {real:.1} | {dual:.1} | {complex:.1} | {extended:.0} |", $name);
    }};
}

/// The search for ten frequencies of a portal on each instruction set: the least time over rounds.
fn print_searches(portal: &PlainSystem) -> Result<(), Failure> {
    println!(
        "\n| instruction set | evaluations | ten certified frequencies [µs] | of that an evaluation of a beam [ns] |"
    );
    println!("|---|---|---|---|");
    for set in InstructionSet::ALL.into_iter().filter(|set| *set <= InstructionSet::widest()) {
        set.limit();
        let evaluations = portal.first_frequencies::<10>()?.evaluations();
        let rounds = (0..10 * ROUNDS).map(|_| nanoseconds(1, |_| portal.first_frequencies::<10>()));
        let least = rounds.fold(f64::INFINITY, f64::min);
        let of_beam = least / (3 * evaluations) as f64;
        println!("| {set:?} | {evaluations} | {:.1} | {of_beam:.0} |", least / 1e3);
    }
    Ok(())
}

fn main() -> Result<(), Failure> {
    println!("| frame | mode | response | at speed | shape | all sensitivities | det U_all | first eight roots |");
    println!("|---|---|---|---|---|---|---|---|");
    let plain = Plain { ea: 1.26e9, ei: 5.25e6, m: 47.1 }.build()?;
    rows!("plain", Plain, plain.clone(), Plain::conn_b.force_x(), Plain::beam_1.input().moment());
    let workshop = Workshop { ea: 4e8, ei: 1e6, m: 20.0, brace: 2e6, machine: 500.0 }.build()?;
    rows!("workshop", Workshop, workshop, Workshop::conn_b.force_x(), Workshop::beam_1.input().moment());
    println!("\n| Δ | sin, cos, exp [ns] | real | dual | complex | double-double |");
    println!("|---|---|---|---|---|---|");
    evaluations!("portal", plain.clone());
    evaluations!("ring", Ring { ea: 1.26e9, ei: 5.25e6, m: 47.1 }.build()?);
    println!("\n| Δ by stiffnesses, per beam | sin, cos, exp [ns] | alone | AVX2 | AVX-512 |");
    println!("|---|---|---|---|---|");
    print_stiffnesses("portal, legs alike", &plain, 3, [4.0, 6.0])?;
    let uneven = Uneven { ea: 1.26e9, ei: 5.25e6, m: 47.1 }.build()?;
    print_stiffnesses("portal, three different beams", &uneven, 3, [4.0, 6.0, 5.0])?;
    print_searches(&plain)
}
