//! What a frame in space costs: a ring of four beams on four columns, clamped, 24 motions, and buildings of it. Prints a Markdown table.
//!
//! `cargo bench --bench space`. Times are the least of some rounds; quote the ratios.

use mstmm::frame::{Frame, Point, Section, Space, Structure};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm::search::System;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

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
    print_row("3 x 2 bays, 10 storeys", [3, 2, 10], 1)
}
