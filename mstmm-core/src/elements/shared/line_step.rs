//! The steps of massless and inertial elements, and of those with waves, on lines. With `q = -μ` they hold in rotation paths, too.

use crate::elements::shared::uniform_line::LineWaves;
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

/// Takes a line through an element with waves: `(C y - (l/H) S q, C q - (H/l) κ S y)`.
#[inline(always)]
pub(crate) fn through_waves<S: Scalar, C: RootCounter<S>>(
    waves: &LineWaves<S>,
    input: Subspace<S>,
    counter: &mut C,
) -> Subspace<S> {
    let LineWaves { square, cosh, sinhc, stiffness, compliance, exponent } = *waves;
    let space = input.space();
    let (along, force) = (sinhc * compliance, square * sinhc * stiffness);
    let after = match input {
        Subspace::Tip(support, _) if support.holds().contains(space) => Line::new(-along, cosh, exponent),
        Subspace::Tip(..) => Line::new(cosh, -force, exponent),
        Subspace::Grounded(k, _) => Line::new(cosh + along * k, -(force + cosh * k), exponent),
        _ => {
            let Line { y, q, exponent: before } = input.line();
            Line::new(cosh * y - along * q, cosh * q - force * y, before.saturating_add(exponent))
        }
    };
    if C::COUNTS {
        counter.line(&input.line(), &after, waves.held(), sinhc.is_negative());
    }
    Subspace::Line(after, space)
}

/// Takes a covector back through a massless element, whose step multiplies a line by `κ U`, on a fixed tip by `-κ U`.
#[inline]
pub(crate) fn back_through_stiffness<S: Scalar>(kappa: S, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
    let is_grounded = matches!(input, Subspace::Tip(Support::Fixed, _));
    covector.times(if is_grounded { -kappa } else { kappa }, 0)
}
