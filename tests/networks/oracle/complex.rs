//! The determinant of the dynamic stiffness at a complex frequency: its zeros are the eigenvalues of damped structures.

use super::global_matrix::sum;
use super::{Bending, Oracle, Rod, double};
use crate::stiffness_matrix::beam_matrix::{BeamMatrix, Field};
use crate::stiffness_matrix::determinant::{Determinant, determinant};
use crate::stiffness_matrix::discs::{C, SURE_TURN, Verdict, Zeros};
use crate::stiffness_matrix::{Assembled, Form};
use mstmm::number::{DoubleDouble, Parameter, Real, Scalar};
use mstmm::search::Eigenvalue;

/// Part of its terms of a sine or cosine below which a rod nearly vibrates with held ends.
const POLE: f64 = 0.05;

/// Argument below which the sine is small without a pole.
const SHORT: f64 = 0.5;

/// Where rods are cut: their parts do not vibrate with held ends when they do.
const CUT: f64 = 0.381_966_011_250_105;

/// `sin t` and `cos t` over `e^|Im t|`.
fn sine_and_cosine(t: C) -> [C; 2] {
    let ((sin, cos), y) = (t.re.sin_cos(), t.im.abs());
    let (one, half) = (double(1.0), double(0.5));
    let decay = (-(y + y)).exp();
    let ch = (one + decay) * half;
    let mut sh = (one - decay) * half;
    if y.to_f64() < SHORT {
        // the difference cancels
        let (mut term, mut total) = (y, y);
        for k in 1..16_i32 {
            term = term * y * y / double(f64::from(2 * k * (2 * k + 1)));
            total += term;
        }
        sh = total * (-y).exp();
    }
    let sh = if t.im < double(0.0) { -sh } else { sh };
    [C::new(sin * ch, cos * sh), C::new(cos * ch, -(sin * sh))]
}

/// Half of the phase of a rod at λ.
fn half_phase([l, ea, m]: [DoubleDouble; 3], lambda: C) -> C {
    lambda.omega() * C::of(l * (m / ea).sqrt() * double(0.5))
}

fn is_near_a_pole(rod: &Rod, lambda: C) -> bool {
    let t = half_phase(rod.parameters, lambda);
    let [sin, cos] = sine_and_cosine(t).map(Scalar::size);
    cos < POLE || (sin < POLE && t.size() > SHORT)
}

/// A matrix that is assembled.
struct Matrix {
    sum: Assembled<C>,
    lambda: C,
    unknowns: usize,
}

impl Matrix {
    fn unknown(&mut self) -> Form {
        self.unknowns += 1;
        vec![(self.unknowns - 1, double(1.0))]
    }

    fn add(&mut self, form: &Form, factor: C, rounding: f64) {
        self.sum.add(form, form, factor, rounding * factor.size());
    }

    fn rod(&mut self, [from, to]: &[Form; 2], parameters: [DoubleDouble; 3]) {
        let [l, ea, _] = parameters;
        let t = half_phase(parameters, self.lambda);
        let [sin, cos] = sine_and_cosine(t);
        let unit = C::of(ea / l) * t;
        let rounding = 4.0 * (1.0 + t.size()) / cos.size().min(1.0);
        self.add(&sum(to, double(-1.0), from), unit * cos / sin, rounding / sin.size().min(1.0).max(t.size().min(1.0)));
        self.add(&sum(to, double(1.0), from), -(unit * sin / cos), rounding);
    }

    fn bending(&mut self, ends: &[Form; 4], parameters: [DoubleDouble; 3]) {
        let matrix = BeamMatrix::of(parameters, self.lambda);
        for (i, a) in ends.iter().enumerate() {
            for (j, b) in ends.iter().enumerate() {
                self.sum.add(a, b, matrix.entries[i][j], matrix.size(i, j));
            }
        }
        let [y, theta, y_out, theta_out] = ends;
        let minus = double(-1.0);
        let off = [sum(&sum(y_out, minus, y), -parameters[0], theta), sum(theta_out, minus, theta)];
        for (a, row) in off.iter().zip(matrix.bending.iter().flatten()) {
            for (b, entry) in off.iter().zip(row) {
                self.sum.add(a, b, C::of(*entry), entry.to_f64().abs());
            }
        }
    }

    fn rod_in_two(&mut self, Rod { ends: [from, to], parameters: [l, ea, m] }: &Rod) {
        let middle = self.unknown();
        let cut = double(CUT);
        self.rod(&[from.clone(), middle.clone()], [*l * cut, *ea, *m]);
        self.rod(&[middle, to.clone()], [*l * (double(1.0) - cut), *ea, *m]);
    }

    fn bending_in_two(&mut self, Bending { ends, parameters: [l, ei, m] }: &Bending) {
        let [y_middle, theta_middle] = [self.unknown(), self.unknown()];
        let [y, theta, y_out, theta_out] = ends.clone();
        let half = [*l * double(0.5), *ei, *m];
        self.bending(&[y, theta, y_middle.clone(), theta_middle.clone()], half);
        self.bending(&[y_middle, theta_middle, y_out, theta_out], half);
    }
}

impl Zeros for Oracle {
    fn cuts(&self, lambda: C) -> Vec<bool> {
        let bending = |bending: &Bending| BeamMatrix::of(bending.parameters, lambda).is_near_a_pole();
        let rods = self.rods.iter().map(|rod| is_near_a_pole(rod, lambda));
        self.bendings.iter().map(bending).chain(rods).collect()
    }

    fn determinant(&self, lambda: C, cuts: &[bool]) -> Determinant {
        let mut sum = self.assembled(lambda, cuts);
        keep_used(&mut sum);
        determinant(&sum)
    }
}

impl Oracle {
    /// The dynamic stiffness at a complex frequency, with members in one piece or in two.
    pub(super) fn assembled(&self, lambda: C, cuts: &[bool]) -> Assembled<C> {
        let (bendings, rods) = cuts.split_at(self.bendings.len());
        let count = |cuts: &[bool]| cuts.iter().filter(|is_cut| **is_cut).count();
        let size = self.unknowns + 2 * count(bendings) + count(rods);
        let mut matrix = Matrix { sum: Assembled::zero(size), lambda, unknowns: self.unknowns };
        for (bending, &is_cut) in self.bendings.iter().zip(bendings) {
            if is_cut { matrix.bending_in_two(bending) } else { matrix.bending(&bending.ends, bending.parameters) }
        }
        for (rod, &is_cut) in self.rods.iter().zip(rods) {
            if is_cut { matrix.rod_in_two(rod) } else { matrix.rod(&rod.ends, rod.parameters) }
        }
        for link in &self.links {
            matrix.add(&link.form, C::of(link.stiffness), 1.0);
        }
        for dashpot in &self.dashpots {
            matrix.add(&dashpot.form, C::of(dashpot.stiffness) * lambda, 1.0);
        }
        for inertia in &self.masses {
            matrix.add(&inertia.form, C::of(inertia.mass) * lambda.lambda_squared(), 1.0);
        }
        matrix.sum
    }
}

/// Takes out unknowns that no element refers to.
fn keep_used(sum: &mut Assembled<C>) {
    let used: Vec<bool> = sum.sizes.iter().map(|row| row.iter().any(|&size| size != 0.0)).collect();
    super::global_matrix::keep(&mut sum.entries, &used);
    super::global_matrix::keep(&mut sum.sizes, &used);
}

impl Oracle {
    /// Whether the disc of an eigenvalue that is not zero holds it.
    pub(crate) fn judge_disc(&self, root: &Eigenvalue) -> Verdict {
        self.judge(root)
    }

    /// The modulus below which members in one piece have no frequency with held ends.
    pub(crate) fn first_held_frequency(&self) -> f64 {
        let bending = |[l, ei, m]: [DoubleDouble; 3]| (4.73 / l.to_f64()).powi(2) * (ei / m).to_f64().sqrt();
        let rod = |[l, ea, m]: [DoubleDouble; 3]| core::f64::consts::PI / l.to_f64() * (ea / m).to_f64().sqrt();
        let bendings = self.bendings.iter().map(|beam| bending(beam.parameters));
        bendings.chain(self.rods.iter().map(|beam| rod(beam.parameters))).fold(f64::INFINITY, f64::min)
    }

    /// Number of zeros in a rectangle that no pole of an uncut member reaches: turns of the determinant along its edge.
    /// `None` where rounding hides them.
    pub(crate) fn zeros_in(&self, [left, right]: [f64; 2], [lower, upper]: [f64; 2]) -> Option<u64> {
        let corners = [[left, lower], [right, lower], [right, upper], [left, upper]].map(|[re, im]| complex(re, im));
        let cuts = vec![false; self.bendings.len() + self.rods.len()];
        let value = |point: C| {
            let value = self.determinant(point, &cuts);
            (value.error < SURE_TURN).then_some(value.mantissa)
        };
        let mut turns = 0.0;
        for k in 0..4 {
            let (from, to) = (corners[k], corners[(k + 1) % 4]);
            turns += turned(&value, [from, to], [value(from)?, value(to)?], 0)?;
        }
        let turns = turns / core::f64::consts::TAU;
        ((turns - turns.round()).abs() < 1e-6 && turns > -0.5).then(|| turns.round() as u64)
    }
}

fn complex(re: f64, im: f64) -> C {
    C::new(double(re), double(im))
}

/// The first halvings of an edge, which are made in any case: three hid whole turns of one in a hundred regions.
const LEAST: u32 = 7;

/// Steps of the argument that are believed, beside those of both halves.
const STEP: f64 = 0.7;

/// How much the argument turns along an edge.
fn turned(value: &impl Fn(C) -> Option<C>, [from, to]: [C; 2], [first, last]: [C; 2], depth: u32) -> Option<f64> {
    let angle = |first: C, last: C| {
        let quotient = last / first;
        quotient.im.to_f64().atan2(quotient.re.to_f64())
    };
    let middle = (from + to) * C::of(double(0.5));
    let between = value(middle)?;
    let [one, other] = [angle(first, between), angle(between, last)];
    if depth >= LEAST && one.abs() < STEP && other.abs() < STEP {
        return Some(one + other);
    }
    if depth > 40 {
        return None;
    }
    let one = turned(value, [from, middle], [first, between], depth + 1)?;
    Some(one + turned(value, [middle, to], [between, last], depth + 1)?)
}
