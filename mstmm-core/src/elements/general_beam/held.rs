//! The count of a general beam with both ends clamped.

use crate::elements::general_beam::constants::SectionAt;
use crate::elements::general_beam::wave_pair::{WavePair, larger_sum};
use crate::number::{Scalar, Size};
use core::f64::consts::FRAC_1_PI;

/// Number of natural frequencies of the clamped beam below a frequency: those of the pinned beam, whose shapes are sines, less the negative
/// eigenvalues of its stiffness against rotations of both ends.
///
/// For `n` half waves the pinned beam has a stiffness of two rows, whose determinant has the sign of `(k² + κ₁)(k² + κ₂)`, `k = nπ`: one of
/// its eigenvalues is negative between both travelling waves; below both are two, or none where h is negative. Above the frequency of
/// thickness shear the whole beam turns its sections. By the symmetry of the beam `K₁₄/K₀₄` is the mean of the two stiffnesses of the
/// ends, and the sign of `K₀₄` says whether the count is odd.
///
/// # Source
/// Derived here; J of a pinned Timoshenko beam is known in closed form since all its shapes are sines.
pub(super) fn clamped_count<S: Scalar>(section: &SectionAt<S>, k04: S, k14: S) -> S::Size {
    let number = S::Size::of;
    let [(longer, is_longer_odd), (shorter, is_shorter_odd)] =
        travelling(&section.waves).map(|phase| (phase * number(FRAC_1_PI)).whole());
    let is_sheared = section.cut.is_negative() & !section.tau.vanishes();
    let shorter = S::Size::choose(section.h.is_negative(), number(-1.0) * shorter, shorter);
    let pinned = longer + shorter + S::Size::one_if(is_sheared);
    let is_odd = is_longer_odd ^ is_shorter_odd ^ is_sheared ^ k04.is_negative();
    let is_definite = !(k14.is_negative() ^ k04.is_negative()) & !k14.vanishes();
    let even = S::Size::choose(is_definite, number(0.0), number(-2.0));
    pinned + S::Size::choose(is_odd, number(-1.0), even)
}

/// The wave numbers of travelling waves times l, the larger one first; zero where there is none.
fn travelling<S: Scalar>(waves: &WavePair<S>) -> [S::Size; 2] {
    let WavePair { sum, product, square } = *waves;
    let is_complex = square.is_negative();
    let root = S::select(is_complex, S::zero(), square).sqrt();
    let (larger, _) = larger_sum(sum, root);
    let larger = larger.times_power_of_two(-1);
    let smaller = S::select(larger.vanishes(), S::zero(), product / larger);
    let phase = |square: S| {
        let travels = square.is_negative() & !is_complex;
        S::select(travels, -square, S::zero()).sqrt().size()
    };
    let (one, other) = (phase(larger), phase(smaller));
    [one.or_larger(other), one.or_smaller(other)]
}
