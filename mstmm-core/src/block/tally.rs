//! Tallies that hear of straight numbers.

use super::Straight;
use crate::count::{BeamSigns, Tally};
use crate::scalar::Scalar;
use crate::state::{Space, Support};
use crate::subspace::{Line, Plane};

/// Tells a tally of plain numbers what straight ones do.
pub(super) struct Plainly<'a, C>(pub(super) &'a mut C);

fn line<S: Scalar, const SERIES: bool>(line: &Line<Straight<S, SERIES>>) -> Line<S> {
    Line { y: line.y.0, q: line.q.0, exponent: line.exponent }
}

fn plane<S: Scalar, const SERIES: bool>(plane: &Plane<Straight<S, SERIES>>) -> Plane<S> {
    let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = *plane;
    Plane::unscaled([y_theta.0, y_m.0, w.0, theta_q.0, m_q.0], exponent)
}

impl<S: Scalar, C: Tally<S>, const SERIES: bool> Tally<Straight<S, SERIES>> for Plainly<'_, C> {
    const COUNTS: bool = C::COUNTS;

    #[inline(always)]
    fn spring(&mut self, before: &Line<Straight<S, SERIES>>, after: &Line<Straight<S, SERIES>>) {
        self.0.spring(&line(before), &line(after));
    }

    #[inline(always)]
    fn hinge(
        &mut self,
        before: &Plane<Straight<S, SERIES>>,
        after: &Plane<Straight<S, SERIES>>,
        k_y: Straight<S, SERIES>,
    ) {
        self.0.hinge(&plane(before), &plane(after), k_y.0);
    }

    #[inline(always)]
    fn beam(
        &mut self,
        before: &Plane<Straight<S, SERIES>>,
        after: &Plane<Straight<S, SERIES>>,
        signs: BeamSigns<Straight<S, SERIES>>,
    ) {
        let BeamSigns { half_waves, one_minus_product, clamped_stiffness } = signs;
        let signs =
            BeamSigns { half_waves, one_minus_product: one_minus_product.0, clamped_stiffness: clamped_stiffness.0 };
        self.0.beam(&plane(before), &plane(after), signs);
    }

    #[inline(always)]
    fn line_waves(
        &mut self,
        before: &Line<Straight<S, SERIES>>,
        after: &Line<Straight<S, SERIES>>,
        held: u64,
        odd: bool,
    ) {
        self.0.line_waves(&line(before), &line(after), held, odd);
    }

    #[inline(always)]
    fn narrowing(&mut self, own: &Plane<Straight<S, SERIES>>, space: Space) {
        self.0.narrowing(&plane(own), space);
    }

    #[inline(always)]
    fn plane_root(&mut self, own: &Plane<Straight<S, SERIES>>, support: Support) {
        self.0.plane_root(&plane(own), support);
    }

    #[inline(always)]
    fn line_root(&mut self, own: &Line<Straight<S, SERIES>>, support: Support) {
        self.0.line_root(&line(own), support);
    }
}
