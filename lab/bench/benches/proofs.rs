//! What proofs add to searches, in one run: the time of estimates, and that of the proven search in times of it, on each instruction set.
//! Prints a Markdown table.
//!
//! `cargo bench --bench proofs`. Times are the least of many rounds; quote the ratios.

use mstmm::network::{Member, Network, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;
use mstmm::search::System;
use mstmm_lanes::InstructionSet;
use paper::models;
use std::hint::black_box;
use std::time::Instant;
use subjects::frames::{Plain, Workshop};

pub mod subjects;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement; the least counts, since other work on the machine only ever adds.
const ROUNDS: usize = 60;

/// Least time of one call over rounds of `calls` calls [µs].
fn least<R>(calls: u32, mut call: impl FnMut() -> R) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e6 / f64::from(calls)
}

/// A row: estimates, proven search and runs of the proof, on each instruction set.
fn row<Y, const WANTED: usize>(name: &str, system: &Y) -> Result<(), Failure>
where
    Y: Undamped + System<Parameter = f64> + ?Sized,
{
    let [runs, long_runs] = system.first_frequencies::<WANTED>()?.proof_runs();
    print!("| {name} | {WANTED} | {runs} + {long_runs} |");
    for set in InstructionSet::ALL.into_iter().filter(|set| *set <= InstructionSet::widest()) {
        set.limit();
        let calls = if runs > 60 { 2 } else { 20 };
        let estimates = least(calls, || black_box(system).estimates::<WANTED>());
        let proven = least(calls, || black_box(system).first_frequencies::<WANTED>());
        print!(" {estimates:.1} | {proven:.1} | {:.1} |", proven / estimates);
    }
    InstructionSet::widest().limit();
    println!();
    Ok(())
}

/// The nodes and the members of a building.
fn building(storeys: usize, bays: usize) -> (Vec<Node<f64>>, Vec<Member<UndampedMember<f64>>>) {
    let section = Section { axial_stiffness: 1.26e9, bending_stiffness: 5.25e6, mass_per_length: 47.1 };
    let place = |storey: usize, column: usize| storey * (bays + 1) + column;
    let (mut nodes, mut members) = (Vec::new(), Vec::new());
    for storey in 0..=storeys {
        for column in 0..=bays {
            let node = Node::at([6.0 * column as f64, 4.0 * storey as f64]);
            nodes.push(if storey == 0 { node.held(Support::Fixed.holds()) } else { node });
            if storey > 0 {
                members.push(Member::new(place(storey - 1, column), place(storey, column), section));
            }
            if storey > 0 && column > 0 {
                members.push(Member::new(place(storey, column - 1), place(storey, column), section));
            }
        }
    }
    (nodes, members)
}

fn main() -> Result<(), Failure> {
    print!("| scene | roots | runs in two words + four |");
    for set in InstructionSet::ALL.into_iter().filter(|set| *set <= InstructionSet::widest()) {
        print!(" {set:?}: estimates [µs] | proven [µs] | ratio |");
    }
    println!("\n|---|---|---|{}", "---|".repeat(3 * (1 + InstructionSet::widest() as usize)));
    row::<_, 5>("4.1a", &models::light_tip_body().build()?)?;
    row::<_, 5>("4.1b", &models::heavy_tip_body().build()?)?;
    row::<_, 3>("4.2", &models::restrained_beam().build()?)?;
    row::<_, 3>("4.3", &models::spring_and_mass().build()?)?;
    row::<_, 5>("4.4", &models::two_spans().build()?)?;
    row::<_, 10>("portal", &Plain { ea: 1.26e9, ei: 5.25e6, m: 47.1 }.build()?)?;
    let workshop = Workshop { ea: 4e8, ei: 1e6, m: 20.0, brace: 2e6, machine: 500.0 };
    row::<_, 10>("portal with brace and machine", &workshop.build()?)?;
    let (nodes, members) = building(10, 3);
    row::<_, 10>("building, 10 storeys of 3 bays", &Network::new(&nodes, &members)?)
}
