//! Symmetric matrices whose rows are stored from their first entry that is not zero to the diagonal.

/// The lower triangle of a symmetric matrix, row by row, each from its first column on.
#[derive(Clone, Debug, PartialEq)]
pub struct Skyline {
    /// First column of each row.
    first: Vec<usize>,
    /// Where each row starts in `values`; one more for the end.
    start: Vec<usize>,
    values: Vec<f64>,
}

impl Skyline {
    /// A matrix of zeros with the first column of each row.
    pub fn zeros(first: Vec<usize>) -> Self {
        let mut start = vec![0];
        let mut length = 0;
        for (row, column) in first.iter().enumerate() {
            length += row + 1 - column;
            start.push(length);
        }
        Skyline { first, start, values: vec![0.0; length] }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.first.len()
    }

    /// Adds to an entry of the lower triangle, which must be one that is stored.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        let place = self.start[row] + column - self.first[row];
        self.values[place] += value;
    }

    /// `self + factor · other`, of the same profile.
    pub fn plus(&self, factor: f64, other: &Skyline) -> Skyline {
        let values = self.values.iter().zip(&other.values).map(|(a, b)| a + factor * b).collect();
        Skyline { values, ..self.clone() }
    }

    fn row(&self, row: usize) -> &[f64] {
        &self.values[self.start[row]..self.start[row + 1]]
    }

    fn diagonal(&self) -> impl Iterator<Item = f64> {
        self.start[1..].iter().map(|end| self.values[end - 1])
    }

    /// All entries.
    pub fn dense(&self) -> nalgebra::DMatrix<f64> {
        nalgebra::DMatrix::from_fn(self.size(), self.size(), |i, j| {
            let (row, column) = (i.max(j), i.min(j));
            if column < self.first[row] { 0.0 } else { self.row(row)[column - self.first[row]] }
        })
    }

    /// Writes the product with a vector to `product`.
    pub fn times(&self, x: &[f64], product: &mut [f64]) {
        for row in 0..self.size() {
            let Some((diagonal, before)) = self.row(row).split_last() else { continue };
            let columns = self.first[row]..row;
            let own = x[row];
            let mut sum = diagonal * own;
            for ((entry, x), above) in before.iter().zip(&x[columns.clone()]).zip(&mut product[columns]) {
                sum += entry * x;
                *above += entry * own;
            }
            product[row] = sum;
        }
    }

    /// `L D Lᵀ`, without pivoting, which would break the profile.
    ///
    /// # Source
    /// The column reduction of Bathe and Wilson's COLSOL.
    pub fn factorised(mut self) -> Factors {
        for row in 0..self.size() {
            let (done, current) = self.values.split_at_mut(self.start[row]);
            let first = self.first[row];
            for column in first..row {
                let other = &done[self.start[column]..self.start[column + 1] - 1];
                let from = first.max(self.first[column]);
                let a = &current[from - first..column - first];
                let b = &other[from - self.first[column]..];
                let sum: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                current[column - first] -= sum;
            }
            let mut pivot = current[row - first];
            for column in first..row {
                let value = current[column - first];
                let scaled = value * done[self.start[column + 1] - 1];
                pivot -= value * scaled;
                current[column - first] = scaled;
            }
            current[row - first] = 1.0 / pivot;
        }
        Factors(self)
    }
}

/// A factorised matrix: L below the diagonal, the inverse of D on it.
#[derive(Clone, Debug)]
pub struct Factors(Skyline);

impl Factors {
    /// Solves in place.
    pub fn solve(&self, x: &mut [f64]) {
        let Factors(matrix) = self;
        for row in 0..x.len() {
            let Some((_, before)) = matrix.row(row).split_last() else { continue };
            let sum: f64 = before.iter().zip(&x[matrix.first[row]..row]).map(|(l, x)| l * x).sum();
            x[row] -= sum;
        }
        x.iter_mut().zip(matrix.diagonal()).for_each(|(x, inverse)| *x *= inverse);
        for row in (0..x.len()).rev() {
            let Some((_, before)) = matrix.row(row).split_last() else { continue };
            let own = x[row];
            before.iter().zip(&mut x[matrix.first[row]..row]).for_each(|(l, x)| *x -= l * own);
        }
    }
}
