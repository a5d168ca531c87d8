//! A flexible arm under control: its modes as a state space, a loop at 2 kHz in single precision that damps its tip, and the same without control.

use mstmm::motion::{DiscreteStateSpace, HoldOrder};
use mstmm::prelude::*;
use std::error::Error;

system! {
    /// An arm with a gripper, driven by a force at a third of its length.
    ///
    /// ```text
    ///         u
    ///   |     |           | disturbance
    ///   |=====o===========O
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct Arm {
        /// Length [m]
        pub length: f64,
        /// Bending stiffness [N m²]
        pub ei: f64,
        /// Mass per length [kg/m]
        pub m: f64,
        /// Mass of the gripper [kg]
        pub gripper: f64,
    }

    section tube { bending_stiffness: ei, mass_per_length: m }
    fixed -> beam 1 { length: length / 3.0, ..tube } -> conn drive -> beam 2 { length: 2.0 * length / 3.0, ..tube } -> conn tip
        -> point_mass 3 { mass: gripper } -> free;
}

/// Modes, step [s] and steps of the loop.
const MODES: usize = 4;
const STEP: f64 = 5e-4;
const STEPS: usize = 4000;

/// The arm in steps: inputs are the drive and a force at the tip, the output is the deflection of the tip.
pub fn arm() -> Result<DiscreteStateSpace<f64, MODES, 2, 1>, Box<dyn Error>> {
    let arm = Arm { length: 0.9, ei: 40.0, m: 0.6, gripper: 0.2 }.build()?;
    let roots = arm.first_frequencies::<MODES>()?;
    for root in &roots {
        println!("{:8.3} Hz", root.hertz());
    }
    let loads = [Arm::conn_drive.force(), Arm::conn_tip.force()];
    let space = arm.state_space::<MODES, 2, 1>(&roots, loads, [Arm::conn_tip.deflection()])?;
    Ok(space.with_damping_ratio(0.005)?.discrete(STEP, HoldOrder::Zero)?)
}

/// The deflections of the tip after a push of 0.1 s, with a gain of the rate of the tip [N s/m] at the drive.
pub fn run(mut plant: DiscreteStateSpace<f32, MODES, 2, 1>, gain: f32) -> Vec<f32> {
    let mut before = 0.0;
    let mut drive = 0.0;
    let mut deflections = Vec::with_capacity(STEPS);
    for k in 0..STEPS {
        let push = if k < 200 { 0.5 } else { 0.0 };
        let [tip] = plant.step(&[drive, push]);
        drive = -gain * (tip - before) / STEP as f32;
        before = tip;
        deflections.push(tip);
    }
    deflections
}

fn main() -> Result<(), Box<dyn Error>> {
    let plant = arm()?;
    println!("gain [N s/m]   largest deflection [mm]   in the last half second [mm]");
    for gain in [0.0, 1.0, 3.0, 8.0] {
        let deflections = run(plant.single(), gain);
        let largest = |part: &[f32]| 1e3 * part.iter().fold(0.0_f32, |largest, tip| largest.max(tip.abs()));
        println!("{gain:12.1} {:25.4} {:30.4}", largest(&deflections), largest(&deflections[3 * STEPS / 4..]));
    }
    Ok(())
}
