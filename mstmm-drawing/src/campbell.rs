//! Campbell diagrams: the frequencies of both whirls of a rotor over its speed, with lines of order and critical speeds.

use crate::chart::{Chart, page};
use crate::error::DrawingError;
use crate::outline::Outline;
use crate::picture::{element, path, text, titled};
use crate::vector::Vector;
use mstmm_core::search::{AtSpeed, CriticalSpeed};
use std::f64::consts::TAU;
use std::fmt;
use std::path::Path;
use svg::Node;
use svg::node::element::Element;

/// Radius of a critical speed.
const CRITICAL: f64 = 4.5;

/// Revolutions per minute of a speed of 1 rad/s.
const RPM: f64 = 60.0 / TAU;

/// A Campbell diagram, which prints as SVG: frequencies in Hz over the speed in rpm, of forward whirl as whole lines, of backward whirl as broken ones.
///
/// ```
/// use mstmm::prelude::*;
/// use mstmm::search::{campbell, critical_speeds};
/// use mstmm_drawing::CampbellDiagram;
///
/// system! {
///     struct Overhung { speed: f64 }
///     fixed -> beam 1 {
///         length: 0.6, bending_stiffness: 6e4, mass_per_length: 15.0, rotary_inertia: 2.4e-3, polar_inertia_per_length: 4.8e-3, speed
///     } -> disc 2 { mass: 30.0, inertia: 0.3, polar_inertia: 0.6, speed } -> free;
/// }
///
/// let build = |speed| Overhung { speed }.build();
/// let speeds = (0..=20).map(|k| 30.0 * f64::from(k));
/// let at_speeds: Vec<_> = campbell::<3, _>(speeds, build).collect::<Result<_, _>>()?;
/// let critical = critical_speeds::<4, _>(1.0..=600.0, Whirl::Backward, 1.0, build)?;
/// let diagram = CampbellDiagram::of(&at_speeds)?.order(1.0).critical(1.0, &critical);
/// assert!(diagram.to_string().contains("frequency [Hz]"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct CampbellDiagram {
    most: Vector,
    /// The points of the curves of forward and of backward whirl, by the number of the frequency.
    curves: [Vec<Vec<Vector>>; 2],
    orders: Vec<f64>,
    critical: Vec<Vector>,
}

impl CampbellDiagram {
    /// The diagram of lists of frequencies at speeds.
    ///
    /// # Errors
    /// [`DrawingError::Empty`] where no frequency is above zero, or no speed; [`DrawingError::Size`] for speeds or frequencies without a scale.
    pub fn of<const N: usize>(at_speeds: &[AtSpeed<N>]) -> Result<Self, DrawingError> {
        let mut curves = [const { Vec::new() }; 2];
        let mut most = [0.0_f64; 2];
        for AtSpeed { speed, forward, backward } in at_speeds {
            for (curves, list) in curves.iter_mut().zip([forward, backward]) {
                for root in list.iter() {
                    // coinciding roots are so many curves
                    for index in (root.index..root.index + root.multiplicity).map(|index| index as usize) {
                        curves.resize(curves.len().max(index), Vec::new());
                        let point = [speed.abs() * RPM, root.omega / TAU];
                        curves[index - 1].push(point);
                        most = [most[0].max(point[0]), most[1].max(point[1])];
                    }
                }
            }
        }
        for curve in curves.iter_mut().flatten() {
            curve.sort_by(|one, other| one[0].total_cmp(&other[0]));
        }
        if most.contains(&0.0) {
            return Err(DrawingError::Empty);
        }
        let size = most[0].max(most[1]);
        Chart::up_to(most).ok_or(DrawingError::Size { size })?;
        Ok(CampbellDiagram { most, curves, orders: Vec::new(), critical: Vec::new() })
    }

    /// The diagram with the line of an order, a frequency so many times the speed. One that is not positive has no line.
    #[must_use]
    pub fn order(mut self, order: f64) -> Self {
        self.orders.extend(Some(order).filter(|order| *order > 0.0 && order.is_finite()));
        self
    }

    /// The diagram with critical speeds of an order.
    #[must_use]
    pub fn critical(mut self, order: f64, speeds: &[CriticalSpeed]) -> Self {
        self.critical.extend(speeds.iter().map(|critical| [critical.speed * RPM, order * critical.speed / TAU]));
        self
    }

    /// Writes the diagram to a file.
    ///
    /// # Errors
    /// [`DrawingError::Io`] where the file refuses.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), DrawingError> {
        Ok(std::fs::write(path, self.to_string())?)
    }

    /// What is inside of the axes.
    fn inside(&self, chart: &Chart) -> Element {
        let mut all = element("g", "curves");
        for (class, curves) in ["forward", "backward"].into_iter().zip(&self.curves) {
            for curve in curves {
                let points = curve.iter().map(|point| chart.place(*point)).collect();
                all.append(path(class, &Outline::line(points)));
            }
        }
        let [speed, frequency] = chart.most();
        for order in &self.orders {
            // a frequency in Hz at a speed in rpm
            let slope = order / 60.0;
            let end = if slope * speed <= frequency { [speed, slope * speed] } else { [frequency / slope, frequency] };
            let [from, to] = [[0.0; 2], end].map(|point| chart.place(point));
            all.append(path("order", &Outline::line(vec![from, to])));
            // beside the area, or below its upper edge
            let shift = if end[1] < frequency { [16.0, -8.0] } else { [14.0, 12.0] };
            all.append(text("order", [to[0] + shift[0], to[1] + shift[1]], &format!("{order}x")));
        }
        for critical in self.critical.iter().filter(|critical| critical[0] <= speed && critical[1] <= frequency) {
            let circle = path("critical", &Outline::Disc(chart.place(*critical), CRITICAL));
            all.append(titled(circle, &format!("{:.1} rpm", critical[0])));
        }
        all
    }
}

/// What both kinds of lines are, above the diagram.
fn legend() -> Element {
    let mut all = element("g", "legend");
    for (class, x) in [("forward", 72.0), ("backward", 205.0)] {
        all.append(path(class, &Outline::line(vec![[x, 10.0], [x + 30.0, 10.0]])));
        all.append(text("legend", [x + 36.0, 10.0], &format!("{class} whirl")));
    }
    all
}

/// The diagram as SVG, of which a page can take the element as it is.
impl fmt::Display for CampbellDiagram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(chart) = Chart::up_to(self.most) else { return Err(fmt::Error) };
        let parts = [chart.axes(["speed [rpm]", "frequency [Hz]"]), self.inside(&chart), legend()];
        writeln!(f, "{}", page("a Campbell diagram", parts))
    }
}
