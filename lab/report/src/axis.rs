//! Axes: what is measured, its range, ticks and their labels.

use plotters::coord::ranged1d::{BoldPoints, KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::ops::Range;

/// Ticks of a logarithmic axis, at most.
const TICKS: i32 = 7;

/// Exponent of the least distance from zero that a magnifying axis shows.
const NEAREST: i32 = -16;

/// How values become coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scale {
    Linear,
    /// Coordinates are exponents of ten.
    Logarithmic,
    /// Zero is in the middle, exponents grow to both sides from the least.
    Magnifying,
}

/// An axis.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// What is measured, with its unit.
    pub(crate) title: &'static str,
    range: Range<f64>,
    ticks: Vec<f64>,
    scale: Scale,
    /// A tick with words instead of a number.
    named: Option<(f64, &'static str)>,
}

impl Axis {
    /// A linear axis.
    pub(crate) fn linear(title: &'static str, range: Range<f64>) -> Self {
        let ticks = RangedCoordf64::from(range.clone()).key_points(BoldPoints(6));
        Axis { title, range, ticks, scale: Scale::Linear, named: None }
    }

    /// A logarithmic axis over the decades that hold a range.
    pub(crate) fn logarithmic(title: &'static str, range: Range<f64>) -> Self {
        let (low, high) = (range.start.log10().floor() as i32, range.end.log10().ceil() as i32);
        let high = high.max(low + 1);
        let step = ((high - low) as u32).div_ceil(TICKS as u32).max(1);
        // ticks at multiples of the step, so that 10⁰ is one of them
        let first = low.div_euclid(step as i32) * step as i32;
        let ticks = (first..=high).step_by(step as usize).filter(|&tick| tick >= low).map(f64::from).collect();
        Axis { title, range: f64::from(low)..f64::from(high), ticks, scale: Scale::Logarithmic, named: None }
    }

    /// A logarithmic axis over the decades that hold all positive finite values; one decade if there is none.
    pub(crate) fn over(title: &'static str, values: impl Iterator<Item = f64>) -> Self {
        let usable = values.filter(|&value| value > 0.0 && value.is_finite());
        let (low, high) = usable.fold((f64::INFINITY, 0.0), |(low, high), value| (value.min(low), value.max(high)));
        Axis::logarithmic(title, if low <= high { low..high } else { 1.0..10.0 })
    }

    /// An axis on which every decade of the distance from zero has the same width, down to a rounding, with ticks at some exponents.
    pub(crate) fn magnifying(title: &'static str, farthest: i32, ticks: &[i32]) -> Self {
        let end = f64::from(farthest - NEAREST);
        let places = ticks.iter().map(|exponent| f64::from(exponent - NEAREST));
        let ticks = places.clone().map(|place| -place).chain([0.0]).chain(places).collect();
        Axis { title, range: -end..end, ticks, scale: Scale::Magnifying, named: None }
    }

    /// The same with other ticks.
    pub(crate) fn with_ticks(self, ticks: Vec<f64>) -> Self {
        Axis { ticks, ..self }
    }

    /// The same with a name for one coordinate, which is made a tick.
    pub(crate) fn with_name(mut self, coordinate: f64, name: &'static str) -> Self {
        self.ticks.retain(|&tick| tick < coordinate - 1.0);
        self.ticks.push(coordinate);
        self.range.end = self.range.end.max(coordinate);
        Axis { named: Some((coordinate, name)), ..self }
    }

    /// The coordinate of a value, moved into the range.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let coordinate = match self.scale {
            Scale::Linear => value,
            Scale::Logarithmic => value.log10(),
            Scale::Magnifying => value.signum() * (value.abs().log10() - f64::from(NEAREST)).max(0.0),
        };
        coordinate.clamp(self.range.start, self.range.end)
    }

    /// The text at a tick.
    fn label(&self, tick: f64) -> String {
        match self.named {
            Some((coordinate, name)) if coordinate == tick => name.to_owned(),
            _ if self.scale == Scale::Logarithmic => power_of_ten(tick as i32),
            _ if self.scale == Scale::Magnifying && tick != 0.0 => {
                let sign = if tick < 0.0 { "−" } else { "" };
                format!("{sign}{}", power_of_ten(tick.abs() as i32 + NEAREST))
            }
            _ => grouped(tick),
        }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        RangedCoordf64::from(self.range.clone()).map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // no lines between the ticks
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        value.to_string()
    }

    fn format_ext(&self, tick: &f64) -> String {
        self.label(*tick)
    }
}

/// 10ⁿ in characters, without markup.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    let raised = |digit| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        // 0 and 4 to 9 stand in a row of their own
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    exponent.to_string().chars().fold("10".to_owned(), |text, digit| text + &raised(digit).to_string())
}

/// A number with a true minus sign and thin spaces between thousands.
fn grouped(value: f64) -> String {
    // ticks are sums of steps and carry their roundings
    let text = format!("{}", (value.abs() * 1e6).round() / 1e6);
    let (whole, rest) = text.split_once('.').map_or((text.as_str(), String::new()), |(a, b)| (a, format!(".{b}")));
    let digits: Vec<char> = whole.chars().collect();
    let groups: Vec<String> = digits.rchunks(3).rev().map(|group| group.iter().collect()).collect();
    // four digits stay together
    let whole = if digits.len() > 4 { groups.join("\u{2009}") } else { whole.to_owned() };
    let sign = if value < 0.0 { "−" } else { "" };
    format!("{sign}{whole}{rest}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_of_decades_are_powers_of_ten() {
        let axis = Axis::over("", [3e-6, f64::INFINITY, 0.0, 2e-3].into_iter());
        assert_eq!(axis.range, -6.0..-2.0);
        let labels: Vec<_> = axis.ticks.iter().map(|tick| axis.label(*tick)).collect();
        assert_eq!(labels, ["10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"]);
        assert_eq!(axis.place(1e-3), -3.0);
        assert_eq!(axis.place(1e9), -2.0);
    }

    #[test]
    fn a_magnifying_axis_has_decades_on_both_sides_of_zero() {
        let axis = Axis::magnifying("", -1, &[-12, -4]);
        let labels: Vec<_> = axis.ticks.iter().map(|tick| axis.label(*tick)).collect();
        assert_eq!(labels, ["−10⁻¹²", "−10⁻⁴", "0", "10⁻¹²", "10⁻⁴"]);
        assert_eq!([-1e-4, 1e-12, 0.0, 1e-20].map(|value| axis.place(value)), [-12.0, 4.0, 0.0, 0.0]);
    }

    #[test]
    fn wide_ranges_have_few_ticks_and_one_at_1() {
        let ticks = Axis::logarithmic("", 1e-15..1e15).ticks;
        assert!(ticks.len() <= TICKS as usize + 1 && ticks.contains(&0.0), "{ticks:?}");
    }

    #[test]
    fn a_name_takes_the_place_of_ticks() {
        let axis = Axis::logarithmic("", 1e-3..10.0).with_name(3.0, "lost");
        assert_eq!(axis.label(3.0), "lost");
        assert!(axis.ticks.iter().all(|&tick| tick == 3.0 || tick < 2.0));
    }

    #[test]
    fn numbers_are_grouped_and_free_of_rounding() {
        assert_eq!([0.1 + 0.2, -1000.0, 20_000.0].map(grouped), ["0.3", "−1000", "20\u{2009}000"]);
    }
}
