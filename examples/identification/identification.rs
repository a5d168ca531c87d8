//! How stiff is a clamp? Its torsional stiffness from three measured frequencies, by least squares.

use mstmm::prelude::*;
use rmpfit::{MPError, MPFitter, MPPar, MPResult, MPSide};
use std::error::Error;
use std::f64::consts::TAU;

system! {
    /// Beam whose clamp holds the deflection, and the rotation by a torsion spring.
    struct Clamped { length: f64, ei: f64, m: f64, clamp: f64 }

    pinned -> conn 1 -> beam 2 { length, bending_stiffness: ei, mass_per_length: m } -> free;
    conn 1 <- torsion_spring 3 { stiffness: clamp } <- fixed;
}

/// The first three frequencies [Hz] for a stiffness of the clamp [N m/rad], each with its derivative.
pub fn frequencies(clamp: f64) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    // a steel strip, 30 mm by 6 mm
    let system = Clamped { length: 0.8, ei: 113.4, m: 1.413, clamp }.build()?;
    let mut frequencies = Vec::new();
    for root in &system.first_frequencies::<3>()? {
        let slope = system.sensitivity(root)?.get("clamp").ok_or("no such field")?;
        frequencies.push((root.hertz(), slope / TAU));
    }
    Ok(frequencies)
}

/// Measured frequencies with their standard deviations [Hz].
#[derive(Debug)]
pub struct Measured(pub Vec<(f64, f64)>);

/// What is fitted: the stiffness of the clamp, with derivatives of ours.
static CLAMP: [MPPar; 1] = [MPPar { side: MPSide::User, limited_low: true, limit_low: 1.0, ..MPPar::new() }];

impl MPFitter for Measured {
    fn parameters(&self) -> &[MPPar] {
        &CLAMP
    }

    fn number_of_points(&self) -> usize {
        self.0.len()
    }

    fn eval(&mut self, parameters: &[f64], residuals: &mut [f64]) -> MPResult<()> {
        self.jacobian(parameters, residuals, &mut [])
    }

    fn jacobian(&mut self, at: &[f64], residuals: &mut [f64], slopes: &mut [Option<Vec<f64>>]) -> MPResult<()> {
        let model = frequencies(at[0]).map_err(|_| MPError::Eval)?;
        for (index, ((hertz, slope), (measured, deviation))) in model.iter().zip(&self.0).enumerate() {
            residuals[index] = (measured - hertz) / deviation;
            if let Some(Some(slopes)) = slopes.first_mut() {
                slopes[index] = -slope / deviation;
            }
        }
        Ok(())
    }
}

/// The stiffness that fits best and its standard deviation [N m/rad], from a first guess.
pub fn identify(mut measured: Measured, guess: f64) -> Result<(f64, f64), Box<dyn Error>> {
    let mut clamp = [guess];
    let fit = measured.mpfit(&mut clamp).map_err(|error| error.to_string())?;
    Ok((clamp[0], fit.xerror[0]))
}

fn main() -> Result<(), Box<dyn Error>> {
    let measured = vec![(6.12, 0.02), (41.40, 0.1), (121.0, 0.3)];
    let (clamp, deviation) = identify(Measured(measured.clone()), 100.0)?;
    println!("stiffness of the clamp: {clamp:.1} N m/rad, standard deviation {deviation:.1} N m/rad\n");
    println!("measured [Hz]   fitted [Hz]   residual [Hz]   in standard deviations");
    for ((hertz, _), (measured, deviation)) in frequencies(clamp)?.into_iter().zip(measured) {
        let residual = measured - hertz;
        println!("{measured:13.3} {hertz:13.3} {residual:15.3} {:24.2}", residual / deviation);
    }
    Ok(())
}
