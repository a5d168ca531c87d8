//! Digits kept at the extremes: the overall determinant against the certified frequencies.
//!
//! `cargo run --release --example extremes` prints a Markdown table. For each exact value it shows the correct decimal
//! digits of two results: a bisection on the sign of `overall_determinant`, helped by a bracket around the exact value
//! that holds no other root, and `natural_frequencies` on a range that holds the same bracket. Sixteen digits are all that
//! a double has; `-` means that the determinant has the same sign at both ends of the bracket, or is not finite there.

use core::f64::consts::PI;
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;
use mstmm::search::System;

mod damped;
mod limits;

type Failure = Box<dyn std::error::Error>;

/// An undamped system.
trait Searched: Undamped + System<Parameter = f64> {}
impl<Y: Undamped + System<Parameter = f64>> Searched for Y {}

system! {
    /// Fixed and pinned beam with EI = m = l = 1.
    struct FixedPinned {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned
}

system! {
    /// Cantilever of any size.
    struct Cantilever { length: f64, bending_stiffness: f64, mass_per_length: f64 }
    fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> free
}

system! {
    /// Cantilever with EI = m = l = 1 and a grounded tip spring.
    struct TipSpring { stiffness: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> free;
    fixed -> spring 3 { stiffness } -> conn 2
}

system! {
    /// Cantilever with EI = m = l = 1 and a tip mass.
    struct TipMass { mass: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> free;
    free -> mass 3 { mass } -> conn 2
}

system! {
    /// Two cantilevers with EI = m = l = 1 whose tips are joined by a spring.
    struct Twins { stiffness: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
          -> spring 3 { stiffness } -> conn 4 -> free;
    fixed -> beam 5 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 4
}

system! {
    /// Ten spans with EI = m = l = 1, pinned at every joint.
    struct TenSpans {}
    let (length, bending_stiffness, mass_per_length) = (1.0, 1.0, 1.0);
    pinned -> beam 1 { length, bending_stiffness, mass_per_length } -> conn a
           -> beam 2 { length, bending_stiffness, mass_per_length } -> conn b
           -> beam 3 { length, bending_stiffness, mass_per_length } -> conn c
           -> beam 4 { length, bending_stiffness, mass_per_length } -> conn d
           -> beam 5 { length, bending_stiffness, mass_per_length } -> conn e
           -> beam 6 { length, bending_stiffness, mass_per_length } -> conn f
           -> beam 7 { length, bending_stiffness, mass_per_length } -> conn g
           -> beam 8 { length, bending_stiffness, mass_per_length } -> conn h
           -> beam 9 { length, bending_stiffness, mass_per_length } -> conn i
           -> beam 10 { length, bending_stiffness, mass_per_length } -> pinned;
    pinned -> conn a; pinned -> conn b; pinned -> conn c; pinned -> conn d; pinned -> conn e;
    pinned -> conn f; pinned -> conn g; pinned -> conn h; pinned -> conn i
}

/// An exact frequency and a bracket around it, `exact · (1 ± bracket)`.
#[derive(Clone, Copy)]
struct Exact {
    omega: f64,
    bracket: f64,
}

/// Correct decimal digits of a frequency, 16 at most.
fn digits(omega: f64, exact: f64) -> f64 {
    let error = (omega - exact).abs() / exact;
    -error.max(1e-16).log10()
}

/// Digits of a bisection on the sign of the overall determinant.
fn by_determinant(system: &impl Evaluate<f64>, exact: Exact) -> Option<f64> {
    let sign = |omega| system.overall_determinant(omega).mantissa();
    let (mut lower, mut upper) = (exact.omega * (1.0 - exact.bracket), exact.omega * (1.0 + exact.bracket));
    let (start, end) = (sign(lower), sign(upper));
    if !((start < 0.0 && end > 0.0) || (start > 0.0 && end < 0.0)) {
        return None;
    }
    loop {
        let middle = lower + (upper - lower) / 2.0;
        if middle <= lower || middle >= upper {
            return Some(digits(middle, exact.omega));
        }
        let value = sign(middle);
        if value.is_nan() {
            return None;
        }
        if (value > 0.0) == (start > 0.0) { lower = middle } else { upper = middle }
    }
}

/// Digits of the certified frequency that is nearest, and its multiplicity and evaluations.
fn certified(system: &impl Searched, exact: Exact) -> Result<(f64, u64, usize), Failure> {
    let range = exact.omega * (1.0 - exact.bracket)..=exact.omega * (1.0 + exact.bracket);
    let found = system.natural_frequencies::<8>(range)?;
    let error = |root: &&NaturalFrequency| (root.omega - exact.omega).abs();
    let nearest = found.iter().min_by(|a, b| error(a).total_cmp(&error(b))).ok_or("no frequency in the range")?;
    Ok((digits(nearest.omega, exact.omega), nearest.multiplicity, found.evaluations()))
}

/// One line of the table.
fn row(case: &str, digits_of_determinant: Option<f64>, exact: Exact, system: &impl Searched) -> Result<(), Failure> {
    let (digits, multiplicity, evaluations) = certified(system, exact)?;
    let determinant = digits_of_determinant.map_or("-".to_owned(), |digits| format!("{digits:.1}"));
    let several = if multiplicity > 1 { format!(" ({multiplicity} together)") } else { String::new() };
    println!("| {case} | {:.6e} | {determinant} | {digits:.1}{several} | {evaluations} |", exact.omega);
    Ok(())
}

/// A line for a system that has both.
fn compare<Y: Searched + Evaluate<f64>>(case: &str, system: &Y, exact: Exact) -> Result<(), Failure> {
    row(case, by_determinant(system, exact), exact, system)
}

/// Modes of a beam. tan z = tanh z: `z = (n + 1/4)π` but for `e^(-2z)`, which is below an eps from mode 6 on.
fn mode_numbers() -> Result<(), Failure> {
    let system = FixedPinned {}.build()?;
    let exact = |n: f64| match n {
        1.0 => 15.418205716980061,
        3.0 => 104.24769645886133,
        _ => ((n + 0.25) * PI).powi(2),
    };
    for n in [1.0, 3.0, 6.0, 10.0, 12.0, 30.0, 100.0, 1000.0, 3183.0] {
        let case = format!("fixed-pinned beam, mode {n}, βl = {:.0}", (n + 0.25) * PI);
        compare(&case, &system, Exact { omega: exact(n), bracket: 0.2 / n })?;
    }
    Ok(())
}

/// First frequency of the cantilever, in units of `sqrt(EI/m)/l²`.
const CANTILEVER: f64 = 3.5160152685001513;

/// Tip spring: exact values of another method, for soft springs the first order in k of `ω² + 4k`.
fn stiffness_factors() -> Result<(), Failure> {
    let soft = |k: f64| (CANTILEVER * CANTILEVER + 4.0 * k).sqrt();
    let values = [
        (1e-15, soft(1e-15)),
        (1e-12, soft(1e-12)),
        (1e-9, soft(1e-9)),
        (1e3, 15.19285111681764),
        (1e6, 15.417980888703429),
        (1e9, 15.418205492152488),
        (1e12, 15.418205716755233),
        (1e15, 15.418205716979836),
    ];
    for (stiffness, omega) in values {
        let case = format!("tip spring k = {stiffness:e}");
        compare(&case, &TipSpring { stiffness }.build()?, Exact { omega, bracket: 0.1 })?;
    }
    Ok(())
}

/// Tip mass: exact values of another method, for a light mass the first order in its mass of `ω² / (1 + 4 mass)`.
fn mass_factors() -> Result<(), Failure> {
    let values = [
        (1e-9, CANTILEVER / 4e-9_f64.sqrt().hypot(1.0)),
        (1e-6, 3.5160082364898418),
        (1.0, 1.5572978611989208),
        (1e3, 0.054765801546044754),
        (1e6, 0.0017320506034343526),
        (1e9, 5.477225574406131e-05),
    ];
    for (mass, omega) in values {
        compare(&format!("tip mass {mass:e}"), &TipMass { mass }.build()?, Exact { omega, bracket: 0.1 })?;
    }
    Ok(())
}

/// The same cantilever at three scales: frequencies in units of `sqrt(EI/m)/l²`.
fn scales() -> Result<(), Failure> {
    let sizes = [("micrometre", 1e-6, 1.4e-17, 2.3e-11), ("metre", 1.0, 1.7e2, 0.2), ("kilometre", 1e3, 2.1e13, 9.4e5)];
    for (name, length, bending_stiffness, mass_per_length) in sizes {
        let system = Cantilever { length, bending_stiffness, mass_per_length }.build()?;
        let unit = f64::sqrt(bending_stiffness / mass_per_length) / (length * length);
        for (mode, value) in [(1, CANTILEVER), (5, 199.85953011680346)] {
            let exact = Exact { omega: value * unit, bracket: 0.1 };
            compare(&format!("cantilever of a {name}, mode {mode}"), &system, exact)?;
        }
    }
    Ok(())
}

/// Chains pinned at every joint: each span vibrates as one or two half-waves.
fn chains() -> Result<(), Failure> {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let span = ListStep::Element(AnyUndamped::try_from(beam)?);
    for spans in [10, 100, 1000] {
        let mut steps = vec![ListStep::Tip(Support::Pinned), span];
        for _ in 1..spans {
            steps.extend([ListStep::Tip(Support::Pinned), ListStep::Connection(2), span]);
        }
        steps.push(ListStep::Root(Support::Pinned));
        let list = StepList::new(&steps)?;
        for (mode, waves) in [(1, 1.0), (spans + 1, 2.0)] {
            // the next mode is farther by this share
            let exact = Exact { omega: (waves * PI).powi(2), bracket: 0.3 / f64::from(spans).powi(2) };
            let determinant = if spans == 10 { by_determinant(&TenSpans {}.build()?, exact) } else { None };
            row(&format!("{spans} spans, mode {mode}"), determinant, exact, &list)?;
        }
    }
    Ok(())
}

/// The upper root of close pairs: a cantilever with a grounded tip spring of 2k, the first order in k of `ω² + 8k`.
fn gaps() -> Result<(), Failure> {
    for exponent in [2, 4, 6, 8, 10, 12] {
        let stiffness = 10f64.powi(-exponent);
        let omega = match exponent {
            2 => 3.527371172120349,
            4 => 3.5161290315811593,
            6 => 3.5160164061514316,
            _ => (CANTILEVER * CANTILEVER + 8.0 * stiffness).sqrt(),
        };
        let gap = (omega - CANTILEVER) / omega;
        let case = format!("twin cantilevers, gap {gap:.0e}");
        compare(&case, &Twins { stiffness }.build()?, Exact { omega, bracket: (0.5 * gap).max(1e-15) })?;
    }
    Ok(())
}

fn main() -> Result<(), Failure> {
    println!("| case | exact ω [rad/s] | digits, determinant | digits, certified | evaluations |");
    println!("|---|---|---|---|---|");
    mode_numbers()?;
    stiffness_factors()?;
    mass_factors()?;
    scales()?;
    chains()?;
    gaps()?;
    println!();
    limits::print();
    println!();
    damped::print()
}
