//! Tallies of a block, and what they hear of straight numbers.

use crate::model::state::{Space, Support};
use crate::number::branch_free::Straight;
use crate::number::scalar::Scalar;
use crate::pass::block::WIDTH;
use crate::subspace::count::{BeamSigns, Tally};
use crate::subspace::minors::line::Line;
use crate::subspace::minors::plane::Plane;

/// A tally in each lane, and room for what they are about to hear: a lane that has to go alone starts from what it has heard
/// before.
pub(crate) struct Tallies<C> {
    two: [[C; WIDTH]; 2],
    is_second: bool,
}

impl<C: Copy + Default> Tallies<C> {
    /// Tallies that have heard nothing.
    pub(crate) fn new() -> Self {
        Tallies { two: [[C::default(); WIDTH]; 2], is_second: false }
    }
}

impl<C> Tallies<C> {
    /// What they have heard, and room for what they hear next.
    #[inline]
    pub(crate) fn both(&mut self) -> (&[C; WIDTH], &mut [C; WIDTH]) {
        let [first, second] = &mut self.two;
        if self.is_second { (second, first) } else { (first, second) }
    }

    /// What they were about to hear is what they have heard.
    #[inline]
    pub(crate) fn have_heard(&mut self) {
        self.is_second = !self.is_second;
    }

    /// What they have heard.
    #[inline]
    pub(crate) fn heard(&self) -> &[C; WIDTH] {
        &self.two[usize::from(self.is_second)]
    }

    /// The same, to hear more.
    #[inline]
    pub(crate) fn heard_mut(&mut self) -> &mut [C; WIDTH] {
        &mut self.two[usize::from(self.is_second)]
    }
}

/// Tells a tally of plain numbers what straight ones do.
pub(crate) struct Plainly<'a, C>(pub(super) &'a mut C);

fn line<S: Scalar, const SERIES: bool>(line: &Line<Straight<S, SERIES>>) -> Line<S> {
    Line { y: line.y.0, q: line.q.0, exponent: line.exponent }
}

fn plane<S: Scalar, const SERIES: bool>(plane: &Plane<Straight<S, SERIES>>) -> Plane<S> {
    let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = *plane;
    Plane::unscaled([y_theta.0, y_m.0, w.0, theta_q.0, m_q.0], exponent)
}

impl<S: Scalar, C: Tally<S>, const SERIES: bool> Tally<Straight<S, SERIES>> for Plainly<'_, C> {
    const COUNTS: bool = C::COUNTS;
    const WATCHES: bool = C::WATCHES;

    #[inline(always)]
    fn cancelled(&mut self, completely: bool) {
        self.0.cancelled(completely);
    }

    #[inline(always)]
    fn looks_at_root(&self) -> bool {
        self.0.looks_at_root()
    }

    #[inline(always)]
    fn root_sum(&mut self, sum: f64, terms: f64) {
        self.0.root_sum(sum, terms);
    }

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
