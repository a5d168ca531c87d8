//! A house of two storeys in an earthquake: what each mode takes with it, the forces of a spectrum of a building code, two directions combined, and a record.
//!
//! `cargo run --example earthquake -- --svg house.svg` draws the masses to `house.svg` and the spectrum to `house_spectrum.svg`.

use mstmm::motion::{Combination, Directions, combined};
use mstmm::prelude::*;
use mstmm_drawing::ModeDiagram;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

system! {
    /// Two storeys on fixed columns.
    ///
    /// ```text
    ///   b o======o c
    ///     |      |
    ///   a o======o d
    ///     |      |
    ///    ###    ###
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct House {
        /// Height of a storey [m]
        pub height: f64,
        /// Span [m]
        pub span: f64,
        /// Mass of a slab per length [kg/m]
        pub slab: f64,
    }

    section column { axial_stiffness: 2e9, bending_stiffness: 2.4e7, mass_per_length: 80.0 }
    section girder { axial_stiffness: 4e9, bending_stiffness: 9e7, mass_per_length: slab }
    conn foot at (0.0, 0.0) -> beam 1 { ..column } -> conn a at (0.0, height) -> beam 2 { ..column } -> conn b at (0.0, 2.0 * height)
        -> beam 3 { ..girder } -> conn c at (span, 2.0 * height) -> beam 4 { ..column } -> conn d at (span, height)
        -> beam 5 { ..column } -> fixed at (span, 0.0);
    conn a -> beam 6 { ..girder } -> conn d;
    fixed -> conn foot;
}

/// Number of modes of the sums.
pub const MODES: usize = 8;

/// The house of the guide.
pub fn house() -> House {
    House { height: 3.0, span: 6.0, slab: 2500.0 }
}

/// A spectrum as building codes have it, type 1 on stiff soil with 2 m/s² of the ground, at ω and a damping ratio.
pub fn code(omega: f64, ratio: f64) -> f64 {
    let (ground, soil, corners) = (2.0, 1.2, [0.15, 0.5, 2.0]);
    let damping = (10.0 / (5.0 + 100.0 * ratio)).sqrt().max(0.55);
    let period = TAU / omega;
    let plateau = 2.5 * damping * ground * soil;
    match period {
        period if period < corners[0] => ground * soil * (1.0 + period / corners[0] * (2.5 * damping - 1.0)),
        period if period <= corners[1] => plateau,
        period if period <= corners[2] => plateau * corners[1] / period,
        period => plateau * corners[1] * corners[2] / (period * period),
    }
}

/// The acceleration of the ground itself, of a period of zero [m/s²].
pub const AT_ONCE: f64 = 2.0 * 1.2;

fn main() -> Result<(), Box<dyn Error>> {
    let system = house().build()?;
    let roots = system.first_frequencies::<MODES>()?;
    let along = system.participation::<MODES, _>(&roots, Direction::x())?;
    println!("  f [Hz]   mass [%]   sum [%]");
    for (mode, root) in roots.iter().enumerate() {
        let share = |mass: f64| 100.0 * mass / along.total();
        println!(
            "{:8.3} {:10.3} {:9.3}",
            root.hertz(),
            share(along.effective_mass(mode)),
            share(along.cumulative(mode))
        );
    }

    // the moment at the foot, in each direction: modes as the code combines them, and what the list leaves out
    let spectrum = (code, AT_ONCE);
    let moment = House::beam_1.input().moment();
    let mut peaks = [0.0; 2];
    for (peak, (direction, part)) in peaks.iter_mut().zip([(Direction::x(), 1.0), (Direction::y(), 0.9)]) {
        let ground = PlaneLoad::base_acceleration(direction);
        let response = system.modal_response::<MODES, _>(&roots, ground, moment)?.with_damping_ratio(0.05)?;
        *peak = part * response.spectral_peak(&spectrum, Combination::CompleteQuadratic)?.total();
    }
    println!("moment at the foot: {:.1} kN m along x, {:.1} kN m upright", 1e-3 * peaks[0], 1e-3 * peaks[1]);
    println!("both, 100 and 30 %: {:.1} kN m", 1e-3 * combined(&peaks, Directions::HundredThirty));

    // a record: three seconds of a shaken ground, sample by sample
    let ground = PlaneLoad::base_acceleration(Direction::x());
    let sway =
        system.modal_response::<MODES, _>(&roots, ground, House::conn_b.displacement_x())?.with_damping_ratio(0.05)?;
    let mut history = sway.history(0.01)?;
    let record = (0..300).map(|k| 0.01 * f64::from(k)).map(|t| 2.0 * (-0.8 * t).exp() * (11.0 * t).sin());
    let largest = record.map(|acceleration| history.next(acceleration).abs()).fold(0.0, f64::max);
    println!("the roof moves by {:.2} mm beside the ground at most", 1e3 * largest);

    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    ModeDiagram::masses(&roots, &along)?.write(&file)?;
    let beside = Path::new(&file).with_extension("");
    ModeDiagram::spectrum(&roots, &spectrum, 0.05)?.write(format!("{}_spectrum.svg", beside.display()))?;
    Ok(())
}
