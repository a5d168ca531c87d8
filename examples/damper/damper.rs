//! A tuned mass damper for a footbridge: spring and dashpot for the smallest vibration near the first resonance.

use argmin::core::{CostFunction, Error, Executor};
use argmin::solver::neldermead::NelderMead;
use mstmm::prelude::*;

system! {
    /// Bridge on two supports with a mass on a spring and a dashpot at its middle.
    #[derive(Clone, Copy, Debug)]
    pub struct Bridge {
        /// Half of the span [m]
        pub half: f64,
        /// Bending stiffness [N m²]
        pub ei: f64,
        /// Mass per length [kg/m]
        pub m: f64,
        /// Mass of the damper [kg]
        pub mass: f64,
        /// Stiffness of its spring [N/m]
        pub stiffness: f64,
        /// Damping of its dashpot [N s/m]
        pub damping: f64,
    }

    pinned -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m }
           -> conn 2
           -> beam 3 { length: half, bending_stiffness: ei, mass_per_length: m }
           -> pinned;
    conn 2 <- spring 4 { stiffness, damping } <- mass 5 { mass } <- free;
}

/// A bridge that walkers would excite, with a damper of 1 % of its mass.
pub fn bridge(stiffness: f64, damping: f64) -> Bridge {
    Bridge { half: 12.0, ei: 8e8, m: 1500.0, mass: 360.0, stiffness, damping }
}

/// The largest deflection at the middle under a harmonic force of 1 N there, from 9 to 16 rad/s [m/N].
pub fn largest_deflection(bridge: &Bridge) -> Result<f64, Error> {
    let system = bridge.build()?;
    let response = system.frequency_response(Bridge::conn_2.force(), Bridge::conn_2.deflection())?;
    let roots = system.eigenvalues::<8>(Region { re: -20.0..=1.0, im: 1.0..=25.0 })?;
    let curve = response.curve::<4096, _>(9.0..=16.0, &roots, 1e-4)?;
    Ok(curve.iter().map(|sample| sample.value.norm()).fold(0.0, f64::max))
}

/// The optimiser's problem. Its variables are logarithms: stiffness and damping stay positive, and steps are relative.
struct Tuning;

impl CostFunction for Tuning {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, logarithms: &Vec<f64>) -> Result<f64, Error> {
        let bridge = bridge(logarithms[0].exp(), logarithms[1].exp());
        // per MN: the optimiser compares differences with the tolerance below
        Ok(1e6 * largest_deflection(&bridge)?)
    }
}

/// The bridge with the best spring and dashpot, from a first guess.
pub fn tuned(guess: &Bridge) -> Result<Bridge, Error> {
    let (k, c) = (guess.stiffness.ln(), guess.damping.ln());
    let simplex = vec![vec![k, c], vec![k + 0.1, c], vec![k, c + 0.3]];
    let solver = NelderMead::new(simplex).with_sd_tolerance(1e-5)?;
    let result = Executor::new(Tuning, solver).configure(|state| state.max_iters(100)).run()?;
    let best = result.state.best_param.ok_or_else(|| Error::msg("no optimum"))?;
    Ok(bridge(best[0].exp(), best[1].exp()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("                stiffness [N/m]   damping [N s/m]   largest deflection [mm/kN]");
    // tuned to the first frequency of the bare bridge, with a damping ratio of 5 %
    let guess = bridge(56_371.0, 450.5);
    for (name, bridge) in [("first guess", &guess), ("tuned", &tuned(&guess)?)] {
        let largest = 1e6 * largest_deflection(bridge)?;
        println!("{name:14} {:16.0} {:17.1} {largest:28.4}", bridge.stiffness, bridge.damping);
    }
    Ok(())
}
