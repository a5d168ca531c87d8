//! The second compound of a general beam's transfer matrix, and its steps on planes.

use crate::elements::general_beam::constants::SectionAt;
use crate::elements::general_beam::held::clamped_count;
use crate::elements::general_beam::wave_pair::PairProducts;
use crate::elements::shared::compound::Units;
use crate::number::{Scalar, Scaled, twice};
use crate::subspace::{Connecting, Held, Plane, RootCounter, Subspace};
use mstmm_plan::Support;

/// The compound K over `p_YΘ, p_YM, w, p_ΘQ, p_MQ` in units of l and EI, divided by `2^exponent`: the entries that differ.
///
/// Seen from the other end a beam is the same, so that `K_ij` is `K_(4-j)(4-i)`; the column of w, which stands for two equal minors, has
/// twice the entries of its row.
#[derive(Clone, Copy, Debug)]
pub struct GeneralCompound<S: Scalar> {
    pub(crate) k00: S,
    pub(crate) k01: S,
    pub(crate) k03: S,
    pub(crate) k04: S,
    pub(crate) k10: S,
    pub(crate) k11: S,
    pub(crate) k13: S,
    pub(crate) k20: S,
    pub(crate) k21: S,
    pub(crate) k22: S,
    pub(crate) k23: S,
    pub(crate) k24: S,
    pub(crate) k30: S,
    pub(crate) k31: S,
    pub(crate) k40: S,
    pub(crate) exponent: i32,
    pub(crate) section: SectionAt<S>,
    pub(crate) units: Units<S>,
}

/// The row of K whose minor is Δ at a support.
#[inline]
fn row_at(support: Support) -> usize {
    match support {
        Support::Fixed => 0,
        Support::Pinned => 1,
        Support::Guided => 3,
        _ => 4,
    }
}

impl<S: Scalar> GeneralCompound<S> {
    /// The compound of a beam with these constants.
    #[inline]
    pub(crate) fn new(section: SectionAt<S>, units: Units<S>) -> Self {
        GeneralCompound::of_products(section, section.waves.in_form().products(), units)
    }

    /// The compound of a beam with these constants and the products of its waves.
    #[inline]
    pub(super) fn of_products(section: SectionAt<S>, products: PairProducts<S>, units: Units<S>) -> Self {
        let SectionAt { sigma, tau, g, h, cut, .. } = section;
        let PairProducts { p, w, r, v, e, one, inverse_square, exponent } = products;
        let square = sigma * sigma;
        let twice_x = twice(h * square);
        let (tau_h, twice_v) = (tau * h, twice(v));
        let t = g + tau_h;
        let half_r = r.times_power_of_two(-1);
        let twice_xe = twice_x * e;
        // R/2 - tE cancels in strings, where the numerator over δ does not
        let difference = match inverse_square {
            Some(inverse) => ((twice_x + t * tau_h) * r - t * (one - p)) * inverse,
            None => half_r - t * e,
        };
        GeneralCompound {
            k00: p + twice_xe,
            k01: w - tau_h * twice_v,
            k03: tau * w + cut * twice_v,
            k04: tau * r + twice(square * e),
            k10: g * w - h * cut * twice_v,
            k11: p,
            k13: cut * r,
            k20: -(h * sigma * (half_r + t * e)),
            k21: -(h * sigma * twice_v),
            k22: one - twice(twice_xe),
            k23: sigma * w,
            k24: sigma * difference,
            k30: -(h * (w + g * twice_v)),
            k31: -(h * r),
            k40: h * (twice_xe - g * r),
            exponent,
            section,
            units,
        }
    }

    /// Takes a subspace through the beam.
    pub(crate) fn step<C: RootCounter<S>>(&self, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        let after = self.behind(&input).in_range();
        if C::COUNTS {
            counter.plane(&input.plane(), &after, self.held());
        }
        Subspace::Plane(after)
    }

    /// Takes a subspace into the root.
    pub(crate) fn root<C: RootCounter<S>>(&self, input: Subspace<S>, support: Support, counter: &mut C) -> Scaled<S> {
        if !C::COUNTS {
            let (plane, row) = (input.plane(), row_at(support));
            let minor = self.minor(row, self.without_units(&plane)) * self.unit(row);
            return Scaled::new(minor, i64::from(plane.exponent.saturating_add(self.exponent)));
        }
        self.step(input, counter).at_root(support, counter)
    }

    /// The count of the beam with both ends clamped.
    pub(crate) fn clamped_count(&self) -> S::Size {
        clamped_count(&self.section, self.k04, self.k03)
    }

    /// What the count needs of the beam with both ends clamped.
    fn held(&self) -> Held<S> {
        Held {
            below: self.clamped_count(),
            is_negative: self.k04.is_negative(),
            stiffness: [self.units.factors[2] * self.k01, self.k04],
            units: None,
        }
    }

    /// The unit of a minor.
    #[inline]
    pub(super) fn unit(&self, minor: usize) -> S {
        if minor > 0 { self.units.factors[minor - 1] } else { S::one() }
    }

    /// A row of K.
    #[inline(always)]
    pub(super) fn row(&self, row: usize) -> [S; 5] {
        let k = self;
        match row {
            0 => [k.k00, k.k01, twice(k.k24), k.k03, k.k04],
            1 => [k.k10, k.k11, twice(k.k23), k.k13, k.k03],
            2 => [k.k20, k.k21, k.k22, k.k23, k.k24],
            3 => [k.k30, k.k31, twice(k.k21), k.k11, k.k01],
            _ => [k.k40, k.k30, twice(k.k20), k.k10, k.k00],
        }
    }

    /// The minors of a plane in units of l and EI.
    #[inline]
    fn without_units(&self, p: &Plane<S>) -> [S; 5] {
        let inverses = self.units.inverses;
        [p.y_theta, p.y_m * inverses[0], p.w * inverses[1], p.theta_q * inverses[2], p.m_q * inverses[3]]
    }

    /// The plane behind the beam, not shifted into the range.
    #[inline]
    fn behind(&self, input: &Subspace<S>) -> Plane<S> {
        match input {
            Subspace::Tip(support, _) => self.behind_tip(*support),
            _ => self.through(&input.plane()),
        }
    }

    /// The plane behind a beam that starts at a support: a column of K.
    #[inline]
    fn behind_tip(&self, support: Support) -> Plane<S> {
        let (k, inverses) = (self, self.units.inverses);
        let (column, inverse) = match support {
            Support::Fixed => ([k.k04, k.k03, k.k24, k.k01, k.k00], inverses[3]),
            Support::Pinned => ([k.k03, k.k13, k.k23, k.k11, k.k10], inverses[2]),
            Support::Guided => ([k.k01, k.k11, k.k21, k.k31, k.k30], inverses[0]),
            _ => ([k.k00, k.k10, k.k20, k.k30, k.k40], S::one()),
        };
        let [y_theta, y_m, w, theta_q, m_q] = column;
        self.plane([y_theta * inverse, y_m * inverse, w * inverse, theta_q * inverse, m_q * inverse], 0)
    }

    /// A plane with its units, from minors without, not shifted into the range.
    #[inline]
    fn plane(&self, [y_theta, y_m, w, theta_q, m_q]: [S; 5], exponent: i32) -> Plane<S> {
        let [a, b, c, d] = self.units.factors;
        Plane::unscaled([y_theta, y_m * a, w * b, theta_q * c, m_q * d], exponent.saturating_add(self.exponent))
    }

    /// Takes a plane through the beam. Its five rows are written out: an array's `map` is a call, and each row a branch in it.
    #[inline]
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let minors = self.without_units(p);
        let minor = |row: usize| self.minor(row, minors);
        self.plane([minor(0), minor(1), minor(2), minor(3), minor(4)], p.exponent)
    }

    /// A minor behind the beam, from those before it, both without units.
    #[inline(always)]
    fn minor(&self, row: usize, [a, b, c, d, e]: [S; 5]) -> S {
        let [k0, k1, k2, k3, k4] = self.row(row);
        (k0 * a + k1 * b) + (k2 * c + k3 * d) + k4 * e
    }
}
