//! Eigenvalues as zeros of the determinant of the dynamic stiffness: whether a disc holds as many as it says.

use super::determinant::{Determinant, determinant};
use super::{Reduced, Stiffness, Verdict, parameters};
use crate::stiffness_matrix::beam_matrix::BeamMatrix;
use mstmm::Complex;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::search::Eigenvalue;

type C = Complex<DoubleDouble>;

/// Relative error of a determinant half a radius from its zero, which then is sure to this part of the radius.
const SURE: f64 = 1e-3;

/// Relative error of a determinant whose argument is sure.
const SURE_TURN: f64 = 0.1;

/// Distance of a power from a whole number: others that are 100 times farther away move it by less each.
const WHOLE: f64 = 0.05;

/// No eigenvalue of any model but one of which everything is.
const GENERIC: Complex<f64> = Complex::new(0.371_305, 0.773_205);

/// Part of a radius to which an eigenvalue is made out.
const SETTLED: f64 = 1e-4;

/// Part of the next eigenvalue within which eigenvalues that are said to be zero are sought.
const AT_REST: f64 = 1e-2;

fn complex(z: Complex<f64>) -> C {
    C::new(DoubleDouble::from(z.re), DoubleDouble::from(z.im))
}

fn modulus(z: C) -> f64 {
    z.re.to_f64().hypot(z.im.to_f64())
}

impl Reduced {
    /// The beams that nearly vibrate with held ends at λ; their stiffness has poles there, that of their halves has none.
    fn cuts(&self, lambda: C) -> Vec<bool> {
        self.beams.iter().map(|beam| BeamMatrix::of(parameters(&beam.beam), lambda).is_near_a_pole()).collect()
    }

    fn determinant(&self, lambda: C, cuts: &[bool]) -> Determinant {
        let (size, pieces) = self.pieces(lambda, |_, index| cuts[index]);
        determinant(&self.assembled(lambda, size, &pieces))
    }

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

impl Stiffness {
    /// The eigenvalue next to λ, to a small part of a radius; `None` if there is none or rounding hides it.
    #[allow(dead_code, reason = "others ask for discs")]
    pub(crate) fn eigenvalue_near(&self, lambda: C, radius: f64) -> Option<C> {
        self.at(modulus(lambda)).nearest(lambda, radius)
    }

    /// Whether so many eigenvalues are zero as a disc says. Just above zero, stiffnesses hide what mass and damping add to
    /// them, and the rounding of lengths holds what is free: there, a larger circle is as good, if it is far below the next
    /// eigenvalue.
    fn judge_zero(&self, root: &Eigenvalue, next: f64) -> Verdict {
        let (mut radius, mut verdict) = (root.error, Verdict::CannotTell);
        while radius < AT_REST * next && radius < 1.0 / root.error {
            match self.at(radius).power(radius) {
                Some(held) if held == root.multiplicity => return Verdict::Holds,
                // where no other is listed, larger circles may hold some
                Some(held) if held > root.multiplicity && next.is_infinite() => return verdict,
                Some(_) => verdict = Verdict::Misses(radius / root.error),
                None => {}
            }
            radius *= 16.0;
        }
        verdict
    }

    /// Number of eigenvalues up to a modulus, of a model without beams.
    #[allow(dead_code, reason = "others ask for discs")]
    pub(crate) fn eigenvalues_within(&self, radius: f64) -> Option<u64> {
        self.at(radius).power(radius)
    }

    /// Whether nothing is held twice, and nothing is without stiffness, damping and mass.
    #[allow(dead_code, reason = "others take sound models only")]
    pub(crate) fn is_sound(&self) -> bool {
        let model = self.at(modulus(complex(GENERIC)));
        let determinant = model.determinant(complex(GENERIC), &model.cuts(complex(GENERIC)));
        !self.is_held_twice && determinant.error < SURE_TURN
    }

    /// Whether each disc of a list holds its eigenvalues.
    pub(crate) fn judge_discs(&self, list: &[Eigenvalue]) -> Vec<Verdict> {
        let is_zero = |root: &Eigenvalue| root.lambda.norm() <= root.error;
        let next =
            list.iter().filter(|root| !is_zero(root)).map(|root| root.lambda.norm()).fold(f64::INFINITY, f64::min);
        let verdict = |root: &Eigenvalue| {
            if is_zero(root) { self.judge_zero(root, next) } else { self.at(root.lambda.norm()).judge(root) }
        };
        list.iter().map(verdict).collect()
    }
}
