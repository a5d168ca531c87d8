//! The widths of beams: stiff ones are wide.

use crate::figure::Figure;
use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::outline::Outline;

/// Width of a beam among others as stiff as it is, and the least.
const USUAL: f64 = 3.6;
const LEAST: f64 = 1.8;

/// Scales all widths of beams alike, so that they are seen; a beam without one has the usual width.
///
/// Where all are alike they have the usual width. The more they differ, the wider is the stiffest one, up to twice the usual width.
pub(crate) fn scale_beams<M>(figure: &mut Figure<M>) {
    let mut widths: Vec<&mut f64> = figure.parts.iter_mut().filter_map(|part| width_of(&mut part.kind)).collect();
    let known = || widths.iter().map(|width| **width).filter(|width| *width > 0.0 && width.is_finite());
    let (least, most) = (known().fold(f64::INFINITY, f64::min), known().fold(0.0, f64::max));
    let factor = USUAL * (2.0 - least / most) / most;
    for width in &mut widths {
        let own = **width * factor;
        **width = if own > 0.0 && own.is_finite() { own.max(LEAST) } else { USUAL };
    }
}

/// A beam of some width.
pub(super) fn line(outline: Outline, width: f64) -> Ink {
    // the style sheet has the usual one
    let is_usual = (width - USUAL).abs() < 0.005;
    Ink { width: (!is_usual).then_some(width), ..Ink::new(Pen::Beam, outline) }
}

/// The width of a beam.
fn width_of(kind: &mut Kind) -> Option<&mut f64> {
    if let Kind::Beam { width, .. } = kind { Some(width) } else { None }
}
