//! What cannot be written, and why.

use std::io;

/// A file that could not be written, or not as its format asks.
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// The file refuses.
    #[error("the file cannot be written: {0}")]
    Io(#[from] io::Error),
    /// A table refuses.
    #[error("the table cannot be written: {0}")]
    Csv(#[from] csv::Error),
    /// There are no samples.
    #[error("there is nothing to write: a function has a sample at least, and a state space a mode")]
    Empty,
    /// A number is not finite.
    #[error("row {row} has a number that is not finite")]
    NotFinite {
        /// The sample or the mode, from 0 on.
        row: usize,
    },
    /// A frequency is negative.
    #[error("sample {row} is at {omega} rad/s, but frequencies of a response are not negative")]
    Negative {
        /// The sample, from 0 on.
        row: usize,
        /// Its frequency [rad/s].
        omega: f64,
    },
    /// Frequencies do not grow, or are equal in the digits of the format.
    #[error("sample {row} is at {hertz} Hz, not above the one before it in the eight digits that the format has")]
    Order {
        /// The sample, from 0 on.
        row: usize,
        /// Its frequency in hertz.
        hertz: f64,
    },
    /// A number has more digits in its exponent than the format.
    #[error("{value:e} does not fit into its columns, whose exponents have two digits")]
    Columns {
        /// The number.
        value: f64,
    },
    /// A text is longer than its columns, or has characters that are not printable ASCII.
    #[error("`{text}` must be printable ASCII of at most {columns} characters")]
    Text {
        /// The text.
        text: String,
        /// How many characters there is room for.
        columns: usize,
    },
    /// A shape has another number of values than there are points.
    #[error("the shape of mode {row} has {values} values for {points} points")]
    Shape {
        /// The mode, from 0 on.
        row: usize,
        /// Its values.
        values: usize,
        /// The points.
        points: usize,
    },
    /// A shape in space has not three numbers for each point, or six.
    #[error("the shape of mode {row} has {values} values, but {points} points take 3 each, or 6 with rotations")]
    Vectors {
        /// The mode, from 0 on.
        row: usize,
        /// Its values.
        values: usize,
        /// The points.
        points: usize,
    },
    /// A geometry has no points.
    #[error("there are no points: shapes are shown on points")]
    NoPoints,
    /// There are no modes.
    #[error("there are no modes: the file has one data set for each")]
    NoModes,
    /// A geometry has no lines.
    #[error("there are no lines: shapes are shown on lines")]
    NoLines,
    /// A place is not finite.
    #[error("point {point} has a coordinate that is not finite")]
    Place {
        /// The point, from 0 on.
        point: usize,
    },
    /// A line has less than two points.
    #[error("line {line} has less than two points")]
    ShortLine {
        /// The line, from 0 on.
        line: usize,
    },
    /// A line leads through a point that is not there.
    #[error("line {line} leads through point {point}, but points end at {points}")]
    NoSuchPoint {
        /// The line, from 0 on.
        line: usize,
        /// The point.
        point: usize,
        /// The number of points.
        points: usize,
    },
    /// A name has characters that no reader takes.
    #[error("the name {name:?} has control characters")]
    Name {
        /// The name.
        name: String,
    },
    /// Two modes have one name.
    #[error("two modes are called `{name}`")]
    SameName {
        /// The name.
        name: String,
    },
}

/// Its text, so that a program whose `main` returns it prints a sentence.
impl std::fmt::Debug for FileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}
