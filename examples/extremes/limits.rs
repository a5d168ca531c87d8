//! Where the certified searches end: each row makes one quantity more extreme, step by step, until fewer than 14 digits are
//! left, a pair is one entry, or the search says that it cannot.

use crate::damped::Oscillator;
use crate::{CANTILEVER, Failure, FixedPinned, Searched, TipMass, TipSpring, Twins, digits};
use core::f64::consts::PI;
use mstmm::element::{ParameterError, Support};
use mstmm::elements::{Mass, Spring};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;
use mstmm::search::SearchError;

/// Digits that count as kept.
const KEPT: f64 = 14.0;

system! {
    /// Beam on two spans with a spring, a mass and a torsion spring, all in any unit of force.
    struct AnyUnit { unit: f64 }
    let (length, bending_stiffness, mass_per_length) = (1.0, unit, unit);
    fixed -> beam 1 { length, bending_stiffness, mass_per_length } -> conn 2
          -> beam 3 { length, bending_stiffness, mass_per_length } -> pinned;
    conn 2 <- hinge 4 { stiffness_y: unit, stiffness_rz: unit } <- fixed;
    conn 2 <- mass 5 { mass: unit } <- free
}

system! {
    /// Two masses of 1 in a row, on a spring of 1 and one of any stiffness.
    struct TwoMasses { stiffness: f64 }
    fixed -> spring 1 { stiffness: 1.0 } -> conn 2 -> spring 3 { stiffness } -> conn 4 -> free;
    conn 2 <- mass 5 { mass: 1.0 } <- free;
    conn 4 <- mass 6 { mass: 1.0 } <- free
}

/// Digits at a value, or what is said instead.
type Outcome = Result<f64, Failure>;

/// One row: the last value that keeps so many digits, those digits, and what comes of the next value.
fn row(case: &str, least: f64, values: impl IntoIterator<Item = f64>, outcome: impl Fn(f64) -> Outcome) {
    let mut last = None;
    for value in values {
        let problem = match outcome(value) {
            Ok(digits) if digits >= least => {
                last = Some((value, digits));
                continue;
            }
            Ok(digits) => format!("{digits:.1} digits"),
            Err(failure) => name(&failure),
        };
        return print_row(case, last, &format!("{value:.1e}: {problem}"));
    }
    print_row(case, last, "none, this is the last one tried");
}

fn print_row(case: &str, last: Option<(f64, f64)>, next: &str) {
    let (value, digits) =
        last.map_or_else(Default::default, |(value, digits)| (format!("{value:.1e}"), format!("{digits:.1}")));
    println!("| {case} | {value} | {digits} | {next} |");
}

/// An error by its type.
fn name(failure: &Failure) -> String {
    if let Some(error) = failure.downcast_ref::<SearchError>() {
        return format!("`SearchError::{}`", error.kind());
    }
    if failure.is::<ParameterError>() { String::from("`ParameterError`") } else { failure.to_string() }
}

/// Powers of ten, or of another base.
fn powers(base: f64, exponents: impl Iterator<Item = i32>) -> impl Iterator<Item = f64> {
    exponents.map(move |exponent| base.powi(exponent))
}

/// The lowest frequency beside the exact one.
fn lowest(system: &impl Searched, exact: f64) -> Outcome {
    Ok(digits(system.first_frequencies::<1>()?[0].omega, exact))
}

/// What is said where two roots are not two entries.
fn together(multiplicity: u64) -> Failure {
    format!("one entry of multiplicity {multiplicity}").into()
}

/// Both frequencies of a range beside the exact ones; an error where they are one entry.
fn pair(system: &impl Searched, range: [f64; 2], exact: [f64; 2]) -> Outcome {
    let found = system.natural_frequencies::<4>(range[0]..=range[1])?;
    match &*found {
        [first, second] => Ok(digits(first.omega, exact[0]).min(digits(second.omega, exact[1]))),
        _ => Err(together(found.iter().map(|root| root.multiplicity).sum())),
    }
}

/// Relative gap of the twins that a spring joins, from the exact frequencies, to first order in the spring.
fn twins(gap: f64) -> Outcome {
    let stiffness = gap * CANTILEVER * CANTILEVER / 4.0;
    let upper = CANTILEVER.mul_add(CANTILEVER, 8.0 * stiffness).sqrt();
    pair(&Twins { stiffness }.build()?, [3.5, 3.6], [CANTILEVER, upper])
}

/// The same pair as minima of `|det U_all|` on 100 points from 1 to 20 rad/s, wherever the upper one lies.
fn twins_as_minima(gap: f64) -> Outcome {
    let system = Twins { stiffness: gap * CANTILEVER * CANTILEVER / 4.0 }.build()?;
    let upper = system.first_frequencies::<2>()?[1].omega;
    let minima = fmin1d::<16, _>(|omega| system.overall_determinant(omega), 1.0..=20.0, 100, 1e-9)?;
    let inside: Vec<f64> = minima.iter().filter(|minimum| !minimum.at_end).map(|minimum| minimum.x).collect();
    match inside.as_slice() {
        [first, second, ..] => Ok(digits(*first, CANTILEVER).min(digits(*second, upper))),
        _ => Err(format!("{} minimum", inside.len()).into()),
    }
}

/// Two masses on springs of their own, which meet at a support: nothing couples them.
fn neighbours(gap: f64) -> Outcome {
    let element = |spring: f64| -> Result<[ListStep<AnyUndamped<f64>>; 2], Failure> {
        let spring = AnyUndamped::try_from(Spring { stiffness: spring })?;
        let mass = AnyUndamped::try_from(Mass { mass: 1.0 })?;
        Ok([ListStep::Element(spring), ListStep::Element(mass)])
    };
    // ω² = 1 and (1 + gap)²; the stiffness is rounded
    let stiffness = (1.0 + gap) * (1.0 + gap);
    let [[first, one], [second, other]] = [element(1.0)?, element(stiffness)?];
    let steps = [
        ListStep::Tip(Support::Free),
        one,
        first,
        ListStep::Tip(Support::Fixed),
        ListStep::Connection(2),
        second,
        other,
        ListStep::Root(Support::Free),
    ];
    pair(&StepList::new(&steps)?, [0.5, 1.5], [1.0, stiffness.sqrt()])
}

/// Two real eigenvalues with a relative gap, just beyond the critical damping 2: at `2 (1 + gap²/8)`.
fn overdamped(gap: f64) -> Outcome {
    let delta = gap * gap / 8.0;
    let found = Oscillator { damping: 2.0 + 2.0 * delta }
        .build()?
        .eigenvalues::<4>(Region { re: -3.0..=0.5, im: -1.0..=1.0 })?;
    let root = (delta * (2.0 + delta)).sqrt();
    let error = |root: &Eigenvalue, exact: f64| -((root.lambda - exact).norm() / exact.abs()).max(1e-16).log10();
    match &*found {
        [first, second] => Ok(error(first, -(1.0 + delta) - root).min(error(second, -(1.0 + delta) + root))),
        _ => Err(together(found.iter().map(|root| root.multiplicity).sum())),
    }
}

/// Both frequencies of two masses, whose squares have the sum `1 + 2 k` and the product k.
fn two_masses(stiffness: f64) -> Outcome {
    let sum = 1.0 + 2.0 * stiffness;
    let upper = (0.5 * (sum + (2.0 * stiffness).hypot(1.0))).sqrt();
    let found = TwoMasses { stiffness }.build()?.first_frequencies::<2>()?;
    match &*found {
        [first, second] => Ok(digits(first.omega, stiffness.sqrt() / upper).min(digits(second.omega, upper))),
        _ => Err(together(found.iter().map(|root| root.multiplicity).sum())),
    }
}

/// The first three frequencies in a unit of force, which do not depend on it.
fn any_unit(unit: f64) -> Outcome {
    let exact = AnyUnit { unit: 1.0 }.build()?.first_frequencies::<3>()?;
    let found = AnyUnit { unit }.build()?.first_frequencies::<3>()?;
    Ok(found.iter().zip(&exact).map(|(root, exact)| digits(root.omega, exact.omega)).fold(16.0, f64::min))
}

/// A mode of the fixed and pinned beam by its βl, `(n + 1/4)π`.
fn mode(number: f64) -> Outcome {
    let omega = ((number + 0.25) * PI).powi(2);
    let share = 0.2 / number;
    let found = FixedPinned {}.build()?.natural_frequencies::<8>(omega * (1.0 - share)..=omega * (1.0 + share))?;
    let root = found.iter().next().ok_or("no frequency in the range")?;
    Ok(digits(root.omega, omega))
}

/// All rows.
pub(crate) fn print() {
    println!("| quantity | last value that holds | digits there | next value tried |");
    println!("|---|---|---|---|");
    row("mode number n of a beam, βl = (n + 1/4)π", KEPT, powers(10.0, 1..17), mode);
    row("gap of twin cantilevers, relative", KEPT, powers(0.5, 30..56), twins);
    row("the same, minima of 100 points", 0.0, powers(0.5, 1..56), twins_as_minima);
    row("gap of two uncoupled oscillators, relative", KEPT, powers(0.5, 4..56), neighbours);
    row("gap of two real eigenvalues, relative", 0.0, powers(0.5, 2..28), overdamped);
    let soft = |k: f64| CANTILEVER.mul_add(CANTILEVER, 4.0 * k).sqrt();
    row("tip spring k l³/EI, soft", KEPT, powers(0.1, 9..300), |stiffness| {
        lowest(&TipSpring { stiffness }.build()?, soft(stiffness))
    });
    row("tip spring k l³/EI, stiff", KEPT, powers(10.0, 12..300), |stiffness| {
        // the first order in 1/k, from the values at 1e9 and 1e12
        lowest(&TipSpring { stiffness }.build()?, 15.418205716980061 - 224.8285 / stiffness)
    });
    row("tip mass / m l, light", KEPT, powers(0.1, 9..300), |mass| {
        lowest(&TipMass { mass }.build()?, CANTILEVER / (4.0 * mass).sqrt().hypot(1.0))
    });
    row("tip mass / m l, heavy", KEPT, powers(10.0, 9..300), |mass| {
        lowest(&TipMass { mass }.build()?, (3.0 / (mass + 33.0 / 140.0)).sqrt())
    });
    row("second of two springs in a row, stiff", KEPT, powers(10.0, 0..300), two_masses);
    row("second of two springs in a row, soft", KEPT, powers(0.1, 0..300), two_masses);
    row("all stiffnesses and masses, large", KEPT, powers(10.0, 0..300), any_unit);
    row("all stiffnesses and masses, small", KEPT, powers(0.1, 0..300), any_unit);
}
