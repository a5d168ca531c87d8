//! The steps of massless and inertial elements on lines. With `q = -μ` they hold in rotation paths, too.

use crate::number::{Scalar, Size, Truth};
use crate::subspace::{Covector, Line, RootCounter, Subspace};
use mstmm_plan::Support;

/// Takes a line through a massless element of dynamic stiffness κ: `(κ y - q, κ q)`. An element on a fixed tip becomes grounded.
#[inline(always)]
pub(crate) fn through_stiffness<S: Scalar, C: RootCounter<S>>(
    kappa: S,
    input: Subspace<S>,
    counter: &mut C,
) -> Subspace<S> {
    let space = input.space();
    if let Subspace::Tip(Support::Fixed, _) = input {
        return Subspace::Grounded(kappa, space);
    }
    let after = match input {
        Subspace::Grounded(k, _) => Line::new(kappa + k, -(kappa * k), 0),
        _ => {
            let before = input.line();
            Line::new(kappa * before.y - before.q, kappa * before.q, before.exponent)
        }
    };
    if C::COUNTS {
        counter.line(&input.line(), &after, S::Size::of(0.0), S::Truth::of(false));
    }
    Subspace::Line(after, space)
}

/// Takes a line through an inertia `m λ²`: `(y, q - mλ² y)`. An inertia on a free tip becomes grounded.
#[inline(always)]
pub(crate) fn through_inertia<S: Scalar>(inertia: S, input: Subspace<S>) -> Subspace<S> {
    let space = input.space();
    match input {
        // a line and no longer a tip: a support of the translation need not hold a rotation
        Subspace::Tip(Support::Fixed, _) => Subspace::Line(input.line(), space),
        Subspace::Grounded(k, _) => Subspace::Grounded(k + inertia, space),
        Subspace::Line(Line { y, q, exponent }, _) => Subspace::Line(Line { y, q: q - inertia * y, exponent }, space),
        Subspace::Tip(..) | Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => {
            Subspace::Grounded(inertia, space)
        }
    }
}

/// Takes a covector back through a massless element, whose step multiplies a line by `κ U`, on a fixed tip by `-κ U`.
#[inline]
pub(crate) fn back_through_stiffness<S: Scalar>(kappa: S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
    let is_grounded = matches!(input, Subspace::Tip(Support::Fixed, _));
    covector.times(if is_grounded { -kappa } else { kappa }, 0)
}
