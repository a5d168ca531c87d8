//! Elements that are known by their step of the plane method alone: their stiffness for a count without a proof.

use crate::element::{Element, OwnPart, PlaneStep, space_of};
use crate::number::{FrequencyPowers, Real, Scalar, Size};
use crate::subspace::{Line, RootCounter, Subspace};

/// The stiffness of an element of one motion at ω, which is the sum of two words; none of other elements.
///
/// The step takes a line to `F U z` with `det U = 1`: a column of `F U` each from the lines (1, 0) and (0, 1), F from their determinant. A line has the force against
/// the displacement of its input end, in rotation, too.
#[doc(hidden)]
pub fn own_part<E, S>(built: &E::Built, [hi, lo]: [f64; 2]) -> Option<OwnPart>
where
    E: Element + PlaneStep<S>,
    S: Real,
{
    let space = space_of::<E>();
    if space.count() != 1 {
        return None;
    }
    let at = FrequencyPowers::new(S::from_f64(hi) + S::from_f64(lo), true);
    let coefficients = E::coefficients(built, &at);
    let mut held = HeldLine { below: 0.0, is_negative: false };
    let mut column = |y: S, q: S| {
        let input = Subspace::Line(Line::new(y, q, 0), space);
        let line = E::step(&coefficients, input, &mut held).line();
        [line.y, line.q].map(|entry| entry.times_power_of_two(line.exponent))
    };
    let ([a, c], [b, d]) = (column(S::one(), S::zero()), column(S::zero(), S::one()));
    let size = (a * d - b * c).sqrt();
    let factor = if held.is_negative { -size } else { size };
    let held = held.below;
    if b.vanishes() {
        let ratio = a / factor;
        return Some(OwnPart::Tie { ratio: ratio.words(), stiffness: (-(ratio * c / factor)).words() });
    }
    let stiffness = [-(a / b), factor / b, -(d / b)].map(S::words);
    Some(OwnPart::Stiffness { stiffness, held })
}

/// A counter that hears how many frequencies an element has with both ends held.
struct HeldLine {
    below: f64,
    is_negative: bool,
}

impl<S: Scalar<Truth = bool>> RootCounter<S> for HeldLine {
    const COUNTS: bool = true;

    fn line(&mut self, _before: &Line<S>, _after: &Line<S>, held: S::Size, is_negative: bool) {
        (self.below, self.is_negative) = (held.first(), is_negative);
    }
}
