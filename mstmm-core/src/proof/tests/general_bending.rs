//! The general beam against halves of halves of a short piece, whose stiffness is a series of matrices in 160 digits.

use crate::element::BeamNumbers;
use crate::proof::ball::Ball;
use crate::proof::functions::Level;
use crate::proof::general_bending::{General, general_bending};
use crate::proof::member::place;
use crate::proof::number::{Number, OneWord, TwoWords};
use crate::proof::word::Word;
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::vec::Vec;

type Exact = FBig<HalfEven, 2>;
type Matrix<const N: usize> = [[Exact; N]; N];

/// Bits of the exact numbers.
const BITS: usize = 540;

fn exact(number: f64) -> Exact {
    Exact::try_from(number).unwrap().with_precision(BITS).value()
}

fn pair([hi, lo]: [f64; 2]) -> Exact {
    exact(hi) + exact(lo)
}

fn near(number: &Exact) -> f64 {
    number.to_f64().value()
}

fn product<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| (0..N).fold(exact(0.0), |sum, k| sum + &a[i][k] * &b[k][j])))
}

fn sum<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| &a[i][j] + &b[i][j]))
}

fn difference<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| &a[i][j] - &b[i][j]))
}

fn determinant(a: &Matrix<2>) -> Exact {
    &a[0][0] * &a[1][1] - &a[0][1] * &a[1][0]
}

fn inverse(a: &Matrix<2>) -> Matrix<2> {
    let over = exact(1.0) / determinant(a);
    let [[p, q], [r, s]] = a;
    [[s * &over, -(q * &over)], [-(r * &over), p * &over]]
}

/// A beam at a frequency.
#[derive(Clone, Copy, Debug)]
struct Case {
    section: BeamNumbers,
    length: f64,
    square: f64,
}

/// A beam's stiffness in quarters, [[near, between], [betweenᵀ, far]], and the count with both ends held.
struct Held {
    quarters: [Matrix<2>; 3],
    count: u32,
}

impl Case {
    /// σ, τ, g, h in units of l and EI.
    fn equations(&self) -> [Exact; 4] {
        let section = self.section;
        let (one, square, length) = (exact(1.0), exact(self.square), exact(self.length));
        let tension = pair(section.axial_force) + pair(section.shear_layer);
        let flexibility = pair(section.shear_flexibility);
        let scale = &length * &length / pair(section.bending_stiffness);
        let sigma = &one / (&one + &tension * &flexibility);
        let tau = &flexibility * &sigma / &scale;
        let g = (&sigma * tension - pair(section.rotary_inertia) * &square) * &scale;
        let h =
            (pair(section.mass_per_length) * square - pair(section.foundation_stiffness)) * scale * &length * length;
        [sigma, tau, g, h]
    }

    /// A piece of `2^-halvings` l: by the transfer matrix, a series.
    fn piece(equations: &[Exact; 4], halvings: i32) -> Held {
        let [sigma, tau, g, h] = equations;
        let part = exact(0.5f64.powi(halvings));
        let [sigma, tau, g, h] = [sigma, tau, g, h].map(|number| number * &part);
        // of the state (Y, Θ, M, Q): a column of the product has few terms
        let next = |row: &[Exact; 4]| {
            [&row[3] * &h, &row[0] * &sigma + &row[2] * &g, &row[1] * &part, &row[2] * &sigma - &row[0] * &tau]
        };
        let identity: Matrix<4> = from_fn(|i| from_fn(|j| exact(f64::from(u8::from(i == j)))));
        let (mut transfer, mut term) = (identity.clone(), identity);
        for n in 1..90 {
            term = from_fn(|i| next(&term[i]).map(|entry| entry / exact(f64::from(n))));
            transfer = sum(&transfer, &term);
        }
        let block = |row: usize, column: usize| -> Matrix<2> {
            from_fn(|i| from_fn(|j| transfer[row + i][column + j].clone()))
        };
        // the forces that do work on y and θ are (Q, -M) at the near end and (-Q, M) at the far one
        let forces = |m: Matrix<2>| -> Matrix<2> {
            let [moments, shears] = m;
            [shears, moments.map(|entry| -entry)]
        };
        let negated = |m: Matrix<2>| m.map(|row| row.map(|entry| -entry));
        // d₂ = A d₁ + B f₁, f₂ = C d₁ + D f₁
        let [a, b, c, d] = [block(0, 0), block(0, 2), block(2, 0), block(2, 2)];
        let flexible = inverse(&b);
        let held = negated(product(&flexible, &a));
        let far = negated(product(&d, &flexible));
        let _ = c;
        Held { quarters: [forces(held), forces(flexible), forces(far)], count: 0 }
    }

    /// The whole, and that of its two halves: the stiffness of the point between them has the frequencies that are new.
    fn held(&self) -> Held {
        let equations = self.equations();
        let [sigma, tau, g, h] = equations.each_ref().map(near);
        // No frequency of a held piece of a l is below, by ∫Y² <= A ∫Y'² and the same for Θ, A = (a/π)²: with e = Y' - σΘ its energy is
        // ∫Θ'² + e²/τ + gΘ² - hY², and Y'² <= 2σ²Θ² + 2e².
        let is_free = |part: f64| {
            let (square, h) = ((part / core::f64::consts::PI).powi(2), h.max(0.0));
            2.0 * h * tau * square < 0.9 && 0.9 + g * square - 2.0 * h * sigma * sigma * square * square > 0.0
        };
        let largest = [sigma, tau, g.abs(), h.abs(), 1.0].into_iter().fold(0.0, f64::max);
        let is_short = |halvings: i32| 0.5f64.powi(halvings) * largest < 0.5 && is_free(0.5f64.powi(halvings));
        let halvings = (0..200).find(|halvings| is_short(*halvings)).unwrap();
        let mut whole = Self::piece(&equations, halvings);
        for _ in 0..halvings {
            let [first, between, last] = &whole.quarters;
            let point = sum(first, last);
            let (det, trace) = (determinant(&point), &point[0][0] + &point[1][1]);
            let zero = exact(0.0);
            let negative = if det < zero {
                1
            } else if trace < zero {
                2
            } else {
                0
            };
            let flexible = inverse(&point);
            let transposed: Matrix<2> = from_fn(|i| from_fn(|j| between[j][i].clone()));
            let through = product(between, &flexible);
            whole = Held {
                quarters: [
                    difference(first, &product(&through, &transposed)),
                    product(&through, between).map(|row| row.map(|entry| -entry)),
                    difference(last, &product(&product(&transposed, &flexible), between)),
                ],
                count: 2 * whole.count + negative,
            };
        }
        whole
    }

    fn at<N: Level>(&self) -> General<N> {
        general_bending(&self.section, Ball::of(self.length), Ball::of(self.square))
    }
}

impl Held {
    /// The lower triangle over (y1, θ1, y2, θ2).
    fn entries(&self) -> Vec<Exact> {
        let [first, between, last] = &self.quarters;
        let mut entries = std::vec![exact(0.0); 10];
        for i in 0..2 {
            for j in 0..2 {
                entries[place(i, j)] = first[i][j].clone();
                entries[place(2 + i, 2 + j)] = last[i][j].clone();
                entries[place(2 + j, i)] = between[i][j].clone();
            }
        }
        entries
    }
}

/// What a number is exactly.
trait Parts: Level {
    fn exactly(self) -> Exact;
}

impl Parts for OneWord {
    fn exactly(self) -> Exact {
        exact(self.0)
    }
}

impl Parts for TwoWords<f64> {
    fn exactly(self) -> Exact {
        exact(self.hi) + exact(self.lo)
    }
}

/// What the tests saw.
#[derive(Debug, Default)]
struct Seen {
    cases: u32,
    /// Entries without a bound.
    unknown: u32,
    ranges: u32,
    beside: u32,
    /// The largest part of a bound that was needed.
    share: f64,
    /// The largest bound beside the largest entry of its kind.
    radius: f64,
}

impl Seen {
    fn look<N: Parts<Word = f64>>(&mut self, case: &Case, truth: &Held) {
        let General { member, is_beside_pole } = case.at::<N>();
        self.cases += 1;
        self.beside += u32::from(is_beside_pole);
        if member.stiffness.iter().any(|ball| !ball.rad.is_finite()) {
            self.unknown += 1;
            return;
        }
        let count = f64::from(truth.count);
        let [least, most] = member.held;
        assert!(least <= count && count <= most, "{count} is not in {least} to {most}: {case:?}");
        assert!(least == most || is_beside_pole);
        self.ranges += u32::from(least < most);
        for (entry, (ball, exactly)) in member.stiffness.iter().zip(truth.entries()).enumerate() {
            let off = near(&(ball.mid.exactly() - &exactly)).abs();
            assert!(off <= ball.rad, "entry {entry}: {off:e} of {:e}, {:e}: {case:?}", ball.rad, near(&exactly));
            self.share = self.share.max(off / ball.rad);
            if !is_beside_pole {
                self.radius = self.radius.max(ball.rad / near(&exactly).abs());
            }
        }
    }
}

/// Random numbers.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn decade(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(from + (to - from) * self.next())
    }

    /// A beam of some regime. The second words of its parameters are not zero.
    fn case(&mut self, kind: usize) -> Case {
        let tail = |number: f64, random: &mut Self| [number, number * 1e-17 * random.next()];
        let shear = self.decade(-5.0, 0.0);
        let tension = self.decade(-1.0, 3.0);
        let [f, r, n, k] = match kind % 8 {
            0 => [shear, self.decade(-5.0, 0.0), 0.0, 0.0],
            1 => [0.0, 0.0, tension, self.decade(-1.0, 5.0)],
            2 => [0.0, self.decade(-5.0, -1.0), -tension, 0.0],
            3 => [shear, self.decade(-5.0, 0.0), -(0.9 / shear).min(tension), self.decade(-1.0, 5.0)],
            4 => [0.0, 0.0, -tension, self.decade(1.0, 5.0)],
            5 => [shear, 0.0, tension, 0.0],
            6 => [self.decade(-3.0, 0.0), self.decade(-3.0, 0.0), 0.0, self.decade(-1.0, 3.0)],
            _ => [shear, self.decade(-5.0, 0.0), tension, self.decade(-1.0, 5.0)],
        };
        let square = match kind % 5 {
            0 => -self.decade(-2.0, 4.0),
            1 if r * f > 0.0 => self.decade(0.0, 1.0) / (r * f),
            _ => self.decade(-2.0, 5.0),
        };
        let [bending, mass, length] = [self.decade(-0.5, 0.5), self.decade(-0.5, 0.5), self.decade(-0.3, 0.3)];
        let section = BeamNumbers {
            bending_stiffness: tail(bending, self),
            mass_per_length: tail(mass, self),
            shear_flexibility: tail(f, self),
            shear_stiffness: [0.0; 2],
            rotary_inertia: tail(r, self),
            axial_force: tail(n, self),
            shear_layer: if kind % 3 == 0 { tail(0.3 * n.abs(), self) } else { [0.0; 2] },
            foundation_stiffness: tail(k, self),
            ..BeamNumbers::default()
        };
        Case { section, length, square }
    }
}

fn random_beams(seed: u64, count: usize) {
    let mut random = Random(seed);
    let mut seen = [Seen::default(), Seen::default()];
    for kind in 0..count {
        let case = random.case(kind);
        let truth = case.held();
        seen[0].look::<OneWord>(&case, &truth);
        seen[1].look::<TwoWords<f64>>(&case, &truth);
    }
    std::println!("{seen:#?}");
    assert!(seen[0].share < 1.0 && seen[1].share < 1.0);
    assert!(seen[1].unknown == 0 && seen[1].ranges == 0);
}

#[test]
fn a_few_random_beams() {
    random_beams(1, 60);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_random_beams() {
    random_beams(2, 20_000);
}
