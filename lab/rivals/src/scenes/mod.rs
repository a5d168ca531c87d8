//! What methods are compared on: the examples of the paper, and extremes.

pub mod extremes;
mod searches;
mod structures;

use crate::contour::Ellipse;
use crate::error::Error;
use crate::found::Found;
use crate::plain::Line;
use crate::structure::Structure;
use core::f64::consts::PI;
use core::fmt;
use core::ops::RangeInclusive;
use extremes::{FreeFixed, SoftAndStiff, Twins};
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;
use paper::models;

/// Stiffness of the spring between the twin cantilevers: their first two frequencies differ by a relative 3.2e-9.
pub const WEAK: f64 = 1e-8;

/// How many times stiffer every other beam of the stiff scene is.
pub const STIFF: f64 = 1e12;

/// A system with its wanted roots, and the methods that depend on its type.
pub struct Scene {
    /// "4.1a", "4.2", .., "mode 100", "close pair", "stiff".
    pub name: &'static str,
    /// The wanted roots, by ascending imaginary part; undamped ones are iω.
    pub exact: Vec<Complex<f64>>,
    /// The system as finite elements see it.
    pub structure: Structure,
    /// Square of a frequency [rad²/s²]: the wanted roots are those nearest to it.
    pub shift: f64,
    /// Whether wanted roots are so close that a single Krylov space does not tell them apart.
    pub has_close_roots: bool,
    /// The certified search.
    pub certified: Box<dyn Fn() -> Found>,
    /// The plain method with a relative tolerance.
    pub plain: Box<dyn Fn(f64) -> Found>,
    /// The paper's scan for minima with a tolerance, relative to the end of its range.
    pub scan: Box<dyn Fn(f64) -> Found>,
    /// The contour integral method with a number of quadrature nodes; for damped systems.
    pub contour: Option<Box<dyn Fn(usize) -> Found>>,
}

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scene").field("name", &self.name).field("exact", &self.exact).finish_non_exhaustive()
    }
}

/// A scene of an undamped model: its first `$wanted` frequencies, with range and grid points of the scan.
macro_rules! first {
    ($name:literal, $model:expr, $wanted:literal, $range:expr, $points:expr, $structure:expr) => {{
        let model = $model;
        let judge = model.build_as::<DoubleDouble>()?.first_frequencies::<$wanted>()?;
        let exact = judge.iter().map(|root| root.omega.to_f64()).collect();
        let certified = |system: &_| searches::first::<_, $wanted>(system);
        searches::undamped($name, model.build()?, certified, exact, $range, $points, $structure)
    }};
}

/// All scenes. Scans have the paper's ranges and grids; in 4.4 the range is cut, since it holds a sixth root.
///
/// # Errors
/// [`Error`] if a model cannot be built or its exact roots are not found.
pub fn all() -> Result<Vec<Scene>, Error> {
    let (a, b) = (models::light_tip_body(), models::restrained_beam());
    let (c, d) = (models::spring_and_mass(), models::two_spans());
    Ok(vec![
        first!("4.1a", a, 5, 1.0..=1700.0, 100, structures::tip_body(&a)),
        first!("4.2", b, 3, 1.0..=3000.0, 100, structures::restrained_beam(&b)),
        first!("4.3", c, 3, 1.0..=2000.0, 100, structures::spring_and_mass(&c)),
        first!("4.4", d, 5, 1.0..=17_500.0, 437, structures::two_spans(&d)),
        damped()?,
        hundredth()?,
        Scene {
            has_close_roots: true,
            ..first!("close pair", Twins { stiffness: WEAK }, 2, 1.0..=10.0, 1000, structures::twins(WEAK))
        },
        first!("stiff", SoftAndStiff { stiff: STIFF }, 3, 0.1..=8.0, 100, structures::soft_and_stiff(STIFF)),
    ])
}

/// The hundredth frequency of a beam, sought between those of the pinned beam of as many half-waves: no other is there.
fn hundredth() -> Result<Scene, Error> {
    let range = || -> RangeInclusive<f64> { (99.0 * PI).powi(2)..=(100.0 * PI).powi(2) };
    let wide = DoubleDouble::from_f64(*range().start())..=DoubleDouble::from_f64(*range().end());
    let judge = FreeFixed {}.build_as::<DoubleDouble>()?.natural_frequencies::<2>(wide)?;
    let exact = judge.iter().map(|root| root.omega.to_f64()).collect();
    let certified = move |system: &_| searches::in_range(system, range());
    let scene =
        searches::undamped("mode 100", FreeFixed {}.build()?, certified, exact, range(), 100, structures::cantilever());
    // next to the root at 99.5π and not at it, where the shifted matrix is singular
    Ok(Scene { shift: (99.6 * PI).powi(4), ..scene })
}

/// The damped example, in the paper's rectangle.
fn damped() -> Result<Scene, Error> {
    let model = models::damped_oscillator();
    let structure = structures::damped_oscillator(&model);
    let wide = |x: f64| DoubleDouble::from_f64(x);
    let region = Region { re: wide(-300.0)..=wide(5.0), im: wide(-10.0)..=wide(12_000.0) };
    let judge = model.build_as::<DoubleDouble>()?.eigenvalues::<8>(region)?;
    let exact = judge.iter().map(|root| Complex::new(root.lambda.re.to_f64(), root.lambda.im.to_f64())).collect();
    Ok(searches::damped("4.5", model.build()?, exact, structure))
}

/// The fewest grid points, equally spaced in the square root of ω, that separate neighbouring roots in a range; a
/// thousand where no fewer do.
pub(crate) fn fewest_points(roots: &[f64], range: &RangeInclusive<f64>) -> usize {
    let (start, end) = (range.start().sqrt(), range.end().sqrt());
    let cell = |root: f64, points: usize| ((root.sqrt() - start) / (end - start) * (points - 1) as f64).floor();
    let separates = |&points: &usize| roots.windows(2).all(|pair| cell(pair[0], points) < cell(pair[1], points));
    (2..1000).find(separates).unwrap_or(1000)
}

/// Where the plain method looks for the damped roots: the fewest points and a line from which Muller's method finds them all.
pub(crate) const LINE: Line = Line { re: -10.0, points: 17 };

/// Where the contour integral method looks for the damped roots: of the ellipses tried, the one with the fewest nodes.
pub(crate) const ELLIPSE: Ellipse = Ellipse { width: 3862.0, height: 12_230.0 };
