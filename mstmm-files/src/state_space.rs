//! State spaces in steps of time, as controllers take them: JSON, MATLAB, C, Rust.

use crate::error::FileError;
use mstmm_core::DiscreteStateSpace;
use std::io::Write;

/// The language of a file of a state space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// JSON: `dt`, the matrices `e`, `g`, `c`, `d`, and `after`, what an input at the end of a step adds to the states.
    Json,
    /// A script of MATLAB or Octave, which makes the same matrices.
    Matlab,
    /// A header of C with constants of single precision and a step in line.
    CHeader,
    /// A module of Rust without `std`, with constants of single precision and a step.
    Rust,
}

/// Writes a state space in steps of time: `y = C x + D u`, and then `x = E x + G u`. At rest under a first sample u the states are `-after u`, which C and Rust have as `begin`.
///
/// ```
/// use mstmm::motion::HoldOrder;
/// use mstmm::prelude::*;
/// use mstmm_files::{Format, write_state_space};
///
/// system! {
///     struct Mast {}
///     fixed -> beam 1 { length: 2.0, bending_stiffness: 8.0, mass_per_length: 1.5 } -> conn tip -> free;
/// }
///
/// let mast = Mast {}.build()?;
/// let roots = mast.first_frequencies::<2>()?;
/// let space = mast.state_space::<2, 1, 1>(&roots, [Mast::conn_tip.force()], [Mast::conn_tip.deflection()])?;
/// let discrete = space.with_damping_ratio(0.01)?.discrete(1e-3, HoldOrder::First)?;
/// let mut header = Vec::new(); // or File::create("mast.h")?
/// write_state_space(&mut header, &discrete, Format::CHeader)?;
/// assert!(String::from_utf8(header)?.contains("static inline void mstmm_step("));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError::Empty`] for a space without modes, [`FileError::NotFinite`] for a number that is not finite, in single precision for C and Rust; a writer that fails.
pub fn write_state_space<const MODES: usize, const I: usize, const O: usize>(
    mut writer: impl Write,
    space: &DiscreteStateSpace<f64, MODES, I, O>,
    format: Format,
) -> Result<(), FileError> {
    const { assert!(I > 0 && O > 0, "a state space in a file has inputs and outputs") };
    let states = space.states();
    if states == 0 {
        return Err(FileError::Empty);
    }
    let e = matrix(states, states, |row, column| space.e(row, column));
    let g = matrix(states, I, |row, column| space.g(row, column));
    let after = matrix(states, I, |row, column| space.after(row, column));
    let c = matrix(O, states, |row, column| space.c(row, column));
    let d = matrix(O, I, |row, column| space.d(row, column));
    let largest = if matches!(format, Format::CHeader | Format::Rust) { f64::from(f32::MAX) } else { f64::MAX };
    for (row, values) in [&e, &g, &after, &c, &d].into_iter().flatten().enumerate() {
        if !values.iter().all(|value| value.abs() <= largest) {
            return Err(FileError::NotFinite { row });
        }
    }
    let blocks: Vec<Vec<f64>> = (0..states).map(|row| e[row][row / 2 * 2..row / 2 * 2 + 2].to_vec()).collect();
    let outputs: Vec<Vec<f64>> = c.iter().map(|row| row.iter().copied().step_by(2).collect()).collect();
    let sizes = Sizes { states, inputs: I, outputs: O, dt: space.dt() };
    let text = match format {
        Format::Json => {
            let [e, g, after, c, d] = [&e, &g, &after, &c, &d].map(|rows| nested(rows, ["[", "]"], exact));
            format!("{{\"dt\":{:?},\"e\":{e},\"g\":{g},\"after\":{after},\"c\":{c},\"d\":{d}}}\n", sizes.dt)
        }
        Format::Matlab => {
            let lines = [("E", &e), ("G", &g), ("after", &after), ("C", &c), ("D", &d)].map(|(name, rows)| {
                let rows: Vec<String> = rows.iter().map(|row| joined(row, " ", exact)).collect();
                format!("{name} = [{}];\n", rows.join("; "))
            });
            format!(
                "% y = C*x + D*u; x = E*x + G*u; at rest under u: x = -after*u\ndt = {:?};\n{}",
                sizes.dt,
                lines.concat()
            )
        }
        Format::CHeader => c_header(&sizes, [&blocks, &g, &after, &outputs, &d]),
        Format::Rust => rust(&sizes, [&blocks, &g, &after, &outputs, &d]),
    };
    Ok(writer.write_all(text.as_bytes())?)
}

/// The sizes of a space, and its step.
struct Sizes {
    states: usize,
    inputs: usize,
    outputs: usize,
    dt: f64,
}

fn matrix(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    (0..rows).map(|row| (0..columns).map(|column| entry(row, column)).collect()).collect()
}

/// A number with all its digits.
fn exact(value: f64) -> String {
    format!("{value:?}")
}

/// A number in single precision.
fn short(value: f64) -> String {
    format!("{:?}", value as f32)
}

/// A number in single precision, as C writes it.
fn short_in_c(value: f64) -> String {
    format!("{:e}f", value as f32)
}

fn joined(row: &[f64], between: &str, number: fn(f64) -> String) -> String {
    row.iter().map(|value| number(*value)).collect::<Vec<String>>().join(between)
}

/// Rows in brackets.
fn nested(rows: &[Vec<f64>], [open, close]: [&str; 2], number: fn(f64) -> String) -> String {
    let rows: Vec<String> = rows.iter().map(|row| format!("{open}{}{close}", joined(row, ",", number))).collect();
    format!("{open}{}{close}", rows.join(","))
}

/// The matrices as constants in a language, given what a constant of a name is.
fn tables(matrices: [&[Vec<f64>]; 5], table: impl Fn(&str, [usize; 2], &[Vec<f64>]) -> String) -> String {
    let named = ["growth", "gain", "after", "output", "feed"].into_iter().zip(matrices);
    named.map(|(name, rows)| table(name, [rows.len(), rows.first().map_or(0, Vec::len)], rows)).collect()
}

fn c_header(Sizes { states, inputs, outputs, dt }: &Sizes, matrices: [&[Vec<f64>]; 5]) -> String {
    let modes = states / 2;
    let tables = tables(matrices, |name, [count, width], rows| {
        format!("static const float mstmm_{name}[{count}][{width}] = {};\n", nested(rows, ["{", "}"], short_in_c))
    });
    format!(
        "/* A state space of {modes} modes in steps of {dt:?} s: {inputs} inputs, {outputs} outputs. */\n\
         #ifndef MSTMM_STATE_SPACE_H\n#define MSTMM_STATE_SPACE_H\n\
         enum {{ MSTMM_STATES = {states}, MSTMM_INPUTS = {inputs}, MSTMM_OUTPUTS = {outputs} }};\n{}\
         /* The states at rest under a first sample. */\n\
         static inline void mstmm_begin(float *x, const float *u) {{\n\
         \x20 for (int k = 0; k < MSTMM_STATES; k++) {{\n    x[k] = 0.0f;\n\
         \x20   for (int i = 0; i < MSTMM_INPUTS; i++) x[k] -= mstmm_after[k][i] * u[i];\n  }}\n}}\n\
         /* The outputs y at a sample u of the inputs, and the states x of the next one. */\n\
         static inline void mstmm_step(float *x, const float *u, float *y) {{\n\
         \x20 for (int o = 0; o < MSTMM_OUTPUTS; o++) {{\n    y[o] = 0.0f;\n\
         \x20   for (int i = 0; i < MSTMM_INPUTS; i++) y[o] += mstmm_feed[o][i] * u[i];\n\
         \x20   for (int k = 0; k < MSTMM_STATES; k += 2) y[o] += mstmm_output[o][k / 2] * x[k];\n  }}\n\
         \x20 for (int k = 0; k < MSTMM_STATES; k += 2) {{\n\
         \x20   float a = mstmm_growth[k][0] * x[k] + mstmm_growth[k][1] * x[k + 1];\n\
         \x20   float b = mstmm_growth[k + 1][0] * x[k] + mstmm_growth[k + 1][1] * x[k + 1];\n\
         \x20   for (int i = 0; i < MSTMM_INPUTS; i++) {{\n      a += mstmm_gain[k][i] * u[i];\n      b += mstmm_gain[k + 1][i] * u[i];\n    }}\n\
         \x20   x[k] = a;\n    x[k + 1] = b;\n  }}\n}}\n#endif\n",
        tables
    )
}

fn rust(Sizes { states, inputs, outputs, dt }: &Sizes, matrices: [&[Vec<f64>]; 5]) -> String {
    let modes = states / 2;
    let tables = tables(matrices, |name, [count, width], rows| {
        format!("const {}: [[f32; {width}]; {count}] = {};\n", name.to_uppercase(), nested(rows, ["[", "]"], short))
    });
    format!(
        "//! A state space of {modes} modes in steps of {dt:?} s: {inputs} inputs, {outputs} outputs.\n\n{}\n\
         /// The states at rest under a first sample.\n\
         pub fn begin(inputs: &[f32; {inputs}]) -> [f32; {states}] {{\n\
         \x20   AFTER.map(|row| row.iter().zip(inputs).fold(0.0, |sum, (after, u)| sum - after * u))\n}}\n\n\
         /// The outputs at a sample of the inputs; the states become those of the next one.\n\
         pub fn step(states: &mut [f32; {states}], inputs: &[f32; {inputs}]) -> [f32; {outputs}] {{\n\
         \x20   let dot = |row: &[f32], values: &[f32]| row.iter().zip(values).fold(0.0, |sum, (one, other)| sum + one * other);\n\
         \x20   let mut outputs = FEED.map(|row| dot(&row, inputs));\n\
         \x20   for (output, row) in outputs.iter_mut().zip(OUTPUT) {{\n\
         \x20       *output += row.iter().zip(states.chunks(2)).fold(0.0, |sum, (value, state)| sum + value * state[0]);\n    }}\n\
         \x20   let before = *states;\n\
         \x20   for (k, state) in states.iter_mut().enumerate() {{\n\
         \x20       *state = dot(&GROWTH[k], &before[k / 2 * 2..]) + dot(&GAIN[k], inputs);\n    }}\n\
         \x20   outputs\n}}\n",
        tables
    )
}
