//! The equations of a general beam in balls, from its parameters, and its two squared wave numbers.

use crate::element::BeamNumbers;
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::word::Word;

/// The constants of the equations.
#[derive(Clone, Copy)]
pub(crate) struct Equations<N: Number> {
    /// `1/(1 + T f)`.
    pub(crate) sigma: Ball<N>,
    /// `f σ EI/l²`.
    pub(crate) tau: Ball<N>,
    /// `(σ T - r ω² + H ω) l²/EI`.
    pub(crate) g: Ball<N>,
    /// `(m ω² - k) l⁴/EI`.
    pub(crate) h: Ball<N>,
    /// `σ² + τ g`.
    pub(crate) cut: Ball<N>,
    /// `g + τ h`.
    pub(crate) coupling: Ball<N>,
    pub(crate) waves: WavePair<N>,
}

/// The two squared wave numbers κ, which are negative where waves travel: `κ² - s κ + d = 0`.
#[derive(Clone, Copy)]
pub(crate) struct WavePair<N: Number> {
    /// s.
    pub(crate) sum: Ball<N>,
    /// d.
    pub(crate) product: Ball<N>,
    /// `δ = (κ₁ - κ₂)²`.
    pub(crate) square: Ball<N>,
}

/// The κ that is larger in size, the other one, and the first less the second.
pub(crate) type Roots<N> = [Ball<N>; 3];

impl<N: Level> Equations<N> {
    #[inline(always)]
    pub(crate) fn of(beam: &BeamNumbers, length: Ball<N>, square: Ball<N>, moment: Option<Ball<N>>) -> Self {
        let of = Ball::<N>::of_pair;
        let (stiffness, mass, foundation) =
            (of(beam.bending_stiffness), of(beam.mass_per_length), of(beam.foundation_stiffness));
        let (rotary, axial, layer) = (of(beam.rotary_inertia), of(beam.axial_force), of(beam.shear_layer));
        let flexibility = if beam.shears() { Ball::of_pair(beam.shear_stiffness).inverse() } else { Ball::of(0.0) };
        let (one, tension, inertia) = (Ball::of(1.0), axial + layer, rotary * square);
        // what holds against a rotation adds to g as what its inertia takes from it
        let inertia = moment.map_or(inertia, |moment| inertia - moment);
        let length_squared = length * length;
        let scale = length_squared * stiffness.inverse();
        let sigma = (one + tension * flexibility).inverse();
        let tau = flexibility * sigma * scale.inverse();
        let g = (sigma * tension - inertia) * scale;
        let h = (mass * square - foundation) * (scale * length_squared);
        // σ² + τg = σ² (1 + T f) - σ f r ω², and σ (1 + T f) = 1
        let cut = sigma * (one - flexibility * inertia);
        let product = tau * h;
        let (coupling, inertia) = (g + product, h * (sigma * sigma));
        // (κ₁ - κ₂)² = s² - 4d, without cancellation where h > 0
        let square = coupling * coupling + inertia.scaled(4.0);
        let waves = WavePair { sum: g - product, product: -(h * cut), square };
        Equations { sigma, tau, g, h, cut, coupling, waves }
    }
}

impl<N: Level> WavePair<N> {
    /// The pair where a truth holds, else another one.
    #[inline(always)]
    pub(crate) fn where_true(self, truth: <N::Word as Word>::Mask, other: [f64; 3]) -> Self {
        let of_lanes = [self.sum, self.product, self.square];
        let other = [Ball::of(other[0]), Ball::of(other[1]), Ball::of(other[2])];
        let [sum, product, square] = select_all(truth, of_lanes, other);
        WavePair { sum, product, square }
    }

    /// κ₁ and κ₂ where they are real. Where the sign of δ is not known, √δ is anything up to the largest.
    #[inline(always)]
    pub(crate) fn roots(&self) -> Roots<N> {
        let zero = N::Word::of(0.0);
        let is_positive = self.square.is_positive();
        let root = Ball::select(is_positive, self.square, Ball::of(1.0)).root();
        let anything = Ball { mid: N::of(0.0), rad: self.square.largest().root() * N::Word::of(1.0 + 1e-15) };
        let root = Ball::select(is_positive, root, anything);
        let gap = Ball::select(self.sum.mid.leading().is_less(zero), -root, root);
        let larger = (self.sum + gap).scaled(0.5);
        [larger, self.product * larger.inverse(), gap]
    }
}

/// The first balls where a truth holds, else the second ones.
#[inline(always)]
pub(crate) fn select_all<N: Level, const K: usize>(
    truth: <N::Word as Word>::Mask,
    first: [Ball<N>; K],
    second: [Ball<N>; K],
) -> [Ball<N>; K] {
    let mut selected = first;
    for (own, other) in selected.iter_mut().zip(second) {
        *own = Ball::select(truth, *own, other);
    }
    selected
}

/// One of two truths at least.
#[inline(always)]
pub(crate) fn either<W: Word>(first: W::Mask, second: W::Mask) -> W::Mask {
    W::not(W::both(W::not(first), W::not(second)))
}
