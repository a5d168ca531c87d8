//! The clock.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Rounds of a measurement; the least counts, since other work on the machine only ever adds.
const ROUNDS: usize = 25;
/// What a round lasts, at least.
const ROUND: Duration = Duration::from_millis(1);

/// Least time of a call over rounds of so many calls that the clock is fine enough [s].
pub(crate) fn least_seconds<T>(mut call: impl FnMut() -> T) -> f64 {
    let mut round = |calls: u32| {
        let start = Instant::now();
        for _ in 0..calls {
            black_box(call());
        }
        start.elapsed()
    };
    let mut calls = 1;
    while round(calls) < ROUND {
        calls *= 2;
    }
    let least = (0..ROUNDS).map(|_| round(calls)).min().unwrap_or_default();
    least.as_secs_f64() / f64::from(calls)
}
