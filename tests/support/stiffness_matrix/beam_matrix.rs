//! The dynamic stiffness of a beam between the displacements `[Y, Θ]` of its two ends (Kolousek's functions).

use mstmm::Complex;
use mstmm::number::{DoubleDouble, Parameter, Real, Scalar, Single};

/// Below this size of `z`, the functions are summed up: their differences cancel. The static stiffness is kept apart, that of
/// the bending, which leaves no rigid motion to rounding.
pub(crate) const SERIES: f64 = 3.0;

/// Terms of the sums: the next is below 1e-36 of the first.
const TERMS: u32 = 13;

/// Part of its terms of `1 - ch cos` below which the beam nearly vibrates with held ends. Halves of such a beam do not.
const POLE: f64 = 0.05;

/// A number of double-double parts: ω of an undamped system, or λ.
pub(crate) trait Field: Single {
    fn of(value: DoubleDouble) -> Self;
    fn lambda_squared(self) -> Self;
    /// `Cλ`; an undamped system has none.
    fn damping(self, damping: f64) -> Self;
    /// A root of `-λ²`, of which the positive side counts: ω.
    fn omega(self) -> Self;
    /// `[ch cos, ch sin, sh cos, sh sin, ch, cos, sh, sin, 1]` of z, all divided by one number so that none is large.
    fn waves(self) -> [Self; 9];
}

fn double(value: f64) -> DoubleDouble {
    DoubleDouble::from(value)
}

impl Field for DoubleDouble {
    fn of(value: DoubleDouble) -> Self {
        value
    }

    fn lambda_squared(self) -> Self {
        -(self * self)
    }

    fn damping(self, _damping: f64) -> Self {
        double(0.0)
    }

    fn omega(self) -> Self {
        self
    }

    fn waves(self) -> [Self; 9] {
        let ((sin, cos), e) = (self.sin_cos(), (-self).exp());
        let (ch, sh) = ((double(1.0) + e * e) * double(0.5), (double(1.0) - e * e) * double(0.5));
        [ch * cos, ch * sin, sh * cos, sh * sin, ch, cos * e, sh, sin * e, e]
    }
}

type C = Complex<DoubleDouble>;

/// `e^z`.
fn exponential(z: C) -> C {
    let ((sin, cos), size) = (z.im.sin_cos(), z.re.exp());
    C::new(cos * size, sin * size)
}

impl Field for C {
    fn of(value: DoubleDouble) -> Self {
        C::new(value, double(0.0))
    }

    fn lambda_squared(self) -> Self {
        self * self
    }

    fn damping(self, damping: f64) -> Self {
        C::new(self.re * double(damping), self.im * double(damping))
    }

    fn omega(self) -> Self {
        let omega = C::new(self.im, -self.re);
        if omega.re < double(0.0) { -omega } else { omega }
    }

    fn waves(self) -> [Self; 9] {
        // `cos z = (1 + f²)/(2 f)` with f that decays, `sin z = ±i (1 - f²)/(2 f)`
        let upper = self.im >= double(0.0);
        let turned = if upper { C::new(-self.im, self.re) } else { C::new(self.im, -self.re) };
        let (e, f) = (exponential(-self), exponential(turned));
        let (one, half) = (Self::of(double(1.0)), Self::of(double(0.5)));
        let i = C::new(double(0.0), double(if upper { 1.0 } else { -1.0 }));
        let (ch, sh) = ((one + e * e) * half, (one - e * e) * half);
        let (cos, sin) = ((one + f * f) * half, i * (one - f * f) * half);
        [ch * cos, ch * sin, sh * cos, sh * sin, ch * f, cos * e, sh * f, sin * e, e * f]
    }
}

/// `Σ x^k/(4k + first)!` for k from 1 on.
fn series<S: Field>(x: S, first: u32) -> S {
    let (mut term, mut sum) = (x, S::zero());
    for n in 1..=first + 4 {
        term = term / S::from_f64(f64::from(n));
    }
    for k in 1..TERMS {
        sum += term;
        let n = f64::from(4 * k + first);
        term = term * x / S::from_f64((n + 1.0) * (n + 2.0) * (n + 3.0) * (n + 4.0));
    }
    sum
}

/// A beam at a frequency.
#[derive(Clone, Copy)]
pub(crate) struct BeamMatrix<S> {
    pub(crate) entries: [[S; 4]; 4],
    /// The static stiffness between the deflection and the rotation of the output end, which does not belong to the
    /// entries.
    pub(crate) bending: Option<[[DoubleDouble; 2]; 2]>,
    z: S,
    /// `(1 - ch cos)/z⁴`, and part of it that its terms are.
    held: S,
    share: f64,
    /// `EI/l³`.
    unit: f64,
    length: f64,
}

impl<S: Field> BeamMatrix<S> {
    /// The matrix of a beam of length, bending stiffness and mass per length.
    pub(crate) fn of([l, ei, m]: [DoubleDouble; 3], x: S) -> Self {
        let z_squared = x.omega() * S::of(l * l * (m / ei).sqrt());
        let z = z_squared.sqrt();
        let is_short = z.size() < SERIES;
        let fourth = z_squared * z_squared;
        let ([near, mixed, turn, far, far_mixed, far_turn, held], share) =
            if is_short { (short(fourth), 1.0) } else { long(z, z_squared) };
        // one factor `EI/l³ · 1/held`, and a length for each rotation
        let stiffness = ei / (l * l * l);
        let unit = S::of(stiffness) / held;
        let (unit_l, unit_ll) = (unit * S::of(l), unit * S::of(l * l));
        let (y, mixed, theta) = (near * unit, mixed * unit_l, turn * unit_ll);
        let (y_far, mixed_far, theta_far) = (far * unit, far_mixed * unit_l, far_turn * unit_ll);
        let entries = [
            [y, mixed, -y_far, mixed_far],
            [mixed, theta, -mixed_far, theta_far],
            [-y_far, -mixed_far, y, -mixed],
            [mixed_far, theta_far, -mixed, theta],
        ];
        let at_rest = |factor: f64, arms: DoubleDouble| stiffness * arms * double(factor);
        let bending = [[at_rest(12.0, double(1.0)), at_rest(-6.0, l)], [at_rest(-6.0, l), at_rest(4.0, l * l)]];
        let bending = is_short.then_some(bending);
        BeamMatrix { entries, bending, z, held, share, unit: stiffness.to_f64(), length: l.to_f64() }
    }

    /// Size of the terms of an entry, with what the argument of sine and cosine adds to their rounding.
    pub(crate) fn size(&self, i: usize, j: usize) -> f64 {
        let (z, l) = (self.z.size(), self.length);
        let terms = match (self.bending, i % 2 + j % 2) {
            (Some(_), rotations) => z.powi(4) * l.powi(rotations as i32),
            (None, 0) => z * z * z,
            (None, 1) => z * z * l,
            (None, _) => z * l * l,
        };
        self.unit * terms * (1.0 + z) / self.share.min(1.0)
    }

    /// Whether it nearly vibrates with held ends.
    pub(crate) fn is_near_a_pole(&self) -> bool {
        self.share < POLE
    }
}

impl BeamMatrix<DoubleDouble> {
    /// Number of the beam's frequencies with both ends clamped; `None` where z is no number.
    pub(crate) fn held_frequencies_below(&self) -> Option<u64> {
        let waves = self.z.to_f64() / core::f64::consts::PI;
        if !waves.is_finite() || !self.held.to_f64().is_finite() {
            return None;
        }
        let (whole, is_positive) = (waves.floor() as u64, self.held > double(0.0));
        Some(whole - u64::from(is_positive == (whole % 2 == 1)))
    }
}

/// `[ch s + sh c, sh s, ch s - sh c, s + sh, ch - c, sh - s]` over powers of z that leave entire functions of `z⁴`, each
/// less its static value times `(1 - ch c)/z⁴`; and that.
fn short<S: Field>(fourth: S) -> [S; 7] {
    let number = S::from_f64;
    let both = -(fourth * number(4.0));
    let held = number(4.0) * series(both, 4);
    let less = |value: S, at_rest: f64| value - number(at_rest) * held;
    [
        less(number(2.0) * series(both, 1), 12.0),
        less(number(2.0) * series(both, 2), 6.0),
        less(number(4.0) * series(both, 3), 4.0),
        less(number(2.0) * series(fourth, 1), 12.0),
        less(number(2.0) * series(fourth, 2), 6.0),
        less(number(2.0) * series(fourth, 3), 2.0),
        held + number(1.0) / number(6.0),
    ]
}

/// The same by sines and exponentials; and the part of its terms that is left of `1 - ch c`.
fn long<S: Field>(z: S, z_squared: S) -> ([S; 7], f64) {
    let [ch_cos, ch_sin, sh_cos, sh_sin, ch, cos, sh, sin, one] = z.waves();
    let (third, fourth) = (z_squared * z, z_squared * z_squared);
    let held = one - ch_cos;
    let share = held.size() / 0.5;
    let functions = [
        (ch_sin + sh_cos) / z,
        sh_sin / z_squared,
        (ch_sin - sh_cos) / third,
        (sin + sh) / z,
        (ch - cos) / z_squared,
        (sh - sin) / third,
        held / fourth,
    ];
    (functions, share)
}
