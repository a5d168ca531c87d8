//! Shapes, responses and sensitivities of plane structures.

mod balance;
mod exact;
mod responses;
mod sensitivities;
