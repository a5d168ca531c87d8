//! Blocks: Δ and the count at many frequencies at once.
//!
//! The loop over the steps is outside, that over the frequencies of a block inside: a step is one loop over [`Lanes`] in
//! straight-line code, which the compiler turns into vector instructions. What has branches is rare, and is not taken there:
//! a [`BranchFree`] number becomes NaN where a branch would be needed, and such a lane goes through the step alone, as does one
//! outside of the range in which nothing is shifted. So each lane has the bits that it has outside of a block, whatever is
//! beside it, unless a minor under- or overflows.

pub(crate) mod both_ways;
pub(crate) mod connection;
pub(crate) mod counters;
pub(crate) mod frequencies;
pub(crate) mod kinds;
pub(crate) mod lane_ops;
pub(crate) mod lanes;
pub(crate) mod loops;
pub(crate) mod pass;
pub(crate) mod root;

/// Frequencies in a block: enough to hide the latency of every operation, few enough for the nearest cache.
pub(crate) const WIDTH: usize = 32;

/// Below so many frequencies a block costs more than each alone.
pub(crate) const WORTHWHILE: usize = WIDTH / 3;
