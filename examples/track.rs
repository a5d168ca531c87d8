//! A rail on ballast under a wheel: its deflection at rest, and waves from the cut-on frequency on.

use mstmm::prelude::*;
use std::error::Error;
use std::f64::consts::TAU;

system! {
    /// A long rail on ballast with a wheel set in the middle.
    #[derive(Clone, Copy, Debug)]
    pub struct Track {
        /// Length to both sides [m]
        pub half: f64,
        /// Bending stiffness of the rail [N m²]
        pub ei: f64,
        /// Mass per length of rail and sleepers [kg/m]
        pub m: f64,
        /// Stiffness of the ballast per length [N/m²]
        pub ballast: f64,
        /// Mass of the wheel set [kg]
        pub wheel: f64,
        /// Stiffness of the contact [N/m]
        pub contact: f64,
    }

    fixed -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m, foundation_stiffness: ballast } -> conn rail
        -> beam 2 { length: half, bending_stiffness: ei, mass_per_length: m, foundation_stiffness: ballast } -> fixed;
    conn rail <- spring 3 { stiffness: contact } <- mass 4 { mass: wheel } <- free;
}

/// A main line with rails of 60 kg/m.
pub fn main_line() -> Track {
    Track { half: 30.0, ei: 6.4e6, m: 350.0, ballast: 1e8, wheel: 600.0, contact: 1.5e9 }
}

/// Deflection of a rail without end under a unit force, `1/(8 EI β³)` with `β⁴ = k/(4 EI)` [m/N].
pub fn winkler(track: &Track) -> f64 {
    let beta = (track.ballast / (4.0 * track.ei)).powf(0.25);
    1.0 / (8.0 * track.ei * beta.powi(3))
}

/// The frequency above which waves travel along the rail [rad/s].
pub fn cut_on(track: &Track) -> f64 {
    (track.ballast / track.m).sqrt()
}

fn main() -> Result<(), Box<dyn Error>> {
    let track = main_line();
    let system = track.build()?;
    let (rail, wheel) = (Track::beam_1.output(), Track::mass_4.input());
    let response = system.frequency_response(rail.force(), rail.deflection())?;
    println!("a wheel of 100 kN presses the rail down by {:.9} mm", 1e8 * response.at(0.0)?);
    println!("Winkler's rail without end goes down by    {:.9} mm", 1e8 * winkler(&track));
    println!(
        "\nwaves travel from {:.3} Hz on; frequencies below it hold the wheel and the rail near it",
        cut_on(&track) / TAU
    );
    for (k, root) in system.first_frequencies::<4>()?.iter().enumerate() {
        let shape = system.mode_shape(root)?;
        let part = shape.state(rail).y / shape.state(wheel).y;
        println!("mode {}: {:9.4} Hz, the rail moves by {part:8.5} of the wheel", k + 1, root.hertz());
    }
    println!("\nfrequency [Hz]  rail under a wheel of 1 N [nm]");
    for frequency in [0.0, 30.0, 60.0, 80.0] {
        println!("{frequency:14.1}  {:9.5}", 1e9 * response.at(hertz(frequency))?);
    }
    Ok(())
}
