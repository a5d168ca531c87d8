//! The frame of a chart: axes with ticks and their names.

use crate::outline::{Outline, number};
use crate::picture::{element, path, text};
use crate::vector::Vector;
use svg::Node;
use svg::node::Text;
use svg::node::element::Element;

/// Left, right, upper and lower end of the area.
const LEFT: f64 = 66.0;
const RIGHT: f64 = 620.0;
const TOP: f64 = 24.0;
const BOTTOM: f64 = 384.0;

/// Size of the picture.
const SIZE: [f64; 2] = [700.0, 440.0];

/// About so many ticks of an axis.
const TICKS: f64 = 6.0;

/// A chart from zero to the largest value of each axis.
pub(crate) struct Chart {
    most: Vector,
}

impl Chart {
    /// A chart that holds values up to the largest of each axis; none of values that are not positive and finite.
    pub(crate) fn up_to(most: Vector) -> Option<Self> {
        let is_in_range = |value: &f64| *value > 0.0 && value.is_finite() && (1.0 / *value).is_finite();
        most.iter().all(is_in_range).then_some(Chart { most })
    }

    /// The largest value of each axis.
    pub(crate) fn most(&self) -> Vector {
        self.most
    }

    /// The place of a point on the paper.
    pub(crate) fn place(&self, [x, y]: Vector) -> Vector {
        [LEFT + (RIGHT - LEFT) * x / self.most[0], BOTTOM - (BOTTOM - TOP) * y / self.most[1]]
    }

    /// The axes with their ticks and names.
    pub(crate) fn axes(&self, names: [&str; 2]) -> Element {
        let mut all = element("g", "axes");
        for axis in 0..2 {
            let step = step(self.most[axis] / TICKS);
            let count = (self.most[axis] / step * (1.0 + 1e-9)) as usize;
            let exponent = exponent_of(self.most[axis]);
            let unit = 10.0_f64.powi(exponent);
            for value in (0..=count).map(|k| k as f64 * step) {
                let at = self.place(if axis == 0 { [value, 0.0] } else { [0.0, value] });
                let end = if axis == 0 { [at[0], TOP] } else { [RIGHT, at[1]] };
                all.append(path("grid", &Outline::line(vec![at, end])));
                let digits = (-(step / unit).log10().floor()).clamp(0.0, 12.0) as usize;
                let shift = if axis == 0 { [0.0, 16.0] } else { [-8.0, 0.0] };
                let class = if axis == 0 { "tick" } else { "tick end" };
                all.append(text(class, [at[0] + shift[0], at[1] + shift[1]], &format!("{:.digits$}", value / unit)));
            }
        }
        let [along, upwards] = [0, 1].map(|axis| name_of(names[axis], exponent_of(self.most[axis])));
        all.append(text("name", [0.5 * (LEFT + RIGHT), BOTTOM + 40.0], &along));
        let mut upright = text("name", [0.0; 2], &upwards);
        upright
            .assign("transform", format!("translate({} {}) rotate(-90)", number(18.0), number(0.5 * (TOP + BOTTOM))));
        all.append(upright);
        let corners = [[0.0, self.most[1]], [0.0, 0.0], [self.most[0], 0.0]].map(|corner| self.place(corner));
        all.append(path("frame", &Outline::line(corners.into())));
        all
    }
}

/// The exponent of ten by which ticks up to a value are divided: a multiple of three, and zero between a hundredth and a hundred thousand.
fn exponent_of(most: f64) -> i32 {
    if (1e-2..1e5).contains(&most) { 0 } else { 3 * (most.log10() / 3.0).floor() as i32 }
}

/// The name of an axis, with the power of ten by which its ticks are divided.
fn name_of(name: &str, exponent: i32) -> String {
    if exponent == 0 { name.to_owned() } else { format!("{name}, times 1e{exponent}") }
}

/// A chart as a picture, of its parts.
pub(crate) fn page(label: &str, parts: impl IntoIterator<Item = Element>) -> Element {
    let mut svg = element("svg", "mstmm-chart");
    svg.assign("xmlns", "http://www.w3.org/2000/svg");
    svg.assign("viewBox", format!("0 0 {} {}", SIZE[0], SIZE[1]));
    svg.assign("width", SIZE[0]);
    svg.assign("height", SIZE[1]);
    svg.assign("role", "img");
    svg.assign("aria-label", label);
    let mut style = Element::new("style");
    style.append(Text::new(include_str!("style_of_charts.css")));
    svg.append(style);
    parts.into_iter().for_each(|part| svg.append(part));
    svg
}

/// 1, 2 or 5 times a power of ten, about as large as a number.
fn step(about: f64) -> f64 {
    let power = 10f64.powf(about.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|step| *step >= about).unwrap_or(10.0 * power)
}
