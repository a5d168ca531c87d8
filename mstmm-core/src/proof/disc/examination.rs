//! An examination of a disc: see [the theorem](crate::proof::disc).

use crate::number::{Scalar, Size};
use crate::proof::disc::bounds::{Bounds, inflated};
use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::invert::invert;
use crate::proof::disc::matrix::Matrix;
use crate::proof::disc::room::{Examined, Room, Slope, Unknown};
use crate::proof::join::Failure;
use crate::proof::level::Level;
use crate::proof::member::place;
use crate::proof::number::U;
use crate::proof::run::join_all;
use crate::proof::tree::Path;
use crate::proof::visit::Visited;
use num_complex::Complex;

/// Radii, relative to |λ|, of discs on which the matrix is bounded. The first disc on which the bounds suffice is taken. A bound of the derivatives is
/// the smaller, the wider the disc (Cauchy); elements with poles near λ need a narrow disc. The theorem holds with each radius.
const WIDE: [f64; 5] = [3e-2, 3e-3, 1e-4, 1e-6, 1e-8];

/// Steps that improve the solution. Each adds the digits of the inverse, six at least: five steps reach the 30 digits of a ball. The bound of the
/// residual holds after any number of steps.
const STEPS: usize = 5;

/// Rounds in which the sizes of rows are made equal. Each halves the exponents that are left, which eight rounds take from ±1000 to ±4. The powers of two
/// are exact, whatever they are.
const ROUNDS: usize = 8;

/// The number of variables of a model, given memory for whether each is in use.
#[cfg(feature = "std")]
pub(crate) fn variables<N: Level<Word = f64, Alone = N>>(
    model: &dyn Visited,
    centre: ComplexBall<N>,
    is_taken: &mut [bool],
    paths: &mut [Path<N>],
) -> Result<usize, Failure> {
    put_together(model, &mut [], is_taken, paths, [centre; 2])
}

/// Puts the matrix together at λ as at the centre. Returns the number of places.
fn put_together<N: Level<Word = f64, Alone = N>>(
    model: &dyn Visited,
    entries: &mut [ComplexBall<N>],
    is_taken: &mut [bool],
    paths: &mut [Path<N>],
    at: [ComplexBall<N>; 2],
) -> Result<usize, Failure> {
    is_taken.fill(false);
    let Matrix { width, failure, .. } = join_all(model, None, Matrix::new(entries, is_taken, at), paths);
    failure.map_or(Ok(width), Err)
}

/// A disc that is examined.
pub(crate) struct Examination<'a, 'm, N: Level> {
    pub(crate) model: &'a dyn Visited,
    pub(crate) room: Room<'m, N>,
    pub(crate) centre: ComplexBall<N>,
    /// The radius.
    pub(crate) most: f64,
}

impl<N: Level<Word = f64, Alone = N>> Examination<'_, '_, N> {
    /// Examines the disc.
    pub(crate) fn run(mut self) -> Result<Examined, Failure> {
        let Room { entries, is_taken, paths, .. } = &mut self.room;
        let width = put_together(self.model, entries, is_taken, paths, [self.centre; 2])?;
        let mut count = 0;
        for place in 0..width {
            if self.room.is_taken[place] {
                self.room.unknowns[count] = Unknown { place, ..Unknown::none() };
                count += 1;
            }
        }
        // a power of two, so that the quotient is exact
        let step = 1.0.times_power_of_two(Size::exponent(self.most).unwrap_or(-1000) - 1);
        let beside =
            ComplexBall { re: self.centre.re.plus(N::of(step)), ..self.centre }.widened(N::SUM * self.centre.size());
        let Room { others, is_taken, paths, .. } = &mut self.room;
        put_together(self.model, others, is_taken, paths, [beside, self.centre])?;
        self.scale(count, step);
        self.set_slopes(count, step);
        if !self.set_inverse(count) {
            return Ok(Examined { radius: None, step: Complex::new(f64::NAN, 0.0) });
        }
        self.solve(count);
        let bounds = Bounds::new(&mut self.room, count, self.most);
        for share in WIDE {
            let wide = share * self.centre.size();
            let Room { others, is_taken, paths, .. } = &mut self.room;
            let found = put_together(self.model, others, is_taken, paths, [self.centre.widened(wide), self.centre]);
            if found.is_err() || !self.bound_slopes(count, wide) {
                continue;
            }
            let examined = bounds.examined(&mut self.room);
            if examined.radius.is_some() {
                return Ok(examined);
            }
        }
        Ok(Examined { radius: None, step: bounds.step(&self.room) })
    }

    /// The place of an entry of two unknowns, and the power of two that it is taken times.
    fn entry(&self, row: usize, column: usize) -> (usize, f64) {
        let [row, column] = [row, column].map(|k| &self.room.unknowns[k]);
        (place(row.place, column.place), row.scale * column.scale)
    }

    /// Finds powers of two for which all rows have entries about as large as 1 (Ruiz). The size of an entry is that of its value and of λ times its
    /// derivative, since the value may vanish at the eigenvalue.
    fn scale(&mut self, count: usize, step: f64) {
        let over_step = self.centre.size() / step;
        for _ in 0..ROUNDS {
            for row in 0..count {
                let sizes = (0..count).map(|column| {
                    let (place, power) = self.entry(row, column);
                    let entry = self.room.entries[place];
                    power * (entry.size() + (self.room.others[place] - entry).size() * over_step)
                });
                let largest = sizes.fold(0.0, f64::max);
                let exponent = Size::exponent(largest).unwrap_or(0);
                self.room.unknowns[row].product = f64::from(exponent);
            }
            for row in &mut self.room.unknowns[..count] {
                // half of the exponent, since the column is scaled, too
                row.scale = row.scale.times_power_of_two(-(row.product as i32) / 2);
            }
        }
    }

    /// Takes quotients of differences for derivatives.
    fn set_slopes(&mut self, count: usize, step: f64) {
        for row in 0..count {
            for column in 0..=row {
                let (at, power) = self.entry(row, column);
                let difference = (self.room.others[at] - self.room.entries[at]).scaled(power / step);
                let value = difference.leading();
                let rounded = inflated(difference.rad + 4.0 * U * (value.re.abs() + value.im.abs()));
                self.room.slopes[place(row, column)] = Slope { value, rounded, off: f64::INFINITY };
            }
        }
    }

    /// Bounds how far derivatives on the disc are from these quotients, from the matrix on a wider disc (Cauchy): `|K''| <= 2 sup|K|/(R - r)²` where a
    /// disc of `R - r` fits in the wider one, and no two points are farther apart than 2r. Returns whether all are bounded.
    fn bound_slopes(&mut self, count: usize, wide: f64) -> bool {
        // two roundings lose less than 1e-15
        let distance = (wide - self.most) * (1.0 - 1e-9);
        let factor = 4.0 * self.most / (distance * distance);
        let mut is_bounded = distance > 0.0;
        for row in 0..count {
            for column in 0..=row {
                let (at, power) = self.entry(row, column);
                let largest = self.room.others[at].largest() * power;
                let slope = &mut self.room.slopes[place(row, column)];
                slope.off = inflated(slope.rounded + factor * largest);
                is_bounded &= slope.off.is_finite();
            }
        }
        is_bounded
    }

    /// Sets the bordered matrix in words and its inverse. The first border is any, and shows the shape; the second one is conjugate to that.
    fn set_inverse(&mut self, count: usize) -> bool {
        let n = count + 1;
        for round in 0..2 {
            self.set_border(count, round == 0);
            self.set_matrix(count);
            let Room { matrix, inverse, pivots, .. } = &mut self.room;
            inverse[..n * n].copy_from_slice(&matrix[..n * n]);
            if !invert(&mut inverse[..n * n], &mut pivots[..n]) {
                return false;
            }
        }
        true
    }

    /// Sets the border: that of a shape is conjugate to the solution so far.
    fn set_border(&mut self, count: usize, is_first: bool) {
        let Room { inverse, unknowns, .. } = &mut self.room;
        let shape = |k: usize| inverse[k * (count + 1) + count];
        let square: f64 = if is_first { 1.0 } else { (0..count).map(|k| shape(k).norm_sqr()).sum() };
        let length = Scalar::sqrt(square);
        for (k, unknown) in unknowns[..count].iter_mut().enumerate() {
            let part = |factor: f64| 0.5 + k as f64 * factor - ((k as f64 * factor) as u64) as f64;
            let any = Complex::new(part(0.618), part(0.414));
            unknown.border = if is_first { any } else { shape(k).conj() / length };
        }
    }

    /// Sets the bordered matrix in words, and bounds of what each of its rows is off by.
    fn set_matrix(&mut self, count: usize) {
        let n = count + 1;
        for row in 0..count {
            let mut unknown = 0.0;
            for column in 0..count {
                let (at, power) = self.entry(row, column);
                let entry = self.room.entries[at].scaled(power);
                let value = entry.leading();
                self.room.matrix[row * n + column] = value;
                unknown += entry.rad + 4.0 * U * (value.re.abs() + value.im.abs());
            }
            let border = self.room.unknowns[row].border;
            (self.room.matrix[row * n + count], self.room.matrix[count * n + row]) = (border, border);
            self.room.unknowns[row].unknown = inflated(unknown);
        }
        self.room.matrix[count * n + count] = Complex::new(0.0, 0.0);
        self.room.unknowns[count] = Unknown::none();
    }

    /// Solves the bordered system, step by step to the digits of the balls, and bounds the residual of what it is left with.
    fn solve(&mut self, count: usize) {
        let n = count + 1;
        for k in 0..n {
            let Complex { re, im } = self.room.inverse[k * n + count];
            self.room.unknowns[k].value = ComplexBall::exactly(N::of(re), N::of(im));
        }
        for step in 0..=STEPS {
            for row in 0..n {
                let residual = self.residual(row, count);
                let unknown = &mut self.room.unknowns[row];
                (unknown.correction, unknown.residual) = (residual.leading(), residual.largest());
            }
            if step == STEPS {
                break;
            }
            for row in 0..n {
                let Room { unknowns, inverse, .. } = &mut self.room;
                let inverse = &inverse[row * n..(row + 1) * n];
                let sum: Complex<f64> = inverse.iter().zip(&unknowns[..n]).map(|(r, other)| r * other.correction).sum();
                let value = &mut unknowns[row].value;
                *value = ComplexBall::exactly(value.re.plus(N::of(sum.re)), value.im.plus(N::of(sum.im)));
            }
        }
    }

    /// The right-hand side less the matrix times the solution, in a row.
    fn residual(&self, row: usize, count: usize) -> ComplexBall<N> {
        let unknowns = &self.room.unknowns[..=count];
        let exactly = |number: Complex<f64>| ComplexBall::exactly(N::of(number.re), N::of(number.im));
        if row == count {
            let one = ComplexBall::of(1.0);
            return unknowns[..count].iter().fold(one, |rest, other| rest - exactly(other.border) * other.value);
        }
        let mut rest = -(exactly(unknowns[row].border) * unknowns[count].value);
        for (column, other) in unknowns[..count].iter().enumerate() {
            let (at, power) = self.entry(row, column);
            rest = rest - self.room.entries[at].scaled(power) * other.value;
        }
        rest
    }
}
