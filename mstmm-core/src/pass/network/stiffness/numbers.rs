//! The numbers from which the waves of a member follow at any frequency, computed from its parameters once.

use crate::DoubleDouble;
use crate::element::{BeamNumbers, Exact, LineNumbers, MemberNumbers};
use crate::number::{Frequency, Scalar, Single};
use mstmm_plan::Freedoms;

/// A number at which members are evaluated.
pub(super) trait StiffnessNumber: Frequency<f64> {
    /// What members are known by: numbers of one frequency, or of all that are in lanes.
    type Part: Single;

    /// A number of a member.
    fn of(part: Self::Part) -> Self;
}

macro_rules! alone {
    ($($number:ty),*) => {$(
        impl StiffnessNumber for $number {
            type Part = Self;

            #[inline(always)]
            fn of(part: Self) -> Self {
                part
            }
        }
    )*};
}
alone!(f64, DoubleDouble);

#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
impl<V: crate::number::lanes::Waving> StiffnessNumber for mstmm_lanes::Lanes<V>
where
    Self: Frequency<f64>,
{
    type Part = f64;

    #[inline(always)]
    fn of(part: f64) -> Self {
        Self::from_f64(part)
    }
}

/// The bending of a uniform beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BendingWave<N> {
    /// `z / √ω` with z the wave number times the length, `z⁴ / ω²` and its inverse.
    pub(super) wave: N,
    pub(super) wave_fourth: N,
    pub(super) inverse_fourth: N,
    /// `EI/l³`.
    pub(super) stiffness: N,
    /// Length l.
    pub(super) length: N,
}

/// The longitudinal vibration of a beam or a rod, that of a string or a shaft, or a spring, which has neither inertia nor foundation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LineWave<N> {
    /// κ over λ², and κ at rest, with κ the square of the wave number times the length.
    pub(super) inertia: N,
    pub(super) foundation: N,
    /// `H/l`, or the stiffness of the spring.
    pub(super) stiffness: N,
}

/// What a member is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Waving<N> {
    /// Something else.
    Other,
    /// A beam, with longitudinal vibration or without.
    Beam(BendingWave<N>, Option<LineWave<N>>),
    /// A line in the freedom of that index.
    Line(usize, LineWave<N>),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [N; 3]),
}

impl<N: Scalar> Waving<N> {
    /// A member of a length that its places give.
    pub(super) fn new(numbers: &MemberNumbers, length: N) -> Self {
        let of = |[upper, lower]: Exact| N::from_f64(upper) + N::from_f64(lower);
        match *numbers {
            MemberNumbers::Beam(beam) if beam.is_plain() => {
                let BeamNumbers { bending_stiffness, mass_per_length, axial_stiffness, .. } = beam;
                let [stiffness, mass, axial] = [bending_stiffness, mass_per_length, axial_stiffness].map(of);
                let along = (axial_stiffness != [0.0; 2]).then(|| LineWave::new([length, axial, mass, N::zero()]));
                Waving::Beam(BendingWave::new([length, stiffness, mass]), along)
            }
            MemberNumbers::Line(freedom, LineNumbers { length, stiffness, inertia, foundation }) => {
                Waving::Line(freedom, LineWave::new([length, stiffness, inertia, foundation].map(of)))
            }
            MemberNumbers::Spring(freedom, stiffness) => {
                Waving::Line(freedom, LineWave { inertia: N::zero(), foundation: N::zero(), stiffness: of(stiffness) })
            }
            MemberNumbers::Joint(rigid, elastic) => Waving::Joint(rigid, elastic.map(of)),
            _ => Waving::Other,
        }
    }
}

impl<N: Scalar> BendingWave<N> {
    /// Of length, bending stiffness and mass per length.
    fn new([length, stiffness, mass]: [N; 3]) -> Self {
        let square = (mass / stiffness).sqrt();
        let half_fourth = square * length * length;
        let wave_fourth = half_fourth * half_fourth;
        BendingWave {
            wave: square.sqrt() * length,
            wave_fourth,
            inverse_fourth: N::one() / wave_fourth,
            stiffness: stiffness / (length * length * length),
            length,
        }
    }
}

impl<N: Scalar> LineWave<N> {
    /// Of length, stiffness, inertia and foundation.
    fn new([length, stiffness, inertia, foundation]: [N; 4]) -> Self {
        let compliance = length / stiffness;
        LineWave {
            inertia: inertia * length * compliance,
            foundation: foundation * length * compliance,
            stiffness: stiffness / length,
        }
    }
}
