//! Blocks: Δ and the count at many frequencies at once.
//!
//! The loop over the steps is outside, that over the frequencies of a block inside: a step is one branch-free loop over
//! [`Lanes`](lanes::Lanes), which the compiler turns into vector instructions. A number becomes NaN where a branch would be
//! needed ([`BranchFree`](crate::number::branch_free::BranchFree)). Such a lane goes through the step alone, as does one outside
//! of the range in which nothing is shifted. So each lane has the bits that it has outside of a block, unless a minor under- or
//! overflows.

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

/// Number of frequencies in a block: enough to hide the latency of every operation, few enough for the nearest cache.
pub(crate) const WIDTH: usize = 32;

/// Least number of frequencies for which a block costs less than single evaluations.
pub(crate) const WORTHWHILE: usize = WIDTH / 3;
