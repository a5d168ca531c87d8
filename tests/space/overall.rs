//! The overall determinants of random frames in space against Δ of their dynamic stiffness: one constant for all frequencies.
#![expect(clippy::unwrap_used, reason = "a frame that cannot be built fails the test")]

use crate::random::random_model;
use mstmm::network::NetworkError;
use mstmm::number::{DoubleDouble, Scalar};
use mstmm::prelude::*;

/// Frequencies, and how far the quotients may be apart: lengths of members are numbers of sixteen digits in U_all, of which stiffness ratios take some.
const OMEGA: [f64; 4] = [0.31, 0.87, 1.43, 2.19];
const ROUNDING: f64 = 1e-8;

/// Calls a function for numbers of unknowns until one is right.
macro_rules! with_unknowns {
    ($needed:expr, $body:ident($argument:expr): $($count:literal)*) => {
        match $needed { $($count => Some($body::<$count>($argument)),)* _ => None }
    };
}

/// The largest difference of `det U_all / Δ` from that at the first frequency, relative to that.
fn difference<const N: usize>(frame: &mstmm::frame::Structure<mstmm::frame::Space>) -> f64 {
    let equation = frame.overall::<N>().unwrap();
    let quotients = OMEGA.map(|omega| {
        let omega = DoubleDouble::from(omega);
        let (all, delta) = (equation.overall_determinant(omega), frame.characteristic(omega));
        let exponent = (all.exponent() - delta.exponent()).clamp(-900, 900);
        (all.mantissa() / delta.mantissa()).times_power_of_two(exponent as i32)
    });
    let apart = quotients.map(|own| (own / quotients[0] - DoubleDouble::from(1.0)).size());
    apart.into_iter().fold(0.0, |worst, one| if one <= worst { worst } else { one })
}

#[test]
fn overall_determinants_of_random_frames_are_proportional_to_delta() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for seed in 0..400 {
        let structure = random_model(seed, 1.0).frame().0.build().unwrap();
        let Err(NetworkError::Unknowns { needed }) = structure.overall::<0>() else { continue };
        let apart = with_unknowns!(needed, difference(&structure): 12 18 24 30 36);
        let Some(apart) = apart else { continue };
        println!("{seed} {needed} {apart:.1e}");
        (compared, worst) = (compared + 1, worst.max(apart));
        assert!(apart < ROUNDING, "{seed}: {needed} unknowns, {apart:e}");
    }
    println!("{compared} frames, worst {worst:.1e}");
    assert!(compared > 20);
}
