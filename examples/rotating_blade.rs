//! A rotating blade: frequencies of flapping that rise with the speed, and the speeds at which they meet multiples of it.

use mstmm::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;

system! {
    /// A tapered blade on a hub.
    ///
    /// ```text
    ///   Ω |     radius  ____
    ///   --|--------====|____----____   flaps up and down
    ///     |
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Blade {
        /// Length [m]
        pub length: f64,
        /// Bending stiffness at the root [N m²]
        pub ei: f64,
        /// Mass per length at the root [kg/m]
        pub m: f64,
        /// Taper of the width: 0 is constant, 0.5 halves it
        pub width: f64,
        /// Taper of the height
        pub height: f64,
        /// Radius of the hub [m]
        pub radius: f64,
        /// Speed of rotation [rad/s]
        pub speed: f64,
    }

    fixed -> tapered_beam 1 {
        length, bending_stiffness: ei, mass_per_length: m, width_taper: width, height_taper: height, rotation_speed: speed,
        hub_radius: radius
    } -> free
}

/// A blade of a small wind turbine.
pub fn small() -> Blade {
    Blade { length: 5.0, ei: 2e5, m: 12.0, width: 0.5, height: 0.6, radius: 0.3, speed: 0.0 }
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("speed [1/min]  first [Hz]  second [Hz]  third [Hz]  first per turn");
    for per_minute in [0.0, 60.0, 120.0, 180.0, 240.0] {
        let speed = per_minute / 60.0 * TAU;
        let blade = Blade { speed, ..small() }.build()?;
        let roots = blade.first_frequencies::<3>()?;
        let [first, second, third] = [0, 1, 2].map(|k| roots[k].hertz());
        let per_turn = if per_minute > 0.0 { first / (per_minute / 60.0) } else { f64::INFINITY };
        println!("{per_minute:13.0}  {first:10.5}  {second:11.5}  {third:10.5}  {per_turn:14.4}");
    }
    // Southwell: ω² = ω₀² + aΩ², nearly
    let [rest, turning] = [0.0, 10.0].map(|speed| Blade { speed, ..small() }.build());
    let [rest, turning] = [rest?.first_frequencies::<1>()?[0].omega, turning?.first_frequencies::<1>()?[0].omega];
    println!("\nSouthwell's coefficient of the first mode: {:.6}", (turning * turning - rest * rest) / 100.0);
    Ok(())
}
