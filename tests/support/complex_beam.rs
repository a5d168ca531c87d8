//! An oracle for beams with damping: the exponential of their equations with complex stiffnesses, by its series.

use mstmm::prelude::Complex;

pub(crate) type C = Complex<f64>;
pub(crate) type Matrix = [[C; 4]; 4];

/// What a beam is made of, undamped, and its damping.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ComplexBeam {
    pub(crate) length: f64,
    pub(crate) bending_stiffness: f64,
    pub(crate) mass_per_length: f64,
    /// None without shear.
    pub(crate) shear_stiffness: Option<f64>,
    pub(crate) rotary_inertia: f64,
    pub(crate) axial_force: f64,
    pub(crate) foundation_stiffness: f64,
    pub(crate) loss_factor: f64,
    pub(crate) kelvin_voigt_time: f64,
    pub(crate) external_damping: f64,
}

impl ComplexBeam {
    /// The derivative of Y, Θ, M, Q along the beam, from the forces: `-Q = kGA (Y' - Θ) + N Y'`.
    fn equations(&self, lambda: C) -> Matrix {
        let factor = C::new(1.0, self.loss_factor) * (1.0 + self.kelvin_voigt_time * lambda);
        let (zero, one, tension) = (C::ZERO, C::ONE, C::from(self.axial_force));
        let bending = (factor * self.bending_stiffness).inv();
        let inertia =
            lambda * lambda * self.mass_per_length + lambda * self.external_damping + self.foundation_stiffness;
        let rotary = lambda * lambda * self.rotary_inertia;
        let (slope, moment) = match self.shear_stiffness {
            None => ([one, zero], [tension + rotary, one]),
            Some(stiffness) => {
                let shear = factor * stiffness;
                let whole = (shear + tension).inv();
                // Y' = (kGA Θ - Q)/(kGA + N), and M' = kGA (Θ - Y') + r λ² Θ
                ([shear * whole, -whole], [shear - shear * shear * whole + rotary, shear * whole])
            }
        };
        [
            [zero, slope[0], zero, slope[1]],
            [zero, zero, bending, zero],
            [zero, moment[0], zero, moment[1]],
            [-inertia, zero, zero, zero],
        ]
    }

    /// The transfer matrix over Y, Θ, M, Q: the series of a short piece, squared as often as it fits.
    pub(crate) fn transfer(&self, lambda: C) -> Matrix {
        const HALVES: i32 = 10;
        let piece = self.equations(lambda).map(|row| row.map(|entry| entry * self.length * 0.5f64.powi(HALVES)));
        let mut sum = identity();
        let mut term = identity();
        for k in 1..=24 {
            term = product(&term, &piece).map(|row| row.map(|entry| entry / f64::from(k)));
            sum = core::array::from_fn(|i| core::array::from_fn(|j| sum[i][j] + term[i][j]));
        }
        (0..HALVES).for_each(|_| sum = product(&sum, &sum));
        sum
    }
}

fn identity() -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { C::ONE } else { C::ZERO }))
}

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The root of a function beside an estimate, by the secant method.
pub(crate) fn refined(function: impl Fn(C) -> C, estimate: C) -> C {
    let (mut before, mut here) = (estimate * (1.0 + 1e-4), estimate);
    let mut value = function(before);
    for _ in 0..12 {
        let own = function(here);
        let step = own * (here - before) / (own - value);
        if step.norm().is_nan() || step.norm() <= 1e-15 * here.norm() {
            break;
        }
        (before, value) = (here, own);
        here -= step;
    }
    here
}
