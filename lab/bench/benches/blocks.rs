//! Time of Δ, of the count and of a response per frequency, alone and in blocks, on every instruction set of the machine, in one
//! run. Prints a Markdown table.
//!
//! `cargo bench --bench blocks`. Times are the least of many rounds; quote the ratios.

use mstmm::motion::{ExtendedTree, Point};
use mstmm::number::{Oscillation, Scaled};
use mstmm::prelude::*;
use mstmm::search::{InBlocks, System};
use mstmm_lanes::InstructionSet;
use paper::models;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement; the least counts, since other work on the machine only ever adds.
const ROUNDS: usize = 40;

/// Frequencies in a round.
const FREQUENCIES: usize = 2048;

/// Time of a round per frequency in ns.
fn nanoseconds(mut round: impl FnMut()) -> f64 {
    let start = Instant::now();
    round();
    start.elapsed().as_secs_f64() * 1e9 / FREQUENCIES as f64
}

/// The instruction sets of this machine.
fn sets() -> impl Iterator<Item = InstructionSet> {
    InstructionSet::ALL.into_iter().filter(|set| *set <= InstructionSet::widest())
}

/// A line of the table: the time alone, and in blocks on each instruction set with its ratio. Rounds of all take turns, so that
/// other work on the machine meets all alike.
fn print(name: &str, mut alone: impl FnMut(), mut together: impl FnMut()) {
    let mut least = vec![f64::INFINITY; 1 + sets().count()];
    for _ in 0..ROUNDS {
        least[0] = least[0].min(nanoseconds(&mut alone));
        for (set, least) in sets().zip(&mut least[1..]) {
            set.limit();
            *least = least.min(nanoseconds(&mut together));
        }
    }
    let mut line = format!("| {name} | {:.1} |", least[0]);
    for block in &least[1..] {
        line += &format!(" {block:.1} | {:.1} |", least[0] / block);
    }
    println!("{line}");
}

/// Δ of a system, at shares of a range of frequencies.
fn values<Y, S>(name: &str, system: &Y, at: impl Fn(f64) -> S) -> Result<(), Failure>
where
    S: mstmm::number::Frequency<f64> + mstmm::number::InLanes,
    Y: InBlocks<S> + System<Parameter = f64>,
{
    let frequencies: Vec<S> = (1..=FREQUENCIES).map(|k| at(k as f64 / FREQUENCIES as f64)).collect();
    let (mut some, mut same) = ([Scaled::new(S::zero(), 0); FREQUENCIES], [Scaled::new(S::zero(), 0); FREQUENCIES]);
    print(
        name,
        || {
            for (value, &x) in some.iter_mut().zip(black_box(&frequencies)) {
                *value = Characteristic::<S>::characteristic(black_box(system), x);
            }
        },
        || {
            let _ = black_box(system.characteristics(black_box(&frequencies), &mut same));
        },
    );
    if some != same {
        return Err(format!("{name}: values in blocks are not those alone").into());
    }
    Ok(())
}

/// The count of an undamped system.
fn counts<Y: Undamped + System<Parameter = f64>>(name: &str, system: &Y, end: f64) -> Result<(), Failure> {
    let frequencies: Vec<f64> = (1..=FREQUENCIES).map(|k| end * k as f64 / FREQUENCIES as f64).collect();
    let (mut some, mut same) = ([Ok(0); FREQUENCIES], [Ok(0); FREQUENCIES]);
    print(
        name,
        || {
            for (count, &omega) in some.iter_mut().zip(black_box(&frequencies)) {
                *count = black_box(system).count_below(omega);
            }
        },
        || {
            let _ = black_box(system.counts_below(black_box(&frequencies), &mut same));
        },
    );
    if some != same {
        return Err(format!("{name}: counts in blocks are not those alone").into());
    }
    Ok(())
}

/// The response at a point to a force there, of a system, at shares of a range of frequencies.
fn responses<Y, S>(name: &str, system: &Y, point: Point<Y::Model>, at: impl Fn(f64) -> S) -> Result<(), Failure>
where
    Y: ExtendedTree<S> + System<Parameter = f64>,
    S: Oscillation<f64>,
{
    let frequencies: Vec<S> = (1..=FREQUENCIES).map(|k| at((k as f64 - 0.3) / FREQUENCIES as f64)).collect();
    let response = system.frequency_response(point.force(), point.deflection())?;
    let (mut some, mut same) = ([S::zero(); FREQUENCIES], [S::zero(); FREQUENCIES]);
    print(
        name,
        || {
            for (value, &x) in some.iter_mut().zip(black_box(&frequencies)) {
                *value = black_box(&response).at(x).unwrap_or_default();
            }
        },
        || {
            let _ = black_box(black_box(&response).on(black_box(&frequencies), &mut same));
        },
    );
    if some != same {
        return Err(format!("{name}: responses in blocks are not those alone").into());
    }
    Ok(())
}

fn main() -> Result<(), Failure> {
    print!("| | alone [ns] |");
    sets().for_each(|set| print!(" {set:?} [ns] | ratio |"));
    print!("\n|---|---|");
    sets().for_each(|_| print!("---|---|"));
    println!();
    let (a, b) = (models::light_tip_body().build()?, models::restrained_beam().build()?);
    let (c, d) = (models::spring_and_mass().build()?, models::two_spans().build()?);
    let e = models::damped_oscillator().build()?;
    values("4.1a, Δ", &a, |share| 1700.0 * share)?;
    values("4.2, Δ", &b, |share| 3000.0 * share)?;
    values("4.3, Δ", &c, |share| 2000.0 * share)?;
    values("4.4, Δ", &d, |share| 20_000.0 * share)?;
    values("4.5, Δ", &e, |share| Complex::new(-300.0 * share, 12_000.0 * share))?;
    values("4.1a, Δ and Δ'", &a, |share| mstmm::number::Dual::variable(1700.0 * share))?;
    values("4.5, Δ and Δ'", &e, |share| {
        mstmm::number::Dual::variable(Complex::new(-300.0 * share, 12_000.0 * share))
    })?;
    counts("4.1a, count", &a, 1700.0)?;
    counts("4.2, count", &b, 3000.0)?;
    counts("4.3, count", &c, 2000.0)?;
    counts("4.4, count", &d, 20_000.0)?;
    responses("4.1a, response", &a, models::TipBody::body_2.output(), |share| 1700.0 * share)?;
    responses("4.2, response", &b, models::RestrainedBeam::conn_4, |share| 3000.0 * share)?;
    responses("4.3, response", &c, models::SpringAndMass::conn_5, |share| 2000.0 * share)?;
    responses("4.4, response", &d, models::TwoSpans::conn_4, |share| 20_000.0 * share)?;
    responses("4.5, response", &e, models::DampedOscillator::conn_5, |share| Complex::new(0.0, 12_000.0 * share))
}
