//! What a member is in the elimination: its dynamic stiffness, with a border beside a pole, and its count with both ends held.

use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::word::{Word, load};

/// The dynamic stiffness of a member over `F` displacements of its ends, `E = F(F + 1)/2` entries of the lower triangle row after row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member<N: Number, const F: usize, const E: usize> {
    pub(crate) stiffness: [Ball<N>; E],
    /// One variable more, if a lane is beside a pole.
    pub(crate) border: Option<Border<N, F>>,
    /// Bounds of the number of frequencies with both ends held; NaN where it is not known. In a lane with a border they are less by 1 where σ > 0.
    pub(crate) held: [N::Word; 2],
    /// The factor of Δ, as near as a word: it decides nothing.
    pub(crate) minor: N::Word,
    /// Sizes of the displacements' stiffnesses, in the first lane: they decide nothing.
    pub(crate) sizes: [f64; F],
}

/// The border `[[R, v], [vᵀ, -σ]]` of a member whose stiffness is `R + v vᵀ/σ`: entire where σ vanishes.
///
/// A lane without a border has v = 0 and σ = -1: a pivot of 1 that is coupled to nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Border<N: Number, const F: usize> {
    pub(crate) forces: [Ball<N>; F],
    pub(crate) flexibility: Ball<N>,
}

/// Size of the minor of a member, beside its terms, below which it has a border. From 0.1 to 1e-4 nothing changes but how often borders
/// are there.
pub(crate) const BESIDE_POLE: f64 = 1e-3;

/// Part of a half wave, about the pole in the middle, within which the count with one end let go is known without a sign: its own frequencies
/// lie a quarter or more of a half wave away.
pub(crate) const IN_THE_MIDDLE: f64 = 0.1;

/// The place of an entry in the lower triangle.
#[inline(always)]
pub(crate) const fn place(row: usize, column: usize) -> usize {
    if row < column { column * (column + 1) / 2 + row } else { row * (row + 1) / 2 + column }
}

/// Whether a truth holds in some lane.
#[inline(always)]
pub(crate) fn any<W: Word>(truth: W::Mask) -> bool {
    !W::all(W::not(truth))
}

/// Whether zero is not in a ball.
#[inline(always)]
pub(crate) fn is_nonzero<N: Number>(ball: Ball<N>) -> <N::Word as Word>::Mask {
    N::Word::of(0.0).is_less(ball.least())
}

impl<N: Level, const F: usize, const E: usize> Member<N, F, E> {
    /// Members in lanes, none with a border.
    #[inline(always)]
    pub(crate) fn of_lanes(members: &[Member<N::Alone, F, E>]) -> Self {
        let mut stiffness = [Ball::of(0.0); E];
        for (k, entry) in stiffness.iter_mut().enumerate() {
            *entry = Ball::of_lanes(members, &|member| member.stiffness[k]);
        }
        Member {
            stiffness,
            border: None,
            held: [load(members, &|member| member.held[0]), load(members, &|member| member.held[1])],
            minor: load(members, &|member| member.minor),
            sizes: members.first().map_or([0.0; F], |member| member.sizes),
        }
    }

    /// The lanes of one member where a truth holds, else those of another.
    #[inline(always)]
    pub(crate) fn select(truth: <N::Word as Word>::Mask, first: Self, second: Self) -> Self {
        let mut stiffness = first.stiffness;
        for (entry, other) in stiffness.iter_mut().zip(&second.stiffness) {
            *entry = Ball::select(truth, *entry, *other);
        }
        let border = match (first.border, second.border) {
            (None, None) => None,
            (first, second) => {
                let (first, second) = (first.unwrap_or(Border::none()), second.unwrap_or(Border::none()));
                let mut forces = first.forces;
                for (force, other) in forces.iter_mut().zip(&second.forces) {
                    *force = Ball::select(truth, *force, *other);
                }
                Some(Border { forces, flexibility: Ball::select(truth, first.flexibility, second.flexibility) })
            }
        };
        Member {
            stiffness,
            border,
            held: [
                N::Word::select(truth, first.held[0], second.held[0]),
                N::Word::select(truth, first.held[1], second.held[1]),
            ],
            minor: N::Word::select(truth, first.minor, second.minor),
            sizes: if N::Word::select(truth, N::Word::of(1.0), N::Word::of(0.0)).first() > 0.5 {
                first.sizes
            } else {
                second.sizes
            },
        }
    }

    /// The border `[[R, v], [vᵀ, -σ]]` with some of `v vᵀ` left in the matrix, `R + v vᵀ/κ` and `σ/(1 - σ/κ)`: a row of R alone is zero, and
    /// the sum over several members may vanish at every frequency. Returns `1 - σ/κ` besides, which has to be positive.
    #[inline(always)]
    pub(crate) fn shifted(
        stiffness: &mut [Ball<N>; E],
        forces: [Ball<N>; F],
        flexibility: Ball<N>,
        inverse_kappa: Ball<N>,
    ) -> (Border<N, F>, Ball<N>) {
        for row in 0..F {
            let scaled = forces[row] * inverse_kappa;
            for column in 0..=row {
                let entry = &mut stiffness[place(row, column)];
                *entry = *entry + scaled * forces[column];
            }
        }
        let left = Ball::of(1.0) - flexibility * inverse_kappa;
        (Border { forces, flexibility: flexibility * left.inverse() }, left)
    }

    /// A member of which nothing is known in the lanes where a truth does not hold: not its count either, since of a member whose ends are all held
    /// nothing else is asked.
    #[inline(always)]
    pub(crate) fn known_where(mut self, truth: <N::Word as Word>::Mask) -> Self {
        for bound in &mut self.held {
            *bound = N::Word::select(truth, *bound, N::Word::of(f64::NAN));
        }
        for entry in &mut self.stiffness {
            entry.rad = N::Word::select(truth, entry.rad, N::Word::of(f64::INFINITY));
        }
        self
    }
}

impl<N: Number, const F: usize> Border<N, F> {
    /// No border.
    #[inline(always)]
    fn none() -> Self {
        Border { forces: [Ball::of(0.0); F], flexibility: Ball::of(-1.0) }
    }
}

/// Whether a number of half waves is beside the middle of one, and that one's index, which is a whole number.
#[inline(always)]
pub(crate) fn half_wave<W: Word>(half_waves: W) -> (W, W::Mask) {
    let index = (half_waves - W::of(0.5)).nearest();
    let offset = (half_waves - index - W::of(0.5)).size();
    (index, offset.is_less(W::of(IN_THE_MIDDLE)))
}
