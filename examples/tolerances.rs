//! A lot of portals whose numbers have tolerances: the exact range of each frequency, whether a machine may run, and how far a load may move any of them.
//!
//! `cargo run --example tolerances -- --svg ranges.svg` draws the ranges.

use mstmm::prelude::*;
use mstmm_drawing::ModeDiagram;
use std::error::Error;

system! {
    /// A portal with a machine at a corner.
    ///
    /// ```text
    ///   b o--------o c
    ///     |        |
    ///     |        |
    ///    ###      ###
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Portal {
        /// Axial stiffness [N]
        pub ea: f64,
        /// Bending stiffness [N m²]
        pub ei: f64,
        /// Mass per length [kg/m]
        pub m: f64,
        /// Mass of the machine [kg]
        pub machine: f64,
    }

    section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
    fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0)
        -> beam 3 { ..steel } -> fixed at (4.0, 0.0);
    conn b -> point_mass 4 { mass: machine };
}

/// The portal of a lot, from -1 for the soft and heavy end to 1 for the stiff and light one: 5 % of stiffnesses, 3 % of masses.
pub fn portal(share: f64) -> Portal {
    let (up, down) = (1.0 + 0.05 * share, 1.0 - 0.03 * share);
    Portal { ea: 4e8 * up, ei: 1e6 * up, m: 20.0 * down, machine: 100.0 * down }
}

fn main() -> Result<(), Box<dyn Error>> {
    let lot = ToleranceBox::between(portal(-1.0).build()?, portal(1.0).build()?)?;
    let ranges = lot.first_frequencies::<5>()?;
    println!("number   lowest [Hz]   highest [Hz]");
    for (number, range) in ranges.iter().enumerate() {
        println!("{:6} {:13.4} {:14.4}", number + 1, range.lowest.hertz(), range.highest.hertz());
    }
    for (from, to) in [(10.0, 20.0), (8.0, 12.0)] {
        let is_free = lot.is_free_of(hertz(from)..=hertz(to))?;
        let word = if is_free { "no portal of the lot has" } else { "a portal of the lot may have" };
        println!("{from} to {to} Hz: {word} a frequency there");
    }
    let sway = lot.compliance(Portal::conn_b.force_x())?;
    println!("1 kN moves the corner by {:.4} to {:.4} mm", 1e6 * sway.start(), 1e6 * sway.end());
    if let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) {
        ModeDiagram::ranges(&ranges)?.marked(10.0, 20.0).write(file)?;
    }
    Ok(())
}
