//! Numbers of twice the digits, neighbours of a number, and whether a list holds what it must.

use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::search::NaturalFrequency;

pub(super) type Double = DoubleDouble;

pub(super) fn double(value: f64) -> Double {
    Double::from(value)
}

pub(super) fn square(value: f64) -> Double {
    double(value) * double(value)
}

/// `n π` in two words.
pub(super) fn pi(n: u32) -> Double {
    Double::from_sum(std::f64::consts::PI, 1.224_646_799_147_353_2e-16) * double(f64::from(n))
}

/// The positive number so many numbers above.
pub(super) fn moved(value: f64, numbers: i64) -> f64 {
    f64::from_bits(value.to_bits().wrapping_add_signed(numbers))
}

/// A zero of a function by Newton's steps, given with its derivative.
pub(super) fn zero(start: f64, function: impl Fn(Double) -> [Double; 2]) -> Double {
    (0..6).fold(double(start), |x, _| {
        let [value, slope] = function(x);
        x - value / slope
    })
}

/// `βl` of the n-th mode of a cantilever, `cos z = -1/cosh z`, or of a clamped beam, `cos z = 1/cosh z`.
pub(super) fn wave_of_mode(n: u32, is_clamped: bool) -> Double {
    let sign = double(if is_clamped { -1.0 } else { 1.0 });
    let start = match (n, is_clamped) {
        (1, false) => 1.8751,
        (1, true) => 4.73,
        (n, false) => (f64::from(n) - 0.5) * std::f64::consts::PI,
        (n, true) => (f64::from(n) + 0.5) * std::f64::consts::PI,
    };
    zero(start, |z| {
        let ((sin, cos), (sinh, cosh)) = (z.sin_cos(), z.sinh_cosh());
        [cos + sign / cosh, -sin - sign * sinh / (cosh * cosh)]
    })
}

/// Ascending.
pub(super) fn sorted(mut numbers: Vec<Double>) -> Vec<Double> {
    numbers.sort_by(|a, b| a.partial_cmp(b).unwrap());
    numbers
}

/// Whether entries are proven, follow each other without a gap and hold frequencies of whose squares such bounds are known, from the first on.
pub(super) fn fault(entries: &[NaturalFrequency], bounds: &[[Double; 2]]) -> Option<String> {
    let mut before: Option<&NaturalFrequency> = None;
    for entry in entries {
        let [first, last] = [entry.index - 1, entry.index + entry.multiplicity - 2].map(|index| index as usize);
        let follows = before.is_none_or(|one| one.index + one.multiplicity == entry.index && one.upper <= entry.lower);
        if !entry.is_proven || !follows {
            return Some(format!("{entry:?} does not follow {before:?} or is not proven"));
        }
        let [Some(of_first), Some(of_last)] = [bounds.get(first), bounds.get(last)] else { break };
        if of_first[1] < square(entry.lower) || of_last[0] >= square(entry.upper) {
            return Some(format!(
                "{entry:?} holds {:?} to {:?}",
                of_first[1].to_f64().sqrt(),
                of_last[0].to_f64().sqrt()
            ));
        }
        before = Some(entry);
    }
    None
}

/// The same of frequencies whose squares are known.
pub(super) fn fault_of_squares(entries: &[NaturalFrequency], squares: &[Double]) -> Option<String> {
    fault(entries, &squares.iter().map(|square| [*square; 2]).collect::<Vec<_>>())
}

/// Whether both bounds of a count, and the count if there is one, agree with an exact one.
pub(super) fn count_is_right<E>([least, most]: [u64; 2], count: &Result<u64, E>, exact: u64) -> bool {
    least <= exact && exact <= most && count.as_ref().map_or(least < most, |count| *count == exact)
}
