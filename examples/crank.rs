//! A crank of bent steel: bending and torsion go together, except where the crank is straight. A damped response, and what its arm does.

use mstmm::prelude::*;
use mstmm::sections;
use mstmm_drawing::{Drawing, Force};
use std::error::Error;

system! {
    /// A shaft along x that is held at its end, an arm across it, and a pin at the end of the arm that carries a mass.
    ///
    /// ```text
    ///     |/|
    ///     |/|=========+          z  y
    ///     |/|         |          | /
    ///                 |          |/
    ///                 +===O      +-- x
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Crank {
        /// Length of the shaft [m]
        pub shaft: f64,
        /// Part of the arm along y [m]
        pub arm_y: f64,
        /// Part of the arm along z [m]
        pub arm_z: f64,
        /// Length of the pin [m]
        pub pin: f64,
        /// Diameter [m]
        pub diameter: f64,
        /// Young's modulus [Pa]
        pub e: f64,
        /// Shear modulus [Pa]
        pub g: f64,
        /// Density [kg/m³]
        pub rho: f64,
        /// Mass at the end of the pin [kg]
        pub mass: f64,
        /// Loss factor of the steel
        pub loss: f64,
    }

    let (area, i, _, j) = sections::round(diameter);
    section steel {
        axial_stiffness: e * area, torsional_stiffness: g * j, bending_stiffness: e * i, mass_per_length: rho * area,
        polar_inertia_per_length: 2.0 * rho * i, loss_factor: loss,
    }

    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn corner at (shaft, 0.0, 0.0)
        -> beam 2 { ..steel } -> conn elbow at (shaft, arm_y, arm_z)
        -> beam 3 { ..steel } -> conn handle at (shaft + pin, arm_y, arm_z) <- point_mass 4 { mass };
}

/// A crank of a rod of 20 mm.
pub fn steel() -> Crank {
    Crank {
        shaft: 0.4,
        arm_y: 0.0,
        arm_z: -0.25,
        pin: 0.15,
        diameter: 0.02,
        e: 2.1e11,
        g: 8.1e10,
        rho: 7850.0,
        mass: 0.8,
        loss: 0.004,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = steel();
    let crank = model.build()?;
    println!("Eigenvalues, each inside a proven disc: frequency, damping ratio, and how the handle moves");
    println!("mode   f [Hz]    ratio      x       y       z");
    let eigenvalues = crank.first_eigenvalues::<6>()?;
    for (mode, root) in eigenvalues.iter().enumerate() {
        let shape = crank.mode_shape(root)?;
        let motion = shape.motion_of(Crank::conn_handle)?;
        let largest = motion[..3].iter().fold(0.0, |most: f64, part| most.max(part.norm()));
        let [x, y, z] = [0, 1, 2].map(|k| motion[k].norm() / largest);
        let (hertz, ratio) = (root.lambda.norm() / std::f64::consts::TAU, -root.lambda.re / root.lambda.norm());
        println!("{:4} {hertz:9.3} {ratio:9.6} {x:7.3} {y:7.3} {z:7.3}", mode + 1);
    }
    println!("\nA force of 1 N along y at the handle, slowly and near the first two frequencies");
    println!("f [Hz]      |y| [mm]    torque at the wall [N m]");
    let load = Crank::conn_handle.force_y();
    let deflection = crank.frequency_response(load, Crank::conn_handle.displacement_y())?;
    let torque = crank.frequency_response(load, Crank::beam_1.input().torque())?;
    for frequency in [0.0, 10.0, 20.0, 25.0, 30.0, 40.0] {
        let (deflection, torque) = (deflection.at_hertz(frequency)?.norm(), torque.at_hertz(frequency)?.norm());
        println!("{frequency:6} {:13.6} {torque:16.6}", 1e3 * deflection);
    }
    draw(&crank)
}

/// With `-- --svg FILE`: the torques in the crank under a force along y at the handle.
fn draw(crank: &CrankSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = crank.mode_shape(&crank.first_eigenvalues::<1>()?[0])?;
    Ok(Drawing::of(crank)?.forces(&shape, Force::Torque)?.write(file)?)
}
