//! A zero of a function between two points of opposite sign.

/// Brent's method: the secant or inverse quadratic interpolation, and bisection where these do not shorten the bracket.
///
/// Ends where the bracket is shorter than twice a tolerance, relative to the zero. The values at both ends must differ in
/// sign. Crates with the method end later: theirs lack the least step of half the tolerance, with which the last steps pass
/// the zero and close the bracket.
///
/// # Source
/// R. P. Brent, Algorithms for Minimization without Derivatives (1973), chapter 4.
pub fn zero(start: (f64, f64), end: (f64, f64), tolerance: f64, mut function: impl FnMut(f64) -> f64) -> f64 {
    // b is the best point, a the one before, c an older one on the other side of the zero
    let ((mut a, mut fa), (mut b, mut fb)) = (start, end);
    let (mut c, mut fc) = (a, fa);
    let mut step = b - a;
    let mut last_step = step;
    loop {
        if fc.abs() < fb.abs() {
            ((a, fa), (b, fb), (c, fc)) = ((b, fb), (c, fc), (b, fb));
        }
        let least = 2.0 * f64::EPSILON * b.abs() + 0.5 * tolerance * b.abs();
        let half = 0.5 * (c - b);
        if half.abs() <= least || fb == 0.0 {
            return b;
        }
        let interpolated = if last_step.abs() >= least && fa.abs() > fb.abs() {
            interpolation([(a, fa), (b, fb), (c, fc)], half)
        } else {
            half
        };
        let is_short = interpolated * half > 0.0
            && interpolated.abs() < (1.5 * half).abs() - (0.5 * least).abs()
            && interpolated.abs() < 0.5 * last_step.abs();
        (last_step, step) = if is_short { (step, interpolated) } else { (half, half) };
        (a, fa) = (b, fb);
        b += if step.abs() > least { step } else { least.copysign(half) };
        fb = function(b);
        if (fb > 0.0) == (fc > 0.0) {
            (c, fc) = (a, fa);
            step = b - a;
            last_step = step;
        }
    }
}

/// Step from the second point to the zero of the secant, or of the inverse parabola through three points.
fn interpolation([(a, fa), (b, fb), (c, fc)]: [(f64, f64); 3], half: f64) -> f64 {
    let s = fb / fa;
    if a == c {
        return 2.0 * half * s / (s - 1.0);
    }
    let (q, r) = (fa / fc, fb / fc);
    let numerator = s * (2.0 * half * q * (q - r) - (b - a) * (r - 1.0));
    -numerator / ((q - 1.0) * (r - 1.0) * (s - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Oracle: closed forms. An evaluation count of 20 is beyond bisection, which takes 50.
    #[test]
    fn finds_zeros_in_few_steps() {
        type Case = (fn(f64) -> f64, f64, f64, f64);
        let cases: [Case; 4] = [
            (|x| x.cos(), 1.0, 2.0, core::f64::consts::FRAC_PI_2),
            (|x| x * x - 2.0, 0.0, 2.0, core::f64::consts::SQRT_2),
            (|x| 1.0 - x.exp() / 3.0, 0.0, 5.0, 3.0_f64.ln()),
            (|x| (x - 1.0).powi(3), 0.5, 1.75, 1.0),
        ];
        for (index, (function, start, end, exact)) in cases.into_iter().enumerate() {
            let mut evaluations = 0;
            let count = |x| {
                evaluations += 1;
                function(x)
            };
            let tolerance = if index == 3 { 1e-5 } else { 0.0 };
            let found = zero((start, function(start)), (end, function(end)), tolerance, count);
            // the bracket ends 4 eps wide at least
            let allowed = (tolerance + 4.0 * f64::EPSILON) * exact;
            assert!((found - exact).abs() <= allowed, "{index}: {found} instead of {exact}");
            assert!(evaluations <= if index == 3 { 60 } else { 20 }, "{index}: {evaluations}");
        }
    }
}
