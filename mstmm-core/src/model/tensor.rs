//! The inertia of a body about its mass centre, as a tensor that is not indefinite.

use crate::number::double_double::DoubleDouble;
use crate::number::{Parameter, Scalar, binary_exponent, power_of_two};

/// The inertia of a body about its mass centre: the entries xx, yy, zz, xy, yz and zx of its tensor in the axes of the structure.
pub(crate) type Tensor<T> = [T; 6];

/// The first addition on the diagonal, as a part of the trace, and the largest one: a rounding of entries, and what entries of four digits less have.
const ADDITION: f64 = 2.0 * f64::EPSILON;
const LARGEST_ADDITION: f64 = 1e-12;

/// The entries of a tensor that is not indefinite: those that are given, with an addition on the diagonal where rounding has made them so. None
/// where they are indefinite beyond rounding, or not finite.
pub(crate) fn definite(entries: Tensor<f64>) -> Option<Tensor<f64>> {
    let largest = entries.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    if !largest.is_finite() || entries.iter().any(|entry| entry.is_nan()) {
        return None;
    }
    // over a power of two no sum and no product is out of range
    let exponent = binary_exponent(largest);
    let [first, second] = [exponent / 2, exponent - exponent / 2];
    let scaled = entries.map(|entry| entry * power_of_two(-first) * power_of_two(-second));
    let trace: f64 = scaled[..3].iter().sum();
    let mut addition = 0.0;
    while addition <= LARGEST_ADDITION {
        let (mut own, mut kept) = (scaled, entries);
        let least = addition * trace;
        own[..3].iter_mut().for_each(|moment| *moment += least);
        kept[..3].iter_mut().for_each(|moment| *moment += least * power_of_two(first) * power_of_two(second));
        if is_definite(own) {
            return Some(kept);
        }
        addition = if addition == 0.0 { ADDITION } else { 4.0 * addition };
    }
    None
}

/// The least moment of inertia of an indefinite tensor about any axis: less than what its diagonal lacks.
pub(crate) fn least_moment(entries: Tensor<f64>) -> f64 {
    let added = |size: f64| {
        let mut sum = entries;
        sum[..3].iter_mut().for_each(|moment| *moment += size);
        sum
    };
    // the diagonal outweighs the other entries at the latest
    let (mut below, mut above) = (0.0, 2.0 * entries.iter().map(|entry| entry.abs()).sum::<f64>());
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        if definite(added(middle)).is_some() { above = middle } else { below = middle }
    }
    -above
}

/// Halvings of an interval of the size of the entries after which four digits of its place are known, however small it is.
const HALVINGS: u32 = 60;

/// Whether all principal minors of a tensor whose entries are at most 2 are proven not to be negative.
fn is_definite([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> bool {
    if [xx, yy, zz].iter().any(|moment| *moment < 0.0) {
        return false;
    }
    if [xy, yz, zx] == [0.0; 3] {
        return true;
    }
    let [xx, yy, zz, xy, yz, zx] = [xx, yy, zz, xy, yz, zx].map(DoubleDouble::from_f64);
    let minors = [(xx, yy, xy), (yy, zz, yz), (zz, xx, zx)];
    let third = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
    let is_proven = |minor: DoubleDouble| minor.to_f64() >= ROUNDING;
    minors.iter().all(|(one, other, product)| is_proven(*one * *other - *product * *product)) && is_proven(third)
}

/// A bound of the rounding of a minor whose entries are at most 2: some twenty roundings of 2e-32 of terms of at most 8.
const ROUNDING: f64 = 1e-29;

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod along a direction has no inertia about that: its tensor is singular, and rounding makes it indefinite or not.
    #[test]
    fn a_tensor_of_a_rod_gets_an_addition_of_rounding() {
        for [x, y, z] in [[0.6_f64, 0.8, 0.0], [0.3, 0.4, 0.5], [1.0, 2.0, 3.0], [1e-3, 1.0, 1e-6]] {
            let size = (x * x + y * y + z * z).sqrt();
            let [x, y, z] = [x / size, y / size, z / size];
            let rod = [1.0 - x * x, 1.0 - y * y, 1.0 - z * z, -x * y, -y * z, -z * x];
            let own = definite(rod).unwrap();
            assert!((0..3).all(|k| (own[k] - rod[k]).abs() <= 1e-12 && own[k] >= rod[k]), "{own:?}");
        }
    }

    #[test]
    fn definite_tensors_are_as_they_are_and_indefinite_ones_refused() {
        let engine = [4.0, 6.0, 7.0, 0.5, -0.3, 0.2];
        assert_eq!(definite(engine), Some(engine));
        assert_eq!(definite([0.0, 2.0, 2.0, 0.0, 0.0, 0.0]), Some([0.0, 2.0, 2.0, 0.0, 0.0, 0.0]));
        assert_eq!(definite([1.0, 1.0, 1.0, 1.1, 0.0, 0.0]), None);
        assert_eq!(definite([-1e-3, 1.0, 1.0, 0.0, 0.0, 0.0]), None);
        assert_eq!(definite([f64::NAN, 1.0, 1.0, 0.0, 0.0, 0.0]), None);
        assert!((least_moment([1.0, 1.0, 1.0, 1.1, 0.0, 0.0]) + 0.1).abs() < 1e-9);
        for size in [1e308, 1e-307, 1.0] {
            assert_eq!(
                definite([size, size, size, 0.1 * size, 0.0, 0.0]),
                Some([size, size, size, 0.1 * size, 0.0, 0.0])
            );
        }
    }
}
