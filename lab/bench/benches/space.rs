//! What a frame in space costs: a ring of four beams on four columns, clamped, 24 motions, and buildings of it; the ring as a sketch, undamped, and with
//! braces and losses. Prints Markdown tables.
//!
//! `cargo bench --bench space`. Times are the least of some rounds; quote the ratios.

use mstmm::frame::{Frame, Point, Section, Space, Structure};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::System;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

system! {
    /// The ring on columns.
    struct Ring { e: f64, g: f64, rho: f64, area: f64, i: f64 }
    section steel {
        axial_stiffness: e * area, bending_stiffness: e * i, torsional_stiffness: 2.0 * g * i, mass_per_length: rho * area,
        polar_inertia_per_length: 2.0 * rho * i,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 0.0, 5.0) -> beam 2 { ..steel } -> conn b at (6.0, 0.0, 5.0)
        -> beam 3 { ..steel } -> conn c at (6.0, 4.0, 5.0) -> beam 4 { ..steel } -> conn d at (0.0, 4.0, 5.0) -> beam 5 { ..steel } -> conn a;
    fixed at (6.0, 0.0, 0.0) -> beam 6 { ..steel } -> conn b;
    fixed at (6.0, 4.0, 0.0) -> beam 7 { ..steel } -> conn c;
    fixed at (0.0, 4.0, 0.0) -> beam 8 { ..steel } -> conn d;
}

system! {
    /// The same with losses, and with slender bars from foot to head.
    struct Braced { e: f64, g: f64, rho: f64, area: f64, i: f64, loss_factor: f64 }
    section steel {
        axial_stiffness: e * area, bending_stiffness: e * i, torsional_stiffness: 2.0 * g * i, mass_per_length: rho * area,
        polar_inertia_per_length: 2.0 * rho * i, loss_factor,
    }
    section tie { axial_stiffness: 0.02 * e * area, bending_stiffness: 1e-4 * e * i, mass_per_length: 0.02 * rho * area, loss_factor }
    fixed -> conn p at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (0.0, 0.0, 5.0) -> beam 2 { ..steel } -> conn b at (6.0, 0.0, 5.0)
        -> beam 3 { ..steel } -> conn c at (6.0, 4.0, 5.0) -> beam 4 { ..steel } -> conn d at (0.0, 4.0, 5.0) -> beam 5 { ..steel } -> conn a;
    fixed -> conn q at (6.0, 0.0, 0.0) -> beam 6 { ..steel } -> conn b;
    fixed -> conn r at (6.0, 4.0, 0.0) -> beam 7 { ..steel } -> conn c;
    fixed -> conn s at (0.0, 4.0, 0.0) -> beam 8 { ..steel } -> conn d;
    conn p -> bar 9 { ..tie } -> conn b;
    conn q -> bar 10 { ..tie } -> conn c;
    conn r -> bar 11 { ..tie } -> conn d;
    conn s -> bar 12 { ..tie } -> conn a;
}

/// Rounds of each measurement.
const ROUNDS: usize = 11;

/// Young's modulus, shear modulus, density, area and moment of area of all members.
const STEEL: [f64; 5] = [210e9, 210e9 / 2.6, 7850.0, 6e-3, 2.5e-5];

/// Bays of 6 by 4 and storeys of 5, with beams along x and y of each floor and columns between floors.
fn building([bays_x, bays_y, storeys]: [usize; 3]) -> (Frame<Space>, [Point<Space>; 2]) {
    let [e, g, rho, area, i] = STEEL;
    let steel = Section::new()
        .axial_stiffness(e * area)
        .bending_stiffness(e * i)
        .torsional_stiffness(2.0 * g * i)
        .mass_per_length(rho * area)
        .polar_inertia_per_length(2.0 * rho * i);
    let mut frame = Frame::new();
    let mut below: Vec<Point<Space>> = Vec::new();
    for storey in 0..=storeys {
        let mut floor = Vec::new();
        for x in 0..=bays_x {
            for y in 0..=bays_y {
                floor.push(frame.point([6.0 * x as f64, 4.0 * y as f64, 5.0 * storey as f64]));
            }
        }
        let place = |x: usize, y: usize| x * (bays_y + 1) + y;
        if storey == 0 {
            floor.iter().for_each(|foot| frame.hold(*foot, Support::Fixed));
        } else {
            for x in 0..=bays_x {
                for y in 0..=bays_y {
                    frame.member(below[place(x, y)], floor[place(x, y)], steel);
                    if x < bays_x {
                        frame.member(floor[place(x, y)], floor[place(x + 1, y)], steel);
                    }
                    if y < bays_y {
                        frame.member(floor[place(x, y)], floor[place(x, y + 1)], steel);
                    }
                }
            }
        }
        below = floor;
    }
    let corners = [below[0], below[below.len() - 1]];
    (frame, corners)
}

/// The least time of a call over rounds, in µs.
fn microseconds<R>(calls: u32, call: impl Fn() -> R) -> f64 {
    let round = |_| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        start.elapsed().as_secs_f64() * 1e6 / f64::from(calls)
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}

/// A row: building it, Δ by stiffnesses at one frequency of sixteen, both bounds of a count, ten proven frequencies, a response, a shape.
fn print_row(name: &str, size: [usize; 3], calls: u32) -> Result<(), Failure> {
    let (frame, [load, read]) = building(size);
    let built: Structure<Space> = frame.build()?;
    let roots = built.frequencies(10)?;
    let response = built.frequency_response(load.force_x(), read.displacement_x())?;
    let omega: [f64; 16] = core::array::from_fn(|k| 20.0 + 7.0 * k as f64);
    let delta = built.in_numbers().map(|model| {
        let evaluate = || {
            let (mut values, mut below) = ([0.0; 16], [0.0; 16]);
            model.evaluate(black_box(&omega), &mut values, &mut below);
            values[0]
        };
        microseconds(calls, evaluate) / 16.0
    });
    println!(
        "| {name} | {:.0} | {} | {:.0} | {:.0} | {:.0} | {:.0} |",
        microseconds(calls, || frame.build().is_ok()),
        delta.map_or("".into(), |delta| format!("{delta:.2}")),
        microseconds(calls, || built.count_bounds(200.0)),
        microseconds(calls, || built.frequencies(10).is_ok()),
        microseconds(calls, || response.at(200.0).is_ok()),
        microseconds(calls, || built.mode_shape(&roots[0]).is_ok()),
    );
    Ok(())
}

fn main() -> Result<(), Failure> {
    println!(
        "| frame [µs] | build | Δ, of sixteen at once | both bounds | ten proven frequencies | response | shape |"
    );
    println!("|---|---|---|---|---|---|---|");
    print_row("ring on columns", [1, 1, 1], 20)?;
    print_row("two storeys", [1, 1, 2], 10)?;
    print_row("2 x 1 bays, 3 storeys", [2, 1, 3], 2)?;
    print_row("3 x 2 bays, 10 storeys", [3, 2, 10], 1)?;
    print_sketches()
}

/// Sketches: one evaluation of Δ, ten proven frequencies, a response and its part of an evaluation.
fn print_sketches() -> Result<(), Failure> {
    let [e, g, rho, area, i] = STEEL;
    let (ring, braced) =
        (Ring { e, g, rho, area, i }.build()?, Braced { e, g, rho, area, i, loss_factor: 0.01 }.build()?);
    println!("\n| sketch [µs] | Δ | ten proven frequencies | response | response over Δ |\n|---|---|---|---|---|");
    let delta = microseconds(100, || ring.characteristic(black_box(200.0)));
    let response = ring.frequency_response(Ring::conn_a.force_x(), Ring::conn_c.displacement_x())?;
    let response = microseconds(100, || response.at(black_box(200.0)).is_ok());
    let ten = microseconds(10, || ring.first_frequencies::<10>().is_ok());
    println!("| ring on columns | {delta:.1} | {ten:.0} | {response:.0} | {:.1} |", response / delta);
    let at = Complex::new(0.0, 200.0);
    let delta = microseconds(100, || braced.characteristic(black_box(at)));
    let response = braced.frequency_response(Braced::conn_a.force_x(), Braced::conn_c.displacement_x())?;
    let response = microseconds(100, || response.at(black_box(at)).is_ok());
    println!("| braced, with losses | {delta:.1} | | {response:.0} | {:.1} |", response / delta);
    Ok(())
}
