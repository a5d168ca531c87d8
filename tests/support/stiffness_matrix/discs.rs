//! Eigenvalues as zeros of the determinant of a dynamic stiffness: whether a disc holds as many as it says.

use super::determinant::Determinant;
use mstmm::Complex;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::search::Eigenvalue;

pub(crate) type C = Complex<DoubleDouble>;

/// Relative error of a determinant half a radius from its zero, which then is sure to this part of the radius.
pub(crate) const SURE: f64 = 1e-3;

/// Relative error of a determinant whose argument is sure.
pub(crate) const SURE_TURN: f64 = 0.1;

/// Distance of a power from a whole number: others that are 100 times farther away move it by less each.
const WHOLE: f64 = 0.05;

/// Part of a radius to which an eigenvalue is made out.
const SETTLED: f64 = 1e-4;

/// What the model says of a certified root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    Holds,
    /// The root is so many half widths or radii from the middle; of intervals and clusters, up to a factor of two less.
    Misses(f64),
    /// Rounding may have changed a sign of the model itself.
    CannotTell,
}

pub(crate) fn complex(z: Complex<f64>) -> C {
    C::new(DoubleDouble::from(z.re), DoubleDouble::from(z.im))
}

pub(crate) fn modulus(z: C) -> f64 {
    z.re.to_f64().hypot(z.im.to_f64())
}

/// A model whose eigenvalues are the zeros of a determinant.
pub(crate) trait Zeros {
    /// The beams that nearly vibrate with held ends at λ; their stiffness has poles there, that of their parts has none.
    fn cuts(&self, lambda: C) -> Vec<bool>;

    /// The determinant with beams cut in two.
    fn determinant(&self, lambda: C, cuts: &[bool]) -> Determinant;

    /// The eigenvalue to which Newton's method leads from λ, to a small part of a radius; `None` if it leads nowhere or
    /// rounding hides where.
    fn nearest(&self, start: C, radius: f64) -> Option<C> {
        let cuts = self.cuts(start);
        let mut lambda = start;
        for _ in 0..20 {
            let h = C::new(DoubleDouble::from(0.5 * radius), DoubleDouble::from(0.0));
            let [before, here, after] = [lambda - h, lambda, lambda + h].map(|point| self.determinant(point, &cuts));
            let unit = before.exponent.max(after.exponent);
            let slope = (after.over_power(unit) - before.over_power(unit)) / (h + h);
            let step = here.over_power(unit) / slope;
            if !modulus(step).is_finite() {
                return None;
            }
            lambda -= step;
            if modulus(step) < SETTLED * radius {
                return (before.error < SURE && after.error < SURE).then_some(lambda);
            }
        }
        None
    }

    /// Number of eigenvalues in a circle that is said to hold so many: the turns of the determinant along it.
    fn winding(&self, centre: C, radius: f64, expected: u64) -> Option<u64> {
        let cuts = self.cuts(centre);
        // a whole turn between two points would not be seen
        let mut points = 16 * u32::try_from(expected).ok()?;
        for _ in 0..3 {
            let value = |k: u32| {
                let angle = core::f64::consts::TAU * (f64::from(k) + 0.3) / f64::from(points);
                let value = self.determinant(centre + complex(Complex::from_polar(radius, angle)), &cuts);
                (value.error < SURE_TURN).then_some(value.mantissa)
            };
            let values = (0..points).map(value).collect::<Option<Vec<C>>>()?;
            let turn = |k: usize| {
                let quotient = values[(k + 1) % values.len()] / values[k];
                quotient.im.to_f64().atan2(quotient.re.to_f64())
            };
            let turns: Vec<f64> = (0..values.len()).map(turn).collect();
            if turns.iter().all(|turn| turn.abs() < 1.0) {
                let sum = turns.iter().sum::<f64>() / core::f64::consts::TAU;
                return (sum > -0.5).then(|| sum.round() as u64);
            }
            points *= 4;
        }
        None
    }

    /// Number of eigenvalues up to a modulus that is far from all of theirs: the determinant grows by that power of λ.
    fn power(&self, radius: f64) -> Option<u64> {
        let near = complex(Complex::from_polar(radius, 1.1));
        let cuts = self.cuts(near);
        let [first, second] = [near, near + near].map(|point| self.determinant(point, &cuts));
        let growth = modulus(second.over_power(first.exponent)) / modulus(first.mantissa);
        let power = growth.log2();
        let is_whole = (power - power.round()).abs() < WHOLE;
        (first.error < SURE && second.error < SURE && is_whole && power > -WHOLE).then(|| power.round() as u64)
    }

    /// Whether the disc of an eigenvalue that is not zero holds it.
    fn judge(&self, root: &Eigenvalue) -> Verdict {
        if root.multiplicity > 1 {
            return self.judge_by_turns(root);
        }
        let centre = complex(root.lambda);
        let Some(nearest) = self.nearest(centre, root.error) else { return self.judge_by_turns(root) };
        let radii = modulus(nearest - centre) / root.error;
        if radii <= 1.0 {
            return Verdict::Holds;
        }
        // in a cluster, the method may have left the disc
        match self.winding(centre, root.error, 1) {
            Some(1) => Verdict::Holds,
            _ if radii < 1.0 + 2.0 * SURE => Verdict::CannotTell,
            _ => Verdict::Misses(radii),
        }
    }

    fn judge_by_turns(&self, root: &Eigenvalue) -> Verdict {
        let (centre, mut radius) = (complex(root.lambda), root.error);
        for doublings in 0..40 {
            match self.winding(centre, radius, root.multiplicity) {
                None => return Verdict::CannotTell,
                Some(held) if held == root.multiplicity && doublings == 0 => return Verdict::Holds,
                Some(held) if held >= root.multiplicity => return Verdict::Misses(radius / root.error),
                Some(_) => radius *= 2.0,
            }
        }
        Verdict::CannotTell
    }
}
