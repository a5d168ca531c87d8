//! The radius that an eigenvalue is reported with, beside its true error.

use crate::{CANTILEVER, Cantilever, Failure};
use mstmm::prelude::*;

system! {
    /// A mass of 1 on a spring of 1 with a dashpot beside it.
    pub(crate) struct Oscillator { pub(crate) damping: f64 }
    fixed -> spring 1 { stiffness: 1.0, damping } -> mass 2 { mass: 1.0 } -> free
}

system! {
    /// Pinned beam with a grounded dashpot at mid-span (`damped_beam` of tests/data/validation.json).
    struct DampedBeam { bending_stiffness: f64 }
    let (length, mass_per_length) = (0.5, 0.674);
    pinned -> beam 1 { length, bending_stiffness, mass_per_length } -> conn 2
           -> beam 3 { length, bending_stiffness, mass_per_length } -> pinned;
    fixed -> damper 4 { damping: 5.0 } -> conn 2
}

/// A row: the eigenvalue that is nearest to the exact one.
fn row(case: &str, found: &[Eigenvalue], exact: Complex<f64>) -> Result<(), Failure> {
    let distance = |root: &Eigenvalue| (root.lambda - exact).norm();
    let nearest = found.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).ok_or("no eigenvalue")?;
    let [truth, radius] = [distance(nearest), nearest.error].map(|error| error / exact.norm());
    let is_inside = if truth <= radius { "yes" } else { "no" };
    println!("| {case} | {} | {truth:.1e} | {radius:.1e} | {is_inside} |", nearest.multiplicity);
    Ok(())
}

/// All rows.
pub(crate) fn print() -> Result<(), Failure> {
    println!("| case | multiplicity | true error / modulus | radius / modulus | holds it |");
    println!("|---|---|---|---|---|");
    for damping in [0.0_f64, 1e-9, 0.02, 1.0, 1.999_999_9, 2.0, 2.000_000_1, 4.0, 1e3] {
        let half: f64 = 0.5 * damping;
        let exact = match (1.0 - half) * (1.0 + half) {
            below if below >= 0.0 => Complex::new(-half, below.sqrt()),
            beyond => Complex::new(-1.0 / (half + (-beyond).sqrt()), 0.0),
        };
        let found = Oscillator { damping }.build()?.first_eigenvalues::<1>()?;
        row(&format!("oscillator, damping ratio {half}"), &found, exact)?;
    }
    let beam = DampedBeam { bending_stiffness: 7e10 * 0.05 * 0.005_f64.powi(3) / 12.0 }.build()?;
    let found = beam.eigenvalues::<8>(Region { re: -20.0..=1.0, im: 1.0..=5000.0 })?;
    let values = [
        (1, -7.422_980_115_254_971, 72.230_652_796_046_34),
        (2, 0.0, 290.354_254_541_445_7),
        (5, -7.417_578_504_359_549, 1_814.602_572_455_042_5),
        (8, 0.0, 4_645.668_072_663_131),
    ];
    for (mode, re, im) in values {
        row(&format!("beam with a dashpot, mode {mode}"), &found, Complex::new(re, im))?;
    }
    let beam = Cantilever { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }.build()?;
    let found = beam.first_eigenvalues::<1>()?;
    row("cantilever without damping, mode 1", &found, Complex::new(0.0, CANTILEVER))
}
