//! Two parallel beams that springs couple: modes in which both move as one, which no spring knows of, and modes in which they move apart,
//! beside beams on an even foundation.

use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;
use std::f64::consts::PI;

system! {
    /// Two equal beams on pins, one above the other, with three equal springs between them.
    ///
    /// ```text
    ///     o ---- a1 ---- a2 ---- a3 ---- o
    ///             |       |       |
    ///     o ---- b1 ---- b2 ---- b3 ---- o
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct DoubleBeam {
        /// Length of both beams [m]
        pub length: f64,
        /// Bending stiffness of each beam [N m²]
        pub ei: f64,
        /// Mass per length of each beam [kg/m]
        pub m: f64,
        /// Stiffness of each spring [N/m]
        pub stiffness: f64,
    }

    let quarter = 0.25 * length;

    pinned at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn a1 at quarter
        -> beam 2 { bending_stiffness: ei, mass_per_length: m } -> conn a2 at 2.0 * quarter
        -> beam 3 { bending_stiffness: ei, mass_per_length: m } -> conn a3 at 3.0 * quarter
        -> beam 4 { bending_stiffness: ei, mass_per_length: m } -> pinned at length;
    pinned at 0.0 -> beam 5 { bending_stiffness: ei, mass_per_length: m } -> conn b1 at quarter
        -> beam 6 { bending_stiffness: ei, mass_per_length: m } -> conn b2 at 2.0 * quarter
        -> beam 7 { bending_stiffness: ei, mass_per_length: m } -> conn b3 at 3.0 * quarter
        -> beam 8 { bending_stiffness: ei, mass_per_length: m } -> pinned at length;
    conn a1 -> spring 9 { stiffness } -> conn b1;
    conn a2 -> spring 10 { stiffness } -> conn b2;
    conn a3 -> spring 11 { stiffness } -> conn b3;
}

/// Two beams of steel, four metres long.
pub fn steel() -> DoubleBeam {
    DoubleBeam { length: 4.0, ei: 2e4, m: 10.0, stiffness: 5e4 }
}

/// The frequency of a beam on pins with `n` half waves.
pub fn of_one_beam(model: &DoubleBeam, n: u32) -> f64 {
    (f64::from(n) * PI / model.length).powi(2) * (model.ei / model.m).sqrt()
}

/// The frequency of the beams moving apart with `n` half waves, were the springs spread evenly: each beam stands on twice their
/// stiffness per length, of which there is one per quarter.
pub fn on_even_foundation(model: &DoubleBeam, n: u32) -> f64 {
    let per_length = 2.0 * model.stiffness / (0.25 * model.length);
    (of_one_beam(model, n).powi(2) + per_length / model.m).sqrt()
}

/// How the beams move in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// Both as one.
    Together,
    /// Opposite to each other.
    Apart,
    /// Either, at one frequency.
    Both,
}

/// How the beams move at a root: at the first spring, which is at rest in modes of four, eight .. half waves alone.
pub fn motion(system: &DoubleBeamSystem, root: &NaturalFrequency<f64>) -> Result<Motion, Box<dyn Error>> {
    if root.multiplicity > 1 {
        return Ok(Motion::Both);
    }
    let shape = system.mode_shape(root)?;
    let [a, b] = [DoubleBeam::conn_a1, DoubleBeam::conn_b1].map(|point| shape.value(point.displacement_y()));
    Ok(if a? * b? > 0.0 { Motion::Together } else { Motion::Apart })
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = steel();
    let system = model.build()?;

    println!("Natural frequencies; with four half waves no spring moves, and two modes share one frequency");
    println!(
        "half waves         ω [rad/s]   count   motion      one beam [rad/s]   difference   springs spread evenly"
    );
    let (mut together, mut apart) = (0, 0);
    for root in &system.first_frequencies::<10>()? {
        let motion = motion(&system, root)?;
        together += u32::from(motion != Motion::Apart);
        apart += u32::from(motion != Motion::Together);
        let (omega, often, name) = (root.omega, root.multiplicity, format!("{motion:?}"));
        if motion == Motion::Apart {
            let even = on_even_foundation(&model, apart);
            println!("{apart:10} {omega:17.10} {often:7}   {name:8} {even:56.6}");
        } else {
            let single = of_one_beam(&model, together);
            println!(
                "{together:10} {omega:17.10} {often:7}   {name:8} {single:19.10} {:12.0e}",
                (omega - single).abs()
            );
        }
    }

    println!("\nThe first two frequencies over the stiffness of the springs: only one of them knows it");
    println!("k [N/m]    together [rad/s]   apart [rad/s]   spread evenly [rad/s]");
    for stiffness in [1e2, 1e3, 1e4, 3e4, 1e5] {
        let model = DoubleBeam { stiffness, ..model };
        let system = model.build()?;
        let roots = system.first_frequencies::<6>()?;
        let first = |wanted: Motion| -> Result<f64, Box<dyn Error>> {
            for root in &roots {
                if motion(&system, root)? == wanted {
                    return Ok(root.omega);
                }
            }
            Err("not among the first".into())
        };
        let (together, apart) = (first(Motion::Together)?, first(Motion::Apart)?);
        println!("{stiffness:7} {together:19.8} {apart:15.8} {:23.8}", on_even_foundation(&model, 1));
    }
    draw(&system)
}

/// With `-- --svg FILE`: a picture of the second mode, in which the beams move apart.
fn draw(system: &DoubleBeamSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_frequencies::<2>()?[1])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
