//! The trend of |Δ|: how it grows where it is far from its roots.

use crate::error::ReportError;
use mstmm::Complex;
use nalgebra::{Matrix3, Vector3};

/// Where the power of the trend has its pole, below the origin, as a share of the largest |λ|: |Δ| is finite at rest.
const BELOW: f64 = 0.05;

/// Of what log₁₀ of the trend is made: a constant, √(−iλ), by which the waves of beams grow along the imaginary axis, and log λ, for
/// powers of λ in front of them.
///
/// These are real parts of functions that are analytic above the real axis. So Δ over its trend has the roots of Δ and no others, and
/// nowhere a maximum of its modulus.
fn growth(lambda: Complex<f64>, scale: f64) -> Vector3<f64> {
    let wave = (Complex::new(0.0, -1.0) * lambda / scale).sqrt();
    Vector3::new(1.0, wave.re, (lambda / scale + Complex::new(0.0, BELOW)).norm().log10())
}

/// log₁₀ |Δ| less its trend, the combination of the three that fits best to so many of the first values.
pub(crate) fn less_trend(places: &[Complex<f64>], values: &[f64], fitted: usize) -> Result<Vec<f64>, ReportError> {
    let scale = places.iter().map(|place| place.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let finite = places.iter().zip(values).take(fitted).filter(|(_, value)| value.is_finite());
    for (&place, &value) in finite {
        let row = growth(place, scale);
        matrix += row * row.transpose();
        right += row * value;
    }
    let fit = matrix.cholesky().ok_or(ReportError::NoTrend)?.solve(&right);
    Ok(places.iter().zip(values).map(|(&place, value)| value - growth(place, scale).dot(&fit)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::LOG10_E;

    /// Oracle: the growth of cos z cosh z in closed form.
    #[test]
    fn the_growth_of_a_beam_is_removed() {
        let places: Vec<_> = (1..400).map(|n| Complex::new(0.0, f64::from(n * n))).collect();
        let value = |place: &Complex<f64>| (place.im.sqrt()) * LOG10_E + 3.0;
        let values: Vec<f64> = places.iter().map(value).collect();
        assert!(less_trend(&places, &values, values.len()).unwrap().iter().all(|rest| rest.abs() < 1e-9));
    }

    #[test]
    fn a_single_place_has_no_trend() {
        assert!(less_trend(&[Complex::new(0.0, 1.0)], &[1.0], 1).is_err());
    }
}
