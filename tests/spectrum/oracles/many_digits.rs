//! One general beam between two supports, in as many digits as its waves need.
//!
//! The equations `z' = A z` are solved by `exp A = c₀ + c₁ A + c₂ A² + c₃ A³` with the coefficients as divided differences of `cosh √κ` and
//! `sinh √κ/√κ`, without any care for cancellation: more digits stand for it. Nothing of the compound matrix is in it.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;

/// A number of many digits.
pub(crate) type Exact = FBig<HalfEven, 2>;

type Rows = [[Exact; 4]; 4];

/// A beam between two supports.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) beam: GeneralBeam<f64>,
    pub(crate) tip: Support,
    pub(crate) root: Support,
}

/// A root as the oracle knows it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    /// `exact / ω - 1` of the ω at which it was looked for.
    pub(crate) away: f64,
    /// Sum of the relative changes of the root with each parameter.
    pub(crate) condition: f64,
}

/// Relative step of a difference quotient, an exact power of two.
const STEP: f64 = 1.0 / (1_u64 << 40) as f64;

/// Entries Y, Θ, M, Q of a state that a support holds at zero, and those that it leaves.
fn held(support: Support) -> ([usize; 2], [usize; 2]) {
    match support {
        Support::Fixed => ([0, 1], [2, 3]),
        Support::Pinned => ([0, 2], [1, 3]),
        Support::Guided => ([1, 3], [0, 2]),
        _ => ([2, 3], [0, 1]),
    }
}

impl Case {
    /// The determinant of the boundary conditions at ω.
    pub(crate) fn determinant(&self, omega: &Exact, bits: usize) -> Exact {
        let number = |value: f64| exact(value, bits);
        let GeneralBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness,
            rotary_inertia,
            axial_force,
            foundation_stiffness,
            foundation_shear_stiffness,
        } = self.beam;
        let [l, ei, m] = [length, bending_stiffness, mass_per_length].map(number);
        let is_sheared = shear_stiffness < f64::INFINITY;
        let f = if is_sheared { number(1.0) / number(shear_stiffness) } else { number(0.0) };
        let tension = number(axial_force) + number(foundation_shear_stiffness);
        let square = omega * omega;
        let sigma = number(1.0) / (number(1.0) + &tension * &f);
        let scale = &l * &l / &ei;
        let tau = &f * &sigma / &scale;
        let g = (&sigma * &tension - number(rotary_inertia) * &square) * &scale;
        let h = (m * &square - number(foundation_stiffness)) * scale * &l * &l;
        let u = exponential(&[sigma, tau, g, h], bits);
        let ((rows, _), (_, columns)) = (held(self.root), held(self.tip));
        let entry = |row: usize, column: usize| &u[rows[row]][columns[column]];
        entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0)
    }

    /// The root nearest to ω, if ω has all its digits but the last ones.
    pub(crate) fn root_near(&self, omega: f64) -> Found {
        let bits = self.bits(omega);
        let at = exact(omega, bits);
        let step = &at * exact(STEP, bits);
        let value = self.determinant(&at, bits);
        let slope = (self.determinant(&(&at + &step), bits) - &value) / &step;
        let away = -(value / &slope) / &at;
        let root = &at * (exact(1.0, bits) + &away);
        let mut condition = 0.0;
        for changed in self.with_changes() {
            let change = changed.determinant(&root, bits) / (&slope * &step);
            condition += change.to_f64().value().abs();
        }
        Found { away: away.to_f64().value(), condition }
    }

    /// Whether the determinant changes its sign between two frequencies.
    pub(crate) fn changes_between(&self, lower: f64, upper: f64) -> bool {
        let bits = self.bits(upper);
        let [a, b] = [lower, upper].map(|omega| self.determinant(&exact(omega, bits), bits));
        (a > exact(0.0, bits)) != (b > exact(0.0, bits))
    }

    /// The case with each parameter changed by the relative step.
    fn with_changes(&self) -> Vec<Case> {
        let beam = self.beam;
        let more = |value: f64| value * (1.0 + STEP);
        let beams = [
            GeneralBeam { length: more(beam.length), ..beam },
            GeneralBeam { bending_stiffness: more(beam.bending_stiffness), ..beam },
            GeneralBeam { mass_per_length: more(beam.mass_per_length), ..beam },
            GeneralBeam { shear_stiffness: more(beam.shear_stiffness), ..beam },
            GeneralBeam { rotary_inertia: more(beam.rotary_inertia), ..beam },
            GeneralBeam { axial_force: more(beam.axial_force), ..beam },
            GeneralBeam { foundation_stiffness: more(beam.foundation_stiffness), ..beam },
            GeneralBeam { foundation_shear_stiffness: more(beam.foundation_shear_stiffness), ..beam },
        ];
        beams.map(|beam| Case { beam, ..*self }).into()
    }

    /// Bits that are enough for waves of this frequency: squares of their growth cancel.
    fn bits(&self, omega: f64) -> usize {
        let GeneralBeam { length: l, bending_stiffness: ei, mass_per_length: m, .. } = self.beam;
        let scale = l * l / ei;
        let tension = self.beam.axial_force + self.beam.foundation_shear_stiffness;
        let h = (m * omega * omega + self.beam.foundation_stiffness) * scale * l * l;
        let g = (tension.abs() + self.beam.rotary_inertia * omega * omega) * scale;
        let tau = 1.0 / self.beam.shear_stiffness / scale;
        let wave = (h.sqrt() + g + tau * h).sqrt();
        (3.0 * wave) as usize + 400
    }
}

pub(crate) fn exact(value: f64, bits: usize) -> Exact {
    #[expect(clippy::unwrap_used, reason = "tests have finite numbers")]
    let number = Exact::try_from(value).unwrap();
    number.with_precision(bits).value()
}

fn product(a: &Rows, b: &Rows) -> Rows {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let [one, two, three, four] = [0, 1, 2, 3].map(|k: usize| &a[i][k] * &b[k][j]);
            one + two + three + four
        })
    })
}

/// `exp A` of the equations with σ, τ, g, h.
fn exponential([sigma, tau, g, h]: &[Exact; 4], bits: usize) -> Rows {
    let zero = || exact(0.0, bits);
    let one = || exact(1.0, bits);
    let a: Rows = [
        [zero(), sigma.clone(), zero(), -tau.clone()],
        [zero(), zero(), one(), zero()],
        [zero(), g.clone(), zero(), sigma.clone()],
        [h.clone(), zero(), zero(), zero()],
    ];
    let tau_h = tau * h;
    let sum = g - &tau_h;
    let cut = sigma * sigma + tau * g;
    let product_of_squares = -(h * cut);
    let c = coefficients(&sum, &product_of_squares, bits);
    let second = product(&a, &a);
    let third = product(&second, &a);
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let identity = if i == j { one() } else { zero() };
            &c[0] * identity + &c[1] * &a[i][j] + &c[2] * &second[i][j] + &c[3] * &third[i][j]
        })
    })
}

/// `c₀..c₃` of a matrix with the squared eigenvalues of this sum and product, each of them twice.
fn coefficients(sum: &Exact, product: &Exact, bits: usize) -> [Exact; 4] {
    let number = |value: f64| exact(value, bits);
    let half = number(0.5);
    let square = sum * sum - number(4.0) * product;
    if square >= number(0.0) {
        let root = square.sqrt();
        let [first, second] = [(sum + &root) * &half, (sum - &root) * &half];
        let ([c1, s1], [c2, s2]) = (even(&first, bits), even(&second, bits));
        return [
            (&first * &c2 - &second * &c1) / &root,
            (&first * &s2 - &second * &s1) / &root,
            (c1 - c2) / &root,
            (s1 - s2) / &root,
        ];
    }
    // κ = r ± iw, √κ = p + iq
    let (r, w) = (sum * &half, (-square).sqrt() * &half);
    let p = ((product.sqrt() + &r) * &half).sqrt();
    let q = &w / (number(2.0) * &p);
    let growth = p.exp();
    let decay = number(1.0) / &growth;
    let (cosh, sinh) = ((&growth + &decay) * &half, (&growth - &decay) * &half);
    let (sin, cos) = (q.sin(), q.cos());
    let [c_re, c_im] = [&cosh * &cos, &sinh * &sin];
    let [n_re, n_im] = [&sinh * &cos, &cosh * &sin];
    let modulus = &p * &p + &q * &q;
    let s_re = (&n_re * &p + &n_im * &q) / &modulus;
    let s_im = (&n_im * &p - &n_re * &q) / &modulus;
    [(&w * &c_re - &r * &c_im) / &w, (&w * &s_re - &r * &s_im) / &w, c_im / &w, s_im / &w]
}

/// `cosh √κ` and `sinh √κ/√κ` of a real κ.
fn even(square: &Exact, bits: usize) -> [Exact; 2] {
    let number = |value: f64| exact(value, bits);
    if *square == number(0.0) {
        return [number(1.0), number(1.0)];
    }
    if *square < number(0.0) {
        let root = (-square.clone()).sqrt();
        return [root.cos(), root.sin() / &root];
    }
    let root = square.sqrt();
    let growth = root.exp();
    let decay = number(1.0) / &growth;
    let half = number(0.5);
    [(&growth + &decay) * &half, (&growth - &decay) * &half / root]
}
