//! A beam of halves of halves of a short piece, in 160 digits: nothing of wave numbers is in it.

use crate::element::BeamNumbers;
use crate::proof::ball::Ball;
use crate::proof::general_bending::{General, general_bending};
use crate::proof::level::Level;
use crate::proof::member::place;
use core::array::from_fn;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::vec::Vec;

pub(crate) type Exact = FBig<HalfEven, 2>;
type Matrix<const N: usize> = [[Exact; N]; N];

/// Bits of the exact numbers.
const BITS: usize = 540;

pub(crate) fn exact(number: f64) -> Exact {
    Exact::try_from(number).unwrap().with_precision(BITS).value()
}

fn pair([hi, lo]: [f64; 2]) -> Exact {
    exact(hi) + exact(lo)
}

pub(crate) fn near(number: &Exact) -> f64 {
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
pub(crate) struct Case {
    pub(crate) section: BeamNumbers,
    pub(crate) length: f64,
    pub(crate) square: f64,
}

/// A beam's stiffness in quarters, [[near, between], [betweenᵀ, far]], and the count with both ends held.
pub(crate) struct Held {
    quarters: [Matrix<2>; 3],
    pub(crate) count: u32,
}

impl Case {
    /// σ, τ, g, h in units of l and EI.
    fn equations(&self) -> [Exact; 4] {
        let section = self.section;
        let (one, square, length) = (exact(1.0), exact(self.square), exact(self.length));
        let tension = pair(section.axial_force) + pair(section.shear_layer);
        let flexibility = if section.shears() { &one / pair(section.shear_stiffness) } else { exact(0.0) };
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
        for n in 1..80 {
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
        // of d₂ = A d₁ + B f₁ and f₂ = C d₁ + D f₁
        let [a, b, d] = [block(0, 0), block(0, 2), block(2, 2)];
        let flexible = inverse(&b);
        let held = negated(product(&flexible, &a));
        let far = negated(product(&d, &flexible));
        Held { quarters: [forces(held), forces(flexible), forces(far)], count: 0 }
    }

    /// The whole, and that of its two halves: the stiffness of the point between them has the frequencies that are new.
    pub(crate) fn held(&self) -> Held {
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

    pub(crate) fn at<N: Level>(&self) -> General<N> {
        general_bending(&self.section, Ball::of(self.length), Ball::of(self.square), None)
    }
}

impl Held {
    /// The lower triangle over (y1, θ1, y2, θ2).
    pub(crate) fn entries(&self) -> Vec<Exact> {
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
