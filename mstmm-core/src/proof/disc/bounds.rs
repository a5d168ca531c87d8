//! Bounds of the solution on a disc, and whether they leave one zero of g in it. Norms are those of the largest entry.

use crate::proof::disc::complex::{larger, modulus};
use crate::proof::disc::room::{Examined, Room, Unknown};
use crate::proof::level::Level;
use crate::proof::member::place;
use crate::proof::number::U;
use num_complex::Complex;

/// A sum of a million positive numbers, and a few operations more, lose a relative `1e6 u`, which is 1.2e-10.
const ADDED_UP: f64 = 1.0 + 1e-9;

/// What a sum loses where products underflow: a million times the least number is 5e-318, and factors are below 1e30 in the units of the matrix.
const UNDERFLOWN: f64 = 1e-280;

/// It multiplies what a few operations have rounded. Each loses a relative 1.1e-16, so that all lose less than 1e-12.
const FEW: f64 = 1.0 - 1e-12;

/// A bound that is a rounded sum of products of positive numbers, with what underflows in it.
pub(crate) fn inflated(bound: f64) -> f64 {
    bound * ADDED_UP + UNDERFLOWN
}

/// No less than the size of a number.
fn size(number: Complex<f64>) -> f64 {
    number.re.abs() + number.im.abs()
}

/// What is known of the bordered matrix and its inverse at the centre.
pub(crate) struct Bounds {
    /// Number of variables.
    count: usize,
    /// The radius.
    most: f64,
}

/// What g and its derivative are on the disc.
struct OnDisc {
    /// A bound of |g| at the centre.
    value: f64,
    /// The size of the slope from which those on the disc differ by no more than `off`.
    slope: f64,
    off: f64,
}

impl Bounds {
    /// Bounds what is the same for all bounds of derivatives: of each row of `I - R M` the part that is no error of M, and that of `|R|` times the
    /// rounding of the product.
    pub(crate) fn new<N: Level<Word = f64, Alone = N>>(room: &mut Room<'_, N>, count: usize, most: f64) -> Self {
        let n = count + 1;
        // a product of complex numbers and its sum: of each part 2n + 4 roundings, of which the sizes of both parts are bounds
        let rounding = (2.0 * n as f64 + 8.0) * U * 1.01;
        for row in 0..n {
            let of_row = &room.matrix[row * n..(row + 1) * n];
            room.unknowns[row].row = of_row.iter().map(|entry| size(*entry)).sum();
        }
        for row in 0..n {
            let of_inverse = &room.inverse[row * n..(row + 1) * n];
            let mut sum = rounding;
            for column in 0..n {
                let mut product = Complex::new(if row == column { 1.0 } else { 0.0 }, 0.0);
                for (k, factor) in of_inverse.iter().enumerate() {
                    product -= factor * room.matrix[k * n + column];
                }
                sum += size(product);
            }
            for (k, factor) in of_inverse.iter().enumerate() {
                sum += size(*factor) * rounding * room.unknowns[k].row;
            }
            room.unknowns[row].product = inflated(sum);
        }
        Bounds { count, most }
    }

    /// What the bounds say, with those of derivatives in memory.
    pub(crate) fn examined<N: Level<Word = f64, Alone = N>>(&self, room: &mut Room<'_, N>) -> Examined {
        self.set_sums(room);
        let step = self.step(room);
        let radius = self.on_disc(room).and_then(|OnDisc { value, slope, off }| {
            let least = slope * FEW - off;
            // larger than the quotient, which is no disc yet, and than its rounding
            let radius = value / least * ADDED_UP + self.most * 1e-9;
            (least > 0.0 && radius <= self.most).then_some(radius)
        });
        Examined { radius, step }
    }

    /// Newton's step to the zero of g.
    pub(crate) fn step<N: Level<Word = f64, Alone = N>>(&self, room: &Room<'_, N>) -> Complex<f64> {
        -(room.unknowns[self.count].value.leading() / self.slope(room))
    }

    /// `-xᵀ K' x` with the quotients for K', rounded.
    fn slope<N: Level<Word = f64, Alone = N>>(&self, room: &Room<'_, N>) -> Complex<f64> {
        let mut sum = Complex::new(0.0, 0.0);
        for row in 0..self.count {
            for column in 0..self.count {
                let [x, y] = [row, column].map(|k| room.unknowns[k].value.leading());
                sum -= x * room.slopes[place(row, column)].value * y;
            }
        }
        sum
    }

    /// Sets the sums of the bounds of derivatives on the disc, of each row: alone, and times the solution.
    fn set_sums<N: Level<Word = f64, Alone = N>>(&self, room: &mut Room<'_, N>) {
        for row in 0..self.count {
            let (mut slopes, mut products) = (0.0, 0.0);
            for column in 0..self.count {
                let slope = &room.slopes[place(row, column)];
                let most = size(slope.value) + slope.off;
                slopes += most;
                products += most * size_of(&room.unknowns[column]);
            }
            (room.unknowns[row].slopes, room.unknowns[row].products) = (inflated(slopes), inflated(products));
        }
    }

    /// Bounds of g and its slope; none where the bordered matrix is not known to be regular.
    fn on_disc<N: Level<Word = f64, Alone = N>>(&self, room: &Room<'_, N>) -> Option<OnDisc> {
        let n = self.count + 1;
        let (mut norm, mut at_centre, mut on_disc, mut of_g) = (0.0, 0.0, 0.0, [0.0; 2]);
        for row in 0..n {
            let mut sums = [room.unknowns[row].product, 0.0, 0.0];
            for (factor, other) in room.inverse[row * n..(row + 1) * n].iter().zip(&room.unknowns[..n]) {
                let factor = size(*factor);
                sums[0] += factor * (other.unknown + self.most * other.slopes);
                sums[1] += factor * other.residual;
                sums[2] += factor * (other.residual + self.most * other.products);
            }
            let [of_row, residual, moved] = sums.map(inflated);
            norm = larger(norm, of_row);
            at_centre = larger(at_centre, residual);
            on_disc = larger(on_disc, moved);
            of_g = [of_row, residual];
        }
        let rest = (1.0 - norm) * FEW;
        if rest.is_nan() || rest <= 0.0 {
            return None;
        }
        let (at_centre, on_disc) = (inflated(at_centre / rest), inflated(on_disc / rest));
        let value = inflated(room.unknowns[self.count].value.largest() + of_g[1] + of_g[0] * at_centre);
        let Complex { re, im } = self.slope(room);
        Some(OnDisc { value, slope: modulus(re, im), off: self.off(room, on_disc) })
    }

    /// A bound of the distance of g' on the disc from its rounded slope, given one of the distance of solutions.
    fn off<N: Level<Word = f64, Alone = N>>(&self, room: &Room<'_, N>, distance: f64) -> f64 {
        let n = self.count as f64;
        // the sum of n² products of three complex numbers, of which two are rounded to words
        let rounding = (4.0 * n * n + 64.0) * U;
        let mut off = 0.0;
        for (row, unknown) in room.unknowns[..self.count].iter().enumerate() {
            off += distance * (2.0 * unknown.products + distance * unknown.slopes);
            off += rounding * size_of(unknown) * unknown.products;
            for (column, other) in room.unknowns[..self.count].iter().enumerate() {
                off += size_of(unknown) * size_of(other) * room.slopes[place(row, column)].off;
            }
        }
        inflated(off)
    }
}

/// No less than the size of the solution for an unknown.
fn size_of<N: Level<Word = f64>>(unknown: &Unknown<N>) -> f64 {
    size(unknown.value.leading()) * (1.0 + 1e-14)
}
