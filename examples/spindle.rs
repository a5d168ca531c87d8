//! A milling spindle: a stepped shaft with shear and rotary inertia on two bearings, which slender beams would make too stiff.

use mstmm::prelude::*;
use mstmm::sections;
use mstmm_drawing::Drawing;
use std::error::Error;

system! {
    /// A spindle on two bearings with a tool at its nose.
    ///
    /// ```text
    ///    rear          front    nose  tool
    ///   ==o==================o=======||###
    ///     /                  /
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Spindle {
        /// Diameter of the shaft between the bearings [m]
        pub diameter: f64,
        /// Diameter of the nose [m]
        pub nose: f64,
        /// Diameter of the bore [m]
        pub bore: f64,
        /// Distance of the bearings [m]
        pub span: f64,
        /// Length of the nose beyond the front bearing [m]
        pub overhang: f64,
        /// Stiffness of the rear bearing [N/m]
        pub rear: f64,
        /// Stiffness of the front bearing [N/m]
        pub front: f64,
        /// Mass of the tool [kg]
        pub tool: f64,
        /// Share of the shear flexibility that counts: 1, or 0 for a slender beam
        pub shear: f64,
    }

    let (area, second_moment, ..) = sections::tube(diameter, bore);
    let (nose_area, nose_second_moment, ..) = sections::tube(nose, bore);
    // steel, and the shear coefficient of a thick tube
    section shaft {
        bending_stiffness: 2.1e11 * second_moment, mass_per_length: 7850.0 * area,
        shear_stiffness: 0.6 * 8.1e10 * area / shear, rotary_inertia: shear * 7850.0 * second_moment,
    }
    section thick {
        bending_stiffness: 2.1e11 * nose_second_moment, mass_per_length: 7850.0 * nose_area,
        shear_stiffness: 0.6 * 8.1e10 * nose_area / shear, rotary_inertia: shear * 7850.0 * nose_second_moment,
    }

    free -> conn rear
        -> beam 1 { length: span, ..shaft } -> conn front
        -> beam 2 { length: overhang, ..thick }
        -> point_mass 3 { mass: tool, inertia: 0.0 } -> free;
    conn rear <- spring 4 { stiffness: rear } <- fixed;
    conn front <- spring 5 { stiffness: front } <- fixed;
}

/// A spindle for heavy milling.
pub fn heavy() -> Spindle {
    Spindle {
        diameter: 0.1,
        nose: 0.16,
        bore: 0.04,
        span: 0.3,
        overhang: 0.12,
        rear: 4e8,
        front: 8e8,
        tool: 3.0,
        shear: 1.0,
    }
}

/// Deflection of the nose under a unit force there [m/N].
pub fn flexibility(spindle: &Spindle) -> Result<f64, Box<dyn Error>> {
    let system = spindle.build()?;
    let nose = Spindle::point_mass_3.output();
    Ok(system.frequency_response(nose.force(), nose.deflection())?.at(0.0)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let spindle = heavy();
    let slender = Spindle { shear: 0.0, ..spindle };
    println!("nose: {:.3} N/µm, of a slender beam {:.3}", 1e-6 / flexibility(&spindle)?, 1e-6 / flexibility(&slender)?);
    println!("\nmode  frequency [Hz]  of a slender beam [Hz]");
    let [roots, stiffer] = [spindle.build()?.first_frequencies::<5>()?, slender.build()?.first_frequencies::<5>()?];
    for (k, (root, other)) in roots.iter().zip(&stiffer).enumerate() {
        println!("{:4}  {:14.3}  {:22.3}", k + 1, root.hertz(), other.hertz());
    }
    draw(&spindle.build()?)
}

/// With `-- --svg FILE`: a picture of the first mode.
fn draw(system: &SpindleSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_frequencies::<1>()?[0])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
