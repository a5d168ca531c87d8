//! A uniform line over the displacements of its ends, over `H/l`, by `y = (mλ² + k) l²/H = w²`.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::member::Member;
use crate::proof::level::Level;

/// A line.
pub(crate) type Line<N> = Member<N, 3>;

/// The line at any y: `w coth w` and `-w/sinh w`, whatever root w is.
pub(crate) fn line<N: Level<Word = f64>>(y: ComplexBall<N>) -> Line<N> {
    if y.largest() < 1.0 {
        let [cosh, sinh] = [y.series::<0, 2>(), y.series::<1, 2>()];
        let over_sinh = sinh.inverse();
        let own = cosh * over_sinh;
        return Member { stiffness: [own, -over_sinh, own], minor: sinh, terms: 1.0 };
    }
    let w = y.root().to_the_right();
    let decay = w.decay();
    let (one, square) = (ComplexBall::of(1.0), decay * decay);
    let minor = one - square;
    let over_sinh = w * minor.inverse();
    let own = over_sinh * (one + square);
    Member { stiffness: [own, -(over_sinh * decay.scaled(2.0)), own], minor, terms: 1.0 + square.size() }
}
