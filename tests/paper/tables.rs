//! The tables of the paper: every printed value, found by the paper's searches, against print and exact values.

use core::ops::RangeInclusive;
use mstmm::prelude::*;
use paper::{Column, Example, Failure, Search, Solved, Value, examples, models, solve};

fn solved_examples() -> Result<Vec<(Example, Solved)>, Failure> {
    let mut pairs = Vec::new();
    for example in examples()? {
        let solved = solve(&example)?;
        pairs.push((example, solved));
    }
    Ok(pairs)
}

/// Calls `check` with every value of every table: example, column, index, eigenvalue found, unit. Returns their number.
fn for_each_value(mut check: impl FnMut(&Example, &Column, usize, Complex<f64>, f64)) -> Result<usize, Failure> {
    let mut count = 0;
    for (example, solved) in solved_examples()? {
        for column in &example.columns {
            for index in 0..column.printed.len() {
                let root = solved.solutions[0].roots[index];
                check(&example, column, index, root, solved.unit);
                count += 1;
            }
        }
    }
    Ok(count)
}

/// Oracle: the paper's MSTMM columns in Tables 2 to 6, whose printed digits are good to a relative 6e-7. Table 3 cuts
/// its six digits instead of rounding them, which costs up to a unit of the last, 1e-5/3.03 = 3.3e-6 at worst; its
/// values lose 2.3e-6 at most.
#[test]
fn all_31_values_agree_with_the_printed_ones() {
    let count = for_each_value(|example, column, index, root, unit| {
        let (computed, printed) = (column.quantity.of(root, unit), column.printed[index]);
        let allowed = if example.table == 3 { 3e-6 } else { 1e-6 };
        let error = computed.relative_error(printed);
        assert!(error <= allowed, "{} {} {computed}, printed {printed}: {error:e}", example.id, column.name);
    });
    assert_eq!(count.unwrap(), 31);
}

/// Oracle: the exact values, which come from another method in 60 digits.
///
/// The tolerance ε of the searches, absolute in rad/s, bounds in one dimension the interval of two cells that holds the
/// root, with the point found in its middle: it is off by ε/2 at most. In two dimensions it bounds the sides of a cell,
/// and the point found is the grid's nearest to the root: it is off by ε/sqrt(2) at most. The rest of ε is room for the
/// rounding of the determinant, which grows like e^{βl}: at the highest mode, βl = 15.7 in Table 5, it moves the root
/// by 2.8e-7 rad/s (seen with ε -> 0), elsewhere by less than 2e-8 rad/s.
#[test]
fn all_31_values_are_exact_to_the_tolerance_of_the_search() {
    let count = for_each_value(|example, column, index, root, unit| {
        let (Search::Line { tolerance, .. } | Search::Rectangle { tolerance, .. }) = example.search;
        let (computed, exact) = (column.quantity.of(root, unit), column.exact[index]);
        let moved = |by: f64| column.quantity.of(root + Complex::new(0.0, by), unit).distance(computed);
        let allowed = moved(tolerance).max(moved(-tolerance));
        let error = computed.distance(exact);
        assert!(error <= allowed, "{} {} {computed}, exact {exact}: {error:e}", example.id, column.name);
    });
    assert_eq!(count.unwrap(), 31);
}

/// Sign changes of a real determinant on a grid of 10,000 cells, at least 20 times finer than the paper's and 200 times
/// finer than the distance of its roots: another way to count than minima of the modulus.
fn sign_changes(system: &impl Evaluate<f64>, range: &RangeInclusive<f64>) -> usize {
    const CELLS: u32 = 10_000;
    let step = (range.end() - range.start()) / f64::from(CELLS);
    let positive = |k: u32| system.overall_determinant(range.start() + step * f64::from(k)).mantissa() > 0.0;
    (0..CELLS).filter(|&k| positive(k) != positive(k + 1)).count()
}

/// Turns of Δ(λ) around zero as λ runs once round a rectangle, counter-clockwise: the number of eigenvalues inside,
/// by the argument principle.
fn turns(system: &impl Evaluate<Complex<f64>>, [omega, delta]: &[RangeInclusive<f64>; 2]) -> f64 {
    let corners = [
        Complex::new(-delta.end(), *omega.start()),
        Complex::new(-delta.start(), *omega.start()),
        Complex::new(-delta.start(), *omega.end()),
        Complex::new(-delta.end(), *omega.end()),
    ];
    let angles = (0..4).map(|k| angle(system, corners[k], corners[(k + 1) % 4]));
    angles.sum::<f64>() / core::f64::consts::TAU
}

/// Change of the argument of Δ from `start` to `end`. A step is accepted when Δ changes by less than a quarter of its
/// modulus over the step and over both halves, else it is halved: a bound on the phase alone could hide a whole turn.
fn angle(system: &impl Evaluate<Complex<f64>>, start: Complex<f64>, end: Complex<f64>) -> f64 {
    let ratio = |from: Complex<f64>, to: Complex<f64>| {
        let (a, b) = (system.overall_determinant(from), system.overall_determinant(to));
        b.mantissa() / a.mantissa() * 2f64.powi((b.exponent() - a.exponent()) as i32)
    };
    let middle = (start + end) / 2.0;
    let steps = [ratio(start, end), ratio(start, middle), ratio(middle, end)];
    if steps.iter().all(|step| (step - 1.0).norm() < 0.25) {
        return steps[0].arg();
    }
    angle(system, start, middle) + angle(system, middle, end)
}

/// Number of roots in the search range of an example, counted without the searches.
fn roots_in_range(example: &Example) -> Result<usize, Failure> {
    Ok(match (&example.search, example.id.as_str()) {
        (Search::Line { range, .. }, "4.1a") => sign_changes(&models::light_tip_body().build()?, range),
        (Search::Line { range, .. }, "4.1b") => sign_changes(&models::heavy_tip_body().build()?, range),
        (Search::Line { range, .. }, "4.2") => sign_changes(&models::restrained_beam().build()?, range),
        (Search::Line { range, .. }, "4.3") => sign_changes(&models::spring_and_mass().build()?, range),
        (Search::Line { range, .. }, "4.4") => sign_changes(&models::two_spans().build()?, range),
        (Search::Rectangle { ranges, .. }, "4.5") => {
            let turns = turns(&models::damped_oscillator().build()?, ranges);
            // the angles add up to whole turns but for roundings of each of at most a thousand of them
            assert!((turns - turns.round()).abs() < 1e3 * f64::EPSILON, "{turns} turns");
            turns.round() as usize
        }
        (search, id) => return Err(format!("no count for example {id}, {search:?}").into()),
    })
}

/// Oracle: sign changes on a fine grid (undamped) and the argument principle (damped), which share no search with the
/// minima. Table 5 lists five of the six roots in its range; in all other ranges the printed roots are all there are.
#[test]
fn no_root_is_missing_and_none_is_found_twice() {
    for (example, solved) in solved_examples().unwrap() {
        let roots = &solved.solutions[0].roots;
        assert_eq!(roots.len(), roots_in_range(&example).unwrap(), "{}: {roots:?}", example.id);
        let printed = example.columns[0].printed.len();
        let not_printed = if example.table == 5 { 1 } else { 0 };
        assert_eq!(roots.len(), printed + not_printed, "{}: {roots:?}", example.id);
        // equal numbers could still hide one found twice and one missed; the paper's roots are 36 rad/s apart or more
        let apart = roots.windows(2).all(|pair| pair[1].im - pair[0].im > 30.0);
        assert!(apart, "{}: {roots:?}", example.id);
    }
}

/// Oracle: the sizes that sections 4.1 to 4.5 of the paper state.
#[test]
fn overall_matrices_have_the_sizes_of_the_paper() {
    let sizes: Vec<usize> = solved_examples().unwrap().iter().map(|(_, solved)| solved.size).collect();
    assert_eq!(sizes, [4, 4, 8, 6, 7, 7]);
}

/// Oracle: the definition of the relative error of a complex value, by a 3-4-5 triangle.
#[test]
fn a_complex_relative_error_is_that_of_the_modulus() {
    let (computed, printed) = (Complex::new(3.0, 4.5), Complex::new(3.0, 4.0));
    assert_eq!(Value::Complex(computed).relative_error(Value::Complex(printed)), 0.1);
}
