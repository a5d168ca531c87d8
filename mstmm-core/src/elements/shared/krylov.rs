//! The entire functions of the exact beam, for bending and for longitudinal vibration.

use crate::number::{Frequency, Parameter, Single, series};
use nalgebra::Matrix4;

/// Krylov functions `[S, T/z, U/z², V/z³]` of `x = z⁴`, with `S = (ch z + cos z)/2`, `T = (sh z + sin z)/2`,
/// `U = (ch z - cos z)/2`, `V = (sh z - sin z)/2`: entire in `x`.
///
/// They are Taylor series `Σ x^k/(4k+j)!` for `|x| <= 1`, where the closed forms cancel. Near the negative axis they are
/// `[ch y cos y, (ch y sin y + sh y cos y)/(2y), sh y sin y/(2y²), (ch y sin y - sh y cos y)/(4y³)]` with `z = (1 + i) y`.
#[inline]
pub(crate) fn krylov<S: Single>(x: S) -> [S; 4] {
    if x.size() <= 1.0 {
        return [0, 1, 2, 3].map(|first| series(x, first, 4));
    }
    if is_nearly_negative(x) {
        let y2 = (-x * S::from_f64(0.25)).sqrt();
        let y = y2.sqrt();
        let ((sin, cos), (sh, ch)) = (y.sin_cos(), y.sinh_cosh());
        let two_y = y + y;
        let (even, odd) = (ch * sin, sh * cos);
        return [ch * cos, (even + odd) / two_y, sh * sin / (y2 + y2), (even - odd) / (two_y * (y2 + y2))];
    }
    let z2 = x.sqrt();
    let z = z2.sqrt();
    let (sin, cos) = z.sin_cos();
    let (sh, ch) = z.sinh_cosh();
    let two = S::from_f64(2.0);
    [(ch + cos) / two, (sh + sin) / (two * z), (ch - cos) / (two * z2), (sh - sin) / (two * z * z2)]
}

/// Whether a number is negative, or complex and within an eighth of a turn of the negative axis.
#[inline]
fn is_nearly_negative<S: Single>(x: S) -> bool {
    (x + S::from_f64(x.size())).size() < x.size()
}

/// Transfer matrix of a beam in bending, eq. (19) of the paper, written in `z⁴` and the normalised functions.
#[rustfmt::skip]
pub(crate) fn bending_matrix<T: Parameter, S: Frequency<T> + Single>(l: T, ei: T, m: T, lambda_squared: S) -> Matrix4<S> {
    let z4 = -lambda_squared * (m / ei * l * l * l * l);
    let [s, t, u, v] = krylov(z4);
    let flexibility = l / ei;
    let stiffness = ei / l;
    let (zu, zt, zv) = (z4 * u, z4 * t, z4 * v);
    Matrix4::new(
        s,                          t * l,                u * (l * flexibility), v * (l * l * flexibility),
        zv * (T::one() / l),        s,                    t * flexibility,       u * (l * flexibility),
        zu * (stiffness / l),       zv * stiffness,       s,                     t * l,
        zt * (stiffness / (l * l)), zu * (stiffness / l), zv * (T::one() / l),   s,
    )
}

/// `cos ζ` and `sin ζ / ζ` as entire functions of `x = ζ²`.
#[inline]
pub(crate) fn cosine_and_sinc<S: Single>(x: S) -> (S, S) {
    if x.size() <= 1.0 {
        return (series(-x, 0, 2), series(-x, 1, 2));
    }
    let zeta = x.sqrt();
    let (sin, cos) = zeta.sin_cos();
    (cos, sin / zeta)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Scalar;
    use crate::number::assert_close;
    use num_complex::Complex;

    /// Both branches at points where the closed form still has most of its digits.
    #[test]
    fn series_and_closed_forms_meet_at_the_switch() {
        let above = Complex::new(1.0 + 1e-12, 0.0);
        for (closed, series) in krylov(above).iter().zip(krylov(Complex::new(1.0, 0.0))) {
            // the closed form of V/z³ loses a factor of 7 to cancellation at z = 1, and x differs by 1e-12
            assert_close((closed - series).size(), 0.0, 1.0, 1e-12 / f64::EPSILON);
        }
        let (cos, sinc) = cosine_and_sinc(1.0 + 1e-12);
        let (cos_series, sinc_series) = cosine_and_sinc(1.0);
        assert_close(cos, cos_series, 1.0, 1e-12 / f64::EPSILON);
        assert_close(sinc, sinc_series, 1.0, 1e-12 / f64::EPSILON);
    }

    /// Oracle: the complex fourth root of `x` and the definitions, where a real one has none.
    #[test]
    fn negative_arguments_have_real_values() {
        for x in [-1.1, -4.0, -60.0, -3e3_f64] {
            let z2 = Complex::new(0.0, (-x).sqrt());
            let z = z2.sqrt();
            let (sh, ch, sin, cos) = (z.sinh(), z.cosh(), z.sin(), z.cos());
            let expected = [ch + cos, (sh + sin) / z, (ch - cos) / z2, (sh - sin) / (z2 * z)];
            for (real, expected) in krylov(x).iter().zip(expected) {
                assert_close(*real, (expected / 2.0).re, ch.norm(), 16.0);
            }
        }
    }

    #[test]
    fn zero_is_an_ordinary_point() {
        assert_eq!(krylov(0.0), [1.0, 1.0, 0.5, 1.0 / 6.0]);
        assert_eq!(cosine_and_sinc(0.0), (1.0, 1.0));
    }

    /// `S² - U² - 2(TV - …)` style identities would share the formulas; the differential equations do not:
    /// `d(zT/z)/dz = S` by central differences.
    #[test]
    fn derivatives_step_down_through_the_four_functions() {
        for z in [0.3, 0.9, 1.1, 2.5, 7.0_f64] {
            let h = 1e-5;
            let plain = |z: f64| {
                let [s, t, u, v] = krylov(z.powi(4));
                [s, t * z, u * z * z, v * z.powi(3)]
            };
            let (ahead, behind, [s, t, u, v]) = (plain(z + h), plain(z - h), plain(z));
            for (k, expected) in [v, s, t, u].into_iter().enumerate() {
                let difference = (ahead[k] - behind[k]) / (2.0 * h);
                // truncation h²/6 of a function that is its own fourth derivative
                assert_close(difference, expected, z.cosh(), h * h / f64::EPSILON);
            }
        }
    }
}
