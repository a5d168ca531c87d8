//! A column under load: its critical loads, and how its frequencies fall until it buckles.

use mstmm::prelude::*;
use mstmm::search::critical_loads;
use std::error::Error;

system! {
    /// A column on two pins with a brace in the middle, under a load at its head.
    #[derive(Clone, Copy, Debug)]
    pub struct Column {
        /// Height [m]
        pub height: f64,
        /// Bending stiffness [N m²]
        pub ei: f64,
        /// Mass per length [kg/m]
        pub m: f64,
        /// Stiffness of the brace [N/m]
        pub brace: f64,
        /// The load, positive downwards [N]
        pub load: f64,
    }

    let half = 0.5 * height;

    pinned -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m, axial_force: -load } -> conn middle
        -> beam 2 { length: half, bending_stiffness: ei, mass_per_length: m, axial_force: -load } -> pinned;
    conn middle <- spring 3 { stiffness: brace } <- fixed;
}

/// A steel column of five metres without its brace.
pub fn steel() -> Column {
    Column { height: 5.0, ei: 4.2e6, m: 50.0, brace: 0.0, load: 0.0 }
}

fn main() -> Result<(), Box<dyn Error>> {
    let column = steel();
    println!("brace [MN/m]  critical loads [MN]");
    for brace in [0.0, 1e6, 4e6, 1e7] {
        let loads = critical_loads::<3, _>(0.0..=2e7, |load| Column { brace, load, ..column }.build())?;
        let loads: Vec<String> = loads.iter().map(|load| format!("{:.6}", 1e-6 * load.factor)).collect();
        println!("{:12.3}  {}", 1e-6 * brace, loads.join("  "));
    }
    let critical = critical_loads::<1, _>(0.0..=2e6, |load| Column { load, ..column }.build())?[0].factor;
    let unloaded = column.build()?.first_frequencies::<1>()?[0].omega;
    println!("\nload / critical  frequency [Hz]  square of its share");
    for share in [0.0, 0.25, 0.5, 0.75, 0.99] {
        let root = Column { load: share * critical, ..column }.build()?.first_frequencies::<1>()?[0];
        println!("{share:15.2}  {:14.6}  {:19.9}", root.hertz(), (root.omega / unloaded).powi(2));
    }
    let beyond = Column { load: 1.01 * critical, ..column }.build()?;
    println!("\nbeyond it {} motion grows", beyond.unstable_modes()?);
    if let Err(error) = beyond.first_frequencies::<1>() {
        println!("{error}");
    }
    Ok(())
}
