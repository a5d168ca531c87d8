//! Cost of Δ by planes, in one run, beside the standard library's sine, cosine and exponential of its beams and beside the
//! plain method, a matrix and its elimination; and the time of a whole certified search. Prints a Markdown table.
//!
//! `cargo bench --bench speed`. Times are the least of many rounds; quote the ratios.

use mstmm::prelude::*;
use mstmm::search::System;
use paper::models;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn core::error::Error>;

/// Rounds of each measurement; the least counts, since other work on the machine only ever adds.
const ROUNDS: usize = 40;

/// Evaluations in a round.
const EVALUATIONS: u32 = 2000;

/// Least time of one call in ns, over rounds of so many calls with arguments spread over [0, 1).
fn nanoseconds(calls: u32, mut call: impl FnMut(f64)) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        for k in 0..calls {
            call(f64::from(k) / f64::from(calls));
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e9 / f64::from(calls)
}

/// Sine, cosine and exponential of `z = factor sqrt(ω)` for each distinct beam, by the standard library.
fn functions(factors: &[f64], omega: f64) -> f64 {
    let root = omega.sqrt();
    factors.iter().map(|factor| factor * root).map(|z| z.sin() + z.cos() + z.exp()).sum()
}

/// A row of the table.
struct Row {
    name: &'static str,
    /// Time of the standard functions [ns]; none for complex frequencies.
    functions: Option<f64>,
    planes: f64,
    matrix: f64,
    roots: usize,
    evaluations: usize,
    search: f64,
}

impl Row {
    fn print(&self) {
        let Row { name, planes, matrix, roots, evaluations, .. } = self;
        let (functions, ratio) = match self.functions {
            Some(functions) => (format!("{functions:.0}"), format!("{:.2}", planes / functions)),
            None => (String::new(), String::new()),
        };
        let (to_matrix, search) = (planes / matrix, self.search / 1e3);
        println!(
            "| {name} | {functions} | {planes:.0} | {matrix:.0} | {ratio} | {to_matrix:.2} | {roots} | {evaluations} | {search:.1} |"
        );
    }
}

/// The row of an undamped example, at frequencies spread over `range`, and its first `WANTED` roots.
fn undamped<Y, const WANTED: usize>(
    name: &'static str,
    system: &Y,
    factors: &[f64],
    range: [f64; 2],
) -> Result<(), Failure>
where
    Y: Evaluate<f64> + Undamped + System<Parameter = f64>,
{
    let omega = |share: f64| black_box(range[0] + share * (range[1] - range[0]));
    let factors = black_box(factors);
    Row {
        name,
        functions: Some(nanoseconds(EVALUATIONS, |share| {
            black_box(functions(factors, omega(share)));
        })),
        planes: nanoseconds(EVALUATIONS, |share| {
            black_box(Characteristic::<f64>::characteristic(system, omega(share)));
        }),
        matrix: nanoseconds(EVALUATIONS, |share| {
            black_box(system.overall_determinant(omega(share)));
        }),
        roots: WANTED,
        evaluations: system.first_frequencies::<WANTED>()?.evaluations(),
        search: nanoseconds(20, |_| {
            let _ = black_box(black_box(system).first_frequencies::<WANTED>());
        }),
    }
    .print();
    Ok(())
}

/// The row of the damped example, in the paper's rectangle.
fn damped() -> Result<(), Failure> {
    let system = models::damped_oscillator().build()?;
    let region = || Region { re: -300.0..=5.0, im: -10.0..=12_000.0 };
    let lambda = |share: f64| black_box(Complex::new(-300.0 * share, 12_000.0 * share));
    let found = system.eigenvalues::<8>(region())?;
    Row {
        name: "4.5",
        functions: None,
        planes: nanoseconds(EVALUATIONS, |share| {
            black_box(system.characteristic(lambda(share)));
        }),
        matrix: nanoseconds(EVALUATIONS, |share| {
            black_box(system.overall_determinant(lambda(share)));
        }),
        roots: found.len(),
        evaluations: found.evaluations(),
        search: nanoseconds(5, |_| {
            let _ = black_box(black_box(&system).eigenvalues::<8>(region()));
        }),
    }
    .print();
    Ok(())
}

fn main() -> Result<(), Failure> {
    println!(
        "| example | sin, cos, exp [ns] | planes [ns] | matrix [ns] | planes / functions | planes / matrix | roots | \
         evaluations | search [µs] |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let wave = |stiffness: f64, mass: f64, length: f64| (mass / stiffness).sqrt().sqrt() * length;
    let (a, b) = (models::light_tip_body(), models::heavy_tip_body());
    let section = [wave(a.bending_stiffness, a.mass_per_length, a.length)];
    undamped::<_, 5>("4.1a", &a.build()?, &section, [1.0, 1700.0])?;
    undamped::<_, 5>("4.1b", &b.build()?, &section, [1.0, 1700.0])?;
    let c = models::restrained_beam();
    undamped::<_, 3>("4.2", &c.build()?, &[wave(c.bending_stiffness, c.mass_per_length, c.length)], [1.0, 3000.0])?;
    let d = models::spring_and_mass();
    let lengths = [d.spring_position, d.mass_position - d.spring_position, d.length - d.mass_position];
    let beams = lengths.map(|length| wave(d.bending_stiffness, d.mass_per_length, length));
    undamped::<_, 3>("4.3", &d.build()?, &beams, [1.0, 2000.0])?;
    let e = models::two_spans();
    let lengths = [e.support_position, e.spring_position - e.support_position, e.length - e.spring_position];
    let beams = lengths.map(|length| wave(e.bending_stiffness, e.mass_per_length, length));
    undamped::<_, 5>("4.4", &e.build()?, &beams, [1.0, 20_000.0])?;
    damped()
}
