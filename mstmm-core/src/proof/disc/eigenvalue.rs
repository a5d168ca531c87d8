//! A proven eigenvalue: an estimate is moved to where the proof sees it.

use crate::proof::disc::complex::{ComplexBall, modulus};
use crate::proof::disc::memory::{Two, examine_in};
use crate::proof::disc::room::Examined;
use crate::proof::number::Number;
use crate::proof::visit::Visited;
use num_complex::Complex;

/// Radius of the discs that are examined, in units of eps of the modulus. An estimate that is off by more moves first. A larger disc would prove more
/// estimates at once, and bounds on it are wider. The proof holds on a disc of any radius.
pub(crate) const MOST: f64 = 16.0;

/// Radius, in the same units, with which an eigenvalue is settled: neighbouring floats are as far apart.
const ENOUGH: f64 = 1.0;

/// Centres that are examined. Each step doubles the digits of an estimate (Newton): three take two digits to sixteen. Where more are needed there is no
/// disc, and the search says so.
const CENTRES: usize = 4;

/// A disc that holds exactly one eigenvalue.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProvenDisc {
    pub(crate) centre: Complex<f64>,
    pub(crate) radius: f64,
}

/// Examines a disc; nothing where nothing is known.
pub(crate) fn examined(model: &dyn Visited, centre: Complex<f64>, most: f64) -> Option<Examined> {
    let centre = ComplexBall::exactly(Two::of(centre.re), Two::of(centre.im));
    examine_in(model, centre, most).ok()
}

/// A disc with exactly one eigenvalue, as small as it is proven, about a centre no farther than a distance from an estimate. A part of the estimate
/// that is zero stays zero.
pub(crate) fn proven_disc(model: &dyn Visited, estimate: Complex<f64>, reach: f64) -> Option<ProvenDisc> {
    let (mut centre, mut best) = (estimate, None::<ProvenDisc>);
    for _ in 0..CENTRES {
        let unit = modulus(centre.re, centre.im) * f64::EPSILON;
        let Some(Examined { radius, step }) = examined(model, centre, MOST * unit) else { break };
        if let Some(radius) = radius
            && best.is_none_or(|best| radius < best.radius)
        {
            best = Some(ProvenDisc { centre, radius });
        }
        let part = |of: f64, step: f64| if of == 0.0 { 0.0 } else { of + step };
        let next = Complex::new(part(centre.re, step.re), part(centre.im, step.im));
        let moved = next - estimate;
        let may_go_on = modulus(moved.re, moved.im) <= reach && next != centre;
        if radius.is_some_and(|radius| radius <= ENOUGH * unit) || !may_go_on {
            break;
        }
        centre = next;
    }
    best
}
