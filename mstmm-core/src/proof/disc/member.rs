//! What a member is at a complex frequency: its dynamic stiffness, and the minor whose zeros are its frequencies with both ends held.

use crate::element::{BeamNumbers, DampingNumbers, Exact, LineNumbers, SpinNumbers};
use crate::proof::adding::momentum;
use crate::proof::ball::Ball;
use crate::proof::disc::complex::ComplexBall;
use crate::proof::level::Level;

/// The dynamic stiffness of a member, the lower triangle row after row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Member<N, const E: usize> {
    pub(crate) stiffness: [ComplexBall<N>; E],
    /// Nothing is known of the stiffness where zero is in it.
    pub(crate) minor: ComplexBall<N>,
    /// The size of the terms of the minor.
    pub(crate) terms: f64,
}

/// Size of the minor of a member, beside its terms, below which it is cut in two.
const BESIDE_POLE: f64 = 0.02;

impl<N: Level<Word = f64>, const E: usize> Member<N, E> {
    /// Whether the member has no frequency with both ends held in the ball.
    pub(crate) fn is_known(&self) -> bool {
        self.minor.least() > 0.0
    }

    /// Whether it is better cut in two. It decides nothing.
    pub(crate) fn is_beside_pole(&self) -> bool {
        self.minor.size() < BESIDE_POLE * self.terms
    }
}

impl<N: Level<Word = f64>> ComplexBall<N> {
    /// The number or its opposite: that whose real part is not negative.
    pub(crate) fn to_the_right(self) -> Self {
        if self.leading().re < 0.0 { -self } else { self }
    }

    /// A parameter.
    pub(crate) fn parameter(exact: &Exact) -> Self {
        Self::real(Ball::of_pair(*exact))
    }
}

/// A complex frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frequency<N> {
    pub(crate) lambda: ComplexBall<N>,
    pub(crate) square: ComplexBall<N>,
}

impl<N: Level<Word = f64>> Frequency<N> {
    pub(crate) fn new(lambda: ComplexBall<N>) -> Self {
        Frequency { lambda, square: lambda * lambda }
    }

    /// A product with λ.
    fn times(&self, parameter: &Exact) -> ComplexBall<N> {
        self.lambda * Ball::of_pair(*parameter)
    }

    /// `(1 + iη)(1 + cλ)`.
    pub(crate) fn factor(&self, damping: &DampingNumbers) -> ComplexBall<N> {
        let one = ComplexBall::of(1.0);
        let loss = one + ComplexBall::parameter(&damping.loss_factor).times_i();
        if damping.time == [0.0; 2] { loss } else { loss * (one + self.times(&damping.time)) }
    }

    /// The same of a material that turns at a speed: λ is `λ - iΩ` for it.
    pub(crate) fn factor_of(&self, damping: &DampingNumbers, spin: &SpinNumbers) -> ComplexBall<N> {
        if spin.is_none() || damping.time == [0.0; 2] {
            return self.factor(damping);
        }
        let turning = self.lambda - ComplexBall::parameter(&spin.speed).times_i();
        ComplexBall::of(1.0) + turning * Ball::of_pair(damping.time)
    }

    /// A stiffness with damping: of its material, of a dashpot beside it, and across it.
    pub(crate) fn spring(&self, stiffness: &Exact, damping: &DampingNumbers) -> ComplexBall<N> {
        let along = self.factor(damping) * Ball::of_pair(*stiffness) + self.times(&damping.viscous);
        if damping.cross == [[0.0; 2]; 2] {
            return along;
        }
        let [stiffness, viscous] = &damping.cross;
        along - (ComplexBall::parameter(stiffness) + self.times(viscous)).times_i()
    }

    /// `m λ² + c_e λ + k`.
    pub(crate) fn load(&self, mass: &Exact, damping: &DampingNumbers, foundation: &Exact) -> ComplexBall<N> {
        self.square * Ball::of_pair(*mass) + self.times(&damping.viscous) + ComplexBall::parameter(foundation)
    }

    /// `H ω` of the angular momentum of what spins, with `ω = -iλ`.
    pub(crate) fn moment(&self, spin: &SpinNumbers) -> ComplexBall<N> {
        -(self.lambda.times_i() * momentum::<N>(spin))
    }

    /// `H e/l` of a line and `(mλ² + k) l²/(H e)`.
    pub(crate) fn of_line(
        &self,
        (line, damping): (&LineNumbers, &DampingNumbers),
        length: Ball<N>,
    ) -> [ComplexBall<N>; 2] {
        let stiffness = self.factor(damping) * (Ball::of_pair(line.stiffness) * length.inverse());
        let load = self.load(&line.inertia, damping, &line.foundation);
        [stiffness, load * length * stiffness.inverse()]
    }

    /// `EI e/l³` of a beam and `-(mλ² + k) l⁴/(EI e)`.
    pub(crate) fn of_beam(
        &self,
        (beam, damping): (&BeamNumbers, &DampingNumbers),
        length: Ball<N>,
    ) -> [ComplexBall<N>; 2] {
        let cube = length * length * length;
        let stiffness = self.factor(damping) * (Ball::of_pair(beam.bending_stiffness) * cube.inverse());
        let load = self.load(&beam.mass_per_length, damping, &beam.foundation_stiffness);
        [stiffness, -(load * length * stiffness.inverse())]
    }
}
