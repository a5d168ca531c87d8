//! Cantilever with a tip body: frequencies, shapes, nodes, energies, and what moves the first frequency.

use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;

system! {
    /// Cantilever with an eccentric tip body (section 4.1 of the paper).
    #[derive(Clone, Copy, Debug)]
    pub struct TipBody {
        /// Length of the beam [m]
        pub length: f64,
        /// Bending stiffness of the beam [N m²]
        pub ei: f64,
        /// Mass per length of the beam [kg/m]
        pub m: f64,
        /// Mass of the body [kg]
        pub mass: f64,
        /// Moment of inertia of the body about its mass centre [kg m²]
        pub inertia: f64,
        /// From the end of the beam to the mass centre of the body [m]
        pub centre: f64,
        /// From the end of the beam to the far end of the body [m]
        pub depth: f64,
    }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m }
          -> body 2 { mass, inertia, output_x: depth, centre_x: centre }
          -> free;
}

/// The paper's first set of parameters: a body as heavy as the beam.
pub fn light_body() -> TipBody {
    let (m, ei) = (0.212058, 33.8703);
    TipBody { length: 1.0, ei, m, mass: m, inertia: m, centre: 0.4, depth: 0.8 }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = light_body();
    let system = model.build()?;
    let roots = system.first_frequencies::<4>()?;

    println!("Natural frequencies; ω lies in the certified interval, and none is left out");
    println!("mode    f [Hz]         ω [rad/s]                          interval [rad/s]");
    for (mode, root) in roots.iter().enumerate() {
        let (hertz, omega) = (root.hertz(), root.omega);
        println!("{:4} {hertz:9.4} {omega:17.10} {:20.13} ..{:20.13}", mode + 1, root.lower, root.upper);
    }

    println!("\nDeflections at parts of the length of the beam, the largest one of the mode is 1");
    println!("mode       0.25       0.50       0.75       1.00   body's end   nodes in the beam");
    for (mode, root) in roots.iter().enumerate() {
        let shape = system.mode_shape(root)?.with_unit_deflection().ok_or("nothing deflects")?;
        print!("{:4}", mode + 1);
        for part in [0.25, 0.5, 0.75, 1.0] {
            print!(" {:10.6}", shape.along(TipBody::beam_1, part * model.length)?.y);
        }
        let end = shape.state(TipBody::body_2.output()).y;
        println!("   {end:10.6} {:19}", shape.nodes(TipBody::beam_1));
    }

    println!("\nShares in the energies of the mode [%]");
    println!("mode   strain: beam   kinetic: beam      body");
    for (mode, root) in roots.iter().enumerate() {
        let shape = system.mode_shape(root)?;
        let (beam, body) = (shape.energy_shares(TipBody::beam_1), shape.energy_shares(TipBody::body_2));
        let [strain, of_beam, of_body] = [beam.strain, beam.kinetic, body.kinetic].map(|share| 100.0 * share);
        println!("{:4} {strain:14.3} {of_beam:15.3} {of_body:9.3}", mode + 1);
    }

    println!("\nWhat the first frequency gains where a field grows");
    let units = ["m", "N m²", "kg/m", "kg", "kg m²", "m", "m"];
    for ((field, slope), unit) in system.sensitivity(&roots[0])?.iter().zip(units) {
        println!("{field:8} {slope:12.6} rad/s per {unit}");
    }
    draw(&system)
}

/// With `-- --svg FILE`: a picture of the second mode.
fn draw(system: &TipBodySystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_frequencies::<2>()?[1])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
