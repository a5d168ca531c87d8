//! Diagrams of modes over their frequencies: a response spectrum with the modes on it, the mass that each mode takes, ranges over tolerances, a peak on its response.

use crate::chart::{Chart, page};
use crate::error::DrawingError;
use crate::outline::Outline;
use crate::picture::{element, path, text, titled};
use crate::vector::Vector;
use mstmm_core::search::{FrequencyRange, NaturalFrequency};
use mstmm_core::{Participation, Peak, ResponseSpectrum};
use std::f64::consts::TAU;
use std::fmt;
use std::path::Path;
use svg::Node;
use svg::node::element::Element;

/// Radius of a mode on a curve, and half the width of a bar and of a band.
const MODE: f64 = 4.5;
const BAR: f64 = 5.0;
const BAND: f64 = 6.0;

/// Points of a curve.
const POINTS: usize = 400;

/// How far axes reach beyond the largest value.
const BEYOND: f64 = 1.08;

/// A diagram of modes, which prints as SVG.
///
/// ```
/// use mstmm::prelude::*;
/// use mstmm_drawing::ModeDiagram;
///
/// system! {
///     struct Tower {}
///     fixed -> beam 1 { length: 20.0, bending_stiffness: 4e8, mass_per_length: 300.0 } -> point_mass 2 { mass: 5000.0 } -> free;
/// }
///
/// let tower = Tower {}.build()?;
/// let roots = tower.first_frequencies::<4>()?;
/// let participation = tower.participation::<4, _>(&roots, Direction::y())?;
/// let masses = ModeDiagram::masses(&roots, &participation)?;
/// assert!(masses.to_string().contains("part of all that moves [%]"));
/// // 4 m/s² up to 8 Hz, and less beyond
/// let spectrum = (|omega: f64, _ratio: f64| 4.0_f64.min(200.0 / omega), 1.5);
/// let peaks = ModeDiagram::spectrum(&roots, &spectrum, 0.05)?;
/// assert!(peaks.to_string().contains("spectral acceleration"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct ModeDiagram {
    most: Vector,
    names: [&'static str; 2],
    /// Lines with their classes.
    lines: Vec<(&'static str, Vec<Vector>)>,
    /// Points and bars with what is said of them.
    points: Vec<(Vector, String)>,
    bars: Vec<(Vector, String)>,
    /// From and to along x, and where along y.
    bands: Vec<([f64; 2], f64, String)>,
    /// A range of frequencies that is marked all through.
    marked: Option<[f64; 2]>,
}

impl ModeDiagram {
    /// A diagram without parts, of numbers that are all finite.
    fn with(most: Vector, names: [&'static str; 2], all: impl IntoIterator<Item = f64>) -> Result<Self, DrawingError> {
        if let Some(value) = all.into_iter().find(|value| !value.is_finite()) {
            return Err(DrawingError::NotFinite { name: String::from("a number of the diagram"), value });
        }
        let size = most[0].max(most[1]);
        let most = most.map(|value| BEYOND * value);
        Chart::up_to(most).ok_or(if size > 0.0 { DrawingError::Size { size } } else { DrawingError::Empty })?;
        Ok(ModeDiagram {
            most,
            names,
            lines: Vec::new(),
            points: Vec::new(),
            bars: Vec::new(),
            bands: Vec::new(),
            marked: None,
        })
    }

    /// A spectrum of accelerations [m/s²] at a damping ratio over the frequency, with the modes of some roots on it.
    ///
    /// # Errors
    /// [`DrawingError::Empty`] without roots, [`DrawingError::NotFinite`] and [`DrawingError::Size`] for values without a scale.
    pub fn spectrum(
        roots: &[NaturalFrequency],
        spectrum: &impl ResponseSpectrum<f64>,
        ratio: f64,
    ) -> Result<Self, DrawingError> {
        if roots.is_empty() {
            return Err(DrawingError::Empty);
        }
        let hertz = roots.iter().map(|root| root.omega / TAU);
        let highest = hertz.clone().fold(0.0, f64::max);
        let at = |hertz: f64| [hertz, spectrum.acceleration(TAU * hertz, ratio)];
        let curve: Vec<Vector> = (1..=POINTS).map(|k| at(BEYOND * highest * k as f64 / POINTS as f64)).collect();
        let most = curve.iter().map(|point| point[1]).fold(0.0, f64::max);
        let mut own = ModeDiagram::with(
            [highest, most],
            ["frequency [Hz]", "spectral acceleration [m/s²]"],
            hertz.clone().chain(curve.iter().map(|point| point[1])),
        )?;
        own.lines.push(("forward", curve));
        own.points = hertz.map(|hertz| (at(hertz), format!("{hertz:.3} Hz: {:.3} m/s²", at(hertz)[1]))).collect();
        Ok(own)
    }

    /// The part of the mass that each mode takes with it, as bars over the frequency, and their sum as a line.
    ///
    /// # Errors
    /// [`DrawingError::Roots`] for a participation of other roots, [`DrawingError::Empty`] where nothing moves along its direction; else as [`spectrum`](ModeDiagram::spectrum).
    pub fn masses<const N: usize>(
        roots: &[NaturalFrequency],
        participation: &Participation<f64, N>,
    ) -> Result<Self, DrawingError> {
        let of_shapes = participation.factors().last().map_or(0, |factor| factor.root + 1);
        if of_shapes != roots.len() {
            return Err(DrawingError::Roots { roots: roots.len(), of_shapes });
        }
        let last = roots.iter().map(|root| root.omega / TAU).fold(0.0, f64::max);
        if participation.total() == 0.0 {
            return Err(DrawingError::Empty);
        }
        let all = roots.iter().map(|root| root.omega).chain([participation.total()]);
        let mut own = ModeDiagram::with([last, 100.0], ["frequency [Hz]", "part of all that moves [%]"], all)?;
        let mut sum = vec![[0.0; 2]];
        for (mode, root) in roots.iter().enumerate() {
            let [part, all] = [participation.effective_mass(mode), participation.cumulative(mode)]
                .map(|mass| 100.0 * mass / participation.total());
            let hertz = root.omega / TAU;
            own.bars.push(([hertz, part], format!("{hertz:.3} Hz: {part:.2} %, all up to here {all:.2} %")));
            let before = sum.last().map_or(0.0, |last| last[1]);
            sum.extend([[hertz, before], [hertz, all]]);
        }
        own.lines.push(("backward", sum));
        Ok(own)
    }

    /// The ranges of frequencies over a box of tolerances, one line for each number.
    ///
    /// # Errors
    /// As [`spectrum`](ModeDiagram::spectrum).
    pub fn ranges(ranges: &[FrequencyRange<f64>]) -> Result<Self, DrawingError> {
        let last = ranges.iter().map(|range| range.highest.omega / TAU).fold(0.0, f64::max);
        let all = ranges.iter().flat_map(|range| [range.lowest.omega, range.highest.omega]);
        let mut own = ModeDiagram::with([last, ranges.len() as f64], ["frequency [Hz]", "number"], all)?;
        own.bands = ranges
            .iter()
            .enumerate()
            .map(|(number, range)| {
                let ends = [range.lowest, range.highest].map(|root| root.omega / TAU);
                (ends, number as f64 + 1.0, format!("{:.3} to {:.3} Hz", ends[0], ends[1]))
            })
            .collect();
        Ok(own)
    }

    /// The size of a response over the frequency, by samples `[Hz, size]`, with its peak and the line above which no frequency of the band is.
    ///
    /// # Errors
    /// As [`spectrum`](ModeDiagram::spectrum).
    pub fn peak(samples: &[[f64; 2]], peak: &Peak) -> Result<Self, DrawingError> {
        if samples.is_empty() {
            return Err(DrawingError::Empty);
        }
        let last = samples.iter().map(|sample| sample[0]).fold(0.0, f64::max);
        let largest = samples.iter().map(|sample| sample[1]).fold(peak.upper, f64::max);
        let all = samples.iter().flatten().copied().chain([peak.omega, peak.lower, peak.upper]);
        let mut own = ModeDiagram::with([last, largest], ["frequency [Hz]", "size of the response"], all)?;
        own.lines.push(("backward", vec![[0.0, peak.upper], [last, peak.upper]]));
        own.lines.push(("forward", samples.to_vec()));
        let title = format!("{:.3} Hz: from {:.6e} to {:.6e}", peak.hertz(), peak.lower, peak.upper);
        own.points.push(([peak.hertz(), peak.lower], title));
        Ok(own)
    }

    /// The diagram with a range of frequencies \[Hz\] that is marked, such as that of a machine; nothing where it is empty or reversed.
    #[must_use]
    pub fn marked(self, from: f64, to: f64) -> Self {
        ModeDiagram { marked: (from < to).then_some([from, to]), ..self }
    }

    /// Writes the diagram to a file.
    ///
    /// # Errors
    /// [`DrawingError::Io`] where the file refuses.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), DrawingError> {
        Ok(std::fs::write(path, self.to_string())?)
    }

    /// What is marked, behind the axes.
    fn behind(&self, chart: &Chart) -> Option<Element> {
        let [from, to] = self.marked?.map(|hertz| hertz.clamp(0.0, self.most[0]));
        let corners =
            [[from, 0.0], [to, 0.0], [to, self.most[1]], [from, self.most[1]]].map(|corner| chart.place(corner));
        Some(path("marked", &Outline::Area(corners.into())))
    }

    /// What is inside of the axes.
    fn inside(&self, chart: &Chart) -> Element {
        let mut all = element("g", "curves");
        for (place, title) in &self.bars {
            let [[x, top], [_, bottom]] = [chart.place(*place), chart.place([place[0], 0.0])];
            all.append(titled(path("bar", &area(x - BAR, x + BAR, bottom, top)), title));
        }
        for (class, line) in &self.lines {
            all.append(path(class, &Outline::line(line.iter().map(|point| chart.place(*point)).collect())));
        }
        for (ends, number, title) in &self.bands {
            let [[from, y], [to, _]] = ends.map(|hertz| chart.place([hertz, *number]));
            all.append(titled(path("bar", &area(from, to.max(from + 1.0), y + BAND, y - BAND)), title));
            all.append(text("order", [from - 14.0, y], &format!("{number}")));
        }
        for (place, title) in &self.points {
            all.append(titled(path("critical", &Outline::Disc(chart.place(*place), MODE)), title));
        }
        all
    }
}

/// A rectangle.
fn area(left: f64, right: f64, bottom: f64, top: f64) -> Outline {
    Outline::Area(vec![[left, bottom], [right, bottom], [right, top], [left, top]])
}

/// The diagram as SVG, of which a page can take the element as it is.
impl fmt::Display for ModeDiagram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(chart) = Chart::up_to(self.most) else { return Err(fmt::Error) };
        let parts = self.behind(&chart).into_iter().chain([chart.axes(self.names), self.inside(&chart)]);
        writeln!(f, "{}", page("a diagram of modes", parts))
    }
}
