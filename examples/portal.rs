//! Portal frame with a hinge, a brace and a machine: certified frequencies, where the machine should stand, how the frame moves, what
//! holds it, and what each field of the model does.

use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;

system! {
    /// Portal frame with a hinge in a corner, a braced foot and a machine on its girder.
    #[derive(Clone, Copy, Debug)]
    pub struct Portal {
        /// Height of the columns [m]
        pub height: f64,
        /// Distance of the columns [m]
        pub span: f64,
        /// Where the machine stands on the girder, from the first column on [m]
        pub machine_x: f64,
        /// Axial stiffness of all beams [N]
        pub ea: f64,
        /// Bending stiffness of all beams [N m²]
        pub ei: f64,
        /// Mass per length of all beams [kg/m]
        pub m: f64,
        /// Stiffness of the brace [N/m]
        pub brace: f64,
        /// Mass of the machine [kg]
        pub machine: f64,
        /// Moment of inertia of the machine about its mass centre [kg m²]
        pub inertia: f64,
    }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn girder at (machine_x, height)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
        -> pin 4 {}
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn foot at (span, 0.0)
        <- pinned;
    conn girder -> rigid_body 6 { mass: machine, inertia, centre: (machine_x, height + 0.4) };
    conn b -> spring 7 { stiffness: brace } -> conn foot;
}

/// A portal of steel, three metres high and four wide.
pub fn steel() -> Portal {
    Portal {
        height: 3.0,
        span: 4.0,
        machine_x: 2.0,
        ea: 4e8,
        ei: 1e6,
        m: 20.0,
        brace: 2e6,
        machine: 500.0,
        inertia: 40.0,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let portal = steel();
    let system = portal.build()?;

    println!("Natural frequencies; ω lies in the certified interval, and none is left out");
    println!("mode    f [Hz]         ω [rad/s]                          interval [rad/s]");
    for (mode, root) in system.first_frequencies::<6>()?.iter().enumerate() {
        let (hertz, omega) = (root.hertz(), root.omega);
        println!("{:4} {hertz:9.4} {omega:17.10} {:20.13} ..{:20.13}", mode + 1, root.lower, root.upper);
    }

    println!("\nThe machine runs at 25 Hz: frequencies below, and the two beside it, by its place on the girder");
    println!("x [m]   below   next below [Hz]   next above [Hz]");
    let speed = hertz(25.0);
    for quarter in 1..16 {
        let machine_x = 0.25 * f64::from(quarter);
        let system = Portal { machine_x, ..portal }.build()?;
        let below = system.count_below(speed)?;
        let roots = system.first_frequencies::<12>()?;
        let hertz = |before: bool| {
            let mut all = roots.iter().map(|root| root.hertz()).filter(|hertz| (*hertz < 25.0) == before);
            if before { all.next_back() } else { all.next() }
        };
        let [under, over] =
            [true, false].map(|before| hertz(before).map_or("none".into(), |hertz| format!("{hertz:.4}")));
        println!("{machine_x:5} {below:7} {under:>17} {over:>17}");
    }
    show_shape(&system)?;
    show_response(&system)?;
    show_sensitivities(&system)?;
    draw(&system)
}

/// The first mode with the largest sway of 1 m: displacements of points, and moments in the members.
fn show_shape(system: &PortalSystem) -> Result<(), Box<dyn Error>> {
    let first = system.first_frequencies::<1>()?[0];
    let shape = system.mode_shape(&first)?;
    let sway = shape.value(Portal::conn_b.displacement_x())?;
    println!("\nFirst mode, {:.4} Hz, with a sway of 1 m of the first corner", first.hertz());
    println!("point     x [m]      y [m]      rotation [rad]");
    for (name, point) in [("b", Portal::conn_b), ("girder", Portal::conn_girder), ("c", Portal::conn_c)] {
        let [x, y] = [shape.value(point.displacement_x())? / sway, shape.value(point.displacement_y())? / sway];
        println!("{name:6} {x:10.6} {y:10.6} {:10.6}", shape.value(point.rotation_z())? / sway);
    }
    println!("moment at the foot of the first column: {:.0} N m", shape.value(Portal::beam_1.input().moment())? / sway);
    println!("in the corner b: {:.0} N m", shape.value(Portal::beam_1.output().moment())? / sway);
    Ok(())
}

/// The response of the girder, at rest and to the machine at some speeds.
fn show_response(system: &PortalSystem) -> Result<(), Box<dyn Error>> {
    let deflection = system.frequency_response(Portal::conn_girder.force_y(), Portal::conn_girder.displacement_y())?;
    println!("\nDeflection of the girder per kN at the machine");
    for frequency in [0.0, 10.0, 20.0, 25.0, 30.0] {
        println!("{frequency:5} Hz {:10.6} mm", 1e6 * deflection.at(hertz(frequency))?);
    }
    Ok(())
}

/// The change of the first frequency with each field.
fn show_sensitivities(system: &PortalSystem) -> Result<(), Box<dyn Error>> {
    let first = system.first_frequencies::<1>()?[0];
    println!("\nFirst frequency: relative change per relative change of each field");
    let fields = steel();
    let value = |name: &str| match name {
        "height" => fields.height,
        "span" => fields.span,
        "machine_x" => fields.machine_x,
        "ea" => fields.ea,
        "ei" => fields.ei,
        "m" => fields.m,
        "brace" => fields.brace,
        "machine" => fields.machine,
        _ => fields.inertia,
    };
    for (name, slope) in system.sensitivity(&first)?.iter() {
        println!("{name:10} {:9.5}", slope * value(name) / first.omega);
    }
    Ok(())
}

/// With `-- --svg FILE`: a picture of the first mode.
fn draw(system: &PortalSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_frequencies::<1>()?[0])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
