//! A rotor with two discs on isotropic bearings: whirl, critical speeds, unbalance, and the speed from which on it is unstable.
//!
//! Example 5.9.1 of Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010).

use mstmm::Complex;
use mstmm::prelude::*;
use mstmm::search::{campbell, critical_speeds, stability_threshold};
use mstmm::sections;
use mstmm_drawing::{CampbellDiagram, Drawing};
use std::error::Error;
use std::f64::consts::{PI, TAU};

/// Density of steel [kg/m³].
const RHO: f64 = 7810.0;

/// Mass, and moments of inertia about a diameter and about the axis, of a disc around the shaft.
fn disc(diameter: f64, bore: f64, width: f64) -> [f64; 3] {
    let mass = RHO * 0.25 * PI * (diameter.powi(2) - bore.powi(2)) * width;
    let squares = diameter.powi(2) + bore.powi(2);
    [mass, mass * (squares / 16.0 + width.powi(2) / 12.0), mass * squares / 8.0]
}

system! {
    /// A shaft with two discs on two bearings.
    ///
    /// ```text
    ///            |       |
    ///   o========|=======|========o
    ///   /        |       |        /
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Rotor {
        /// Diameter of the shaft [m]
        pub diameter: f64,
        /// Stiffness of a bearing [N/m]
        pub stiffness: f64,
        /// Speed [rad/s]
        pub speed: f64,
    }

    let (area, i, _, j) = sections::tube(diameter, 0.0);
    let [mass, inertia, polar_inertia] = disc(0.28, 0.05, 0.07);
    let [larger, its_inertia, its_polar_inertia] = disc(0.35, 0.05, 0.07);
    section shaft {
        bending_stiffness: 2.11e11 * i, mass_per_length: RHO * area, shear_stiffness: 0.886 * 8.12e10 * area,
        rotary_inertia: RHO * i, polar_inertia_per_length: RHO * j, speed,
    }

    free -> conn left -> beam 1 { length: 0.5, ..shaft }
         -> disc 2 { mass, inertia, polar_inertia, speed }
         -> beam 3 { length: 0.5, ..shaft }
         -> disc 4 { mass: larger, inertia: its_inertia, polar_inertia: its_polar_inertia, speed }
         -> beam 5 { length: 0.5, ..shaft } -> conn right -> free;
    fixed -> spring 6 { stiffness } -> conn left;
    fixed -> spring 7 { stiffness } -> conn right;
}

system! {
    /// The same with damping: of the bearings, and of the material, which turns with the shaft.
    #[derive(Clone, Copy, Debug)]
    pub struct Damped { diameter: f64, stiffness: f64, damping: f64, time: f64, speed: f64 }

    let (area, i, _, j) = sections::tube(diameter, 0.0);
    let [mass, inertia, polar_inertia] = disc(0.28, 0.05, 0.07);
    section shaft {
        bending_stiffness: 2.11e11 * i, mass_per_length: RHO * area, rotary_inertia: RHO * i, polar_inertia_per_length: RHO * j,
        kelvin_voigt_time: time, speed,
    }

    free -> conn left -> beam 1 { length: 0.75, ..shaft } -> disc 2 { mass, inertia, polar_inertia, speed }
         -> beam 3 { length: 0.75, ..shaft } -> conn right -> free;
    fixed -> spring 4 { stiffness, damping } -> conn left;
    fixed -> spring 5 { stiffness, damping } -> conn right;
}

/// The rotor of the book.
pub fn two_discs() -> Rotor {
    Rotor { diameter: 0.05, stiffness: 1e6, speed: 4000.0 * TAU / 60.0 }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = two_discs();
    let build = |speed| Rotor { speed, ..model }.build();
    let rotor = model.build()?;

    println!("whirl at 4000 rpm, rad/s\n  backward       forward");
    let [forward, backward] = [Whirl::Forward, Whirl::Backward].map(|whirl| rotor.whirl(whirl));
    let lists = (backward.first_frequencies::<3>()?, forward.first_frequencies::<3>()?);
    for (backward, forward) in lists.0.iter().zip(lists.1.iter()) {
        println!("{:10.5}    {:10.5}", backward.omega, forward.omega);
    }

    println!("\ncritical speeds of forward whirl, rpm, each proven");
    let critical = critical_speeds::<4, _>(1.0..=1000.0, Whirl::Forward, 1.0, build)?;
    for speed in critical.iter() {
        println!("{:10.4} in [{:.12}, {:.12}]", rpm(speed.speed), rpm(speed.lower), rpm(speed.upper));
    }

    println!("\nunbalance of 10 g m on disc 4: the disc whirls by");
    for speed in [500.0, 800.0, 2000.0, 4000.0].map(|rpm| rpm * TAU / 60.0) {
        let rotor = build(speed)?;
        let (load, point) = (Rotor::disc_4.output().force(), Rotor::disc_4.output());
        let u = rotor.whirl(Whirl::Forward).unbalance(speed, &[(load, Complex::from(0.01))], point.deflection())?;
        println!("{:8.0} rpm: {:9.2} um", rpm(speed), 1e6 * u.re);
    }

    let damped = |speed| Damped { diameter: 0.05, stiffness: 1e7, damping: 200.0, time: 2e-5, speed }.build();
    let region = Region { re: 0.0..=50.0, im: 10.0..=1000.0 };
    if let Some(threshold) = stability_threshold(1.0..=2000.0, Whirl::Forward, region, damped)? {
        let (speed, omega) = (rpm(threshold.speed), rpm(threshold.eigenvalue.lambda.im));
        println!("\ninternal damping drives the whirl at {omega:.1} rpm from {speed:.1} rpm on");
    }
    draw(&rotor, &critical)
}

fn rpm(speed: f64) -> f64 {
    speed * 60.0 / TAU
}

/// With `-- --svg FILE`: the second mode of forward whirl and its orbits; with `-- --campbell FILE`: the Campbell diagram.
fn draw(
    rotor: &mstmm::search::Rotor<RotorSystem>,
    critical: &[mstmm::search::CriticalSpeed],
) -> Result<(), Box<dyn Error>> {
    let file = |option: &str| std::env::args().skip_while(|argument| argument != option).nth(1);
    if let Some(file) = file("--svg") {
        let forward = rotor.whirl(Whirl::Forward);
        let shape = forward.mode_shape(&forward.first_frequencies::<2>()?[1])?;
        Drawing::of(forward)?.mode(&shape)?.orbits(Whirl::Forward).write(file)?;
    }
    if let Some(file) = file("--campbell") {
        let model = two_discs();
        let speeds = (0..=40).map(|k| 25.0 * f64::from(k));
        let at_speeds: Result<Vec<_>, _> = campbell::<4, _>(speeds, |speed| Rotor { speed, ..model }.build()).collect();
        CampbellDiagram::of(&at_speeds?)?.order(1.0).critical(1.0, critical).write(file)?;
    }
    Ok(())
}
