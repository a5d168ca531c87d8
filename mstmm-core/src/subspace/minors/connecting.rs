//! Lines and planes at supports, at connections and at the root.

use crate::number::{Scalar, Scaled};
use crate::subspace::connecting::Connecting;
use crate::subspace::count::RootCounter;
use crate::subspace::minors::join::joined;
use crate::subspace::minors::line::Line;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::{Space, Support};

impl<S: Scalar> Connecting<S> for Subspace<S> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_support(support: Support, space: Space) -> Self {
        Subspace::Tip(support, space)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn support(&self) -> Option<Support> {
        if let Subspace::Tip(support, _) = *self { Some(support) } else { None }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rescaled(self) -> Self {
        match self {
            Subspace::Plane(plane) | Subspace::OnPin(plane) => Subspace::Plane(plane.in_range()),
            Subspace::Line(line, space) => Subspace::Line(Line::new(line.y, line.q, line.exponent), space),
            Subspace::Tip(..) | Subspace::Grounded(..) | Subspace::Springs { .. } => self,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn joined<C: RootCounter<S>>(self, other: Self, counter: &mut C) -> Self {
        joined(self, other, counter)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn widened(self, output: Option<Space>) -> Self {
        if output.is_none_or(|output| output.is(self.space())) {
            return self;
        }
        match self {
            Subspace::Grounded(k, Space::Translation) => Subspace::Springs { y: Some(k), theta: None },
            Subspace::Grounded(k, _) => Subspace::Springs { y: None, theta: Some(k) },
            Subspace::Springs { .. } => self,
            _ => Subspace::Plane(self.plane()),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn held(self, support: Support) -> Self {
        match self {
            _ if support.holds().intersection(self.space()).is_empty() => self,
            Subspace::Tip(Support::Free, space) => Subspace::Tip(support, space),
            Subspace::Plane(_) | Subspace::Springs { .. } if support == Support::Pinned => {
                Subspace::OnPin(self.plane().held(support))
            }
            Subspace::Tip(_, Space::Bending) | Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => {
                Subspace::Plane(self.plane().held(support))
            }
            _ => {
                let line = self.line();
                Subspace::Line(Line { y: S::zero(), q: line.y, exponent: line.exponent }, self.space())
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn narrowed<C: RootCounter<S>>(self, output: Option<Space>, counter: &mut C) -> Self {
        match (self, output) {
            (
                Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. },
                Some(space @ (Space::Translation | Space::Rotation)),
            ) => {
                let plane = self.plane();
                counter.narrowing(&plane, space);
                let y = plane.minor(Space::Bending.without(space));
                Subspace::Line(Line { y, q: -plane.m_q, exponent: plane.exponent }, space)
            }
            _ => self,
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at_root<C: RootCounter<S>>(self, support: Support, counter: &mut C) -> Scaled<S> {
        if let Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } = self {
            let plane = self.plane();
            counter.plane_root(&plane, support);
            let minors = || [plane.y_theta, plane.y_m, plane.theta_q, plane.m_q];
            return Scaled::new(counted::<S, C, 4>(plane.minor_at(support), minors), i64::from(plane.exponent));
        }
        let line = self.line();
        counter.line_root(&line, support);
        let value = if support.holds().contains(self.space()) { line.y } else { line.q };
        Scaled::new(counted::<S, C, 2>(value, || [line.y, line.q]), i64::from(line.exponent))
    }
}

/// Δ of a pass that counts, NaN if one of the entries is not finite, since the count needs all of them.
#[cfg_attr(not(debug_assertions), inline(always))]
fn counted<S: Scalar, C: RootCounter<S>, const N: usize>(delta: S, entries: impl Fn() -> [S; N]) -> S {
    if !C::COUNTS {
        return delta;
    }
    // zero times what is not finite is not a number
    entries().iter().fold(delta, |delta, &entry| delta + entry * S::zero())
}
