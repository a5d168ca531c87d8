//! The paper's search settings and results, and the exact values: reads `tests/data/paper.json`.

use crate::quantity::{Quantity, Value};
use core::error::Error;
use core::ops::RangeInclusive;
use mstmm::prelude::*;
use serde_json::Value as Json;

/// A failure that ends the program with a message.
pub type Failure = Box<dyn Error>;

/// An example of the paper.
#[derive(Debug)]
pub struct Example {
    /// Section, with a letter for the parameter set.
    pub id: String,
    /// What it is.
    pub title: String,
    /// Number of the paper's table.
    pub table: usize,
    /// How the paper searched.
    pub search: Search,
    /// What the table lists.
    pub columns: Vec<Column>,
}

/// A search of the paper.
#[derive(Debug)]
pub enum Search {
    /// fMin1D over ω [rad/s].
    Line {
        /// Range of ω
        range: RangeInclusive<f64>,
        /// Grid points
        points: usize,
        /// Absolute tolerance [rad/s]
        tolerance: f64,
    },
    /// fMin2D over ω and δ [rad/s], λ = -δ + iω.
    Rectangle {
        /// Ranges of ω and δ
        ranges: [RangeInclusive<f64>; 2],
        /// Grid points in ω and δ
        points: [usize; 2],
        /// Absolute tolerance [rad/s]
        tolerance: f64,
    },
}

/// One quantity of a table.
#[derive(Debug)]
pub struct Column {
    /// The quantity as the reference data describes it.
    pub name: String,
    /// How to compute it.
    pub quantity: Quantity,
    /// The paper's own values.
    pub printed: Vec<Value>,
    /// The exact values, of the first modes like the printed ones.
    pub exact: Vec<Value>,
}

impl Column {
    /// The quantity without its explanation.
    pub fn symbol(&self) -> &str {
        symbol(&self.name)
    }
}

/// What stands before the first comma of a quantity's description.
fn symbol(name: &str) -> &str {
    name.split_once(", ").map_or(name, |(symbol, _)| symbol)
}

/// All examples, in the paper's order.
///
/// # Errors
/// The file is not as expected.
pub fn examples() -> Result<Vec<Example>, Failure> {
    let data: Json = serde_json::from_str(include_str!("../../../tests/data/paper.json"))?;
    list(&data["examples"], example)
}

fn example(data: &Json) -> Result<Example, Failure> {
    Ok(Example {
        id: text(&data["id"])?,
        title: text(&data["title"])?,
        table: whole(&data["table"])?,
        search: search(&data["paper_search"])?,
        columns: list(&data["values"], column)?,
    })
}

fn search(data: &Json) -> Result<Search, Failure> {
    let tolerance = number(&data["epsilon"])?;
    let points = whole(&data["n_x0"])?;
    if data["delta"].is_null() {
        return Ok(Search::Line { range: range(&data["range_rad_s"])?, points, tolerance });
    }
    let ranges = [range(&data["omega_rad_s"])?, range(&data["delta"])?];
    Ok(Search::Rectangle { ranges, points: [points, whole(&data["n_y0"])?], tolerance })
}

fn column(data: &Json) -> Result<Column, Failure> {
    let name = text(&data["quantity"])?;
    let quantity = Quantity::from_symbol(symbol(&name)).ok_or_else(|| format!("unknown quantity {name}"))?;
    Ok(Column { name, quantity, printed: list(&data["printed"], value)?, exact: list(&data["exact"], value)? })
}

/// A number, or real and imaginary part as a pair.
fn value(data: &Json) -> Result<Value, Failure> {
    match data.as_array().map(Vec::as_slice) {
        Some([re, im]) => Ok(Value::Complex(Complex::new(number(re)?, number(im)?))),
        _ => Ok(Value::Real(number(data)?)),
    }
}

fn range(data: &Json) -> Result<RangeInclusive<f64>, Failure> {
    match list(data, number)?.as_slice() {
        [start, end] => Ok(*start..=*end),
        _ => Err(format!("expected a range [start, end] instead of {data}").into()),
    }
}

fn list<T>(data: &Json, item: impl Fn(&Json) -> Result<T, Failure>) -> Result<Vec<T>, Failure> {
    data.as_array().ok_or_else(|| format!("expected a list instead of {data}"))?.iter().map(item).collect()
}

/// A number, or one with more digits than an `f64` holds, in quotes.
fn number(data: &Json) -> Result<f64, Failure> {
    let number = match data.as_str() {
        Some(digits) => digits.parse().ok(),
        None => data.as_f64(),
    };
    number.ok_or_else(|| format!("expected a number instead of {data}").into())
}

fn whole(data: &Json) -> Result<usize, Failure> {
    let number = data.as_u64().ok_or_else(|| format!("expected a whole number instead of {data}"))?;
    Ok(usize::try_from(number)?)
}

fn text(data: &Json) -> Result<String, Failure> {
    Ok(data.as_str().ok_or_else(|| format!("expected a text instead of {data}"))?.to_owned())
}
