//! The theorem of the elimination in whole and rational numbers: matrices moved at random within what it allows, singular ones too.

use crate::proof::tests::random::Random;
use std::vec;
use std::vec::Vec;

/// A rational number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ratio {
    over: i128,
    under: i128,
}

impl Ratio {
    fn new(over: i128, under: i128) -> Self {
        let (mut a, mut b) = (over.abs(), under.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let common = a.max(1) * under.signum();
        Ratio { over: over / common, under: under / common }
    }

    fn plus(self, other: Self) -> Self {
        Ratio::new(self.over * other.under + other.over * self.under, self.under * other.under)
    }

    fn times(self, other: Self) -> Self {
        Ratio::new(self.over * other.over, self.under * other.under)
    }

    fn negated(self) -> Self {
        Ratio { over: -self.over, under: self.under }
    }

    fn size(self) -> Self {
        Ratio { over: self.over.abs(), under: self.under }
    }

    fn is_negative(self) -> bool {
        self.over < 0
    }

    /// The next number of quarters above.
    fn quarters_above(self) -> i128 {
        -((-4 * self.over).div_euclid(self.under))
    }
}

fn quarters(count: i128) -> Ratio {
    Ratio::new(count, 4)
}

/// The number of negative eigenvalues of a symmetric matrix of whole numbers: the changes of sign of its characteristic polynomial at -x
/// (Descartes, exact since all roots are real), by Faddeev and Leverrier.
fn negatives(matrix: &[Vec<i128>]) -> usize {
    let size = matrix.len();
    let mut coefficients = vec![1i128];
    let mut power = vec![vec![0i128; size]; size];
    for k in 1..=size {
        let last = coefficients[k - 1];
        (0..size).for_each(|i| power[i][i] += last);
        power = (0..size)
            .map(|i| (0..size).map(|j| (0..size).map(|m| matrix[i][m] * power[m][j]).sum()).collect())
            .collect();
        let trace: i128 = (0..size).map(|i| power[i][i]).sum();
        coefficients.push(-trace / k as i128);
    }
    let at_opposite = coefficients.iter().enumerate().map(|(k, c)| if (size - k).is_multiple_of(2) { *c } else { -*c });
    let signs: Vec<i128> = at_opposite.filter(|c| *c != 0).map(i128::signum).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// Adds at least what an entry was moved by to the errors of its rows, shared at random.
fn share(errors: &mut [Ratio], (row, column): (usize, usize), off: Ratio, random: &mut Random) {
    if row == column {
        errors[row] = errors[row].plus(off.size());
        return;
    }
    let part = Ratio::new(1 + random.below(4) as i128, 1 + random.below(4) as i128);
    errors[row] = errors[row].plus(off.size().times(part));
    errors[column] = errors[column].plus(off.size().times(Ratio::new(part.under, part.over)));
}

/// Stores entries near the exact ones, in quarters; errors become quarters above.
fn stored(exact: &[Vec<Ratio>], errors: &mut [Ratio], random: &mut Random) -> Vec<Vec<Ratio>> {
    let size = exact.len();
    let mut all = exact.to_vec();
    for row in 0..size {
        for column in 0..=row {
            let entry = quarters(exact[row][column].quarters_above() - random.below(3) as i128);
            share(errors, (row, column), entry.plus(exact[row][column].negated()), random);
            (all[row][column], all[column][row]) = (entry, entry);
        }
    }
    errors.iter_mut().for_each(|error| *error = quarters(error.quarters_above()));
    all
}

/// The number of negative pivots of a run that is moved at random; `toward` as of a front.
fn count(matrix: &[Vec<i128>], toward: i128, random: &mut Random) -> usize {
    let mut exact: Vec<Vec<Ratio>> = matrix.iter().map(|row| row.iter().map(|x| Ratio::new(*x, 1)).collect()).collect();
    let mut errors = vec![quarters(0); matrix.len()];
    let mut below = 0;
    while !exact.is_empty() {
        let is_exact = random.below(3) == 0;
        let entries = if is_exact { exact.clone() } else { stored(&exact, &mut errors, random) };
        // as little as the theorem allows, or more
        let far = [0, 0, 1, 7][random.below(4)];
        let moved = errors[0].plus(quarters(far)).times(Ratio::new(toward, 1));
        let mut pivot = entries[0][0].plus(moved);
        if pivot.over == 0 {
            pivot = Ratio::new(toward, 1000);
        }
        below += usize::from(pivot.is_negative());
        let inverse = Ratio::new(pivot.under, pivot.over);
        exact = (1..entries.len())
            .map(|i| {
                let complement =
                    |j: usize| entries[i][j].plus(entries[i][0].times(entries[0][j]).times(inverse).negated());
                (1..entries.len()).map(complement).collect()
            })
            .collect();
        errors.remove(0);
        // numbers stay short where the next ones are rounded
        if exact.iter().flatten().any(|entry| entry.over.abs() > 1 << 20 || entry.under > 1 << 20) {
            exact = stored(&exact, &mut errors, random);
        }
    }
    below
}

fn check(runs: usize) {
    let mut random = Random::new(15);
    let (mut singular, mut sharp) = (0, 0);
    for run in 0..runs {
        let size = 2 + run % 3;
        let mut matrix = vec![vec![0i128; size]; size];
        for row in 0..size {
            for column in 0..=row {
                let entry = random.below(7) as i128 - 3;
                (matrix[row][column], matrix[column][row]) = (entry, entry);
            }
        }
        // every other one is singular: its last row is the sum of the others
        if run % 2 == 0 {
            let last = size - 1;
            for column in 0..last {
                let sum = (0..last).map(|row| matrix[row][column]).sum();
                (matrix[last][column], matrix[column][last]) = (sum, sum);
            }
            matrix[last][last] = (0..last).map(|row| matrix[row][last]).sum();
            singular += 1;
        }
        let below = negatives(&matrix);
        let bounds = [count(&matrix, 1, &mut random), count(&matrix, -1, &mut random)];
        assert!(bounds[0] <= below && below <= bounds[1], "{matrix:?}: {below}, not in {bounds:?}");
        sharp += usize::from(bounds[0] == bounds[1]);
    }
    std::println!("{runs} matrices, {singular} singular; {sharp} times both bounds are equal");
    assert!(sharp > runs / 20);
}

#[test]
fn the_theorem_holds_in_rational_numbers() {
    check(3_000);
}

#[test]
#[ignore = "long: .ci/long"]
fn the_theorem_holds_for_many_matrices() {
    check(300_000);
}
