//! The confirmation of a doubtful result by counts in extended precision, which costs less than a search there.

use crate::model::SearchError;
use crate::number::{Dual, Frequency, Real};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::sampling::Isolation;

/// Widest interval that is confirmed, in certified widths: a wider one is narrowed by a search.
const WIDEST: f64 = 1.25;

impl<'a, P, T, Y> Isolation<'a, Y, T>
where
    P: Real<Extended = T>,
    T: Real + Frequency<P>,
    Y: System<Parameter = P> + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + ?Sized,
{
    /// Whether the roots of a list, and no others, are counted in their intervals: in a range, or from zero on.
    pub(super) fn confirms(
        &mut self,
        list: &[NaturalFrequency<P>],
        range: Option<[T; 2]>,
    ) -> Result<bool, SearchError> {
        let (from, to) = match range {
            Some([start, end]) => self.enclosing(start, end).map(|[from, to]| (from, Some(to)))?,
            None => (self.just_above_zero, None),
        };
        let mut roots = self.sample(from)?.below;
        let width = (self.half_width + self.half_width) * T::from_f64(WIDEST);
        for root in list {
            if root.omega.is_zero() {
                if roots != root.multiplicity {
                    return Ok(false);
                }
                continue;
            }
            let [lower, upper] = [T::from_parameter(root.lower), T::from_parameter(root.upper)];
            if upper - lower > upper * width {
                return Ok(false);
            }
            // inside, as for every certificate: the rest is room for the rounding of parameters
            let inner = upper * self.half_width * T::from_f64(0.5);
            let [lower, upper] = [lower + inner, upper - inner];
            self.is_at_root = true;
            let sides = [self.sample(lower)?.below, self.sample(upper)?.below];
            self.is_at_root = false;
            if lower <= from || sides != [roots, roots + root.multiplicity] {
                return Ok(false);
            }
            roots += root.multiplicity;
        }
        match to {
            Some(to) => Ok(self.sample(to)?.below == roots),
            None => Ok(true),
        }
    }
}
